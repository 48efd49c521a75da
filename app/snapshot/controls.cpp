#include "app/snapshot/controls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/picture/pointable.hpp"
#include "app/snapshot/comparison.hpp"
#include "render/files/image_difference.hpp"

namespace jw::snapshot {

namespace {

constexpr SnapshotRules kDefaults;
constexpr const char* kNoNumber = "no number of the step has a tolerance";

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

/// Takes everything of a joint out of the picture. @return false if the picture has nothing of it
bool leave_out(Picture& picture, int joint) {
    const auto is_its = [joint](const auto& part) { return belongs_to_joint(part.id, joint); };
    const std::size_t before = picture.scene.shapes.size() + picture.scene.arrows.size();
    std::erase_if(picture.scene.shapes, is_its);
    std::erase_if(picture.scene.arrows, is_its);
    std::erase_if(picture.scene.polylines, is_its);
    return picture.scene.shapes.size() + picture.scene.arrows.size() < before;
}

/// Pixels of the selected parts.
template <class IsIts>
render::PixelMask pixels_of(const render::PictureLayers& layers, const IsIts& is_its) {
    render::PixelMask mask(layers.width, layers.height);
    std::ranges::transform(layers.ids, mask.marked.begin(), is_its);
    return mask;
}

/// True for colours that differ by more than `level` even in shade, which leaves a quarter of the difference.
bool are_plainly_different(const render::Colour& a, const render::Colour& b) {
    const float apart = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    return apart > 4.0F * static_cast<float>(kDefaults.colour.level) / 255.0F;
}

/// Gives the shapes of the first body that is seen the colour of another one.
/// @return false if no body is seen, or all have one colour
template <class IsSeen>
bool swap_colours(Picture& picture, const IsSeen& is_seen) {
    std::vector<render::Shape*> bodies;
    for (render::Shape& shape : picture.scene.shapes) {
        if (pointable_of(shape.id).kind == Pointable::Kind::body) { bodies.push_back(&shape); }
    }
    for (render::Shape* const one : bodies) {
        if (!is_seen(one->id)) { continue; }
        const auto other = std::ranges::find_if(bodies, [one](const render::Shape* shape) {
            return are_plainly_different(shape->colour, one->colour);
        });
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
        : camera_(camera),
          shot_(shot),
          rules_(rules),
          view_(camera.view(shot)),
          right_(camera.take(shot)),
          seen_(camera.painter().layers(camera.painter().picture(view_))) {}

    ControlResults run(const std::set<Fault>& wanted) {
        for (const Fault fault : wanted) {
            kind_ = fault;
            make(fault);
        }
        return std::move(results_);
    }

private:
    void make(Fault fault) {
        switch (fault) {
            case Fault::shift: return shift();
            case Fault::number: return change_number();
            case Fault::tolerance: return loosen_number();
            case Fault::shown_digit: return change_shown_digit();
            case Fault::colours: return exchange_colours();
            case Fault::joint: return leave_out_joint();
        }
    }

    void add(const std::string& fault, const std::string& layer, bool noticed) {
        results_.made.push_back({fault, layer, noticed});
    }
    void skip(const std::string& fault, const std::string& layer, const std::string& reason) {
        results_.skipped.push_back({kind_, fault, layer, reason});
    }

    /// True if more pixels of these parts are seen than the default rules allow to differ.
    template <class IsIts>
    bool is_seen(const IsIts& is_its, double share, int patch) const {
        return !broken_rule(pixels_of(seen_, is_its), share, patch).empty();
    }

    void shift() {
        const std::string fault = "the picture is shifted by one pixel";
        add(fault, "colours",
            !compare_colours(right_.colour, shifted(right_.colour), rules_.colour).broken.empty());
        Snapshot moved = right_;
        moved.layers.ids = shifted(right_.layers.ids);
        moved.layers.depth = shifted(right_.layers.depth);
        const render::PixelMask mask = render::differing(right_.layers.ids, moved.layers.ids, 0);
        if (broken_rule(mask, kDefaults.ids.share, kDefaults.ids.patch).empty()) {
            return skip(fault, "ids", "the edge of each thing has so few pixels that they may differ");
        }
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
        const std::string fault = "a number of the golden file may differ by too much";
        if (number == nullptr) { return skip(fault, "text", kNoNumber); }
        // the smallest change that must be noticed
        number->tolerance *= 2.0 * kMostOfTolerance;
        add(fault, "text", difference_of(loose, right_, rules_).text_fails());
    }

    void change_number() {
        Snapshot changed = right_;
        Fact* const number = first_number(changed.record.facts);
        const std::string fault = "a digit of a number is another";
        if (number == nullptr) { return skip(fault, "text", kNoNumber); }
        // the first digit that panels show of a number as large as its scale
        *number->value += 1e3 * number->tolerance;
        add(fault, "text", difference_of(right_, changed, rules_).text_fails());
    }

    void change_shown_digit() {
        View view = view_;
        const std::string fault = "a digit on the picture is another";
        if (!change_digit(view.sentence)) {
            return skip(fault, "colours", "the sentence of the step has no digit");
        }
        add(fault, "colours", are_other_colours(view, camera_.painter().picture(view)));
    }

    void exchange_colours() {
        Picture picture = camera_.painter().picture(view_);
        const auto is_body_seen = [this](int body) {
            const SnapshotRules::Colour& rules = kDefaults.colour;
            return is_seen([body](int id) { return id == body; }, rules.share, rules.patch);
        };
        const std::string fault = "two bodies have swapped their colours";
        if (!swap_colours(picture, is_body_seen)) {
            return skip(fault, "colours", "no two visible bodies have different colours");
        }
        add(fault, "colours", are_other_colours(view_, picture));
    }

    bool are_other_colours(const View& view, const Picture& picture) {
        const render::Image image = camera_.painter().paint(view, picture);
        return !compare_colours(right_.colour, image, rules_.colour).broken.empty();
    }

    /// For the text, the first joint that is drawn; for the picture of things, the first that is seen.
    void leave_out_joint() {
        const Mechanism& mechanism = camera_.story().lesson().mechanism;
        const Picture whole = camera_.painter().picture(view_);
        bool is_any_drawn = false;
        for (int joint = 0; joint < static_cast<int>(mechanism.joints.size()); ++joint) {
            Picture picture = whole;
            if (!leave_out(picture, joint)) { continue; }
            const std::string fault =
                "joint " + mechanism.joints[static_cast<std::size_t>(joint)].name + " is left out";
            if (!std::exchange(is_any_drawn, true)) {
                add(fault, "text", is_told(whole, picture, mechanism));
            }
            const auto is_its = [joint](int id) { return belongs_to_joint(id, joint); };
            // without the joint, its pixels show something else, so the default rules notice it
            if (!is_seen(is_its, kDefaults.ids.share, kDefaults.ids.patch)) { continue; }
            Snapshot changed = right_;
            changed.layers = picture_of(camera_.painter().layers(picture), mechanism);
            changed.record.things = changed.layers.things;
            return add(fault, "ids", difference_of(right_, changed, rules_).layers_fail());
        }
        if (!is_any_drawn) { skip("a joint is left out", "text", "no joint is drawn"); }
        skip("a joint is left out", "ids", "no joint is seen on more pixels than may differ");
    }

    /// True if the facts about two pictures differ.
    static bool is_told(const Picture& before, const Picture& now, const Mechanism& mechanism) {
        std::vector<Fact> a = facts_of(before, mechanism);
        std::vector<Fact> b = facts_of(now, mechanism);
        set_tolerances({&a, &b}, {});
        return !changes_of(a, b).empty();
    }

    Camera& camera_;
    const Shot& shot_;
    const SnapshotRules& rules_;
    const View view_;
    const Snapshot right_;
    const render::PictureLayers seen_;  ///< of the right picture
    Fault kind_ = Fault::shift;
    ControlResults results_;
};

}  // namespace

std::set<Fault> all_faults() {
    return {Fault::shift, Fault::number, Fault::tolerance, Fault::shown_digit, Fault::colours, Fault::joint};
}

const Shot& shot_for_controls(const Camera& camera) {
    const int last = camera.story().last_assembled();
    const auto found = std::ranges::find(camera.shots(), last, &Shot::step);
    return found != camera.shots().end() ? *found : camera.shots().back();
}

ControlResults control(
    Camera& camera, const Shot& shot, const SnapshotRules& rules, const std::set<Fault>& wanted) {
    return Controls(camera, shot, rules).run(wanted);
}

}  // namespace jw::snapshot
