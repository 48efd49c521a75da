#include <catch2/catch.hpp>

#include <array>
#include <csignal>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"
#include "tests/render/support.hpp"
#include "tests/support/read_png.hpp"

namespace jw::render::test {
namespace {

Image colourful(int width, int height) {
    Image image{width, height, {}};
    std::mt19937 random(7);
    for (int n = 0; n < 3 * width * height; ++n) {
        image.rgb.push_back(static_cast<std::uint8_t>(random() >> 24U));
    }
    return image;
}

/// Limits files of this process to `bytes` while it lives: a writer then fails as on a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limited = before_;
        limited.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limited);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a picture comes back from its PNG as it was", "[render][png]") {
    const TemporaryFolder folder;
    const Image image = colourful(GENERATE(1, 37), GENERATE(1, 23));
    write_file_atomically(folder.path() / "picture.png", encode_png(image));
    CHECK(jw::test::read_png(folder.path() / "picture.png") == image);
    CHECK(folder.files() == 1);
}

TEST_CASE("the same picture gives the same bytes", "[render][png]") {
    CHECK(encode_png(colourful(64, 48)) == encode_png(colourful(64, 48)));
}

TEST_CASE("a picture whose size and data disagree is refused", "[render][png]") {
    Image image = colourful(4, 4);
    image.rgb.pop_back();
    CHECK_THROWS_WITH(encode_png(image), "a picture of 4 x 4 pixels cannot have 47 bytes of colour");
    CHECK_THROWS_AS(encode_png(Image{}), std::invalid_argument);
}

TEST_CASE("reading says which file and why not", "[render][png]") {
    const TemporaryFolder folder;
    const auto path = folder.path() / "text.png";
    std::ofstream(path) << "not a picture";
    CHECK_THROWS_WITH(jw::test::read_png(path), Catch::Contains(path.string()));
    CHECK_THROWS_WITH(jw::test::read_png(folder.path() / "none.png"), Catch::Contains("none.png"));
}

TEST_CASE("a folder that does not exist is named", "[render][png]") {
    const TemporaryFolder folder;
    const auto path = folder.path() / "missing" / "frame.png";
    CHECK_THROWS_WITH(
        write_file_atomically(path, encode_png(colourful(2, 2))),
        "cannot write '" + path.string() + "': No such file or directory");
    CHECK(folder.files() == 0);
}

TEST_CASE("a write that fails half-way leaves the old file and nothing else", "[render][png]") {
    const TemporaryFolder folder;
    const auto path = folder.path() / "frame.png";
    std::ofstream(path) << "old";
    const std::vector<std::uint8_t> bytes(100000, 1);
    {
        const FileSizeLimit limit(4096);
        CHECK_THROWS_WITH(write_file_atomically(path, bytes), Catch::Contains(path.string()));
    }
    CHECK(content(path) == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE(
    "of files that belong together all stay as they were where one cannot be written", "[render][png]") {
    const TemporaryFolder folder;
    const auto first = folder.path() / "frame.png";
    const auto second = folder.path() / "frame.json";
    std::ofstream(first) << "old";
    const std::vector<std::uint8_t> small(10, 1);
    const std::vector<std::uint8_t> large(100000, 1);
    {
        const FileSizeLimit limit(4096);
        const std::array<WholeFile, 2> files{{{first, small}, {second, large}}};
        CHECK_THROWS_WITH(write_files_atomically(files), Catch::Contains(second.string()));
    }
    CHECK(content(first) == "old");
    CHECK(folder.files() == 1);
    const std::array<WholeFile, 2> files{{{first, bytes_of("new")}, {second, bytes_of("new too")}}};
    write_files_atomically(files);
    CHECK(content(first) == "new");
    CHECK(content(second) == "new too");
    CHECK(folder.files() == 2);
}

TEST_CASE("a device, a pipe or a loop of links is not replaced by a file", "[render][png]") {
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe.png";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const std::vector<std::uint8_t> bytes(10, 1);
    CHECK_THROWS_WITH(write_file_atomically(pipe, bytes), Catch::Contains("this is a pipe"));
    CHECK(std::filesystem::is_fifo(pipe));
    CHECK_THROWS_WITH(write_file_atomically("/dev/null", bytes), Catch::Contains("this is a device"));
    CHECK(std::filesystem::is_character_file("/dev/null"));
    CHECK(folder.files() == 1);
}

TEST_CASE("a draft that a killed program left behind is in nobody's way", "[render][png]") {
    const TemporaryFolder folder;
    const auto path = folder.path() / "frame.png";
    std::ofstream(path.string() + ".part-" + std::to_string(::getpid())) << "half";
    write_file_atomically(path, std::string_view("whole"));
    CHECK(content(path) == "whole");
    CHECK(folder.files() == 2);
}

TEST_CASE("a file that cannot take its place leaves nothing behind", "[render][png]") {
    const TemporaryFolder folder;
    const auto path = folder.path() / "frame.png";
    std::filesystem::create_directory(path);
    CHECK_THROWS_WITH(write_file_atomically(path, encode_png(colourful(2, 2))), Catch::Contains("directory"));
    CHECK(folder.files() == 1);
}

}  // namespace jw::render::test
