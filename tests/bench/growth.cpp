#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "app/session/claims/checks.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/view/solution.hpp"
#include "lessons/read/reader.hpp"
#include "tests/bench/clock.hpp"

/// `growth`: milliseconds that the commands spend on lessons of 10 to 500 bodies, and the exponent of the
/// growth over the last decade and a half: 1 is linear in the number of bodies.
namespace {

using namespace jw;

std::string body(const std::string& name, double x, double z) {
    return "[[body]]\nname = '" + name + "'\nposition = [" + std::to_string(x) + ", 0, " + std::to_string(z) +
           "]\n";
}

std::string hinge(const std::string& name, const std::string& i, const std::string& j, double x, double z) {
    return "[[joint]]\nname = '" + name + "'\ntype = 'revolute'\nbodies = ['" + i + "', '" + j +
           "']\nat = [" + std::to_string(x) + ", 0, " + std::to_string(z) + "]\naxis = [0, -1, 0]\n";
}

/// The angle of the first hinge is driven; 20 intervals of motion; two claims.
std::string rest(const std::string& joint, const std::string& last, int dof) {
    return "[[driver]]\nname = 'motor'\njoint = '" + joint +
           "'\nquantity = 'angle'\npolynomial_deg = [0, 30]\n[motion]\nto_s = 1\nsteps = "
           "20\n[[expect]]\nafter = '" +
           last + "'\ndof = " + std::to_string(dof) + "\n[[expect]]\nat_s = 1\nresidual_below = 1e-9\n";
}

/// Rods in a row, hinged with parallel axes.
std::string chain(int bodies) {
    std::string text = "format = 1\ntitle = 'chain'\n";
    for (int k = 0; k < bodies; ++k) { text += body("b" + std::to_string(k), k + 0.5, 0.0); }
    for (int k = 0; k < bodies; ++k) {
        const std::string before = k == 0 ? "ground" : "b" + std::to_string(k - 1);
        text += hinge("j" + std::to_string(k), before, "b" + std::to_string(k), k, 0.0);
    }
    return text + rest("j0", "j" + std::to_string(bodies - 1), bodies);
}

/// Parallelograms side by side: posts on the ground, rungs on top; every loop has three redundant equations.
std::string ladder(int bodies) {
    const int rungs = (bodies - 1) / 2;  // and one post more
    std::string text = "format = 1\ntitle = 'ladder'\n";
    const auto named = [](const char* what, int k) { return what + std::to_string(k); };
    for (int k = 0; k <= rungs; ++k) { text += body(named("p", k), k, 0.5); }
    for (int k = 0; k < rungs; ++k) { text += body(named("r", k), k + 0.5, 1.0); }
    for (int k = 0; k <= rungs; ++k) { text += hinge(named("g", k), "ground", named("p", k), k, 0.0); }
    for (int k = 0; k < rungs; ++k) {
        text += hinge(named("a", k), named("p", k), named("r", k), k, 1.0);
        text += hinge(named("c", k), named("r", k), named("p", k + 1), k + 1, 1.0);
    }
    return text + rest("g0", named("c", rungs - 1), 1);
}

std::size_t nothing_is_left_out = 0;  // so that no result goes unused

void solve_20(const Lesson& lesson, Analysis analysis) {
    SweepPlan plan;
    plan.analysis = analysis;
    plan.step = 0.05;
    const Sweep sweep = solve_sweep(lesson, plan);
    nothing_is_left_out += sweep.rows.size();
}

void inspect(const Lesson& lesson) {
    const Story story(lesson, last_pose_only());
    const int last = static_cast<int>(story.steps().size()) - 1;
    nothing_is_left_out += describe(inspect_step(story, last, lesson.coordinates), lesson).size();
}

void step_until(const Lesson& lesson, int until) {
    StoryOptions options;
    options.last_step = until;
    const Story story(lesson, options);
    const int last = until < 0 ? static_cast<int>(story.steps().size()) - 1 : until;
    for (int k = 0; k <= last; ++k) {
        nothing_is_left_out += describe(view_of(story, k, ViewParts::without_matrix)).size();
    }
}

struct Command {
    const char* name;
    std::function<void(const Lesson&)> run;
};

const std::array kCommands{
    Command{"solve, positions", [](const Lesson& l) { solve_20(l, Analysis::position); }},
    Command{"solve, accelerations", [](const Lesson& l) { solve_20(l, Analysis::acceleration); }},
    Command{"inspect", &inspect},
    Command{"check", [](const Lesson& l) { nothing_is_left_out += check_claims(l).size(); }},
    Command{"step --until 3", [](const Lesson& l) { step_until(l, 3); }},
};
constexpr std::array kBodies{10, 20, 50, 100, 200, 500};

double milliseconds(const Command& command, const Lesson& lesson) {
    double least = 1e300;
    double all = 0.0;
    // other work of the machine can only add to the time
    for (int round = 0; round < 5 && all < 1e6; ++round) {
        const double start = cpu_microseconds();
        command.run(lesson);
        const double spent = cpu_microseconds() - start;
        least = std::min(least, spent);
        all += spent;
    }
    return 1e-3 * least;
}

void measure(const char* family, std::string (*text_of)(int)) {
    for (const Command& command : kCommands) {
        std::printf("%-7s %-21s", family, command.name);
        double first = 0.0;
        double last = 0.0;
        for (const int bodies : kBodies) {
            const ReadResult read = read_lesson(text_of(bodies), family);
            if (!read.lesson) {
                std::printf("%s\n", read.report().c_str());
                return;
            }
            last = milliseconds(command, *read.lesson);
            if (first == 0.0) { first = last; }
            std::printf("%9.2f", last);
            std::fflush(stdout);
        }
        const double times_as_many = static_cast<double>(kBodies.back()) / kBodies.front();
        std::printf("%10.2f\n", std::log(last / first) / std::log(times_as_many));
    }
}

}  // namespace

int main() {
    std::printf("ms of a command              ");
    for (const int bodies : kBodies) { std::printf("%6d   ", bodies); }
    std::printf("bodies; exponent\n");
    measure("chain", &chain);
    measure("ladder", &ladder);
    return nothing_is_left_out > 0 ? 0 : 1;
}
