#include <catch2/catch.hpp>

#include "lessons/diagnostics/read_text.hpp"
#include "lessons/files/search.hpp"
#include "lessons/lesson/in_language.hpp"
#include "lessons/text/text.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/lesson_difference.hpp"
#include "tests/lessons/random_lessons.hpp"
#include "tests/lessons/support.hpp"

using namespace jw;
using test::first_difference;
using test::lesson_of;

namespace {

/// A lesson that has every kind of text, each in English and in Chinese.
const std::string kBilingual = R"(format = 1
title = "A crank"
chapter = "loops"
text = """
A crank turns,
slowly.
"""
summary = "It turns."
motion = { to_s = 1 }
[zh-Hant]
title = "曲柄"
text = """
曲柄慢慢地
轉動。
"""
summary = "它轉動。"
[de]
title = "Eine Kurbel"
[[body]]
name = "crank"
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "crank"]
at = [0, 0, 0]
axis = [0, 0, 1]
text = "The hinge keeps $\\Phi = 0$."
zh-Hant.text = "鉸鏈保持 $\\Phi = 0$。"
[[driver]]
name = "motor"
joint = "hinge"
quantity = "angle"
polynomial_deg = [0, 90]
text = "It is driven."
zh-Hant.text = "它被驅動。"
[[step]]
at = "bodies"
text = "Free."
zh-Hant.text = "自由的。"
[[step]]
at_s = 0.5
text = "Half way."
zh-Hant.text = "一半。"
[[question]]
at = "hinge"
ask = "How many?"
choices = ["one", "five"]
answer = 2
why = "A hinge leaves one freedom."
zh-Hant.ask = "有幾個？"
zh-Hant.choices = ["一", "五"]
zh-Hant.why = "鉸鏈留下一個自由度。"
[[try]]
text = "Take it out."
do = ["drop hinge p1 x"]
zh-Hant.text = "把它拿掉。"
[[expect]]
after = "hinge"
rank = 5
why = "Five equations."
zh-Hant.why = "五個方程式。"
)";

std::vector<Diagnostic> diagnostics_of(const std::string& rest) {
    return read_lesson(test::with_two_bodies(rest), "test.toml").diagnostics;
}

const std::string kHingeInOneLanguage = R"([[joint]]
name = "hinge"
type = "revolute"
bodies = ["base", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]
text = "words"
)";

void check_says(const std::string& rest, Code code, const std::string& message) {
    CAPTURE(rest);
    std::string all;
    for (const Diagnostic& d : diagnostics_of(rest)) { all += to_string(d.code) + ' ' + d.message + '\n'; }
    CHECK_THAT(all, Catch::Contains(to_string(code) + ' ' + message));
}

}  // namespace

TEST_CASE("Every text of a lesson is shown in another language, and in its own again", "[languages]") {
    const Lesson english = lesson_of(kBilingual);
    const Lesson chinese = in_language(english, "zh-Hant");
    int texts = 0;
    for_each_text(chinese, [&](const Text& text) {
        if (text.own().empty()) { return; }
        ++texts;
        CAPTURE(text.own());
        CHECK(static_cast<unsigned char>(text[0]) >= 0x80);
        CHECK(text.own() != text);
    });
    CHECK(texts == 13);
    CHECK(chinese.text == "曲柄慢慢地\n轉動。");
    CHECK(std::get<ChoiceAnswer>(chinese.questions[0].answer).choices[1] == "五");
    const Lesson back = in_language(chinese, "");
    CHECK(back.title == "A crank");
    CHECK(first_difference(english, back) == "");
}

TEST_CASE(
    "A text that is not translated is shown as it is, and a wider tag is better than none", "[languages]") {
    const Lesson lesson = lesson_of(kBilingual);
    const Lesson german = in_language(lesson, "de");
    CHECK(german.title == "Eine Kurbel");
    CHECK(german.summary == "It turns.");
    CHECK(in_language(lesson, "zh-Hant-TW").title == "曲柄");
    for (const char* tag : {"", "en", "zh", "zh-Hans", "fr-CA"}) {
        CHECK(in_language(lesson, tag).title == "A crank");
    }
}

TEST_CASE(
    "A lesson keeps all of its languages when it is written, whichever is shown", "[languages][writing]") {
    const Lesson lesson = lesson_of(kBilingual);
    const std::string text = lesson_text(lesson);
    for (const char* tag : {"", "de", "zh-Hant"}) { CHECK(lesson_text(in_language(lesson, tag)) == text); }
    CHECK(first_difference(lesson, lesson_of(text)) == "");
}

