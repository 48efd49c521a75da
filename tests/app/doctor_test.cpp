#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "app/commands/help/doctor.hpp"
#include "render/surface/offscreen.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

using Outcome = SurfaceReport::State;

Diagnosis healthy() {
    Diagnosis diagnosis;
    diagnosis.surfaces = {examine_offscreen()};
    diagnosis.fonts = render::find_fonts();
    return diagnosis;
}

render::Image changed(render::Image picture, const std::function<void(std::uint8_t*)>& change) {
    for (std::size_t k = 0; k < picture.rgb.size(); k += 3) { change(&picture.rgb[k]); }
    return picture;
}

/// The test picture as it is drawn on this machine.
render::Image test_picture() {
    static const render::Image picture = [] {
        const render::Offscreen offscreen(kTestWidth, kTestHeight);
        render::RenderTargets targets(offscreen.gl(), kTestWidth, kTestHeight);
        return draw_test_picture(offscreen.gl(), targets);
    }();
    return picture;
}

}  // namespace

TEST_CASE("doctor finds everything that is needed for pictures here", "[app][doctor]") {
    const Ran ran = run({"doctor"});
    INFO(ran.out);
    CHECK(ran.status == 0);
    CHECK(ran.err.empty());
    CHECK_THAT(ran.out, Catch::Contains("offscreen  draws correctly"));
    CHECK_THAT(ran.out, Catch::Contains("OpenGL "));
    CHECK_THAT(ran.out, Catch::Contains("window     this build has no window"));
    CHECK_THAT(ran.out, Catch::Contains("DejaVuSansMono.ttf (package fonts-dejavu-core)"));
    CHECK_THAT(ran.out, Catch::Contains("latinmodern-math.otf (package fonts-lmodern)"));
    CHECK_THAT(ran.out, Catch::Contains("Eigen 3."));
    CHECK_THAT(ran.out, Catch::EndsWith("\neverything needed is there\n"));
}

