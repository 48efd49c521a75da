#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include "app/host/host.hpp"
#include "app/host/screen.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "render/surface/offscreen.hpp"
#include "tests/bench/clock.hpp"

/// Processor time of the interface: a frame at rest, a step shown anew, a pull on a body, and the start; one
/// run on one machine.
namespace jw::bench {
namespace {

/// CPU time of `act`, in milliseconds.
template <class Act>
double ms_of(const Act& act) {
    const double begin = cpu_microseconds();
    act();
    return 1e-3 * (cpu_microseconds() - begin);
}

host::HostSetup setup() {
    host::HostSetup setup;
    setup.catalogue = catalogue_folder();
    setup.pictures = std::filesystem::temp_directory_path();
    return setup;
}

struct Size {
    int bodies = 0;
    int rows = 0;
};

Size size_of(const Story& story) {
    const System& system = *story.steps()[static_cast<std::size_t>(story.last_assembled())].system;
    return {static_cast<int>(system.moving_bodies().size()), system.rows()};
}

/// The lesson with the largest matrix, of those whose story runs to the end.
std::filesystem::path largest_lesson() {
    std::filesystem::path largest;
    int most = 0;
    for (const auto& file : lessons_below(catalogue_folder())) {
        const ReadResult read = read_lesson_file(file);
        if (!read.lesson) { continue; }
        const Story story(*read.lesson, poses_only());
        const Size size = size_of(story);
        if (story.failure() == nullptr && size.rows * size.bodies > most) {
            most = size.rows * size.bodies;
            largest = file;
        }
    }
    return largest;
}

void settle(host::Host& host) {
    for (int k = 0; k < 200 && host.seconds_to_change() <= 0.0; ++k) { host.frame(1.0 / 60.0); }
}

void print_frames_at_rest(const std::filesystem::path& lesson) {
    constexpr int kFrames = 300;
    host::Host host(setup());
    host.open(lesson, "1");
    for (const char tab : {'1', '2', '3', '4'}) {
        host.push(host::InputEvent::pressed(host::Key::page_down));
        host.push(host::InputEvent::typed(static_cast<unsigned>(tab)));
        settle(host);
        const double ms = ms_of([&] {
            for (int k = 0; k < kFrames; ++k) { host.frame(1.0 / 60.0); }
        });
        std::printf("  tab %c, nothing changes            %8.3f ms a frame\n", tab, ms / kFrames);
    }
}

/// Prints times of steps, each taken once by a key: view, panels and the picture's parts are made again.
void print_steps(const std::filesystem::path& lesson) {
    constexpr const char* kNames[] = {"bodies", "equations", "iteration", "assembled", "failed", "motion"};
    struct Sum {
        int count = 0;
        double ms = 0.0;
        double most = 0.0;
    };
    Sum sums[6];
    host::Host host(setup());
    host.open(lesson);
    settle(host);
    const auto steps = host.session()->story().steps().size();
    for (std::size_t k = 1; k < steps; ++k) {
        host.push(host::InputEvent::pressed(host::Key::right));
        const double ms = ms_of([&] {
            host.frame(1.0 / 60.0);  // the key
            host.frame(1.0 / 60.0);  // the step
        });
        host.push(host::InputEvent::pressed(host::Key::right, false));
        settle(host);
        Sum& sum = sums[static_cast<std::size_t>(host.session()->step().kind)];
        ++sum.count;
        sum.ms += ms;
        sum.most = std::max(sum.most, ms);
    }
    for (int k = 0; k < 6; ++k) {
        if (sums[k].count == 0) { continue; }
        std::printf(
            "  step '%s'%*s %8.3f ms, at most %.3f (%d steps)\n", kNames[k],
            static_cast<int>(24 - std::string_view(kNames[k]).size()), "", sums[k].ms / sums[k].count,
            sums[k].most, sums[k].count);
    }
}

/// Prints times of pulling a body round a circle, after everything but the drivers is assembled.
void print_pulls(const std::filesystem::path& lesson) {
    constexpr int kPulls = 400;
    const ReadResult read = read_lesson_file(lesson);
    Lesson free = *read.lesson;
    std::erase_if(free.order, [](const Addition& a) { return a.kind == Addition::Kind::driver; });
    free.motion.reset();
    Session session(free);
    session.apply(GoTo{static_cast<int>(session.story().steps().size()) - 1});
    const Size size = size_of(session.story());
    const int body = session.step().system->moving_bodies().front();
    const Vec3 middle = session.step().state.r[static_cast<std::size_t>(body)];
    const double radius = 0.1 * session.style().unit;
    double residual = 0.0;
    const double ms = ms_of([&] {
        for (int k = 0; k < kPulls; ++k) {
            const double angle = 0.05 * k;
            session.apply(Drag{
                body, 0.3 * session.style().unit * Vec3::UnitX(),
                middle + radius * Vec3(std::cos(angle), std::sin(2.0 * angle), std::sin(angle))});
            residual = std::max(residual, session.view().rank.residual);
        }
    });
    std::printf(
        "  %-20s %d moving bodies, %d equations: %6.0f pulls a second with their views, |phi| at most %.0e\n",
        lesson.stem().c_str(), size.bodies, size.rows, 1e3 * kPulls / ms, residual);
}

void print_start(const std::filesystem::path& lesson) {
    std::optional<host::Host> host;
    std::optional<render::Offscreen> context;
    std::optional<host::Screen> screen;
    std::printf("start to first picture, 1280 x 720, OSMesa\n");
    const auto print = [](const char* what, double ms) { std::printf("  %-32s %8.1f ms\n", what, ms); };
    print("fonts", ms_of([&] { host.emplace(setup()); }));
    print("lesson read and told", ms_of([&] { host->open(lesson); }));
    print("context", ms_of([&] {
              context.emplace(16, 16);
              context->begin_3d();
          }));
    print("shaders, meshes, targets", ms_of([&] { screen.emplace(context->gl(), *host); }));
    print("interface", ms_of([&] { host->frame(1.0 / 60.0); }));
    print("first picture", ms_of([&] { screen->draw(); }));
    print("second picture", ms_of([&] {
              host->frame(1.0 / 60.0);
              screen->draw();
          }));
    host->push(host::InputEvent::typed('g'));
    print("list of lessons, one thumbnail", ms_of([&] {
              host->frame(1.0 / 60.0);
              host->frame(1.0 / 60.0);
              screen->draw();
          }));
    screen.reset();
    host.reset();
}

}  // namespace
}  // namespace jw::bench

int main() {
    const std::filesystem::path four_bar = jw::catalogue_folder() / "loops" / "four-bar.toml";
    const std::filesystem::path largest = jw::bench::largest_lesson();
    jw::bench::print_start(four_bar);
    std::printf("interface of %s, 1280 x 720, without drawing\n", largest.stem().c_str());
    jw::bench::print_frames_at_rest(largest);
    jw::bench::print_steps(largest);
    std::printf("pulling at a body\n");
    jw::bench::print_pulls(four_bar);
    jw::bench::print_pulls(largest);
    return 0;
}