TEST_CASE("Lessons with generated texts in many languages are written as they are", "[languages][writing]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        Lesson lesson = test::random_lesson(seed);
        int count = 0;
        for_each_text(lesson, [&](Text& text) {
            if (text.empty()) { return; }
            for (const char* tag : {"de", "pt-BR", "zh-Hant"}) {
                if (random.number(0.0, 1.0) < 0.4) { continue; }
                std::string other = "第 " + std::to_string(++count) + " 「句」\\ \"x\"";
                if (count % 3 == 0) { other += "\n兩行"; }
                text.translate(tag, other);
            }
        });
        const Lesson again = lesson_of(lesson_text(lesson));
        CHECK(first_difference(lesson, again) == "");
        CHECK(lesson_text(again) == lesson_text(lesson));
    }
}

TEST_CASE("Language tags are those of the standard, in its case", "[languages]") {
    for (const char* tag :
         {"de", "gsw", "zh-Hant", "pt-BR", "zh-Hant-TW", "es-419", "de-CH-1996", "sl-rozaj"}) {
        CHECK(is_language_tag(tag));
    }
    for (const char* text :
         {"", "d", "deutsch", "DE", "zh_Hant", "zh-hant", "pt-br", "zh-", "-de", "zh-Hant-"}) {
        CHECK_FALSE(is_language_tag(text));
    }
    CHECK(meant_language_tag("ZH_hant_tw") == "zh-Hant-TW");
    CHECK(meant_language_tag("Deutsch").empty());
}

TEST_CASE("What is wrong with a language is said", "[languages]") {
    check_says(
        kHingeInOneLanguage + "zh-Hant.txt = \"a\"", Code::unknown_key,
        "unknown key 'txt' in zh-Hant of revolute joint");
    check_says(
        kHingeInOneLanguage + "zh-Hant.axis = [0, 0, 1]", Code::unknown_key, "unknown key 'axis' in zh-Hant");
    check_says(
        kHingeInOneLanguage + "zh_Hant.text = \"a\"", Code::language_tag, "'zh_Hant' is not a language tag");
    check_says(
        kHingeInOneLanguage + "zh-hant.text = \"a\"", Code::language_tag, "'zh-hant' is not a language tag");
    check_says(kHingeInOneLanguage + "zh-Hant.text = \"$\\\\fraction$\"", Code::unreadable_formula, "");
    check_says(kHingeInOneLanguage + "zh-Hant.text = 3", Code::wrong_type, "'zh-Hant.text' is a number");
    check_says(kHingeInOneLanguage + "de = \"a\"", Code::unknown_key, "unknown key 'de'");
    check_says(
        kHingeInOneLanguage + "[[step]]\nat = \"hinge\"\ntext = \"a\"\n[zh-Hant]\nsummary = \"a\"",
        Code::lonely_key, "'zh-Hant.summary' without 'summary'");
    check_says(
        kHingeInOneLanguage +
            "[[question]]\nat = \"hinge\"\nask = \"a\"\nchoices = [\"a\", \"b\"]\nanswer = 1\n"
            "zh-Hant.choices = [\"甲\"]",
        Code::wrong_count, "'zh-Hant.choices' has 1 entries; expected 2");
}

TEST_CASE("Texts that a language lacks are counted, with their lines", "[languages]") {
    const auto warnings_of = [](const std::string& text) {
        return missing_translations("test.toml", read_lesson(text, "test.toml").texts);
    };
    const std::vector<Diagnostic> warnings = warnings_of(kBilingual);
    REQUIRE(warnings.size() == 1);
    // the title is translated; `why` of the claim is for authors
    CHECK_THAT(
        warnings[0].message, Catch::StartsWith("11 of 12 texts are not in de: those of the lines 4, 8, "));
    CHECK(warnings[0].severity == Severity::warning);
    CHECK(warnings[0].span.line == 4);
    CHECK(warnings_of(test::with_two_bodies(kHingeInOneLanguage)).empty());
}

TEST_CASE("A lesson is found by its words in every language", "[languages]") {
    const Searchable lesson = searchable_of(lesson_of(kBilingual), "crank.toml");
    for (const char* words : {"crank", "曲柄", "驅動", "kurbel", "slowly 慢慢"}) {
        CHECK(fits(lesson, words));
    }
    CHECK_FALSE(fits(lesson, "滑塊"));
}
