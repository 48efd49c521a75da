#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sys/stat.h>

#include "render/files/png.hpp"
#include "tests/app/snapshot/suite.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {
namespace {

/// Changes `count` pixels of a golden picture.
void spoil_pixels(const Suite& suite, const std::string& file, int count) {
    render::Image image = read_png(suite.golden(file));
    for (int x = 0; x < count; ++x) {
        std::uint8_t& red = image.rgb[3 * static_cast<std::size_t>(20 * image.width + 20 + x)];
        red = static_cast<std::uint8_t>(red ^ 0x80U);
    }
    const std::vector<std::uint8_t> bytes = render::encode_png(image);
    suite.write_golden(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace

TEST_CASE("a lesson that has not changed has the same snapshots", "[snapshot]") {
    const Suite suite;
    const Ran ran = suite.compare();
    INFO(ran.out << ran.err);
    CHECK(ran.status == 0);
    CHECK(says(ran, "negative controls: "));
    CHECK_FALSE(says(ran, "BLIND"));
    CHECK(says(ran, "1 lesson, 8 snapshots: 8 same"));
}

TEST_CASE("recording once more leaves what is there as it is", "[snapshot]") {
    Suite suite;
    suite.change("[0, 90]", "[0, 80]");
    const std::string before = bytes_of(suite.golden("bodies.json"));
    const Ran ran = Suite::snapshot({"record", suite.lesson(), "--golden", suite.golden()});
    CHECK(ran.status == 0);
    CHECK(says(ran, "stay as they are"));
    CHECK(bytes_of(suite.golden("bodies.json")) == before);
    CHECK(suite.compare().status == 1);
}

TEST_CASE("a radius that is 1 mm larger is explained in one line", "[snapshot]") {
    Suite suite(kPlate);
    suite.change("radius = 0.05", "radius = 0.051");
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "why: radius of plate: 1 mm larger (body.plate.shape.0.rod.radius, 0.05 → 0.051)"));
    CHECK(says(ran, "plate · shape 1 · radius: 0.05 m → 0.051 m"));
}

TEST_CASE("a changed number of the program is told where it matters most", "[snapshot]") {
    const Suite suite;
    // as if the program had found another rank when the snapshot was taken
    suite.change_golden("pivot.json", R"(["rank","rank",5])", R"(["rank","rank",4])");
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "why: no value of the lesson has changed, and in 'pivot' rank is another: 4 → 5"));
}

TEST_CASE("a joint that is renamed makes snapshots new and gone", "[snapshot]") {
    Suite suite;
    suite.change("name = \"pivot\"", "name = \"hinge\"");
    suite.change("joint = \"pivot\"", "joint = \"hinge\"");
    const Ran ran = suite.compare({"--format", "json"});
    CHECK(ran.status == 1);
    const auto report = nlohmann::json::parse(ran.out);
    std::map<std::string, std::string> verdicts;
    for (const auto& s : report["lessons"][0]["snapshots"]) { verdicts[s["name"]] = s["verdict"]; }
    CHECK(verdicts["hinge"] == "new");
    CHECK(verdicts["pivot"] == "gone");
    CHECK(verdicts["bodies"] == "same");
}

TEST_CASE("what is blessed is the same from then on, and the reason is kept", "[snapshot]") {
    Suite suite;
    suite.change("[0, 90]", "[0, 80]");
    CHECK(suite.bless(" ").status == 2);
    REQUIRE(suite.compare().status == 1);

    const Ran one = suite.bless("slower for the lecture", {"--only", "motion-1"});
    CHECK(one.status == 0);
    CHECK(one.out == "crank: motion-1\n");
    const Ran left = suite.compare();
    CHECK(left.status == 1);
    // the other snapshots still have the old lesson
    CHECK(says(left, "why: polynomial_deg of drive: number 2 10 deg smaller"));
    CHECK(suite.bless("again", {"--only", "motion-1"}).status == 2);

    CHECK(suite.bless("slower for the lecture").status == 0);
    CHECK(suite.compare().status == 0);
    const auto record = nlohmann::json::parse(bytes_of(suite.golden("motion-1.json")));
    CHECK(record["blessed"] == nlohmann::json{"slower for the lecture"});
}

