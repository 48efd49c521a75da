#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "core/jets/drivers.hpp"

/// `mutated_tests` is the tests of derivatives, forces and linked trees as they are, compiled with sources
/// that can be wrong in one place at a time (marks.hpp); JW_MUTANT says in which.
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

bool passes(const std::string& number) {
    // a minute stands for an endless loop: all tests together take seconds
    const std::string command =
        "JW_MUTANT=" + number + " timeout 60 '" JW_MUTATED_TESTS "' --abort >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
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
        for (std::size_t k = next++; k < mutants.size(); k = next++) {
            survived[k] = passes(mutants[k].number);
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
