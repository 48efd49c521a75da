#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <sstream>

#include "app/host/screen.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/person.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::GuardedScreen;

/// A driver that fails when it is told to: the real one, with some functions replaced.
struct Driver {
    static inline render::GlFunctions real;
    static inline int errors = 0;       ///< errors still to be reported, one for each call
    static inline bool always = false;  ///< report an error after every draw call
    static inline int bad_targets = 0;  ///< framebuffers still to be reported as incomplete

    static GLenum get_error() {
        const GLenum error = real.GetError();
        if (error != GL_NO_ERROR || errors == 0) { return error; }
        --errors;
        return GL_INVALID_OPERATION;
    }
    static GLenum check(GLenum target) {
        if (bad_targets == 0) { return real.CheckFramebufferStatus(target); }
        --bad_targets;
        return GL_FRAMEBUFFER_UNSUPPORTED;
    }

    static void draw(GLenum mode, GLsizei count, GLenum type, const void* indices) {
        real.DrawElements(mode, count, type, indices);
        if (always) { errors = 1; }
    }

    explicit Driver(const render::GlFunctions& functions) : table(functions) {
        real = functions;
        errors = 0;
        always = false;
        bad_targets = 0;
        table.DrawElements = draw;
        table.GetError = get_error;
        table.CheckFramebufferStatus = check;
    }

    render::GlFunctions table;
};

/// A host without a window, drawn by a driver that can fail.
struct Window {
    Window() : driver(surface.gl()), host(setup()), screen((surface.begin_3d(), driver.table), host, log) {
        REQUIRE(host.open(lesson));
    }
    ~Window() { surface.make_current(); }

    host::HostSetup setup() {
        host::HostSetup setup;
        setup.pictures = folder.path();
        setup.unsaved = folder.path() / "unsaved";
        setup.width = 640;
        setup.height = 400;
        lesson = catalogue_folder() / "joints" / "revolute.toml";
        return setup;
    }
    bool frame() {
        host.frame(1.0 / 60.0);
        return screen.draw();
    }
    void type(char character) { host.push(host::InputEvent::typed(static_cast<unsigned char>(character))); }

    TemporaryFolder folder;
    std::filesystem::path lesson;
    render::Offscreen surface{16, 16};
    Driver driver;
    std::ostringstream log;
    host::Host host;
    GuardedScreen screen;
};

std::size_t lines_of(const std::ostringstream& log) {
    const std::string text = log.str();
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

}  // namespace

TEST_CASE("Whatever is pressed after larger or smaller text, OpenGL has nothing to complain about") {
    constexpr std::uint32_t seed = 15;
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint32_t>(n)); };
    Person person("joints/revolute.toml", Person::Pictures::drawn, 640, 400);
    person.host().resize(640, 400);
    // events that make new framebuffers or textures: play and rest, another size, the list of lessons
    constexpr std::string_view keys = "++--++-- ggdnbm0f23451u";
    constexpr int sizes[][2]{{640, 400}, {800, 500}, {900, 420}};
    std::string done;
    for (int event = 0; event < 120; ++event) {
        if (below(6) == 0) {
            const auto& size = sizes[below(3)];
            person.host().resize(size[0], size[1]);
            done += " resize:" + std::to_string(size[0]);
        } else {
            const char key = keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))];
            person.host().push(
                key == ' ' ? host::InputEvent::pressed(host::Key::space)
                           : host::InputEvent::typed(static_cast<unsigned char>(key)));
            done += std::string(" ") + key;
        }
        for (int frames = 1 + below(3); frames > 0; --frames) {
            person.frame();
            INFO(done);
            REQUIRE_NOTHROW(person.screen().draw());
            REQUIRE(person.screen().complaint() == "");
        }
    }
    CHECK(fault_of(person.host()) == "");
}

