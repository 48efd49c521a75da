#include <catch2/catch.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <vector>

#include "app/host/frames/frame_draft.hpp"
#include "app/host/frames/frame_files.hpp"
#include "render/files/png.hpp"
#include "tests/app/program.hpp"

namespace jw::host::test {
namespace {

using jw::test::bytes_of;
using jw::test::Folder;

const Json kThis{{"format", "jointwise run"}, {"size", {960, 540}}, {"look", {{"dark", false}}}};
const Json kOther{{"format", "jointwise run"}, {"size", {960, 540}}, {"look", {{"dark", true}}}};

void draw(const FrameDraft& draft, int number) {
    PictureWriter writer(draft.folder());
    writer.add(number, {1, 1, {1, 2, 3}});
    writer.wait();
}

}  // namespace

TEST_CASE("An equal run goes on with what is there, another one is told what differs", "[film]") {
    const Folder folder;
    const std::string path = folder.path("draft");
    {
        FrameDraft draft(path);
        draft.begin(kThis);
        draw(draft, 3);
        draft.leave();
    }
    {
        FrameDraft other(path);
        CHECK_THROWS_WITH(
            other.go_on(kOther),
            Catch::Contains("has pictures of another run (look.dark: false before, true now)"));
        CHECK_THROWS_WITH(other.join(kOther, FrameDraft::Joined::shard), Catch::Contains("look.dark"));
    }
    {
        FrameDraft again(path);
        again.go_on(kThis);
        CHECK(again.has(3));
        CHECK_FALSE(again.has(2));
    }
    // a run that begins again has no pictures
    FrameDraft anew(path);
    anew.begin(kOther);
    CHECK_FALSE(anew.has(3));
}

TEST_CASE("A picture that is cut off is drawn again", "[film]") {
    const Folder folder;
    FrameDraft draft(folder.path("draft"));
    draft.begin(kThis);
    draw(draft, 0);
    REQUIRE(draft.has(0));
    const std::string whole = bytes_of(draft.folder() / frame_name(0));
    for (const std::size_t size : {std::size_t{0}, std::size_t{8}, whole.size() / 2, whole.size() - 1}) {
        folder.file("draft/" + frame_name(0), whole.substr(0, size));
        CHECK_FALSE(draft.has(0));
    }
    folder.file("draft/" + frame_name(0), whole);
    CHECK(draft.has(0));
}

TEST_CASE(
    "Who begins a folder takes it away, who joins leaves it, and nobody touches what is not ours", "[film]") {
    const Folder folder;
    const std::string path = folder.path("draft");
    {
        FrameDraft draft(path);
        draft.begin(kThis);
        FrameDraft beside(path);
        beside.join(kThis, FrameDraft::Joined::part);
        draw(beside, 1);
    }
    CHECK_FALSE(std::filesystem::exists(path));
    {
        FrameDraft first(path);
        first.join(kThis, FrameDraft::Joined::shard);
        draw(first, 1);
    }
    CHECK(std::filesystem::exists(path + "/frame_00001.png"));
    folder.file("draft/notes.txt", "mine");
    FrameDraft next(path);
    CHECK_THROWS_WITH(next.begin(kThis), Catch::Contains("contains files that this program did not write"));
    CHECK(bytes_of(path + "/notes.txt") == "mine");
}

TEST_CASE(
    "Nobody begins, goes on with or joins what another run draws into, and shards draw side by side",
    "[film]") {
    const Folder folder;
    const std::string path = folder.path("draft");
    {
        FrameDraft draft(path);
        draft.begin(kThis);
        draw(draft, 1);
        FrameDraft other(path);
        CHECK_THROWS_WITH(other.begin(kThis), Catch::Contains("is in use by another run"));
        CHECK_THROWS_WITH(other.go_on(kThis), Catch::Contains("is in use by another run"));
        CHECK_THROWS_WITH(
            other.join(kThis, FrameDraft::Joined::shard), Catch::Contains("is in use by another run"));
        CHECK(draft.has(1));
    }
    FrameDraft one(path);
    one.join(kThis, FrameDraft::Joined::shard);
    FrameDraft two(path);
    two.join(kThis, FrameDraft::Joined::shard);
    FrameDraft end(path);
    CHECK_THROWS_WITH(end.go_on(kThis), Catch::Contains("is in use by another run"));
}

TEST_CASE("Of many runs that begin a folder at once one draws, and others wait or are told", "[film]") {
    const Folder folder;
    std::atomic<int> inside = 0;
    std::atomic<int> disturbed = 0;
    const auto run_often = [&] {
        for (int round = 0; round < 30; ++round) {
            try {
                FrameDraft draft(folder.path("draft"));
                draft.begin(kThis);
                disturbed += inside++ > 0 ? 1 : 0;
                draw(draft, 1);
                --inside;
            } catch (const std::runtime_error& error) {
                const bool is_told =
                    std::string(error.what()).find("in use by another run") != std::string::npos;
                disturbed += is_told ? 0 : 1;
            }
        }
    };
    {
        std::vector<std::jthread> runs;
        for (int k = 0; k < 8; ++k) { runs.emplace_back(run_often); }
    }
    CHECK(disturbed == 0);
    CHECK_FALSE(std::filesystem::exists(folder.path("draft")));
}

TEST_CASE("A folder that others create and remove meanwhile is locked, and by one at a time", "[film]") {
    const Folder folder;
    const std::filesystem::path path = folder.path("draft");
    std::atomic<int> inside = 0;
    std::atomic<int> disturbed = 0;
    // between the attempt to create the folder and the look at why it failed, others remove it in about one
    // of 2,000 rounds
    const auto lock_often = [&] {
        for (int round = 0; round < 500; ++round) {
            try {
                FolderLock lock;
                lock.take(path, FolderLock::Kind::alone, "is held");
                disturbed += inside++ > 0 ? 1 : 0;
                --inside;
                std::filesystem::remove(path);
            } catch (const std::runtime_error&) { ++disturbed; }
        }
    };
    {
        std::vector<std::jthread> runs;
        for (int k = 0; k < 8; ++k) { runs.emplace_back(lock_often); }
    }
    CHECK(disturbed == 0);
}

TEST_CASE("A run goes on while the system still takes apart a killed one", "[film]") {
    const Folder folder;
    const std::string path = folder.path("draft");
    std::filesystem::create_directory(path);
    const int killed = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    REQUIRE(::flock(killed, LOCK_EX | LOCK_NB) == 0);
    std::thread system([killed] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        ::close(killed);
    });
    FrameDraft draft(path);
    CHECK_NOTHROW(draft.join(kThis, FrameDraft::Joined::shard));
    system.join();
}

TEST_CASE("The hash of a file is the one that sha256sum prints", "[film]") {
    const Folder folder;
    // FIPS 180-2, appendix B.1
    CHECK(
        sha256_of(folder.file("abc", "abc")) ==
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK_THROWS_WITH(sha256_of(folder.path("none")), Catch::Contains("cannot be read"));
}

}  // namespace jw::host::test
