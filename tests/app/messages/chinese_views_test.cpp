#include <catch2/catch.hpp>

#include "app/session/output/describe.hpp"
#include "app/session/try/session.hpp"
#include "app/session/view/inspection.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/messages/english_in.hpp"
#include "tests/app/messages/in_language.hpp"

/// In Chinese a step shows no English sentence, except for names, formulas and the lesson's texts.
namespace jw {

namespace {

/// Chapters of the slides, and lessons that fail, are redundant, driven, or moved by forces.
constexpr std::array kFolders{"vectors",  "parallel", "joints", "orientation", "jacobians",
                              "analysis", "loops",    "hard",   "screws",      "links"};
constexpr std::array kSingleLessons{"dynamics/simple-pendulum", "dynamics/block-equation"};

/// The lesson without texts of its author: all that are left are the program's.
Lesson without_texts(Lesson lesson) {
    lesson.title = lesson.source = lesson.text = lesson.summary = "";
    lesson.step_texts.bodies = lesson.step_texts.motion = "";
    lesson.step_texts.times.clear();
    for (std::string& text : lesson.step_texts.joints) { text.clear(); }
    for (std::string& text : lesson.step_texts.drivers) { text.clear(); }
    lesson.questions.clear();
    return lesson;
}

std::string without(std::string text, const std::string& name) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
        text.replace(at, name.size(), "·");
    }
    return text;
}

std::string without_names(std::string text, const Mechanism& mechanism) {
    for (const Body& body : mechanism.bodies) {
        if (body.name.size() > 1) { text = without(text, body.name); }
    }
    for (const Joint& joint : mechanism.joints) {
        if (joint.name.size() > 1) { text = without(text, joint.name); }
    }
    for (const Driver& driver : mechanism.drivers) {
        if (driver.name.size() > 1) { text = without(text, driver.name); }
    }
    return text;
}

std::vector<std::filesystem::path> files() {
    std::vector<std::filesystem::path> all;
    for (const char* folder : kFolders) {
        const auto below = lessons_below(catalogue_folder() / folder);
        all.insert(all.end(), below.begin(), below.end());
    }
    for (const char* lesson : kSingleLessons) {
        all.push_back(catalogue_folder() / (std::string(lesson) + ".toml"));
    }
    return all;
}

/// Every step before the motion, and a few of the motion.
std::vector<int> steps_of(const Story& story) {
    std::vector<int> steps;
    const auto count = static_cast<int>(story.steps().size());
    for (int k = 0; k < count; ++k) {
        const bool moves = story.steps()[static_cast<std::size_t>(k)].kind == Step::Kind::motion;
        if (!moves || k % 25 == 0 || k + 1 == count) { steps.push_back(k); }
    }
    return steps;
}

}  // namespace

TEST_CASE("No English sentence is left in the steps of a lesson told in Chinese", "[messages]") {
    const test::InLanguage chinese("zh-Hant");
    int looked_at = 0;
    for (const std::filesystem::path& file : files()) {
        const ReadResult read = read_lesson_file(file);
        REQUIRE(read.lesson);
        const Lesson lesson = without_texts(*read.lesson);
        const Story story(lesson);
        for (const int step : steps_of(story)) {
            const std::string text = without_names(describe(view_of(story, step)), lesson.mechanism);
            CAPTURE(file.string(), step, text);
            CHECK(test::english_in(text) == "");
            ++looked_at;
        }
    }
    CHECK(looked_at > 200);
}

TEST_CASE("No English sentence is left in a step that is inspected in Chinese", "[messages]") {
    const test::InLanguage chinese("zh-Hant");
    for (const char* name : {"loops/four-bar", "joints/screw", "dynamics/simple-pendulum"}) {
        const ReadResult read = read_lesson_file(catalogue_folder() / (std::string(name) + ".toml"));
        REQUIRE(read.lesson);
        const Lesson lesson = without_texts(*read.lesson);
        const Story story(lesson);
        for (const int step : {story.last_assembled(), static_cast<int>(story.steps().size()) - 1}) {
            const Inspection inspection = inspect_step(story, step, lesson.coordinates);
            const std::string text = without_names(describe(inspection, lesson), lesson.mechanism);
            CAPTURE(name, step, text);
            CHECK(test::english_in(text) == "");
        }
    }
}

TEST_CASE("A session tells its step in the language that was chosen since, and back", "[messages]") {
    const ReadResult read = read_lesson_file(catalogue_folder() / "loops" / "four-bar.toml");
    REQUIRE(read.lesson);
    Session session(*read.lesson);
    session.apply(GoTo{session.story().last_assembled()});
    const int index = session.index();
    const std::string english = session.view().sentence;
    {
        const test::InLanguage chinese("zh-Hant");
        session.tell_again();
        CHECK(session.index() == index);
        CHECK(session.view().sentence != english);
    }
    session.tell_again();
    CHECK(session.index() == index);
    CHECK(session.view().sentence == english);
}

TEST_CASE("The finder of English sentences finds one", "[messages]") {
    CHECK(test::english_in("θ = 1：the rank grows by 2") == "the rank grows");
    CHECK(test::english_in("接頭 A · p1 · x 與 rad s") == "");
}

}  // namespace jw
