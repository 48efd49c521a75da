#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "app/film/processes.hpp"
#include "app/host/frames/frame_draft.hpp"
#include "render/files/png_reader.hpp"
#include "tests/app/program.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {
namespace {

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::map<std::string, std::string> files_of(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files[entry.path().filename().string()] = bytes_of(entry.path());
    }
    return files;
}

}  // namespace

TEST_CASE("Shards that are drawn in any order and put together are one run, to the byte", "[film][render]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const std::vector<std::string> render{"render", crank, "--size", "960x540", "--fps", "3"};
    REQUIRE(run(with(render, {"--out", folder.path("one")})).status == 0);
    for (const char* shard : {"3/3", "1/3", "2/3"}) {
        const Ran ran = run(with(render, {"--out", folder.path("two"), "--shard", shard}));
        REQUIRE(ran.status == 0);
        CHECK_THAT(ran.err, Catch::Contains("give --resume instead of --shard"));
        CHECK_FALSE(std::filesystem::exists(folder.path("two/manifest.json")));
    }
    // a shard that was lost, and a picture that was cut off
    std::filesystem::remove(folder.path("two/unfinished-frames/frame_00002.png"));
    folder.file("two/unfinished-frames/frame_00001.png", "\x89PNG");
    const Ran other = run(with(render, {"--out", folder.path("two"), "--resume", "--dark"}));
    CHECK(other.status == 2);
    CHECK_THAT(other.err, Catch::Contains("look.dark: false before, true now"));
    REQUIRE(run(with(render, {"--out", folder.path("two"), "--resume"})).status == 0);
    CHECK(files_of(folder.path("one")) == files_of(folder.path("two")));
}

TEST_CASE("A film that stands upright has the same limits of size, turned", "[film][render]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const auto drawn = [&](const std::string& size) {
        return run({"render", crank, "--size", size, "--frames", "0", "--out", folder.path(size)}).status;
    };
    CHECK(drawn("540x960") == 0);
    const render::Image picture = read_png(folder.path("540x960/frame_00000.png"));
    CHECK(picture.width == 540);
    CHECK(picture.height == 960);
    CHECK(drawn("539x960") == 2);
    CHECK(drawn("540x959") == 2);
}

TEST_CASE("The manifest has the hash of every picture, and what it was drawn with", "[film][render]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    REQUIRE(
        run({"render", crank, "--size", "960x540", "--frames", "0:2", "--out", folder.path("out")}).status ==
        0);
    const auto manifest = nlohmann::json::parse(bytes_of(folder.path("out/manifest.json")));
    for (const auto& frame : manifest["frames"]) {
        CHECK(frame["sha256"] == host::sha256_of(folder.path("out/" + frame["file"].get<std::string>())));
    }
    CHECK(manifest["drawn_with"].contains("renderer"));
    CHECK(manifest["drawn_with"].contains("jointwise"));
}

TEST_CASE("A changed lesson does not go on with the pictures of the old one", "[film][render]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const std::vector<std::string> render{"render", crank, "--size", "960x540",
                                          "--fps",  "2",   "--out",  folder.path("out")};
    REQUIRE(run(with(render, {"--shard", "1/2"})).status == 0);
    folder.file("crank.toml", std::string(kCrank) + "# changed\n");
    const Ran ran = run(with(render, {"--resume"}));
    CHECK(ran.status == 2);
    CHECK_THAT(ran.err, Catch::Contains("lesson_sha256"));
}

