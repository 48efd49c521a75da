#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/output/json.hpp"
#include "app/session/story/story_telling.hpp"
#include "app/session/view/inspection.hpp"

namespace jw {

namespace {

struct StepOptions {
    std::string file;
    std::vector<std::string> experiments;
    int until = -1;
    std::string format;
};

constexpr int kWidth = 100;
/// Number of moments of the motion in the text; the JSON has all of them.
constexpr int kMoments = 9;

/// The steps in the text: everything before the motion, and some moments of it.
std::vector<int> told_steps(const Story& story, int until) {
    std::vector<int> all;
    std::vector<int> motion;
    for (int k = 0; k <= until; ++k) {
        (story.steps()[static_cast<std::size_t>(k)].kind == Step::Kind::motion ? motion : all).push_back(k);
    }
    const int count = static_cast<int>(motion.size());
    for (int k = 0; k < kMoments && count > 0; ++k) {
        const int index = motion[static_cast<std::size_t>(k * (count - 1) / (kMoments - 1))];
        if (all.empty() || all.back() != index) { all.push_back(index); }
    }
    return all;
}

Exit step(const StepOptions& options, const Streams& streams) {
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    const Lesson& lesson = changed.lesson;
    ProgressBar bar(streams, "telling the lesson");
    StoryOptions how;
    how.last_step = options.until;
    StoryTelling telling(lesson, how);
    while (telling.go_on()) { bar.show(telling.progress()); }
    const Story story = telling.story();
    const int last = static_cast<int>(story.steps().size()) - 1;
    const int until = options.until < 0 ? last : options.until;
    check_step("--until", until, last);
    const Exit exit = story.failure() != nullptr && until == last ? Exit::numerics : Exit::done;
    if (exit == Exit::numerics) { streams.err << not_reached(lesson, *story.failure()).what() << '\n'; }
    if (options.format == "json") {
        streams.out << document_of(json_of(story, until), changed.done);
        return exit;
    }
    streams.out << lesson.title << '\n';
    if (!lesson.source.empty()) { streams.out << lesson.source << '\n'; }
    streams.out << done_text(changed.done) << '\n';
    for (const int k : told_steps(story, until)) {
        streams.out << describe(view_of(story, k, ViewParts::without_matrix), kWidth) << '\n';
    }
    return exit;
}

}  // namespace

void add_step(const CommandLine& line) {
    auto [command, options] = add_command<StepOptions>(
        line, "step", "show the steps of a lesson, joint by joint", step,
        "Example: jointwise step lessons/catalogue/loops/four-bar.toml --until 12");
    add_lesson_options(command, options.file, options.experiments);
    add_value(command, "--until", options.until, "N", "last step to show")->check(&fault_of_step);
    add_format_option(command, options.format, {"text", "json"});
}

}  // namespace jw
