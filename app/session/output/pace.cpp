#include "app/session/output/pace.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "app/session/wording/text_width.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

constexpr double kSecondsToLook = 1.5;
// 260 words a minute, for an attentive reader; whoever needs longer can pause
constexpr double kSecondsPerWord = 60.0 / 260.0;
constexpr double kLongestStill = 10.0;

int words_of(const std::string& text) {
    const std::string plain = math::plain_words(text);
    std::istringstream words(plain);
    // Chinese has no blanks: two characters count as one word
    const auto wide = std::ranges::count_if(from_utf8(plain), is_wide);
    return static_cast<int>(std::distance(std::istream_iterator<std::string>(words), {}) + wide / 2);
}

/// Words of a question and its answer: at the answer, all is read again, which leaves time to think.
int words_of(const QuestionView& question) {
    int words = words_of(question.ask) + words_of(question.answer) + words_of(question.why);
    for (const std::string& choice : question.choices) { words += words_of(choice); }
    return words;
}

}  // namespace

double seconds_to_look(const View& view, double moment) {
    if (view.kind == Step::Kind::motion) { return moment; }
    if (view.kind == Step::Kind::iteration) { return kSecondsToLook; }
    // after assembly, the author's text is the one that was already shown with the equations
    const bool is_new = view.kind != Step::Kind::assembled;
    const int asked = view.question ? words_of(*view.question) : 0;
    const int words = words_of(view.sentence) + (is_new ? words_of(view.author_text) : 0) + asked;
    return std::min(kLongestStill, kSecondsToLook + kSecondsPerWord * words);
}

double seconds_of_step(const Story& story, const View& view) {
    const auto moments = std::ranges::count(story.steps(), Step::Kind::motion, &Step::kind);
    const std::optional<MotionPlan> motion = shown_motion(story.lesson());
    const double duration = motion ? motion->duration : 0.0;
    return seconds_to_look(view, moments > 1 ? duration / static_cast<double>(moments - 1) : duration);
}

}  // namespace jw
