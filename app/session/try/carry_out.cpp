#include "app/session/try/carry_out.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/session/try/experiment_text.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

// each pull moves a few steps of a fifth of the machine's size; nobody drags farther than this
constexpr int kMostPulls = 200;
// limit of experiments that are not edits: each tells the story again, and a link may ask for any number
constexpr std::size_t kMostMoves = 100;
// relative to the distance at the start: a smaller gap is not visible [m per m]
constexpr double kArrived = 1e-12;

Vec3 point_at(const Session& session, const Drag& drag) {
    const State& state = session.step().state;
    const auto body = at(drag.body);
    return state.r[body] + rotation_matrix(state.p[body]) * drag.point_local;
}

bool same_pose(const State& a, const State& b) { return a.r == b.r && a.p == b.p && a.theta == b.theta; }

/// Pulls until the point is there or comes no nearer.
std::string drag_to_the_end(Session& session, const Drag& drag) {
    std::string said;
    double left = (point_at(session, drag) - drag.target).norm();
    const double enough = kArrived * left;
    for (int pull = 0; pull < kMostPulls && left > enough; ++pull) {
        said = session.apply(drag);
        const double now = (point_at(session, drag) - drag.target).norm();
        if (!(now < left)) { break; }
        left = now;
    }
    return said;
}

/// Makes the pose in the hand the start pose. If its story can only be told later, the pose of the step is
/// restored: the whole experiment is then done again.
std::string released(Session& session) {
    try {
        return session.apply(Release{});
    } catch (...) {
        session.apply(LetGo{});
        throw;
    }
}

/// Drags, or follows a free motion, and makes the pose that was reached the start pose.
ExperimentResult move(Session& session, const Experiment& experiment) {
    const int index = session.index();
    const int held = closed_step(session.story(), index);
    const State before = session.story().steps()[at(held)].state;
    const auto* drag = std::get_if<Drag>(&experiment);
    const std::string said = drag != nullptr ? drag_to_the_end(session, *drag) : session.apply(experiment);
    if (!session.in_hand()) {
        // the hand has led a driven motion along its path
        return {
            session.index() != index || said.empty(),
            said.empty() ? tr("the motion moved along its path") : said};
    }
    if (same_pose(before, session.step().state)) {
        session.apply(LetGo{});
        return {false, said.empty() ? tr("nothing moves") : said};
    }
    std::string what = tr("moved along the free motion");
    if (drag != nullptr) {
        const Body& body = session.lesson().mechanism.bodies[at(drag->body)];
        what = tr("{0} dragged to {1}", body.name, vector_text(point_at(session, *drag)));
    }
    const std::uint64_t told = session.told();
    const std::string refused = released(session);
    if (session.told() == told && !refused.empty()) { return {false, refused}; }
    return {true, what + (said.empty() ? "" : ": " + said)};
}

ExperimentResult applied(Session& session, const Experiment& experiment) {
    const std::uint64_t before = session.told();
    const std::string said = session.apply(experiment);
    return {session.told() != before || said.empty(), said};
}

[[noreturn]] void give_up(const std::string& text, const std::string& why) {
    throw std::runtime_error(in_quotes(text) + ": " + why);
}

}  // namespace

ExperimentResult carry_out(Session& session, const std::string& text) {
    std::string error;
    const std::optional<Experiment> experiment = read_experiment(text, session, error);
    if (!experiment) { return {false, error}; }
    return std::visit(
        Overloaded{
            [&](const GoTo& place) -> ExperimentResult {
                session.apply(place);
                return {true, tr("at step {0}", session.index())};
            },
            [&](const EditsLesson auto& change) { return applied(session, change); },
            [&](const Drag& drag) { return move(session, drag); },
            [&](const Release& release) { return applied(session, release); },
            [&](const ShowFreedom& freedom) { return move(session, freedom); },
            [&](const LetGo& let_go) { return applied(session, let_go); },
            [&](const Undo& undo) { return applied(session, undo); },
            [&](const Redo& redo) { return applied(session, redo); },
            [&](const StartOver& start_over) { return applied(session, start_over); },
        },
        *experiment);
}

std::unique_ptr<Session> session_after(
    const Lesson& lesson, const std::vector<std::string>& texts, const Storyteller& tell) {
    std::vector<CarriedOut> done;
    auto text = texts.begin();
    for (auto now = std::make_shared<const Lesson>(lesson); text != texts.end(); ++text) {
        const std::optional<Experiment> read = read_edit(*text, *now);
        if (!read) { break; }
        Edit edit = edited(*now, lesson, *read);
        if (!edit.lesson) { give_up(*text, edit.what); }
        now = std::make_shared<const Lesson>(std::move(*edit.lesson));
        done.push_back({*read, now, edit.what});
    }
    auto session = std::make_unique<Session>(lesson, done, tell);
    const auto moves = static_cast<std::size_t>(texts.end() - text);
    if (moves > kMostMoves) {
        give_up(
            *text, "too many experiments; expected at most " + std::to_string(kMostMoves) +
                       " from the first one that does not change the lesson");
    }
    for (; text != texts.end(); ++text) {
        const ExperimentResult result = carry_out(*session, *text);
        if (!result.done) { give_up(*text, result.said); }
    }
    return session;
}

}  // namespace jw