TEST_CASE("rules that would let anything pass are found by the negative controls", "[snapshot]") {
    const Suite suite(kPlate);
    std::ofstream(suite.golden() + "/rules.toml") << "[colour]\nlevel = 255\nlargest = 255\nsimilarity = 0\n";
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "BLIND: the picture is shifted by one pixel, and the layer of colours does not notice"));
    CHECK(says(ran, "BLIND: two bodies have swapped their colours, and the layer of colours"));
}

TEST_CASE("a joint that nobody can see is no fault of the rules", "[snapshot]") {
    // the hinge is inside of the plate
    const Suite suite(
        "format = 1\ntitle = \"T\"\n[[body]]\nname = \"plate\"\n"
        "shape = [{ sphere = { at = [0, 0, 0], radius = 2 } }]\n"
        "[[joint]]\nname = \"pivot\"\ntype = \"spherical\"\nbodies = [\"ground\", \"plate\"]\nat = [0, 0, "
        "0]\n");
    const Ran ran = suite.compare();
    INFO(ran.out);
    CHECK(ran.status == 0);
    CHECK_FALSE(says(ran, "BLIND"));
}

TEST_CASE("a joint hidden in its body is left out in another lesson, else that is told", "[snapshot]") {
    const Folder folder;
    const auto snapshots = [&](const char* verb, std::vector<std::string> more) {
        more.insert(more.begin(), {verb, folder.path("lessons"), "--golden", folder.path("golden")});
        return Suite::snapshot(more);
    };
    std::filesystem::create_directories(folder.path("lessons"));
    folder.file("lessons/door.toml", kDoor);
    REQUIRE(snapshots("record", {"--moments", "0"}).status == 0);
    const Ran alone = snapshots("compare", {});
    INFO(alone.out);
    CHECK(alone.status == 0);
    CHECK(says(
        alone, "not made here: a joint is left out (ids): no joint is seen on more pixels than may differ"));
    CHECK(says(snapshots("compare", {"--format", "junit"}), "<skipped message=\"no joint is seen"));

    folder.file("lessons/plate.toml", kPlate);
    REQUIRE(snapshots("record", {"--moments", "0"}).status == 0);
    const auto report = nlohmann::json::parse(snapshots("compare", {"--format", "json"}).out);
    CHECK(report["fails"] == false);
    CHECK(report["lessons"][0]["controls_skipped"].size() == 1);
    const auto& made = report["lessons"][1]["controls"];
    REQUIRE(made.size() == 2);
    CHECK(
        made[1] == nlohmann::json{{"fault", "joint pivot is left out"}, {"layer", "ids"}, {"noticed", true}});
}

TEST_CASE("rules that let a joint vanish are blind, however much may differ", "[snapshot]") {
    const Suite suite(kPlate);
    std::ofstream(suite.golden() + "/rules.toml")
        << "[ids]\nshare = 1\npatch = 1000000\n[depth]\nshare = 1\npatch = 1000000\n";
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "BLIND: joint pivot is left out, and the layer of ids does not notice"));
}

TEST_CASE("rules with mistakes are refused with their place", "[snapshot]") {
    const Suite suite;
    std::ofstream(suite.golden() + "/rules.toml") << "[colour]\nshare = 2\n[depths]\n";
    const Ran ran = suite.compare();
    CHECK(ran.status == 2);
    CHECK(says(ran, "rules.toml:2:9: error: 'share' is 2; expected 0 to 1"));
    CHECK(says(ran, "rules.toml:3:"));
}

TEST_CASE("rounding of single pixels is allowed, a line of them is not", "[snapshot]") {
    const Suite suite;
    std::ofstream(suite.golden() + "/rules.toml") << "[colour]\nlargest = 255\n";
    spoil_pixels(suite, "bodies.png", 4);
    CHECK(suite.compare().status == 0);
    spoil_pixels(suite, "pivot.png", 5);
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "colours: 5 pixels that touch each other differ, and 5 in all; 4 may touch"));
}

TEST_CASE("colours do not count where they are drawn with something else, the rest does", "[snapshot]") {
    const Suite suite;
    spoil_pixels(suite, "bodies.png", 50);
    REQUIRE(suite.compare().status == 1);
    const auto record = nlohmann::json::parse(bytes_of(suite.golden("bodies.json")));
    const std::string renderer = record["drawn_with"]["renderer"];
    suite.change_golden("bodies.json", renderer, "another renderer");
    const Ran ran = suite.compare();
    CHECK(ran.status == 0);
    CHECK(says(ran, "drawn with something else: renderer: another renderer before, " + renderer + " now"));
    spoil_pixels(suite, "bodies.ids.png", 50);
    CHECK(suite.compare().status == 1);
}

