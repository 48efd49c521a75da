#include "tests/bench/peers/sweep.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "lessons/catalogue.hpp"
#include "lessons/reader.hpp"
#include "tests/bench/peers/jointwise_runs.hpp"
#include "tests/bench/peers/read_scene.hpp"

namespace jw::peers {

namespace fs = std::filesystem;

void Run::at_sample(int k, const Vec3& point) {
    const double distance = (point - scene_->reference[static_cast<std::size_t>(k)]).norm();
    // NaN must not pass for a small error
    error_ = distance <= error_ ? error_ : distance;
    samples_ = k;
}

double Run::error() const {
    return complete() && std::isfinite(error_) ? error_ : std::numeric_limits<double>::infinity();
}

Outcome least_of_several(const std::function<Outcome()>& run) {
    constexpr int most = 5;
    constexpr double enough = 20.0;  // [ms]
    Outcome best = run();
    double spent = best.milliseconds;
    for (int k = 1; k < most && spent < enough; ++k) {
        const Outcome again = run();
        spent += again.milliseconds;
        if (again.milliseconds < best.milliseconds) { best = again; }
    }
    return best;
}

void Report::add(const std::string& method, const std::string& setting, const Outcome& outcome) {
    std::string remark = outcome.out_of_time ? "out of time" : outcome.remark;
    for (char& c : remark) {
        if (c == ',' || c == '\n' || c == '\r') { c = ' '; }
    }
    std::printf(
        "%s,%s,%s,%s,%.3f,%.3e,%ld,%.120s\n", peer_.c_str(), scene_->name.c_str(), method.c_str(),
        setting.c_str(), outcome.milliseconds, outcome.error, outcome.evaluations, remark.c_str());
    std::fflush(stdout);
    rows_.push_back({method + ' ' + setting, outcome.milliseconds, outcome.error});
}

void Report::print_best() const {
    std::fprintf(stderr, "%s %s\n", peer_.c_str(), scene_->name.c_str());
    for (const double level : {1e-3, 1e-6, 1e-9}) {
        const Row* best = nullptr;
        for (const Row& row : rows_) {
            if (row.error <= level && (best == nullptr || row.milliseconds < best->milliseconds)) {
                best = &row;
            }
        }
        if (best == nullptr) {
            std::fprintf(stderr, "  %.0e never\n", level);
        } else {
            std::fprintf(stderr, "  %.0e %10.2f ms  %s\n", level, best->milliseconds, best->how.c_str());
        }
    }
}

namespace {

fs::path reference_of(const fs::path& lesson) {
    return fs::path(JW_SOURCE_ROOT) / "lessons" / "reference" / (lesson.stem().string() + ".csv");
}

/// @return false if the file is no lesson
bool measure_file(const fs::path& file, bool named, double limit, const char* peer, const Measure& measure) {
    const ReadResult read = read_lesson_file(file);
    if (!read.lesson) {
        std::fprintf(stderr, "%s", read.report().c_str());
        return false;
    }
    std::string why_not;
    const auto scene = read_scene(*read.lesson, reference_of(file), why_not);
    if (scene) {
        Report report(peer, *scene);
        measure(*scene, limit, report);
        report.print_best();
        Report ours("jointwise", *scene);
        measure_jointwise(*read.lesson, *scene, limit, ours);
        ours.print_best();
    } else if (named) {
        std::fprintf(stderr, "%s: %s\n", file.string().c_str(), why_not.c_str());
    }
    return true;
}

}  // namespace

int for_every_scene(int count, char** arguments, const char* peer, const Measure& measure) {
    double limit = 5.0;
    std::vector<fs::path> files;
    for (int k = 1; k < count; ++k) {
        if (std::string(arguments[k]) == "--limit" && k + 1 < count) {
            limit = std::atof(arguments[++k]);
        } else {
            files.emplace_back(arguments[k]);
        }
    }
    const bool named = !files.empty();
    if (!named) { files = lessons_below(fs::path(JW_SOURCE_ROOT) / "lessons"); }
    std::printf("peer,scene,method,setting,cpu_ms,error,evaluations,remark\n");
    bool good = true;
    for (const fs::path& file : files) {
        if (named || fs::exists(reference_of(file))) {
            good &= measure_file(file, named, limit, peer, measure);
        }
    }
    return good ? 0 : 2;
}

}  // namespace jw::peers
