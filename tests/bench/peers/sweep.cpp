#include "tests/bench/peers/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
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
        "%s,%s,%s,%s,%.3f,%.3e,%ld,%ld,%.120s\n", peer_.c_str(), scene_->name.c_str(), method.c_str(),
        setting.c_str(), outcome.milliseconds, outcome.error, outcome.evaluations, outcome.projections,
        remark.c_str());
    std::fflush(stdout);
    rows_.push_back(
        {method, setting, outcome.milliseconds, outcome.error, outcome.evaluations, outcome.projections,
         outcome.out_of_time});
}

namespace {

constexpr double kLevels[] = {1e-3, 1e-6, 1e-9};  // [m]

}  // namespace

void Report::print_best() const {
    std::fprintf(stderr, "%s %s\n", peer_.c_str(), scene_->name.c_str());
    for (const double level : kLevels) {
        const Row* best = nullptr;
        for (const Row& row : rows_) {
            if (row.error <= level && (best == nullptr || row.milliseconds < best->milliseconds)) {
                best = &row;
            }
        }
        if (best == nullptr) {
            std::fprintf(stderr, "  %.0e never\n", level);
        } else {
            std::fprintf(
                stderr, "  %.0e %10.2f ms  %s %s\n", level, best->milliseconds, best->method.c_str(),
                best->setting.c_str());
        }
    }
}

bool Report::is_kept(std::size_t row, double level) const {
    constexpr std::size_t looked_at = 4;
    const std::size_t end = std::min(rows_.size(), row + looked_at);
    for (std::size_t k = row; k < end && rows_[k].method == rows_[row].method; ++k) {
        // a run that took too long says nothing about the tolerance before it
        if (rows_[k].error > level && !(k > row && rows_[k].out_of_time)) { return false; }
    }
    return true;
}

const Report::Row* Report::fewest_at(double level) const {
    const Row* best = nullptr;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (is_kept(k, level) && (best == nullptr || rows_[k].evaluations < best->evaluations)) {
            best = &rows_[k];
        }
    }
    return best;
}

void Report::print_fewest_beside(const Report& ours) const {
    std::fprintf(
        stderr, "evaluations (and projections) on %s: %s; %s\n", scene_->name.c_str(), peer_.c_str(),
        ours.peer_.c_str());
    for (const double level : kLevels) {
        std::fprintf(stderr, "  %.0e", level);
        const Row* const both[] = {fewest_at(level), ours.fewest_at(level)};
        for (const Row* row : both) {
            if (row == nullptr) {
                std::fprintf(stderr, "    never;");
            } else {
                std::fprintf(
                    stderr, " %8ld (%ld) %.2f ms %s %s;", row->evaluations, row->projections,
                    row->milliseconds, row->method.c_str(), row->setting.c_str());
            }
        }
        if (both[0] != nullptr && both[1] != nullptr) {
            const auto count = [](const Row* row) { return static_cast<double>(row->evaluations); };
            std::fprintf(stderr, " %.2f of theirs", count(both[1]) / count(both[0]));
        }
        std::fprintf(stderr, "\n");
    }
}

namespace {

fs::path reference_of(const fs::path& lesson) {
    return fs::path(JW_SOURCE_ROOT) / "lessons" / "reference" / (lesson.stem().string() + ".csv");
}

/// @return false if the file is not a lesson
bool measure_file(
    const fs::path& file, bool named, double limit, const char* peer, const Measure& measure,
    Compared compared) {
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
        if (compared == Compared::evaluations) { report.print_fewest_beside(ours); }
    } else if (named) {
        std::fprintf(stderr, "%s: %s\n", file.string().c_str(), why_not.c_str());
    }
    return true;
}

}  // namespace

int for_every_scene(
    int count, char** arguments, const char* peer, const Measure& measure, Compared compared) {
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
    std::printf("peer,scene,method,setting,cpu_ms,error,evaluations,projections,remark\n");
    bool good = true;
    for (const fs::path& file : files) {
        if (named || fs::exists(reference_of(file))) {
            good &= measure_file(file, named, limit, peer, measure, compared);
        }
    }
    return good ? 0 : 2;
}

}  // namespace jw::peers