TEST_CASE("what was drawn with something else is blessed, so that its colours count again", "[snapshot]") {
    const Suite suite(kPlate, {"--only", "bodies"});
    const std::string before = bytes_of(suite.golden("bodies.json"));
    const std::string renderer = nlohmann::json::parse(before)["drawn_with"]["renderer"];
    // the same pixels
    suite.change_golden("bodies.json", renderer, "another renderer");
    REQUIRE(suite.compare().status == 0);
    CHECK(suite.bless("recorded here").out == "crank: bodies\n");
    CHECK(nlohmann::json::parse(bytes_of(suite.golden("bodies.json")))["drawn_with"]["renderer"] == renderer);
}

TEST_CASE("steps can be chosen by their names", "[snapshot]") {
    const Suite suite(kCrank, {"--only", "bodies", "--only", "motion-0.25"});
    const Ran ran = suite.compare();
    CHECK(ran.status == 0);
    CHECK(says(ran, "1 lesson, 2 snapshots: 2 same"));
    const Ran wrong =
        Suite::snapshot({"record", suite.lesson(), "--golden", suite.path("other"), "--only", "pivott"});
    CHECK(wrong.status == 2);
    CHECK(says(wrong, "no step 'pivott'; expected one of bodies, pivot-equations, "));
    CHECK(says(wrong, "did you mean 'pivot'?"));
    CHECK_FALSE(std::filesystem::exists(suite.path("other")));
}

TEST_CASE("a report is a page, JUnit and JSON in one folder", "[snapshot]") {
    Suite suite(kPlate);
    suite.change("radius = 0.05", "radius = 0.08");
    const Ran ran = Suite::snapshot(
        {"report", suite.lesson(), "--golden", suite.golden(), "--out", suite.path("report")});
    CHECK(ran.status == 1);
    const std::string page = bytes_of(suite.path("report/index.html"));
    CHECK(page.find("radius of plate: 30 mm larger") != std::string::npos);
    CHECK(page.find("data:image/png;base64,") != std::string::npos);
    CHECK(page.find("src=\"http") == std::string::npos);
    const std::string junit = bytes_of(suite.path("report/junit.xml"));
    CHECK(junit.find("<failure type=\"different\"") != std::string::npos);
    const auto report = nlohmann::json::parse(bytes_of(suite.path("report/report.json")));
    CHECK(report["fails"] == true);
    CHECK(report["lessons"][0]["why"] == report["lessons"][0]["lesson_changes"][0]);
}

TEST_CASE("a lesson without snapshots, and one that cannot be read, are told", "[snapshot]") {
    const Folder folder;
    const std::string lesson = folder.file("crank.toml", kCrank);
    const Ran none = Suite::snapshot({"compare", lesson, "--golden", folder.path("golden")});
    CHECK(none.status == 2);
    CHECK(says(none, "has no snapshots of this lesson; 'jointwise snapshot record' takes them"));
    const Ran broken = Suite::snapshot(
        {"compare", folder.file("bad.toml", "format = 1\n"), "--golden", folder.path("golden")});
    CHECK(broken.status == 2);
    CHECK(says(broken, "bad.toml"));
    const Ran empty = Suite::snapshot({"compare", folder.path("golden"), "--golden", folder.path("golden")});
    CHECK(empty.status != 0);
}

TEST_CASE("damaged golden files are named, and nothing else is lost", "[snapshot]") {
    const Suite suite;
    const std::string whole = bytes_of(suite.golden("bodies.png"));
    suite.write_golden("bodies.png", whole.substr(0, whole.size() / 2));
    suite.write_golden("pivot.json", "{\"format\": \"jointwise snap");
    std::filesystem::remove(suite.golden("pivot-equations.ids.png"));
    const Ran ran = suite.compare({"--format", "json"});
    CHECK(ran.status == 1);
    const auto report = nlohmann::json::parse(ran.out);
    std::map<std::string, std::string> reasons;
    for (const auto& s : report["lessons"][0]["snapshots"]) {
        if (s["verdict"] == "broken") { reasons[s["name"]] = s["reasons"][0]; }
    }
    CHECK(reasons.size() == 3);
    CHECK(report["lessons"][0]["why"] == "golden snapshots are damaged; no value of the lesson has changed");
    CHECK(reasons["bodies"].find("cannot be read as a PNG picture") != std::string::npos);
    CHECK(reasons["pivot"].find("it is not JSON, or cut off") != std::string::npos);
    CHECK(reasons["pivot-equations"].find("pivot-equations.ids.png' cannot be read") != std::string::npos);
    // blessing replaces what cannot be read
    CHECK(suite.bless("restored").status == 0);
    CHECK(suite.compare().status == 0);
}

