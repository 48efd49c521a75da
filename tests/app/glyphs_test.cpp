#include <catch2/catch.hpp>

#include "app/commands/check/check_report.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/diagnostics/read_text.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/files/course.hpp"
#include "lessons/read/reader.hpp"
#include "render/fonts/fonts.hpp"
#include "tests/app/messages/in_language.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

TEST_CASE("every character of every shipped text has a glyph", "[app][glyphs]") {
    const auto check = [](const std::string& file, const std::vector<ReadText>& texts) {
        CHECK_FALSE(texts.empty());
        for (const Diagnostic& warning : warnings_about_texts(file, texts)) {
            CAPTURE(file, warning.message);
            CHECK(warning.code != Code::character);
        }
    };
    for (const auto& file : lessons_below(catalogue_folder())) {
        check(file.string(), read_lesson_file(file).texts);
    }
    for (const auto& file : exercise_files_of(catalogue_folder())) {
        check(file.string(), read_exercise_file(file).texts);
    }
    check(kCourseFile, read_course_of(catalogue_folder()).texts);
    // all messages at once, because every check searches all fonts
    std::string messages;
    for (const Language& language : languages()) {
        for (std::size_t k = 1; k < language.messages.size(); ++k) {
            messages += language.messages.translation(k);
        }
    }
    CHECK(messages.size() > 10000);
    CHECK(render::characters_without_glyph(panels::characters_in(messages)).empty());
}

TEST_CASE("every text of every shipped exercise is translated", "[app][glyphs]") {
    int texts = 0;
    for (const auto& file : exercise_files_of(catalogue_folder())) {
        const ExercisesRead read = read_exercise_file(file);
        texts += static_cast<int>(read.texts.size());
        for (const Diagnostic& warning : missing_translations(file.string(), read.texts)) {
            FAIL_CHECK(file.string() << ": " << warning.message);
        }
        CHECK(read.title.translations().contains("zh-Hant"));
    }
    CHECK(texts > 700);
}

TEST_CASE("the name of a language can be shown in it", "[app][glyphs]") {
    for (const Language& one : languages()) {
        const InLanguage shown(one.tag);
        const std::u32string known = panels::characters_of_messages();
        for (const char32_t c : panels::characters_in(one.name)) {
            CHECK(known.find(c) != std::u32string::npos);
        }
    }
}

TEST_CASE("check warns of what a language lacks and of characters that no font has", "[app][glyphs]") {
    const Folder folder;
    const std::string file = folder.file("lesson.toml", R"(format = 1
title = "t"
zh-Hant.title = "甲"
text = "An 😀 here."
[[body]]
name = "arm"
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]
[[expect]]
rank = 5
)");
    const Ran ran = run({"check", file});
    CHECK(ran.status == 0);
    CHECK_THAT(
        ran.err,
        Catch::Contains("lesson.toml:4:8: warning: 1 of 2 texts are not in zh-Hant: those of the lines 4;"));
    CHECK_THAT(ran.err, Catch::Contains("warning: no font has the characters '😀' (U+1F600)"));
}

TEST_CASE("lessons are told in the language that is asked for, and found by it", "[app][glyphs]") {
    const Folder folder;
    const std::string file = folder.file("lessons/lesson.toml", R"(format = 1
title = "An arm"
zh-Hant.title = "一支臂"
text = "It is held."
zh-Hant.text = "它被固定。"
[[body]]
name = "arm"
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]
)");
    const Ran english = run({"step", file, "--until", "0"});
    const Ran chinese = run({"--language", "zh-Hant", "step", file, "--until", "0"});
    set_language("en");
    CHECK_THAT(english.out, Catch::Contains("It is held."));
    CHECK_THAT(chinese.out, Catch::Contains("它被固定。"));
    CHECK(chinese.out.find("It is held.") == std::string::npos);
    for (const char* word : {"held", "固定"}) {
        CHECK_THAT(run({"list", folder.path("lessons"), word}).out, Catch::Contains("An arm"));
    }
}

}  // namespace jw::test
