#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace jw::test {
namespace {

constexpr const char* kLesson = "joints/revolute.toml";

Ran render(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{
        "render", lesson_path(kLesson), "--out", out, "--size", "960x540", "--fps", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
}

nlohmann::json manifest_of(const Folder& folder) {
    return nlohmann::json::parse(bytes_of(folder.path("manifest.json")));
}

}  // namespace

TEST_CASE("two runs give the same bytes, and a part of a run gives that part of it", "[app][frames]") {
    const Folder one;
    const Folder two;
    const Folder part;
    REQUIRE(render(one.path()).status == 0);
    REQUIRE(render(two.path()).status == 0);
    REQUIRE(render(part.path(), {"--frames", "2:4"}).status == 0);

    const auto manifest = manifest_of(one);
    CHECK(bytes_of(one.path("manifest.json")) == bytes_of(two.path("manifest.json")));
    REQUIRE(manifest["frames"].size() == manifest["frames_in_all"]);
    for (const auto& frame : manifest["frames"]) {
        const std::string name = frame["file"];
        INFO(name);
        const std::string bytes = bytes_of(one.path(name));
        CHECK(bytes.starts_with("\x89PNG"));
        CHECK(bytes == bytes_of(two.path(name)));
    }
    const auto partial = manifest_of(part);
    REQUIRE(partial["frames"].size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string name = partial["frames"][k]["file"];
        CHECK(bytes_of(part.path(name)) == bytes_of(one.path(name)));
        CHECK(partial["frames"][k] == manifest["frames"][k + 2]);
    }
    CHECK_FALSE(std::filesystem::exists(part.path("frame_00001.png")));
}

TEST_CASE("the motion alone is drawn by the numbering of all, and no still with it", "[app][frames]") {
    const Folder motion;
    REQUIRE(render(motion.path(), {"--motion-only"}).status == 0);
    const auto manifest = manifest_of(motion);
    REQUIRE(manifest["frames"].size() > 1);
    for (const auto& frame : manifest["frames"]) { CHECK(frame["kind"] == "motion"); }
    // all moments without a gap; only answers about the motion come after it
    const int first = manifest["frames"].front()["frame"];
    const int last = manifest["frames"].back()["frame"];
    CHECK(last - first + 1 == static_cast<int>(manifest["frames"].size()));
    CHECK(last + 1 >= manifest["frames_in_all"].get<int>() - 1);
}

TEST_CASE("where nothing moves there is no motion to be drawn", "[app][frames]") {
    const Folder folder;
    const std::string crank(kCrank);
    const std::string still = folder.file("still.toml", crank.substr(0, crank.find("[motion]")));
    const Ran ran = run({"render", still, "--out", folder.path("frames"), "--motion-only"});
    CHECK(ran.status == 2);
    CHECK_THAT(ran.err, Catch::Contains("--motion-only, but nothing moves in this lesson"));
    CHECK_FALSE(std::filesystem::exists(folder.path("frames")));
}

TEST_CASE("the manifest maps every frame to its step, time and key numbers", "[app][frames]") {
    const Folder folder;
    REQUIRE(render(folder.path(), {"--frames", "0:4"}).status == 0);
    const auto manifest = manifest_of(folder);
    CHECK(manifest["format"] == "jointwise render");
    CHECK(manifest["size"] == nlohmann::json({960, 540}));
    const auto& first = manifest["frames"][0];
    CHECK(first["kind"] == "bodies");
    CHECK(first["step"] == 0);
    CHECK(first["rank"] == 0);
    CHECK(first["dof"] == 6);
    CHECK(first["seconds"] > 1.0);
    const auto equations = std::ranges::find_if(
        manifest["frames"], [](const auto& frame) { return frame["kind"] == "equations"; });
    REQUIRE(equations != manifest["frames"].end());
    CHECK((*equations)["rows"] == 5);
}

TEST_CASE("a folder that cannot be written is status 2, and nothing is left behind", "[app][frames]") {
    const Folder folder;
    const std::string file = folder.file("in-the-way", "");
    const Ran ran = render(file + "/frames");
    CHECK(ran.status == 2);
    CHECK(ran.err.find("cannot be made a folder") != std::string::npos);
    CHECK(bytes_of(file).empty());
}

TEST_CASE("a lesson that cannot close is drawn up to there and is status 3", "[app][frames]") {
    const Folder folder;
    const std::string file = folder.file("short.toml", kTooShort);
    const Ran ran =
        run({"render", file, "--out", folder.path("frames"), "--size", "960x540", "--frames", "0:1"});
    CHECK(ran.status == 3);
    CHECK(ran.err.find("cannot all be closed") != std::string::npos);
    CHECK(std::filesystem::exists(folder.path("frames/frame_00001.png")));
}

}  // namespace jw::test
