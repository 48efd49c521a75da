#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "core/jets/drivers.hpp"

/// `mutated_tests` is the tests of derivatives, forces, linked trees and proofs as they are, compiled with
/// sources that can be wrong in one place at a time (marks.hpp); JW_MUTANT says in which.
namespace {

struct Mutant {
    std::string number, what, place, function, line;
};

std::vector<Mutant> all_mutants() {
    std::ifstream file(JW_MUTANTS);
    std::vector<Mutant> mutants;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        Mutant m;
        for (std::string* field : {&m.number, &m.what, &m.place, &m.function, &m.line}) {
            std::getline(fields, *field, '\t');
        }
        mutants.push_back(m);
    }
    return mutants;
}

/// Outcome of a run of `mutated_tests` with a mutant.
struct Verdict {
    bool passed = false;
    std::string last_test;  ///< the test that failed, or that was running when the program ended
};

/// @param test  the one to run; empty: all of them, until one fails
Verdict run_of(const std::string& number, const std::string& test) {
    // a minute stands for an endless loop: all tests together take seconds
    const std::string command = "JW_MUTANT=" + number + " timeout 60 '" JW_MUTATED_TESTS "' --abort -r xml " +
                                (test.empty() ? "" : "'\"" + test + "\"'") + " 2>/dev/null";
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) { throw std::system_error(errno, std::generic_category(), "popen"); }
    std::string output;
    std::array<char, 4096> part{};
    for (std::size_t size = 0; (size = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
        output.append(part.data(), size);
    }
    Verdict verdict{::pclose(pipe) == 0, {}};
    constexpr std::string_view kBegin = "<TestCase name=\"";
    if (const std::size_t at = output.rfind(kBegin); at != std::string::npos) {
        const std::size_t name = at + kBegin.size();
        verdict.last_test = output.substr(name, output.find('"', name) - name);
    }
    return verdict;
}

bool passes(const std::string& number) { return run_of(number, {}).passed; }

/// True if no test fails. The test that failed for the mutant before runs first: neighbours mostly fail
/// there, too, and a test that fails gives the same verdict wherever it stands.
bool survives(const std::string& number, std::string& failed_before) {
    if (!failed_before.empty() && !run_of(number, failed_before).passed) { return false; }
    const Verdict verdict = run_of(number, {});
    // a test whose name has characters that are special to a shell or to Catch is not run alone
    const bool is_plain = verdict.last_test.find_first_of("'\"\\,[]*&;") == std::string::npos;
    failed_before = verdict.passed || !is_plain ? "" : verdict.last_test;
    return verdict.passed;
}

/// Name of a type of core as the sources write it.
template <class T>
std::string name_of() {
    const std::string text = __PRETTY_FUNCTION__;
    const std::size_t begin = text.find("jw::") + 4;
    return text.substr(begin, text.find_first_of(";]", begin) - begin);
}

template <class... Ts>
std::vector<std::string> names_of(const std::variant<Ts...>*) {
    return {name_of<Ts>()...};
}

}  // namespace

TEST_CASE("Without a mutant all tests pass", "[mutation]") { CHECK(passes("0")); }

TEST_CASE("A sign, number or condition wrong in any marked source makes a test fail", "[mutation]") {
    const std::vector<Mutant> mutants = all_mutants();
    std::vector<char> survived(mutants.size(), 0);
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        std::string failed_before;
        for (std::size_t k = next++; k < mutants.size(); k = next++) {
            survived[k] = survives(mutants[k].number, failed_before);
        }
    };
    {
        std::vector<std::jthread> workers(std::max(1U, std::thread::hardware_concurrency()));
        for (std::jthread& worker : workers) { worker = std::jthread(work); }
    }
    for (std::size_t k = 0; k < mutants.size(); ++k) {
        const Mutant& m = mutants[k];
        INFO(
            m.place << ": " << m.what << "\n  " << m.line << "\nrun alone: JW_MUTANT=" << m.number
                    << " " JW_MUTATED_TESTS);
        CHECK_FALSE(survived[k]);
    }
}

TEST_CASE("Every primitive and every measure has mutants of its own", "[mutation]") {
    std::vector<std::string> names = names_of(static_cast<const jw::Primitive*>(nullptr));
    const std::vector<std::string> measures = names_of(static_cast<const jw::Measure*>(nullptr));
    names.insert(names.end(), measures.begin(), measures.end());
    const std::vector<Mutant> mutants = all_mutants();
    for (const std::string& name : names) {
        CAPTURE(name);
        const auto is_of_it = [&](const Mutant& m) {
            return m.what.starts_with("first block") &&
                   m.function.find("const " + name + "&") != std::string::npos;
        };
        CHECK(std::ranges::any_of(mutants, is_of_it));
    }
}
