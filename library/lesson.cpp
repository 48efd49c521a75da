#include "jointwise/lesson.hpp"

#include "lessons/read/reader.hpp"
#include "library/inside.hpp"
#include "library/inside_lesson.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

std::vector<Mistake> mistakes_of(const jw::ReadResult& read) {
    std::vector<Mistake> mistakes;
    for (const jw::Diagnostic& d : read.diagnostics) {
        if (d.severity != jw::Severity::error) { continue; }
        const std::string code = to_string(d.code);
        mistakes.push_back({d.file, d.span.line, d.span.column, code, d.message, d.hint});
    }
    return mistakes;
}

Lesson lesson_of(jw::ReadResult read) {
    if (!read.lesson) { throw LessonError(read.report(), mistakes_of(read)); }
    std::string warnings = read.diagnostics.empty() ? "" : read.report();
    return Lesson(std::make_shared<Lesson::Inside>(std::move(*read.lesson)), std::move(warnings));
}

/// Intervals between the times of a simulation, as the program uses by default.
constexpr int kIntervals = 100;

std::vector<double> equal_times(double from, double to, int intervals) {
    std::vector<double> times;
    const double step = (to - from) / intervals;
    for (int k = 0; k < intervals; ++k) { times.push_back(from + k * step); }
    times.push_back(to);
    return times;
}

Mechanism mechanism_of(const jw::Lesson& lesson) {
    Mechanism::Inside inside{lesson.mechanism, {}};
    if (lesson.dynamics) { inside.loads = lesson.dynamics->loads; }
    return Mechanism(inside);
}

}  // namespace

Lesson::Lesson(std::shared_ptr<const Inside> inside, std::string warnings)
    : inside_(std::move(inside)),
      mechanism_(mechanism_of(inside_->lesson)),
      title_(inside_->lesson.title),
      text_(inside_->lesson.text),
      warnings_(std::move(warnings)) {}

std::vector<double> Lesson::motion_times() const {
    if (!inside_->lesson.motion) { return {}; }
    const jw::MotionPlan& plan = *inside_->lesson.motion;
    return equal_times(plan.from, plan.to, plan.steps);
}

std::vector<double> Lesson::simulation_times() const {
    if (!inside_->lesson.dynamics) { return {}; }
    return equal_times(0.0, inside_->lesson.dynamics->duration, kIntervals);
}

Simulation Lesson::simulation() const {
    Simulation simulation;
    if (!inside_->lesson.dynamics) { return simulation; }
    const jw::SimulationSettings& settings = inside_->lesson.dynamics->settings;
    simulation.method = jw::entry_of(settings.method).name;
    simulation.tolerance = settings.tolerance;
    simulation.step = settings.step;
    return simulation;
}

Lesson read_lesson(const std::filesystem::path& file) { return lesson_of(jw::read_lesson_file(file)); }

Lesson read_lesson_text(const std::string& toml, const std::string& name) {
    return lesson_of(jw::read_lesson(toml, name));
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