TEST_CASE("golden files of another kind or size are named before they cost time", "[snapshot]") {
    const Suite suite(kPlate, {"--only", "bodies", "--only", "pivot"});
    // opening a pipe that nobody writes into would wait for ever
    std::filesystem::remove(suite.golden("bodies.png"));
    REQUIRE(::mkfifo(suite.golden("bodies.png").c_str(), 0600) == 0);
    const render::Image small{4, 3, std::vector<std::uint8_t>(3U * 4U * 3U)};
    const std::vector<std::uint8_t> bytes = render::encode_png(small);
    suite.write_golden("pivot.depth.png", std::string(bytes.begin(), bytes.end()));
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "bodies.png' cannot be read"));
    CHECK(says(ran, "pivot.depth.png' is 4x3; expected 960x540 as snapshots.json says"));

    suite.change_golden("snapshots.json", "960", "1");
    const Ran thin = suite.compare();
    CHECK(thin.status == 2);
    CHECK(says(thin, "snapshots.json' has a number out of range"));
}

TEST_CASE("the record of another snapshot is found", "[snapshot]") {
    const Suite suite(kPlate, {"--only", "bodies"});
    suite.change_golden("bodies.json", R"("name": "bodies")", R"("name": "pivot")");
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "bodies.json' is the record of another snapshot"));
}

TEST_CASE("lessons of two folders may not share a name", "[snapshot]") {
    const Folder one;
    const Folder two;
    const Ran ran = Suite::snapshot(
        {"record", one.file("crank.toml", kCrank), two.file("crank.toml", kCrank), "--golden",
         one.path("golden")});
    CHECK(ran.status == 2);
    CHECK(says(ran, "have the same name 'crank'"));
}

TEST_CASE("nothing is written outside of the golden folder, whatever a lesson is called", "[snapshot]") {
    const Folder folder;
    std::filesystem::create_directories(folder.path("lessons"));
    std::filesystem::create_directories(folder.path("shared"));
    folder.file("shared/crank.toml", kCrank);
    std::filesystem::create_symlink("../shared/crank.toml", folder.path("lessons/link.toml"));
    const auto record = [&](const char* what) {
        return Suite::snapshot(
            {"record", folder.path(what), "--golden", folder.path("golden"), "--only", "bodies"});
    };
    CHECK(record("lessons").status == 0);
    CHECK(std::filesystem::exists(folder.path("golden/link/bodies.json")));
    CHECK_FALSE(std::filesystem::exists(folder.path("shared/crank")));
    for (const char* const name : {"lessons/...toml", "lessons/..toml"}) {
        folder.file(name, kCrank);
        // hidden in its folder
        CHECK(record("lessons").status == 0);
        const Ran ran = record(name);
        CHECK(ran.status == 2);
        CHECK(says(ran, "its folder of snapshots cannot be named after it"));
        CHECK_FALSE(std::filesystem::exists(folder.path("snapshots.json")));
        CHECK_FALSE(std::filesystem::exists(folder.path("golden/snapshots.json")));
        CHECK_FALSE(std::filesystem::exists(folder.path("bodies.json")));
        std::filesystem::remove(folder.path(name));
    }
}

TEST_CASE("copies of lessons in a golden folder are no lessons", "[snapshot]") {
    const Folder folder;
    folder.file("crank.toml", kCrank);
    const auto golden_below = [&](const char* verb) {
        return Suite::snapshot({verb, folder.path(), "--golden", folder.path("golden")});
    };
    REQUIRE(golden_below("record").status == 0);
    const Ran ran = golden_below("compare");
    CHECK(ran.status == 0);
    CHECK(says(ran, "1 lesson, 8 snapshots: 8 same"));
}

}  // namespace jw::test
