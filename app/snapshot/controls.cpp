#include "app/snapshot/controls.hpp"

#include <algorithm>

#include "app/session/picture/pointable.hpp"
#include "app/snapshot/comparison.hpp"

namespace jw::snapshot {

namespace {

render::Image shifted(const render::Image& image) {
    render::Image moved = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = image.width - 1; x > 0; --x) {
            const std::uint8_t* const from = image.at(x - 1, y);
            std::copy(from, from + 3, moved.rgb.begin() + (moved.at(x, y) - moved.rgb.data()));
        }
    }
    return moved;
}

bool belongs_to_joint(int id, int joint) {
    const Pointable link = pointable_of(id);
    const bool of_joint = link.kind == Pointable::Kind::joint || link.kind == Pointable::Kind::vector;
    return of_joint && link.index == joint;
}

/// Takes everything of a joint out of the picture. @return false if there is nothing of it
bool leave_out(Picture& picture, int joint) {
    const auto is_its = [joint](const auto& part) { return belongs_to_joint(part.id, joint); };
    const std::size_t before = picture.scene.shapes.size() + picture.scene.arrows.size();
    std::erase_if(picture.scene.shapes, is_its);
    std::erase_if(picture.scene.arrows, is_its);
    std::erase_if(picture.scene.polylines, is_its);
    return picture.scene.shapes.size() + picture.scene.arrows.size() < before;
}

/// Gives the shapes of the first body after the ground that can be seen the colour of another thing.
bool swap_colours(Picture& picture) {
    std::vector<render::Shape*> bodies;
    for (render::Shape& shape : picture.scene.shapes) {
        if (pointable_of(shape.id).kind == Pointable::Kind::body) { bodies.push_back(&shape); }
    }
    for (render::Shape* const one : bodies) {
        const auto other = std::ranges::find_if(
            bodies, [one](const render::Shape* shape) { return !(shape->colour == one->colour); });
        if (other == bodies.end()) { continue; }
        const render::Colour colour = one->colour;
        const int id = one->id;
        const int other_id = (*other)->id;
        const render::Colour other_colour = (*other)->colour;
        for (render::Shape* const shape : bodies) {
            if (shape->id == id && shape->colour == colour) {
                shape->colour = other_colour;
            } else if (shape->id == other_id && shape->colour == other_colour) {
                shape->colour = colour;
            }
        }
        return true;
    }
    return false;
}

/// Changes the first digit of a text; false if it has none.
bool change_digit(std::string& text) {
    const auto digit = std::ranges::find_if(text, [](char c) { return c >= '0' && c <= '9'; });
    if (digit == text.end()) { return false; }
    *digit = *digit == '7' ? '1' : '7';
    return true;
}

class Controls {
public:
    Controls(Camera& camera, const Shot& shot, const SnapshotRules& rules)
        : camera_(camera), shot_(shot), rules_(rules), right_(camera.take(shot)) {}

    std::vector<ControlResult> run() {
        shift();
        change_number();
        loosen_number();
        change_shown_digit();
        change_picture("two bodies have swapped their colours", "colours", swap_colours);
        leave_out_joint();
        return std::move(results_);
    }

private:
    void add(const std::string& fault, const std::string& layer, bool noticed) {
        results_.push_back({fault, layer, noticed});
    }

    void shift() {
        const std::string fault = "the picture is shifted by one pixel";
        add(fault, "colours",
            !compare_colours(right_.colour, shifted(right_.colour), rules_.colour).broken.empty());
        Snapshot moved = right_;
        moved.layers.ids = shifted(right_.layers.ids);
        moved.layers.depth = shifted(right_.layers.depth);
        if (moved.layers.ids == right_.layers.ids) { return; }
        add(fault, "ids", difference_of(right_, moved, rules_).layers_fail());
    }

    static Fact* first_number(std::vector<Fact>& facts) {
        const auto number =
            std::ranges::find_if(facts, [](const Fact& fact) { return fact.value && fact.tolerance > 0.0; });
        return number == facts.end() ? nullptr : &*number;
    }

    void loosen_number() {
        Snapshot loose = right_;
        Fact* const number = first_number(loose.record.facts);
        if (number == nullptr) { return; }
        // the smallest that must be noticed
        number->tolerance *= 2.0 * kMostOfTolerance;
        add("a number of the golden file may differ by too much", "text",
            difference_of(loose, right_, rules_).text_fails());
    }

    void change_number() {
        Snapshot changed = right_;
        Fact* const number = first_number(changed.record.facts);
        if (number == nullptr) { return; }
        // the first digit that panels show of a number as large as its scale
        *number->value += 1e3 * number->tolerance;
        add("a digit of a number is another", "text", difference_of(right_, changed, rules_).text_fails());
    }

    void change_shown_digit() {
        View view = camera_.view(shot_);
        if (!change_digit(view.sentence)) { return; }
        const render::Image image = camera_.painter().paint(view, camera_.painter().picture(view));
        add("a digit on the picture is another", "colours",
            !compare_colours(right_.colour, image, rules_.colour).broken.empty());
    }

    template <class Change>
    void change_picture(const std::string& fault, const std::string& layer, const Change& change) {
        const View view = camera_.view(shot_);
        Picture picture = camera_.painter().picture(view);
        if (!change(picture)) { return; }
        const render::Image image = camera_.painter().paint(view, picture);
        add(fault, layer, !compare_colours(right_.colour, image, rules_.colour).broken.empty());
    }

    void leave_out_joint() {
        const View view = camera_.view(shot_);
        const Mechanism& mechanism = camera_.story().lesson().mechanism;
        for (int joint = 0; joint < static_cast<int>(mechanism.joints.size()); ++joint) {
            Picture picture = camera_.painter().picture(view);
            if (!leave_out(picture, joint)) { continue; }
            const std::string& name = mechanism.joints[static_cast<std::size_t>(joint)].name;
            const std::string fault = "joint " + name + " is left out";
            add(fault, "text", is_told(camera_.painter().picture(view), picture, mechanism));
            // one inside a body has no pixel that could be missed
            if (!is_seen(name)) { continue; }
            Snapshot changed = right_;
            changed.layers = picture_of(camera_.painter().layers(picture), mechanism);
            changed.record.things = changed.layers.things;
            add(fault, "ids", difference_of(right_, changed, rules_).layers_fail());
            return;
        }
    }

    /// The facts about two pictures differ.
    static bool is_told(const Picture& before, const Picture& now, const Mechanism& mechanism) {
        std::vector<Fact> a = facts_of(before, mechanism);
        std::vector<Fact> b = facts_of(now, mechanism);
        set_tolerances({&a, &b}, {});
        return !changes_of(a, b).empty();
    }

    bool is_seen(const std::string& name) const {
        return std::ranges::any_of(
            right_.record.things, [&](const auto& thing) { return thing.second == name; });
    }

    Camera& camera_;
    const Shot& shot_;
    const SnapshotRules& rules_;
    Snapshot right_;
    std::vector<ControlResult> results_;
};

}  // namespace

const Shot& shot_for_controls(const Camera& camera) {
    const int last = camera.story().last_assembled();
    const auto found = std::ranges::find(camera.shots(), last, &Shot::step);
    return found != camera.shots().end() ? *found : camera.shots().back();
}

std::vector<ControlResult> control(Camera& camera, const Shot& shot, const SnapshotRules& rules) {
    return Controls(camera, shot, rules).run();
}

}  // namespace jw::snapshot