TEST_CASE(
    "A transparent picture is clear around bodies, smooth at their edges, and else as usual",
    "[film][render]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const std::vector<std::string> render{"render",   crank, "--size", "320x240",         "--no-panel",
                                          "--frames", "3",   "--out",  folder.path("out")};
    const auto picture_with = [&](const std::vector<std::string>& options) {
        REQUIRE(run(with(render, options)).status == 0);
        const std::string bytes = bytes_of(folder.path("out/frame_00003.png"));
        const std::vector<std::uint8_t> png(bytes.begin(), bytes.end());
        return render::decode_png(png, "picture", render::Alpha::kept);
    };
    const render::Image picture = picture_with({"--transparent"});
    const render::Image usual = picture_with({});
    REQUIRE(picture.alpha.size() == 320U * 240U);
    CHECK(picture.alpha.front() == 0);
    CHECK(std::ranges::count(picture.alpha, 255) > 1000);
    int equal = 0;
    for (std::size_t n = 0; n < picture.alpha.size(); ++n) {
        const bool is_equal = std::equal(&picture.rgb[3 * n], &picture.rgb[3 * n] + 3, &usual.rgb[3 * n]);
        equal += picture.alpha[n] == 255 && is_equal ? 1 : 0;
    }
    // all but the ends of lines, which are blended with what is behind them
    CHECK(equal > 0.99 * static_cast<double>(std::ranges::count(picture.alpha, 255)));
    // smooth edges
    CHECK(std::ranges::count_if(picture.alpha, [](int alpha) { return alpha > 0 && alpha < 255; }) > 100);
}

TEST_CASE("The stages of a picture are parts of the loop that is measured from end to end", "[film][bench]") {
    const Folder folder;
    const Ran ran = run(
        {"bench", folder.file("crank.toml", kCrank), "--render", "--size", "960x540", "--format", "json"});
    REQUIRE(ran.status == 0);
    const auto scene = nlohmann::json::parse(ran.out)["scenes"][0];
    double sum = 0.0;
    for (const auto& stage : scene["stages_s"]) {
        CHECK(stage.get<double>() >= 0.0);
        sum += stage.get<double>();
    }
    CHECK(scene["stages_s"].size() == 7);
    CHECK(scene["all_s"].get<double>() == Approx(sum));
    // two clocks: the loop also has the time between the stages, which is never negative
    CHECK(scene["loop_s"].get<double>() >= sum * (1.0 - 1e-9));
    // a second of motion at 30 a second, and its end
    CHECK(scene["pictures"] == 31);
    CHECK(run({"bench", folder.file("still.toml", kTooShort), "--render"}).status == 2);
}

TEST_CASE("Options of render that make no sense together say so", "[film][render]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    struct Case {
        std::vector<std::string> options;
        std::string says;
    };
    const std::vector<Case> cases{
        {{"--out", "x.mp4", "--loop"}, "--loop is only for .gif and .apng"},
        {{"--out", "x", "--loop"}, "--loop and --no-tween apply only to films"},
        {{"--out", "x", "--transparent"}, "--transparent needs --no-panel"},
        {{"--out", "x.gif", "--transparent", "--no-panel"}, "this format has no transparency"},
        {{"--out", "x", "--camera", "1,2"}, "--camera '1,2'; expected X,Y,Z"},
        {{"--out", "x", "--camera", "0,0,0"}, "--camera '0,0,0'; expected X,Y,Z"},
        {{"--out", "x", "--camera", "1,nan,0"}, "expected X,Y,Z"},
        {{"--out", "x.gif", "--frames", "1:2"}, "for a film give --from and --to"},
        {{"--out", "x", "--frames", "1:2", "--from", "1"}, "exclude each other"},
        {{"--out", "x", "--from", "nowhere"}, "--from 'nowhere'; expected a step from 1 to"},
        {{"--out", "x", "--from", "3", "--to", "2"}, "--to '2' is step 2, before step 3 of --from"},
        {{"--out", "x", "--shard", "3/2"}, "--shard '3/2'; expected I/N"},
        {{"--out", "x", "--shard", "0/2"}, "--shard '0/2'; expected I/N"},
        {{"--out", "x", "--shard", "1/2", "--resume"}, "give --resume only after all parts"},
        {{"--out", "x", "--text", "2"}, "--text above 1.5"},
        {{"--out", "x", "--size", "15360x8640"}, "letters do not fit into one texture"},
        {{"--out", crank + "/x.gif"}, "x.gif"}};
    for (const Case& c : cases) {
        const Ran ran = run(with({"render", crank}, c.options));
        INFO(c.says << "\n" << ran.err);
        CHECK(ran.status == 2);
        CHECK_THAT(ran.err, Catch::Contains(c.says));
    }
    CHECK_FALSE(std::filesystem::exists("x"));
    CHECK_FALSE(std::filesystem::exists("x.gif"));
}

}  // namespace jw::test
