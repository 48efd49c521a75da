#include <catch2/catch.hpp>

#include <random>
#include <set>

#include <nlohmann/json.hpp>

#include "app/host/frames/frame_files.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

std::set<std::string> files_in(const std::string& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

std::set<std::string> named_by_manifest(const std::string& folder) {
    const auto manifest = nlohmann::json::parse(bytes_of(folder + "/manifest.json"));
    std::set<std::string> names;
    for (const auto& frame : manifest["frames"]) { names.insert(frame["file"].get<std::string>()); }
    return names;
}

/// Writes the first `drawn` of the pictures `first` to `last`, and finishes the run if these are all.
void write_run(const std::string& folder, int first, int last, int drawn) {
    host::FrameFiles files(folder, first, last);
    const View view;
    for (int k = first; k < first + drawn; ++k) { files.add(k, view, 1.0, {1, 1, {0, 0, 0}}); }
    if (drawn == last - first + 1) { files.finish({{"format", "jointwise render"}}); }
}

/// Files in a folder that its manifest does not name.
std::set<std::string> strays_in(const std::string& folder) {
    std::set<std::string> strays;
    const std::set<std::string> named = named_by_manifest(folder);
    for (const std::string& name : files_in(folder)) {
        if (name != "manifest.json" && !named.contains(name)) { strays.insert(name); }
    }
    return strays;
}

}  // namespace

TEST_CASE(
    "Whatever runs went into a folder, finished or not, the last one's manifest names all that is there") {
    constexpr std::uint32_t seed = 15;
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint32_t>(n)); };
    for (int sample = 0; sample < 40; ++sample) {
        const Folder folder;
        std::string history;
        for (int run = 0; run < 6; ++run) {
            const int first = below(8);
            const int count = 1 + below(6);
            const int drawn = below(3) == 0 ? below(count) : count;
            history +=
                " " + std::to_string(first) + "+" + std::to_string(drawn) + "/" + std::to_string(count);
            const std::set<std::string> before = files_in(folder.path());
            write_run(folder.path(), first, first + count - 1, drawn);
            CAPTURE(history);
            const std::set<std::string> there = files_in(folder.path());
            if (drawn < count) {
                CHECK(there == before);
                continue;
            }
            CHECK(named_by_manifest(folder.path()).size() == static_cast<std::size_t>(count));
            for (const std::string& name : named_by_manifest(folder.path())) { CHECK(there.contains(name)); }
            CHECK(strays_in(folder.path()).empty());
        }
    }
}

TEST_CASE("A run that draws nothing leaves the folder as it was") {
    const Folder folder;
    write_run(folder.path(), 0, 2, 3);
    const std::set<std::string> before = files_in(folder.path());
    write_run(folder.path(), 0, 5, 0);
    CHECK(files_in(folder.path()) == before);
    CHECK(named_by_manifest(folder.path()).size() == 3);
}

TEST_CASE("Only pictures that the old manifest names are removed, and only in the folder") {
    const Folder folder;
    write_run(folder.path("frames"), 0, 3, 4);
    folder.file("frames/notes.txt", "somebody's own");
    folder.file("frame_00042.png", "outside");
    auto manifest = nlohmann::json::parse(bytes_of(folder.path("frames/manifest.json")));
    for (const char* name : {"../frame_00042.png", "notes.txt", "manifest.json", "/tmp", "", "frame_.png"}) {
        manifest["frames"].push_back({{"file", name}});
    }
    manifest["frames"].push_back({{"file", 7}});
    folder.file("frames/manifest.json", manifest.dump());
    write_run(folder.path("frames"), 1, 2, 2);
    CHECK(
        files_in(folder.path("frames")) ==
        std::set<std::string>{"frame_00001.png", "frame_00002.png", "manifest.json", "notes.txt"});
    CHECK(bytes_of(folder.path("frame_00042.png")) == "outside");
}

