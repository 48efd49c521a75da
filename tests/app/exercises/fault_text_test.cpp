#include "app/exercises/grading/fault_text.hpp"

#include <catch2/catch.hpp>

namespace jw {

TEST_CASE("The error of a program is named, not the place that its language writes behind it", "[grade]") {
    exercises::SandboxResult result;
    result.exit_status = 1;
    const auto named = [&](const char* err) {
        result.err = err;
        return program_fault(result, {});
    };
    // error output of Octave, JavaScript, Python and a program in C++
    CHECK(
        named("error: 'f' undefined\nerror: called from\n    answer at line 5 column 7\n") ==
        "The program ended with status 1: error: 'f' undefined");
    CHECK(
        named("/submission/a.js:3\n  f();\n  ^\n\nReferenceError: f is not defined\n    at a.js:3\n\nNode.js "
              "v18\n") == "The program ended with status 1: ReferenceError: f is not defined");
    CHECK(named("Traceback:\n  File\nStopIteration\n") == "The program ended with status 1: StopIteration");
    CHECK(named("terminate called\n  what():  no\n") == "The program ended with status 1:   what():  no");
    CHECK(named("") == "The program ended with status 1");
}

}  // namespace jw
