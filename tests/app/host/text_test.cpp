#include <catch2/catch.hpp>

#include <algorithm>

#include <imgui.h>

#include "app/session/story/timeline.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/lesson/in_language.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"
#include "tests/app/host/overprint.hpp"
#include "tests/app/host/person.hpp"
#include "tests/app/host/reach.hpp"
#include "tests/app/messages/in_language.hpp"

namespace jw::test {
namespace {

using host::Key;

struct Size {
    int width;
    int height;
};

// the last stands upright, with the units of the smallest phones
constexpr Size kSizes[] = {{900, 600}, {1280, 720}, {480, 800}};
constexpr float kTexts[] = {0.75F, 1.0F, 1.25F, 1.5F};

/// A lesson of every chapter, those with the longest texts and the largest matrices among them.
const std::vector<std::string>& lessons_looked_at() {
    static const std::vector<std::string> names{
        "vectors/perpendicular-vectors",
        "parallel/parallel-vectors",
        "joints/screw",
        "links/universal-spherical",
        "loops/four-bar",
        "loops/rssr",
        "loops/double-scott-russell",
        "hard/anti-parallel",
        "hard/cannot-close",
        "dynamics/four-bar-4",
        "dynamics/governor"};
    return names;
}

/// The first step of every kind, the last assembled one, and the middle of the motion.
std::vector<int> steps_looked_at(const Story& story) {
    std::vector<int> steps;
    std::vector<Step::Kind> seen;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        const Step::Kind kind = story.steps()[static_cast<std::size_t>(k)].kind;
        if (std::ranges::find(seen, kind) != seen.end()) { continue; }
        seen.push_back(kind);
        steps.push_back(k);
    }
    steps.push_back(story.last_assembled());
    steps.push_back((story.last_assembled() + last_step(story)) / 2);
    return steps;
}

/// A lesson of the catalogue with a text in Chinese beside each of its own, formulas as they are.
std::string in_chinese(const std::string& name) {
    static const std::string kWords =
        "剛體之間的拘束由點與軸構成，每一條拘束方程式都拿走一個自由度；雅可比矩陣的秩說明「還剩下」多少（見投"
        "影片）。";
    Lesson lesson = *read_lesson_file(catalogue_folder() / (name + ".toml")).lesson;
    for_each_text(lesson, [](Text& text) {
        std::string chinese;
        for (const math::TextPart& part : math::text_parts(text.own()).parts) {
            if (part.kind != math::TextPart::Kind::words) {
                chinese += " $\\Phi = 0$ ";
                continue;
            }
            // three bytes a character: as many bytes are about as wide as the English words
            const std::size_t bytes = part.words.size() / 6 * 3;
            for (std::size_t k = 0; k < bytes; k += kWords.size()) {
                chinese += kWords.substr(0, std::min(kWords.size(), bytes - k));
            }
        }
        if (!text.own().empty()) { text.translate("zh-Hant", chinese.empty() ? "剛體" : chinese); }
    });
    return lesson_text(lesson);
}

/// All that is wrong with the frame, in one text; empty if everything can be read.
std::string unreadable(Person& person) {
    // afterwards no message is shown and no camera turns
    person.rest();
    std::string text;
    std::size_t told = 0;
    for (const std::string& fault : unreadable_letters()) {
        if (++told <= 4) { text += fault + "\n"; }
    }
    return told > 4 ? text + std::to_string(told) + " letters in all\n" : text;
}

}  // namespace

TEST_CASE("Every letter of a lesson in Chinese can be read, at any size of text", "[text][chinese]") {
    const InLanguage chinese("zh-Hant");
    const TemporaryFolder folder;
    for (const char* name : {"loops/four-bar", "joints/screw", "parallel/two-imply-the-third"}) {
        const std::string file = folder.write("chinese.toml", in_chinese(name));
        for (const Size& size : kSizes) {
            for (const float text : kTexts) {
                Person person(file, Person::Pictures::none, size.width, size.height, false, text);
                for (const int step : steps_looked_at(person.session().story())) {
                    person.go_to(step);
                    CAPTURE(name, size.width, text, step);
                    CHECK(unreadable(person) == "");
                }
            }
        }
    }
}

TEST_CASE("Characters that the fonts lack are added between two frames", "[text][chinese]") {
    const TemporaryFolder folder;
    Person person("loops/four-bar.toml");
    const int before = person.host().fonts().version();
    CHECK(person.host().fonts().needed().empty());
    const InLanguage chinese("zh-Hant");
    REQUIRE(person.host().open(folder.write("chinese.toml", in_chinese("loops/four-bar"))));
    person.settle();
    CHECK(person.host().fonts().version() == before + 1);
    const ImFont& font = *person.host().fonts().fonts().title;
    CHECK(font.FindGlyphNoFallback(static_cast<ImWchar>(U'剛')) != nullptr);
    // a character that no font has is drawn as a box, not as a question mark
    CHECK(font.FallbackChar == 0xFFFD);
    CHECK(font.FindGlyphNoFallback(0xFFFD) != nullptr);
}