TEST_CASE("doctor says the same as JSON", "[app][doctor]") {
    const Ran ran = run({"doctor", "--format", "json"});
    CHECK(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    CHECK(json["format"] == "jointwise doctor");
    CHECK(json["exit_status"] == 0);
    CHECK(json["surfaces"][0]["state"] == "right");
    CHECK(json["surfaces"][0]["samples"].get<int>() >= 1);
    CHECK(json["surfaces"][1]["state"] == "absent");
    CHECK(json["fonts"].size() == 5);
    for (const auto& font : json["fonts"]) {
        CHECK(std::filesystem::exists(font["path"].get<std::string>()));
    }
    CHECK(json["versions"].size() >= 8);
    CHECK(json["lessons"]["state"] == "right");
    CHECK(json["lessons"]["count"].get<int>() > 30);
}

TEST_CASE("a folder without fonts takes none away from those of the system", "[app][doctor]") {
    const Folder folder;
    ::setenv("JOINTWISE_FONTS", folder.path().c_str(), 1);
    const Ran empty = run({"doctor"});
    std::filesystem::copy_file(render::find_fonts()[0].path, folder.path("DejaVuSans.ttf"));
    const Ran own = run({"doctor"});
    folder.file("latinmodern-math.otf", "no font");
    const Ran broken = run({"doctor"});
    const Ran broken_json = run({"doctor", "--format", "json"});
    ::unsetenv("JOINTWISE_FONTS");
    CHECK(empty.status == 0);
    CHECK(own.status == 0);
    CHECK_THAT(own.out, Catch::Contains(folder.path("DejaVuSans.ttf") + " (package"));
    CHECK(broken.status == 2);
    CHECK_THAT(
        broken.out, Catch::Contains(
                        "font '" + folder.path("latinmodern-math.otf") +
                        "' is damaged: it is not a TrueType or OpenType font; replace the file, or take its "
                        "folder out of JOINTWISE_FONTS (package fonts-lmodern)"));
    CHECK_THAT(broken.out, Catch::Contains("\nsomething needed is damaged"));
    // nothing needs to be installed: the file exists
    CHECK(broken.out.find("apt-get install") == std::string::npos);
    const auto fonts = nlohmann::json::parse(broken_json.out)["fonts"];
    CHECK(fonts[3]["state"] == "damaged");
    CHECK(fonts[0]["state"] == "right");
}

TEST_CASE("missing fonts are named with their packages", "[app][doctor]") {
    const Folder folder;
    Diagnosis diagnosis = healthy();
    diagnosis.fonts = render::find_fonts({folder.path()});
    REQUIRE(diagnosis.fonts.size() == 5);
    CHECK(exit_of(diagnosis) == Exit::bad_input);
    CHECK(
        verdict_of(diagnosis) ==
        "something needed is missing; install it:\n  apt-get install fonts-dejavu-core "
        "fonts-droid-fallback fonts-lmodern");
    CHECK_THAT(
        describe(diagnosis),
        Catch::Contains("  font 'DejaVuSans.ttf' not found; install the Debian package fonts-dejavu-core or "
                        "name its folder in JOINTWISE_FONTS"));
    CHECK(json_of(diagnosis)["fonts"][0]["path"].is_null());
    CHECK(json_of(diagnosis)["fonts"][0]["state"] == "missing");
}

TEST_CASE(
    "without the font for Chinese everything needed is there, and its package is named", "[app][doctor]") {
    Diagnosis diagnosis = healthy();
    render::FontSource& chinese = diagnosis.fonts.back();
    REQUIRE(chinese.optional);
    chinese = render::find_fonts({"/nowhere"}).back();
    CHECK(exit_of(diagnosis) == Exit::done);
    CHECK(
        verdict_of(diagnosis) ==
        "everything needed is there; texts in Chinese need more:\n  apt-get install fonts-droid-fallback");
}

TEST_CASE("a surface that does not load is status 2, one that draws wrong is status 3", "[app][doctor]") {
    Diagnosis diagnosis = healthy();
    SurfaceReport& surface = diagnosis.surfaces[0];
    surface.state = Outcome::missing;
    surface.problem = "no OpenGL 3.3 without a window";
    surface.packages = "libosmesa6";
    surface.remedy = "unset MESA_GL_VERSION_OVERRIDE";
    CHECK(exit_of(diagnosis) == Exit::bad_input);
    CHECK(
        verdict_of(diagnosis) ==
        "something needed is missing; install it:\n  apt-get install libosmesa6\n"
        "  offscreen: unset MESA_GL_VERSION_OVERRIDE");
    surface.state = Outcome::draws_wrong;
    CHECK(exit_of(diagnosis) == Exit::numerics);
    // a missing screen is not a fault
    surface.state = Outcome::absent;
    CHECK(exit_of(diagnosis) == Exit::done);
}

TEST_CASE("the window is looked at by whoever has one", "[app][doctor]") {
    std::ostringstream out;
    std::ostringstream err;
    const auto window = [] {
        SurfaceReport report;
        report.name = "window";
        report.state = Outcome::draws_wrong;
        report.problem = "the picture is blank";
        return report;
    };
    CHECK(run_program({"doctor"}, Streams{out, err, false}, window) == 3);
    CHECK_THAT(out.str(), Catch::Contains("window     the picture is blank"));
}

TEST_CASE("the test picture tells drivers that draw wrong", "[app][doctor]") {
    const render::Image good = test_picture();
    CHECK(fault_of(good) == "");
    const auto fault = [&](const std::function<void(std::uint8_t*)>& change) {
        return fault_of(changed(good, change));
    };
    const auto paint = [](int r, int g, int b) {
        return [=](std::uint8_t* pixel) {
            pixel[0] = static_cast<std::uint8_t>(r);
            pixel[1] = static_cast<std::uint8_t>(g);
            pixel[2] = static_cast<std::uint8_t>(b);
        };
    };
    CHECK_THAT(fault(paint(0, 0, 0)), Catch::Contains("a corner of the test picture is #000000"));
    CHECK_THAT(fault(paint(250, 249, 248)), Catch::Contains("the ball at the left"));
    CHECK_THAT(fault([](std::uint8_t* p) { std::swap(p[0], p[2]); }), Catch::Contains("expected red"));
    // upside down, mirrored
    render::Image turned = good;
    for (int y = 0; y < kTestHeight; ++y) {
        std::copy_n(
            good.at(0, kTestHeight - 1 - y), 3 * kTestWidth,
            &turned.rgb[3U * kTestWidth * static_cast<unsigned>(y)]);
    }
    CHECK_THAT(fault_of(turned), Catch::Contains("of the test picture is"));
    for (int y = 0; y < kTestHeight; ++y) {
        for (int x = 0; x < kTestWidth; ++x) {
            std::copy_n(
                good.at(kTestWidth - 1 - x, y), 3,
                &turned.rgb[3U * static_cast<unsigned>(y * kTestWidth + x)]);
        }
    }
    CHECK_THAT(fault_of(turned), Catch::Contains("the ball at the left of the test picture is"));
}

}  // namespace jw::test
