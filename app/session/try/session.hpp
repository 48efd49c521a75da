#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/session/picture/picture.hpp"
#include "app/session/story/story_telling.hpp"
#include "app/session/try/experiments.hpp"
#include "app/session/try/hand.hpp"
#include "app/session/view/view.hpp"

/// A lesson that is looked at and tried out; the window and the command line share it.
///
/// Every experiment makes another lesson, whose story is told again. So each experiment can be undone and
/// saved as a lesson file, and has the same numerics as a lesson of an author.
namespace jw {

/// An edit that was carried out, and the lesson that it led to.
struct CarriedOut {
    Experiment edit;
    std::shared_ptr<const Lesson> lesson;
    std::string what;  ///< description of what was done
};

class Session {
public:
    /// @param with_motion  false: the story ends when everything is assembled
    explicit Session(Lesson lesson, bool with_motion = true, Storyteller tell = tell_at_once);
    /// Session of a lesson that is told already, with its motion or without.
    Session(ToldLesson told, bool with_motion, Storyteller tell);
    /// Session of a lesson in which `done` was carried out; each of them can be undone.
    Session(Lesson lesson, const std::vector<CarriedOut>& done, Storyteller tell = tell_at_once);
    ~Session();

    /// The lesson with all changes made so far.
    const Lesson& lesson() const { return *lesson_; }
    const Lesson& as_written() const { return *written_; }
    const Story& story() const { return *story_; }
    /// Lesson and story as they are now: they do not change, whatever is done to the session.
    ToldLesson as_told() const { return {lesson_, *story_}; }

    /// Index of the step of the story that is shown, as it is or moved by hand.
    int index() const { return index_; }
    /// The shown step.
    const Step& step() const;
    /// True if the shown pose is not a step of the story: it was moved by hand, or along a free motion.
    bool in_hand() const { return hand_ != nullptr; }
    /// True at a question whose answer is the pose of a body: a pose that is led by hand is an answer, not an
    /// edit.
    bool asks_for_pose() const;

    /// @return what was done or why it was not, for people; empty where there is nothing to say
    std::string apply(const Experiment& experiment);

    /// Sentences (experiment_text.hpp) that lead from as_written() to lesson(): carried out one after the
    /// other (carry_out.hpp), they give every number of the lesson exactly. They are few: a later sentence
    /// about the same thing replaces the earlier ones.
    const std::vector<std::string>& tried() const;

    /// Shows vectors and equations of this joint during the motion; the same one again, or -1, leaves the
    /// choice to the story. This is not an experiment: the lesson stays as it is.
    void show_joint(int joint);

    /// Replaces the lesson after its file was saved again. What was tried before stays in the history.
    void replace(Lesson lesson);
    /// Shows what `other` shows, with the joint chosen there: one change, which undo takes back.
    /// @param what  description of the change
    void become(Session&& other, std::string what);
    /// Tells the same story again, at the same step, in the present language
    /// (app/session/wording/messages.hpp).
    void tell_again();

    const View& view() const;
    const Picture& picture() const;
    const PictureStyle& style() const;
    /// Freedoms of what is shown, in the order of RankReport::free_motions.
    const RankReport& rank() const;

    /// Grows whenever view() or picture() may have changed.
    std::uint64_t version() const { return version_; }
    /// Grows whenever the lesson is told again.
    std::uint64_t told() const { return told_; }
    /// Number of times that a view was computed. Tests check that it does not grow while nothing changes.
    std::uint64_t views_computed() const { return views_computed_; }

    bool is_changed() const { return lesson_ != written_; }
    /// Text of the change that undo (redo) would take back (repeat); empty if there is none.
    std::string undo_text() const { return undo_.empty() ? std::string() : undo_.back().what; }
    std::string redo_text() const { return redo_.empty() ? std::string() : redo_.back().what; }

    /// The free motion that is shown; nullptr if none is.
    const FollowedMotion* shown_freedom() const {
        return hand_ && hand_->followed() ? &*hand_->followed() : nullptr;
    }

    /// Index of the step of the story that is nearest to time `t` of the motion; the last step if there is no
    /// motion.
    int index_of_time(double t) const;

private:
    /// One entry of the history: the state before a change.
    struct Past {
        std::shared_ptr<const Lesson> lesson;
        std::shared_ptr<const Lesson> written;  ///< differs if the file was saved again since
        std::vector<Experiment> edits;
        int index = 0;
        std::string what;
    };
    struct Cache;

    // one for each experiment, or for each kind of experiments
    std::string perform(const EditsLesson auto& experiment);
    std::string perform(const Drag& drag);
    std::string perform(const Release& experiment);
    std::string perform(const ShowFreedom& experiment);
    std::string perform(const LetGo& experiment);
    std::string perform(const GoTo& experiment);
    std::string perform(const Undo& experiment);
    std::string perform(const Redo& experiment);
    std::string perform(const StartOver& experiment);
    /// Goes back to the pose of the step from the pose that a hand or a free motion led to.
    void leave_hand();
    std::string edit(const Experiment& experiment);
    std::string scrub(const Drag& drag);
    std::string step_back_in_history(std::vector<Past>& from, std::vector<Past>& to);
    Past present(std::string what) const;
    void push_past(Past past);
    void take_over(std::shared_ptr<const Lesson> lesson);
    void told_anew();
    void changed();

    Storyteller tell_;
    StoryOptions how_;
    std::shared_ptr<const Lesson> written_;
    std::shared_ptr<const Lesson> lesson_;
    std::vector<Experiment> edits_;  ///< from written_ to lesson_
    std::unique_ptr<Story> story_;
    int index_ = 0;
    std::unique_ptr<Hand> hand_;
    std::vector<Past> undo_;
    std::vector<Past> redo_;
    std::size_t gesture_ = 0;  ///< kind and subject of the last edit: a slider that is dragged is one change
    std::uint64_t version_ = 1;
    std::uint64_t told_ = 0;
    mutable std::uint64_t views_computed_ = 0;
    mutable std::unique_ptr<Cache> cache_;
};

}  // namespace jw