TEST_CASE("Every letter of every lesson can be read, at any size of text and of the window", "[text]") {
    for (const std::string& name : lessons_looked_at()) {
        for (const Size& size : kSizes) {
            for (const float text : kTexts) {
                Person person(name + ".toml", Person::Pictures::none, size.width, size.height, false, text);
                for (const int step : steps_looked_at(person.session().story())) {
                    person.go_to(step);
                    CAPTURE(name, size.width, text, step);
                    CHECK(unreadable(person) == "");
                }
            }
        }
    }
}

TEST_CASE("Every letter beside the picture can be read, at any size of text and of the window", "[text]") {
    for (const std::string name : {"loops/four-bar", "joints/screw", "dynamics/governor"}) {
        for (const Size& size : kSizes) {
            for (const float text : kTexts) {
                Person person(name + ".toml", Person::Pictures::none, size.width, size.height, false, text);
                person.go_to(person.session().story().last_assembled() + 2);
                for (const char tab : {'2', '3', '4', '5', '6', '7'}) {
                    person.type(std::string_view(&tab, 1));
                    CAPTURE(name, size.width, text, tab);
                    CHECK(unreadable(person) == "");
                }
            }
        }
    }
}

TEST_CASE("Every letter of the list, of the keys and of the menu can be read", "[text]") {
    for (const Size& size : kSizes) {
        for (const float text : kTexts) {
            Person person(
                "loops/four-bar.toml", Person::Pictures::none, size.width, size.height, false, text);
            CAPTURE(size.width, text);
            person.type("?");
            CHECK(unreadable(person) == "");
            person.press(Key::escape);
            person.type("g");
            CHECK(unreadable(person) == "");
            person.press(Key::escape);
            const host::WindowLayout& layout = person.host().layout();
            const auto right = static_cast<float>(size.width);
            const float y = layout.bar.bottom() - (layout.upright ? 0.3F : 0.6F) * layout.bar.height;
            person.click(layout.upright ? right - 30.0F : right - 1.125F * layout.bar.height, y);
            panels::Box menu;
            REQUIRE(open_popup(menu) != nullptr);
            CHECK(unreadable(person) == "");
            // the group with the most commands
            person.click(menu.x + 40.0F, menu.y + 0.75F * menu.height);
            CHECK(unreadable(person) == "");
        }
    }
}

TEST_CASE(
    "What is higher than its place scrolls by wheel, bar and keys, and begins anew at another step",
    "[text]") {
    Person person("joints/screw.toml", Person::Pictures::none, 900, 600, false, 1.5F);
    const auto& steps = person.session().story().steps();
    const auto equations =
        static_cast<int>(std::ranges::find(steps, Step::Kind::equations, &Step::kind) - steps.begin());
    person.go_to(equations);
    const panels::Box column = person.host().layout().column;
    const auto offset = [&] { return person.host().state().column.offset; };
    REQUIRE(offset() == 0.0F);
    person.point(column.centre().x, column.centre().y);
    person.wheel(-1.0F);
    const float notch = offset();
    CHECK(notch > 0.0F);
    person.wheel(-100.0F);
    const float most = offset();
    CHECK(most > notch);
    person.wheel(100.0F);
    CHECK(offset() == 0.0F);
    person.type("]");
    CHECK(offset() > 0.0F);
    person.type("[");
    CHECK(offset() == 0.0F);
    const float bar = column.right() - 5.0F;
    person.drag(bar, column.y + 20.0F, bar, column.bottom() - 2.0F);
    CHECK(offset() == most);
    // the drag has not turned the picture, and the step is the same
    CHECK(person.session().index() == equations);
    person.go_to(equations + 1);
    CHECK(offset() == 0.0F);
}

TEST_CASE("The list of keys scrolls where the window is low, and any other key closes it", "[text]") {
    Person person("loops/four-bar.toml", Person::Pictures::none, 900, 600, false, 1.5F);
    person.type("?");
    REQUIRE(person.host().state().help);
    person.press(Key::down);
    person.press(Key::page_down);
    CHECK(person.host().state().help);
    CHECK(unreadable(person) == "");
    person.press(Key::right);
    CHECK_FALSE(person.host().state().help);
}

}  // namespace jw::test
