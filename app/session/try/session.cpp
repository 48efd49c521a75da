#include "app/session/try/session.hpp"

#include <algorithm>
#include <limits>

#include "app/session/story/timeline.hpp"
#include "app/session/try/experiments.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"

namespace jw {

namespace {

// more than a person remembers
constexpr std::size_t kMostHistory = 200;

/// Number that is the same for all edits of one dragged slider, which are one change; 0 for other edits.
std::size_t gesture_of(const Experiment& experiment) {
    const std::size_t kind = experiment.index() + 1;
    if (const auto* a = std::get_if<SetGeometry>(&experiment)) {
        return kind + 100 * (static_cast<std::size_t>(a->joint) + 1);
    }
    if (const auto* a = std::get_if<SetDriver>(&experiment)) {
        return kind + 100 * (static_cast<std::size_t>(a->driver) + 1);
    }
    return 0;
}

}  // namespace

/// Results for the shown step, each computed when first asked for.
struct Session::Cache {
    std::optional<View> view;
    std::optional<Picture> picture;
    std::optional<RankReport> rank;
    std::optional<PictureStyle> style;  ///< of the whole story
    std::optional<std::vector<std::string>> tried;
};

Session::Session(Lesson lesson, bool with_motion, Storyteller tell)
    : Session(
          tell(std::make_shared<const Lesson>(std::move(lesson)), {.with_motion = with_motion}), with_motion,
          tell) {}

Session::Session(ToldLesson told, bool with_motion, Storyteller tell)
    : tell_(std::move(tell)),
      how_{.with_motion = with_motion},
      written_(told.lesson),
      lesson_(told.lesson),
      story_(std::make_unique<Story>(std::move(told.story))),
      cache_(std::make_unique<Cache>()) {
    told_anew();
}

Session::Session(Lesson lesson, const std::vector<CarriedOut>& done, Storyteller tell)
    : tell_(std::move(tell)),
      written_(std::make_shared<const Lesson>(std::move(lesson))),
      lesson_(written_),
      cache_(std::make_unique<Cache>()) {
    for (const CarriedOut& one : done) {
        push_past(present(one.what));
        edits_ = tried_with(std::move(edits_), std::span(&one.edit, 1), {*written_, *lesson_, *one.lesson});
        lesson_ = one.lesson;
    }
    take_over(lesson_);
    if (done.empty()) { written_ = lesson_; }
}

Session::~Session() = default;

const Step& Session::step() const { return hand_ ? hand_->step() : story_->steps()[at(index_)]; }

std::string Session::apply(const Experiment& experiment) {
    return std::visit([this](const auto& e) { return perform(e); }, experiment);
}

std::string Session::perform(const EditsLesson auto& experiment) { return edit(experiment); }

std::string Session::perform(const LetGo& /*experiment*/) {
    leave_hand();
    return {};
}

std::string Session::perform(const GoTo& experiment) {
    leave_hand();
    gesture_ = 0;
    const int last = static_cast<int>(story_->steps().size()) - 1;
    const int next = std::clamp(experiment.step, 0, last);
    if (next != index_) {
        index_ = next;
        changed();
    }
    return {};
}

std::string Session::perform(const Undo& /*experiment*/) { return step_back_in_history(undo_, redo_); }

std::string Session::perform(const Redo& /*experiment*/) { return step_back_in_history(redo_, undo_); }

std::string Session::perform(const StartOver& /*experiment*/) {
    if (!is_changed()) {
        leave_hand();
        return tr("Nothing was changed.");
    }
    Past past = present(tr("start over"));
    take_over(written_);
    written_ = lesson_;
    edits_.clear();
    push_past(std::move(past));
    gesture_ = 0;
    return tr("All changes are undone.");
}

void Session::leave_hand() {
    if (!hand_) { return; }
    hand_.reset();
    changed();
}

std::string Session::edit(const Experiment& experiment) {
    Edit result = edited(*lesson_, *written_, experiment);
    if (!result.lesson) {
        leave_hand();
        return result.what;
    }
    const std::size_t gesture = gesture_of(experiment);
    Past past = present(result.what);
    std::vector<Experiment> edits =
        tried_with(edits_, std::span(&experiment, 1), {*written_, *lesson_, *result.lesson});
    take_over(std::make_shared<Lesson>(std::move(*result.lesson)));
    edits_ = std::move(edits);
    if (gesture == 0 || gesture != gesture_) { push_past(std::move(past)); }
    gesture_ = gesture;
    redo_.clear();
    return result.what;
}

std::string Session::step_back_in_history(std::vector<Past>& from, std::vector<Past>& to) {
    gesture_ = 0;
    if (from.empty()) {
        leave_hand();
        return tr(
            &from == &undo_ ? tr_later("There is nothing to undo.") : tr_later("There is nothing to redo."));
    }
    const Past past = from.back();
    Past now = present(past.what);
    take_over(past.lesson);
    written_ = past.written == past.lesson ? lesson_ : past.written;
    edits_ = past.edits;
    from.pop_back();
    to.push_back(std::move(now));
    index_ = std::min(past.index, static_cast<int>(story_->steps().size()) - 1);
    changed();
    return &from == &undo_ ? tr("Undone: {0}", past.what) : tr("Redone: {0}", past.what);
}

void Session::replace(Lesson lesson) {
    Past past = present(tr("the file before"));
    take_over(std::make_shared<const Lesson>(std::move(lesson)));
    written_ = lesson_;
    edits_.clear();
    push_past(std::move(past));
    gesture_ = 0;
}

void Session::become(Session&& other, std::string what) {
    push_past(present(std::move(what)));
    hand_ = std::move(other.hand_);
    how_ = other.how_;
    written_ = std::move(other.written_);
    story_ = std::move(other.story_);
    lesson_ = std::move(other.lesson_);  // after the story: the old story refers to the old lesson
    edits_ = std::move(other.edits_);
    index_ = other.index_;
    gesture_ = 0;
    told_anew();
}

void Session::tell_again() {
    const bool changed = is_changed();
    take_over(std::make_shared<const Lesson>(shown_lesson(*lesson_)));
    written_ = changed ? std::make_shared<const Lesson>(shown_lesson(*written_)) : lesson_;
}

Session::Past Session::present(std::string what) const {
    return {lesson_, written_, edits_, index_, std::move(what)};
}

void Session::push_past(Past past) {
    undo_.push_back(std::move(past));
    if (undo_.size() > kMostHistory) { undo_.erase(undo_.begin()); }
    redo_.clear();
}

const std::vector<std::string>& Session::tried() const {
    if (!cache_->tried) { cache_->tried = sentences_of(edits_, *written_); }
    return *cache_->tried;
}

/// Takes over a lesson completely or not at all: if it cannot be told, for example because there is not
/// enough memory, everything stays as it was.
void Session::take_over(std::shared_ptr<const Lesson> lesson) {
    ToldLesson told = tell_(std::move(lesson), how_);
    auto story = std::make_unique<Story>(std::move(told.story));
    if (story_) {
        index_ = find_place(*story, place_of(*story_, index_));
        const int chosen = story_->chosen_joint();
        const auto joints = static_cast<int>(told.lesson->mechanism.joints.size());
        story->choose_joint(chosen < joints ? chosen : -1);
    }
    hand_.reset();
    story_ = std::move(story);
    lesson_ = std::move(told.lesson);  // after the story: the old story refers to the old lesson
    told_anew();
}

void Session::show_joint(int joint) {
    const auto joints = static_cast<int>(lesson_->mechanism.joints.size());
    const bool leave = joint < 0 || joint >= joints || joint == story_->chosen_joint();
    story_->choose_joint(leave ? -1 : joint);
    changed();
}

void Session::told_anew() {
    ++told_;
    cache_->style.reset();
    cache_->tried.reset();
    changed();
}

void Session::changed() {
    ++version_;
    cache_->view.reset();
    cache_->picture.reset();
    cache_->rank.reset();
}

std::string Session::perform(const Drag& drag) {
    const auto bodies = lesson_->mechanism.bodies.size();
    if (drag.body < 0 || static_cast<std::size_t>(drag.body) >= bodies) {
        return tr("there is no such body");
    }
    const Body& body = lesson_->mechanism.bodies[at(drag.body)];
    if (body.fixed) { return tr("{0} is fixed: it has no unknowns.", body.name); }
    gesture_ = 0;
    if (!hand_ && step().kind == Step::Kind::motion) { return scrub(drag); }
    if (!hand_) { hand_ = std::make_unique<Hand>(*story_, index_); }
    const DragOutcome outcome = hand_->pull(drag.body, drag.point_local, drag.target);
    changed();
    if (outcome.freedoms == 0) {
        return tr("No freedom is left here: the joints and drivers present constrain every body.");
    }
    return outcome.blocked ? tr("The equations constrain {0} in this direction.", body.name) : std::string();
}

/// Drags a driven mechanism along its motion, to the moment where the point is nearest to the target. The
/// search walks from the present moment, so that the point does not jump to another part of its path.
std::string Session::scrub(const Drag& drag) {
    const auto body = at(drag.body);
    const auto distance = [&](int k) {
        const Step& s = story_->steps()[at(k)];
        if (s.kind != Step::Kind::motion) { return std::numeric_limits<double>::infinity(); }
        return (s.state.r[body] + rotation_matrix(s.state.p[body]) * drag.point_local - drag.target).norm();
    };
    const int last = static_cast<int>(story_->steps().size()) - 1;
    int best = index_;
    for (const int way : {-1, 1}) {
        int k = index_;
        while (k + way >= 0 && k + way <= last && distance(k + way) < distance(k)) { k += way; }
        if (distance(k) < distance(best)) { best = k; }
    }
    if (best != index_) {
        index_ = best;
        changed();
    }
    return {};
}

bool Session::asks_for_pose() const {
    const Step& step = story_->steps()[at(index_)];
    return step.kind == Step::Kind::question &&
           std::holds_alternative<PoseAnswer>(question_of(*lesson_, step).answer);
}

std::string Session::perform(const Release& /*experiment*/) {
    if (!hand_ || asks_for_pose()) { return {}; }
    const std::vector<Experiment> moves = moves_to(hand_->step().state, *lesson_);
    Edit moved = edited(*lesson_, *written_, moves);
    if (!moved.lesson) {
        leave_hand();
        return moved.what;
    }
    Past past = present(tr("start estimate moved by hand"));
    std::vector<Experiment> edits = tried_with(edits_, moves, {*written_, *lesson_, *moved.lesson});
    take_over(std::make_shared<Lesson>(std::move(*moved.lesson)));
    edits_ = std::move(edits);
    push_past(std::move(past));
    return tr("The pose is the new start estimate.");
}

std::string Session::perform(const ShowFreedom& experiment) {
    gesture_ = 0;
    if (!hand_) { hand_ = std::make_unique<Hand>(*story_, index_); }
    if (!hand_->follow(experiment.motion, experiment.part)) {
        hand_.reset();
        changed();
        return tr("There is no such free motion here.");
    }
    changed();
    return {};
}

const View& Session::view() const {
    if (!cache_->view) {
        ++views_computed_;
        cache_->view = view_of(*story_, step(), index_);
    }
    return *cache_->view;
}

const PictureStyle& Session::style() const {
    if (!cache_->style) { cache_->style = picture_style(*story_); }
    return *cache_->style;
}

const Picture& Session::picture() const {
    if (!cache_->picture) { cache_->picture = picture_of(*story_, style(), step(), index_); }
    return *cache_->picture;
}

const RankReport& Session::rank() const {
    if (!cache_->rank) { cache_->rank = rank_of(step()); }
    return *cache_->rank;
}

int Session::index_of_time(double t) const { return nearest_moment(*story_, t); }

}  // namespace jw
