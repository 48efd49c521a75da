#include "app/exercises/run/languages.hpp"

#include <algorithm>

#include <unistd.h>

#include "app/exercises/run/safe_text.hpp"

namespace jw::exercises {
namespace {

using Outcome = ProgramResult::Outcome;

constexpr const char* kCompiledName = "program";

/// A compiler may use more than the program: standard headers alone take 100 MB of its memory. The compiled
/// program is read from standard output.
SandboxLimits compiler_limits() {
    SandboxLimits limits;
    limits.wall_seconds = 40.0;
    limits.cpu_seconds = 20.0;
    limits.memory_bytes = 1ULL << 30U;
    limits.out_bytes = 16U << 20U;
    limits.err_bytes = 1U << 20U;
    return limits;
}

std::string path_in_sandbox(const std::string& file) { return std::string(kSandboxFolder) + '/' + file; }

std::vector<std::string> arguments_of(const Language& language, const std::string& file) {
    std::vector<std::string> arguments;
    for (const std::string_view word : language.arguments) {
        if (word == "FILE") {
            arguments.push_back(path_in_sandbox(file));
        } else if (word == "PROGRAM") {
            arguments.emplace_back("/tmp/program");
        } else if (!word.empty()) {
            arguments.emplace_back(word);
        }
    }
    return arguments;
}

ReadyProgram compile(const StudentProgram& program, const std::stop_token& stop) {
    SandboxJob job;
    job.stop = stop;
    job.limits = compiler_limits();
    job.command = {
        "/bin/sh", "-c", "\"$@\" 1>&2 && cat /tmp/program", "sh", std::string(program.language->tool)};
    for (std::string& word : arguments_of(*program.language, program.file)) {
        job.command.push_back(std::move(word));
    }
    job.files = {{program.file, program.source, false}};
    SandboxResult result = run_in_sandbox(job);
    ReadyProgram ready;
    if (!result.could_not_run.empty()) {
        ready.outcome = Outcome::no_sandbox;
        ready.message = result.could_not_run;
    } else if (!result.succeeded()) {
        const bool objects = result.exit_status == 1;
        ready.outcome = Outcome::not_compiled;
        if (objects) { ready.message = first_lines(printable(result.err), 12, 200); }
        ready.compiler = std::move(result);
        ready.limits = job.limits;
    } else {
        ready.file = {kCompiledName, std::move(result.out), true};
        ready.command = path_in_sandbox(kCompiledName);
    }
    return ready;
}

ReadyProgram interpreted(const StudentProgram& program) {
    ReadyProgram ready;
    ready.command = program.language->tool;
    ready.arguments = arguments_of(*program.language, program.file);
    ready.file = {program.file, program.source, false};
    return ready;
}

ReadyProgram none(Outcome outcome, std::string message) {
    ReadyProgram ready;
    ready.outcome = outcome;
    ready.message = std::move(message);
    return ready;
}

}  // namespace

const Language* language_of(std::string_view extension) {
    const auto* const found = std::ranges::find(kLanguages, extension, &Language::extension);
    return found == kLanguages.end() ? nullptr : found;
}

std::string missing_tool(const Language& language) {
    const std::string tool(language.tool);
    if (::access(tool.c_str(), X_OK) == 0) { return {}; }
    return "programs in " + std::string(language.name) + " cannot be run on this machine: there is no " +
           tool + " (Debian package " + std::string(language.package) + ")";
}

double longest_program_seconds() {
    return 2.0 * kLongestSetUp + compiler_limits().wall_seconds + SandboxLimits{}.wall_seconds;
}

ReadyProgram make_ready(const StudentProgram& program, const std::stop_token& stop) {
    if (!sandbox_availability().available) {
        return none(Outcome::no_sandbox, sandbox_availability().reason);
    }
    if (std::string missing = missing_tool(*program.language); !missing.empty()) {
        return none(Outcome::no_tool, std::move(missing));
    }
    ReadyProgram ready = program.language->compiled ? compile(program, stop) : interpreted(program);
    ready.address_bytes = program.language->address_bytes;
    return ready;
}

ProgramResult run_ready(
    const ReadyProgram& program, const std::string& input_json, SandboxLimits limits,
    const std::stop_token& stop) {
    if (program.outcome != Outcome::ran) { return {program.outcome, program.message, {}}; }
    limits.address_bytes = program.address_bytes;
    SandboxJob job;
    job.command = {program.command};
    job.command.insert(job.command.end(), program.arguments.begin(), program.arguments.end());
    job.files = {program.file};
    job.input = input_json;
    job.limits = limits;
    job.stop = stop;
    ProgramResult result{Outcome::ran, {}, run_in_sandbox(job)};
    if (!result.run.could_not_run.empty()) {
        result.outcome = Outcome::no_sandbox;
        result.message = result.run.could_not_run;
    }
    return result;
}

ProgramResult run_program(
    const std::string& file, const std::string& input_json, const SandboxLimits& limits) {
    const ProgramSearch search = read_program(file);
    if (search.outcome == ProgramSearch::Outcome::absent) { return {Outcome::not_found, search.reason, {}}; }
    if (search.outcome == ProgramSearch::Outcome::refused) { return {Outcome::refused, search.reason, {}}; }
    return run_ready(make_ready(search.program), input_json, limits);
}

}  // namespace jw::exercises
