#include "tests/app/exercises/run/run_support.hpp"

#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace jw::exercises::test {
namespace {

using Search = ProgramSearch::Outcome;
namespace fs = std::filesystem;

}  // namespace

TEST_CASE("The program of an exercise is found by its name and read as it is", "[run]") {
    const Scratch folder;
    folder.file("other.py", "no");
    folder.file("task.txt", "no");
    CHECK(find_program(folder.path(), "task").outcome == Search::absent);
    CHECK(find_program(folder.path(), "task").reason.find(".py, .cpp, .m, .js") != std::string::npos);
    folder.file("task.m", "x = 1");
    const ProgramSearch search = find_program(folder.path() + "/", "task");
    CHECK(search.outcome == Search::found);
    CHECK(search.program.file == "task.m");
    CHECK(search.program.source == "x = 1");
    CHECK(search.program.language->name == "Octave");
}

TEST_CASE("Two programs for one exercise are refused", "[run]") {
    const Scratch folder;
    folder.file("task.py", "");
    folder.file("task.cpp", "");
    const ProgramSearch search = find_program(folder.path(), "task");
    CHECK(search.outcome == Search::refused);
    CHECK(search.reason.find("'task.py' and 'task.cpp'") != std::string::npos);
}

TEST_CASE("What is not a regular file is refused", "[run]") {
    const Scratch folder;
    const std::string target = folder.file("bob.py", "answer = 42");
    fs::create_symlink(target, folder / "link.py");
    fs::create_symlink("/dev/zero", folder / "zero.py");
    fs::create_symlink("nowhere", folder / "broken.py");
    fs::create_directory(folder / "folder.py");
    REQUIRE(::mkfifo((folder / "pipe.py").c_str(), 0644) == 0);
    // only root can make a device, and not everywhere
    const bool has_device = ::mknod((folder / "device.py").c_str(), S_IFCHR | 0644, makedev(1, 5)) == 0;
    for (const std::string name : {"link", "zero", "broken", "folder", "pipe", "device"}) {
        if (name == "device" && !has_device) { continue; }
        CAPTURE(name);
        const ProgramSearch search = find_program(folder.path(), name);
        CHECK(search.outcome == Search::refused);
        CHECK(search.reason.find("'" + name + ".py' is a ") != std::string::npos);
        CHECK(search.program.source.empty());
        CHECK(read_program(folder / (name + ".py")).outcome == Search::refused);
    }
}

TEST_CASE("A folder that is a symbolic link is refused, with or without a slash", "[run]") {
    const Scratch folder;
    fs::create_directory(folder / "bob");
    folder.file("bob/task.py", "answer = 42");
    fs::create_symlink("bob", folder / "alice");
    CHECK(find_program(folder / "bob/", "task").outcome == Search::found);
    for (const char* name : {"alice", "alice/", "alice//"}) {
        CAPTURE(name);
        CHECK(find_program(folder / name, "task").outcome == Search::refused);
        CHECK(read_program(folder / (std::string(name) + "/task.py")).outcome == Search::refused);
    }
    CHECK(find_program(folder / "carol", "task").outcome == Search::refused);
}

TEST_CASE("A file of 1 MB is read and one byte more is refused", "[run]") {
    const Scratch folder;
    folder.file("small.py", std::string(1U << 20U, '#'));
    folder.file("large.py", std::string((1U << 20U) + 1, '#'));
    CHECK(find_program(folder.path(), "small").program.source.size() == 1U << 20U);
    CHECK(find_program(folder.path(), "large").outcome == Search::refused);
    CHECK(find_program(folder.path(), "large").reason == "'large.py' has more than 1 MB");
}

TEST_CASE("A name that leads elsewhere is no name of an exercise", "[run]") {
    const Scratch folder;
    fs::create_directory(folder / "alice");
    folder.file("task.py", "");
    for (const std::string name : {"../task", "", ".", "..", "-rf", "a b", "a\nb", "\x1b[2J", "task.py"}) {
        const ProgramSearch search = find_program(folder / "alice", name);
        CHECK(search.outcome == Search::refused);
        CHECK(search.reason.find('\x1b') == std::string::npos);
    }
}

}  // namespace jw::exercises::test
