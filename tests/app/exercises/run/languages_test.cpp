#include "tests/app/exercises/run/run_support.hpp"

#include <stop_token>
#include <thread>

namespace jw::exercises::test {
namespace {

using Outcome = ProgramResult::Outcome;

/// A program in each language that gives back the JSON that it gets.
struct Echo {
    const char* extension;
    const char* source;
};

constexpr std::array kEchoes{
    Echo{".py", "import json, sys\njson.dump(json.load(sys.stdin), sys.stdout)\n"},
    Echo{".cpp", "#include <iostream>\nint main() { std::cout << std::cin.rdbuf(); }\n"},
    Echo{".m", "x = jsondecode(fread(stdin, Inf, 'char=>char')');\nprintf('{\"x\": [%g, %g]}', x.x);\n"},
    Echo{".js", "process.stdout.write(require('fs').readFileSync(0));\n"}};

}  // namespace

TEST_CASE("Every language whose tool is installed reads and writes JSON", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    REQUIRE(kEchoes.size() == kLanguages.size());
    for (const Echo& echo : kEchoes) {
        CAPTURE(echo.extension);
        const Language* language = language_of(echo.extension);
        REQUIRE(language != nullptr);
        const std::string file = folder.file("echo" + std::string(echo.extension), echo.source);
        SandboxLimits limits;
        limits.wall_seconds = 60.0;  // Octave takes long to start on a busy machine
        const ProgramResult result = run_program(file, R"({"x": [1, 2.5]})", limits);
        CAPTURE(result.message, result.run.err, result.run.exit_status, result.run.timed_out);
        if (!missing_tool(*language).empty()) {
            WARN("not tested: " << missing_tool(*language));
            CHECK(result.outcome == Outcome::no_tool);
            continue;
        }
        CHECK(result.outcome == Outcome::ran);
        CHECK(result.run.succeeded());
        CHECK(result.run.out == R"({"x": [1, 2.5]})");
    }
}

TEST_CASE("A program that does not compile is answered with the first words of the compiler", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    const ProgramResult result = run_program(folder.file("task.cpp", "int main() { retrun 0; }\n"), "{}");
    CHECK(result.outcome == Outcome::not_compiled);
    CHECK(result.message.find("retrun") != std::string::npos);
    CHECK(result.message.size() < 3000);
}

TEST_CASE("A compiler is contained like the programs that it makes", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    const std::string secret = folder.file("secret.txt", "kept to ourselves");
    const ProgramResult read = run_program(
        folder.file("reads.cpp", "#include \"" + secret + "\"\n#include \"/etc/passwd\"\nint main() {}\n"),
        "{}");
    CHECK(read.outcome == Outcome::not_compiled);
    CHECK(read.message.find("kept") == std::string::npos);

    // an array of 2 GB in the file of the program
    const ProgramResult large = run_program(
        folder.file("large.cpp", "char all[1L << 31] = {1};\nint main() { return all[5]; }\n"), "{}");
    CHECK(large.outcome == Outcome::not_compiled);
    const ProgramResult endless =
        run_program(folder.file("endless.cpp", "#include \"/dev/zero\"\nint main() {}\n"), "{}");
    CHECK(endless.outcome == Outcome::not_compiled);
}

TEST_CASE("A compiled program runs many times", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    folder.file(
        "task.cpp", "#include <iostream>\nint main() { int n; std::cin >> n; std::cout << 2 * n; }\n");
    const ProgramSearch search = find_program(folder.path(), "task");
    REQUIRE(search.outcome == ProgramSearch::Outcome::found);
    const ReadyProgram program = make_ready(search.program);
    REQUIRE(program.outcome == Outcome::ran);
    for (const int n : {1, 7, 50}) {
        CHECK(run_ready(program, std::to_string(n)).run.out == std::to_string(2 * n));
    }
}

TEST_CASE("A program and a compiler that nobody waits for any more are killed", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    SandboxLimits limits;
    limits.wall_seconds = limits.cpu_seconds = 600.0;
    std::stop_source source;
    const ProgramSearch search = read_program(folder.file("task.py", "while True: pass\n"));
    std::jthread impatient([&source] { source.request_stop(); });
    const ProgramResult result = run_ready(make_ready(search.program), "{}", limits, source.get_token());
    CHECK(result.outcome == Outcome::no_sandbox);
    CHECK_FALSE(result.run.timed_out);
    const ProgramSearch compiled = read_program(folder.file("task.cpp", "int main() {}\n"));
    CHECK(make_ready(compiled.program, source.get_token()).outcome == Outcome::no_sandbox);
}

TEST_CASE("Whenever a program is given up, none of its processes is left", "[run]") {
    if (no_sandbox_here()) { return; }
    const Scratch folder;
    SandboxLimits limits;
    limits.wall_seconds = limits.cpu_seconds = 600.0;
    const std::string name = "endless-" + std::to_string(::getpid()) + ".py";
    const ReadyProgram program = make_ready(read_program(folder.file(name, "while True: pass\n")).program);
    // a sandbox is set up in 10 to 100 ms
    for (int k = 0; k < 60; ++k) {
        CAPTURE(k);
        std::stop_source source;
        std::jthread impatient([&source, k] {
            std::this_thread::sleep_for(std::chrono::microseconds(700 * k));
            source.request_stop();
        });
        CHECK(run_ready(program, "{}", limits, source.get_token()).outcome == Outcome::no_sandbox);
        REQUIRE(processes_with(name) == 0);
    }
}

TEST_CASE("A missing tool is named with its package", "[run]") {
    const Language missing{".x", "Esperanto", "/usr/bin/no-such-tool", "esperanto", {"FILE"}};
    const std::string reason = missing_tool(missing);
    for (const char* word : {"Esperanto", "/usr/bin/no-such-tool", "package esperanto"}) {
        CHECK(reason.find(word) != std::string::npos);
    }
    if (no_sandbox_here()) { return; }
    CHECK(make_ready({"task.x", "", &missing}).outcome == Outcome::no_tool);
}

TEST_CASE("Scripts of a shell and files without a language are not run", "[run]") {
    const Scratch folder;
    for (const char* name : {"task.sh", "task", "task.exe", "task.PY"}) {
        CAPTURE(name);
        const ProgramResult result = run_program(folder.file(name, "echo hello\n"), "{}");
        CHECK(result.outcome == Outcome::refused);
        CHECK(result.message.find(name) != std::string::npos);
    }
    CHECK(run_program(folder / "absent.py", "{}").outcome == Outcome::not_found);
}

TEST_CASE("Reservations of a runtime are no use of memory, but what it fills is", "[run]") {
    if (no_sandbox_here()) { return; }
    if (!missing_tool(*language_of(".js")).empty()) { return; }
    const Scratch folder;
    const ProgramResult result = run_program(
        folder.file("task.js", "const all = [];\nfor (;;) all.push(Buffer.alloc(1 << 24, 1));\n"), "{}");
    CHECK(result.outcome == Outcome::ran);
    CHECK_FALSE(result.run.succeeded());
    CHECK(result.run.wall_seconds < 15.0);
}

}  // namespace jw::exercises::test