TEST_CASE("The picture after larger text is the one of a window that was opened with it") {
    Person pressed("joints/revolute.toml", Person::Pictures::drawn);
    pressed.picture();
    pressed.ask(Command::larger_text);
    pressed.rest();
    const render::Image now = pressed.picture();
    Person opened("joints/revolute.toml", Person::Pictures::drawn, 1280, 720, false, 1.125F);
    opened.rest();
    CHECK(opened.picture() == now);
}

TEST_CASE("An error of OpenGL costs one frame, is told once, and what was tried stays") {
    Window window;
    REQUIRE(window.frame());
    window.host.push(host::InputEvent::pressed(host::Key::end));
    REQUIRE(window.frame());
    const int step = window.host.session()->index();
    for (int k = 0; k < 3; ++k) {
        Driver::errors = 1;
        CHECK_FALSE(window.frame());
        CHECK_THAT(window.host.notice().text(), Catch::Contains("OpenGL error 0x502 (invalid operation)"));
        CHECK(window.frame());
        CHECK(window.host.session()->index() == step);
    }
    CHECK(lines_of(window.log) == 1);
    CHECK(fault_of(window.host) == "");
}

TEST_CASE("A framebuffer that cannot be made costs frames until it can, whoever asks for it") {
    Window window;
    REQUIRE(window.frame());
    Driver::bad_targets = 3;
    window.host.resize(700, 420);
    SECTION("for drawing") {}
    SECTION("for what the pointer is at") { window.host.push(host::InputEvent::pointer(200.0F, 200.0F)); }
    int lost = 0;
    for (; lost < 10 && !window.frame(); ++lost) {}
    CHECK(lost == 3);
    CHECK(lines_of(window.log) == 1);
    CHECK(window.frame());
}

TEST_CASE("A driver that complains about every frame and draws it is told once and put up with") {
    Window window;
    Driver::always = true;
    int lost = 0;
    for (int k = 0; k < 20; ++k) { lost += window.frame() ? 0 : 1; }
    CHECK(lost == 2);
    CHECK(lines_of(window.log) == 1);
}

TEST_CASE("Where nothing can be drawn any more, the window ends and what was tried is in a file") {
    Window window;
    REQUIRE(window.frame());
    window.host.push(host::InputEvent::pressed(host::Key::end));
    window.frame();
    REQUIRE(window.host.open(window.lesson, "", {"take out hinge"}));
    REQUIRE(window.host.session()->is_changed());
    Driver::bad_targets = 1000000;
    window.host.resize(700, 420);
    int frames = 0;
    const auto until_the_end = [&] {
        for (; frames < 1000; ++frames) { window.frame(); }
    };
    CHECK_THROWS_AS(until_the_end(), host::GraphicsLost);
    CHECK(frames + 1 == GuardedScreen::kMostFailures);
    window.host.keep_unsaved();
    const ReadResult read = read_lesson_file(window.host.unsaved_copy());
    INFO(read.report());
    REQUIRE(read.lesson);
    CHECK(read.lesson->order.size() == window.host.session()->lesson().order.size());
    CHECK(read.lesson->order.size() < window.host.session()->as_written().order.size());
}

TEST_CASE("Small pictures of the list of lessons are drawn anew after an error") {
    Window window;
    window.type('g');
    for (int k = 0; k < 4; ++k) { REQUIRE(window.frame()); }
    Driver::errors = 1;
    CHECK_FALSE(window.frame());
    for (int k = 0; k < 4; ++k) { CHECK(window.frame()); }
    CHECK(lines_of(window.log) == 1);
}

TEST_CASE("A frame that ends in the middle leaves a host that can still keep what was tried") {
    Person person("joints/revolute.toml");
    person.go_to(2);
    person.host().set_picker([](float, float) -> int { throw std::runtime_error("a fault of the test"); });
    person.host().push(host::InputEvent::pointer(300.0F, 300.0F));
    CHECK_THROWS_WITH(person.frame(), "a fault of the test");
    CHECK_NOTHROW(person.host().keep_unsaved());
}

}  // namespace jw::test
