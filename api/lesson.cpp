#include "jointwise/lesson.hpp"

#include "api/inside.hpp"
#include "api/inside_lesson.hpp"
#include "lessons/reader.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

std::vector<Mistake> mistakes_of(const jw::ReadResult& read) {
    std::vector<Mistake> mistakes;
    for (const jw::Diagnostic& d : read.diagnostics) {
        if (d.severity != jw::Severity::error) { continue; }
        const std::string code(jw::entry_of(d.code).printed);
        mistakes.push_back({d.file, d.span.line, d.span.column, code, d.message, d.hint});
    }
    return mistakes;
}

Lesson lesson_of(jw::ReadResult read) {
    if (!read.lesson) { throw LessonError(read.report(), mistakes_of(read)); }
    std::string warnings = read.diagnostics.empty() ? "" : read.report();
    return Lesson(std::make_shared<Lesson::Inside>(std::move(*read.lesson)), std::move(warnings));
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
    std::vector<double> times;
    if (!inside_->lesson.motion) { return times; }
    const jw::MotionPlan& plan = *inside_->lesson.motion;
    const double step = (plan.to - plan.from) / plan.steps;
    for (int k = 0; k < plan.steps; ++k) { times.push_back(plan.from + k * step); }
    times.push_back(plan.to);
    return times;
}

Lesson read_lesson(const std::filesystem::path& file) { return lesson_of(jw::read_lesson_file(file)); }

Lesson read_lesson_text(const std::string& toml, const std::string& name) {
    return lesson_of(jw::read_lesson(toml, name));
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