TEST_CASE("A run that fails leaves every byte of the run before") {
    const Folder folder;
    write_run(folder.path(), 0, 2, 3);
    const std::string manifest = bytes_of(folder.path("manifest.json"));
    const std::string picture = bytes_of(folder.path("frame_00001.png"));
    REQUIRE_FALSE(picture.empty());
    {
        host::FrameFiles files(folder.path(), 1, 4);
        files.add(1, View{}, 1.0, {2, 2, std::vector<std::uint8_t>(12, 255)});
        files.add(2, View{}, 1.0, {2, 2, std::vector<std::uint8_t>(12, 255)});
    }
    CHECK(bytes_of(folder.path("manifest.json")) == manifest);
    CHECK(bytes_of(folder.path("frame_00001.png")) == picture);
    CHECK(files_in(folder.path()).size() == 4);
}

TEST_CASE("Pictures that no manifest names are refused, and stay") {
    const Folder folder;
    write_run(folder.path(), 0, 2, 3);
    const std::string theirs = folder.file("frame_00099.png", "somebody's own");
    const std::set<std::string> before = files_in(folder.path());
    CHECK_THROWS_WITH(
        host::FrameFiles(folder.path(), 0, 1),
        "'" + theirs +
            "' is a picture that no manifest in this folder names; expected a folder for the pictures of one "
            "run alone (move it away, or give another folder)");
    CHECK(files_in(folder.path()) == before);
    const std::string crank = folder.file("crank.toml", kCrank);
    const Ran ran = run({"render", crank, "--out", folder.path(), "--size", "960x540", "--frames", "0"});
    CHECK(ran.status == 2);
    CHECK_THAT(ran.err, Catch::StartsWith("jointwise: error: '" + theirs + "' is a picture"));
    CHECK(bytes_of(theirs) == "somebody's own");
}

TEST_CASE("What an interrupted run left is taken away by the next one") {
    const Folder folder;
    write_run(folder.path(), 0, 2, 3);
    // killed while drawing
    std::filesystem::create_directory(folder.path("unfinished-frames"));
    folder.file("unfinished-frames/frame_00007.png", "");
    folder.file("unfinished-frames/frame_00008.png.part-12", "");
    // killed while pictures were moved to their places
    std::filesystem::rename(folder.path("manifest.json"), folder.path("unfinished.json"));
    write_run(folder.path(), 5, 5, 1);
    CHECK(files_in(folder.path()) == std::set<std::string>{"frame_00005.png", "manifest.json"});
    // files of somebody else in that folder
    std::filesystem::create_directory(folder.path("unfinished-frames"));
    folder.file("unfinished-frames/mine.txt", "");
    CHECK_THROWS_WITH(
        write_run(folder.path(), 0, 0, 1), Catch::Contains("contains files that this program did not write"));
    CHECK(std::filesystem::exists(folder.path("unfinished-frames/mine.txt")));
    CHECK(named_by_manifest(folder.path()) == std::set<std::string>{"frame_00005.png"});
}

TEST_CASE("A manifest of another program is not touched") {
    for (const char* other : {"{\"name\": \"A web page\"}", "[]", "7", "{\"format\": \"other\"}"}) {
        const Folder theirs;
        const std::string path = theirs.file("manifest.json", other);
        CHECK_THROWS_WITH(
            host::FrameFiles(theirs.path(), 0, 1),
            "'" + path +
                "' is not a manifest of pictures, and would be "
                "overwritten; expected a folder that is only for pictures");
        CHECK(files_in(theirs.path()).size() == 1);
        CHECK(bytes_of(path) == other);
    }
    const Folder odd;
    std::filesystem::create_directory(odd.path("manifest.json"));
    CHECK_THROWS_WITH(host::FrameFiles(odd.path(), 0, 1), Catch::Contains("is not a regular file"));
}

TEST_CASE("render into a folder with pictures of a longer run leaves those of this one", "[app][frames]") {
    const Folder folder;
    const std::string crank = folder.file("crank.toml", kCrank);
    const auto render = [&](const std::string& frames) {
        return run(
            {"render", crank, "--out", folder.path("frames"), "--size", "960x540", "--frames", frames});
    };
    REQUIRE(render("0:3").status == 0);
    REQUIRE(render("2:2").status == 0);
    CHECK(files_in(folder.path("frames")) == std::set<std::string>{"frame_00002.png", "manifest.json"});
    // a mistake in the command line changes nothing
    CHECK(render("5:2").status == 2);
    CHECK(named_by_manifest(folder.path("frames")) == std::set<std::string>{"frame_00002.png"});
}

}  // namespace jw::test
