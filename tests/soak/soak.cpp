#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/soak/runner.hpp"

/// jointwise_soak [MINUTES] [--seed N] [--count N] [--only PROPERTY] [--out FOLDER] [--again FILE]:
/// properties of generated mechanisms, round after round with a new seed, until the time is over.
/// Counterexamples become lesson files. Status 1 if there is any.
namespace jw::test {

namespace {

struct Options {
    double minutes = 1.0;
    std::uint64_t seed = 1;
    int count = 100;
    std::string only;
    std::filesystem::path out = "soak-findings";
    std::vector<std::filesystem::path> again;
};

struct Totals {
    long held = 0;
    std::map<std::string, long> not_asked;
    int wrong = 0;
};

void usage() {
    std::cerr << "usage: soak [MINUTES] [--seed N] [--count N] [--only PROPERTY] [--out FOLDER]\n"
                 "       soak --again FILE...\n"
                 "  MINUTES  how long (1); rounds that have begun are finished\n"
                 "  --seed   of the first round (1); the next one adds 1\n"
                 "  --count  mechanisms of a round (100)\n"
                 "  --out    folder of counterexamples (soak-findings)\n"
                 "  --again  asks counterexamples that were written before once more\n"
                 "properties:\n";
    for (const Property& property : properties()) {
        std::cerr << "  " << property.name << ": " << property.says << '\n';
    }
}

/// @return false if the arguments are not valid
bool read(int count, char** arguments, Options& options) {
    for (int k = 1; k < count; ++k) {
        const std::string name = arguments[k];
        const bool has_value = k + 1 < count;
        if (!name.starts_with("--")) {
            char* end = nullptr;
            options.minutes = std::strtod(name.c_str(), &end);
            if (end == name.c_str() || *end != '\0' || !(options.minutes > 0.0)) { return false; }
            continue;
        }
        if (!has_value) { return false; }
        if (name == "--again") {
            options.again.assign(arguments + k + 1, arguments + count);
            return true;
        }
        const std::string value = arguments[++k];
        if (name == "--seed") {
            options.seed = std::strtoull(value.c_str(), nullptr, 10);
        } else if (name == "--count") {
            options.count = std::atoi(value.c_str());
        } else if (name == "--only") {
            options.only = value;
        } else if (name == "--out") {
            options.out = value;
        } else {
            return false;
        }
    }
    const auto known = [&](const Property& property) { return property.name == options.only; };
    return options.count > 0 && (options.only.empty() || std::ranges::any_of(properties(), known));
}

void write(
    const Property& property, const Options& options, const Asked& asked, const Counterexample& wrong) {
    std::filesystem::create_directories(options.out);
    const std::string name = property.name + '-' + std::to_string(asked.seed);
    const auto path = options.out / (name + ".toml");
    std::cout << "  WRONG: " << wrong.why << '\n';
    try {
        std::ofstream(path) << lesson_text_of(property, asked, wrong);
        std::cout << "  made smaller from " << wrong.parts_before << " parts: " << path.string() << '\n';
    } catch (const std::exception& error) {
        std::ofstream(options.out / (name + ".txt")) << wrong.recipe << error.what() << '\n';
        std::cout << "  no lesson can say it: " << error.what() << '\n' << wrong.recipe;
    }
}

void round(const Property& property, const Options& options, std::uint64_t seed, Totals& totals) {
    Asked asked;
    asked.count = options.count;
    asked.seed = seed;
    const Answer answer = ask(property, asked);
    totals.held += answer.held;
    for (const auto& [why, count] : answer.not_asked) { totals.not_asked[why] += count; }
    if (!answer.wrong) { return; }
    ++totals.wrong;
    std::cout << property.name << ", seed " << seed << ", after " << answer.held << ":\n";
    write(property, options, asked, *answer.wrong);
    std::cout.flush();
}

int soak(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const auto minutes = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 60.0;
    };
    std::map<std::string, Totals> totals;
    std::uint64_t seed = options.seed;
    for (; minutes() < options.minutes; ++seed) {
        for (const Property& property : properties()) {
            if (!options.only.empty() && property.name != options.only) { continue; }
            round(property, options, seed, totals[property.name]);
        }
    }
    int wrong = 0;
    std::cout << "seeds " << options.seed << " to " << seed - 1 << ", " << options.count
              << " mechanisms each\n";
    for (const auto& [name, total] : totals) {
        std::cout << name << ": " << total.held << " held, " << total.wrong << " counterexamples\n";
        for (const auto& [why, count] : total.not_asked) {
            std::cout << "  not asked of " << count << ": " << why << '\n';
        }
        wrong += total.wrong;
    }
    return wrong == 0 ? 0 : 1;
}

/// @return status 1 if one of them still does not hold
int ask_again(const std::vector<std::filesystem::path>& files) {
    bool all_hold = true;
    for (const auto& path : files) {
        const WrittenDown written = read_counterexample(path);
        const auto property = std::ranges::find(properties(), written.property, &Property::name);
        if (property == properties().end()) { throw std::runtime_error("no property " + written.property); }
        const Verdict verdict = ask_of(*property, written.recipe);
        const bool held = verdict.kind == Verdict::Kind::holds;
        all_hold = all_hold && held;
        std::cout << path.string() << ": " << (held ? "holds" : verdict.why) << std::endl;
    }
    return all_hold ? 0 : 1;
}

}  // namespace

}  // namespace jw::test

int main(int count, char** arguments) {
    jw::test::Options options;
    if (!jw::test::read(count, arguments, options)) {
        jw::test::usage();
        return 2;
    }
    try {
        return options.again.empty() ? jw::test::soak(options) : jw::test::ask_again(options.again);
    } catch (const std::exception& error) {
        std::cerr << "soak: error: " << error.what() << '\n';
        return 2;
    }
}
