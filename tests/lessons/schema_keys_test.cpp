#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "lessons/asked_keys.hpp"
#include "lessons/catalogue.hpp"
#include "lessons/schema/keys.hpp"
#include "tests/lessons/support.hpp"

using namespace jw;

namespace {

/// Keys that no shipped and no wrong lesson makes the reader ask for in their own way.
constexpr const char* kRareKeys = R"(
[[body]]
name = "slide"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = "thread"
type = "screw"
bodies = ["ground", "slide"]
at = [0, 0, 0]
axis = [0, 0, 1]
pitch = 0.1
theta_deg = 0
[[driver]]
name = "lift"
quantity = "thread.displacement"
harmonics = { amplitude = 0.1, frequency_hz = 1 }
step = { from = 0, to = 0.1, end_s = 1 }
[[torque]]
body = "slide"
direction = [0, 0, 1]
polynomial = [1]
harmonics = [{ amplitude = 1, omega_rad_per_s = 1, phase_deg = 90 }, { amplitude = 1, frequency_hz = 1 }]
step = { from = 0, to = 1, start_s = 0, end_s = 1 }
[[force]]
body = "slide"
direction = [0, 0, 1]
harmonics = [{ amplitude = 1, omega_rad_per_s = 1, phase_deg = 90 }, { amplitude = 1, frequency_hz = 1 }]
step = { from = 0, to = 1, start_s = 0, end_s = 1 }
[[rotational_spring]]
joint = "thread"
stiffness = 1
free_angle_deg = 10
[dynamics]
duration = 1
[[question]]
at = "motion"
ask = "How far?"
quantity = "thread.displacement"
at_s = 1
tolerance = 0.1
[[question]]
at = "motion"
ask = "Where?"
quantity = "slide.point.x"
point = [0, 0, 1]
at_s = 1
tolerance = 0.1
[precision]
digits = 4
)";

/// A question about an angle or one of its derivatives.
std::string question_about(const std::string& quantity, const std::string& ending) {
    return "[[question]]\nat = \"motion\"\nask = \"?\"\nquantity = \"" + quantity +
           "\"\nat_s = 1\ntolerance" + ending + " = 1\n";
}

/// A lesson with the keys that are rare.
std::string rare_lesson() {
    std::string lesson = "format = 1\ntitle = \"t\"" + std::string(kRareKeys);
    const std::map<std::string, std::string> rates{{"", ""}, {"_dot", "_per_s"}, {"_ddot", "_per_s2"}};
    for (const auto& [dot, per] : rates) {
        for (const char* unit : {"_deg", "_rad"}) {
            lesson += question_about("thread.angle" + dot, unit + per);
        }
    }
    return lesson;
}

/// Lessons of wrong_lessons.txt without what is said of them; what the base lesson has is missing.
std::vector<std::string> wrong_fragments() {
    std::istringstream lines(test::text_of_file("tests/lessons/wrong_lessons.txt"));
    std::vector<std::string> lessons;
    std::string base;
    bool in_lesson = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("--- ")) {
            if (lessons.size() == 1 && line == "--- says") { base = lessons.front(); }
            in_lesson = line != "--- says";
            if (in_lesson) { lessons.push_back(line == "--- whole" ? "" : base); }
        } else if (in_lesson) {
            lessons.back() += line + '\n';
        }
    }
    return lessons;
}

/// Everything that the reader asks for in right and wrong lessons.
std::set<AskedKey> all_asked() {
    const AskedKeys asked;
    for (const auto& file : lessons_below(catalogue_folder())) { read_lesson_file(file); }
    for (const std::string& lesson : wrong_fragments()) { read_lesson(lesson, "wrong.toml"); }
    for (const std::string& lesson : test::documented_toml()) { read_lesson(lesson, "page.toml"); }
    const ReadResult rare = read_lesson(rare_lesson(), "rare.toml");
    INFO(rare.report());
    REQUIRE(rare.lesson.has_value());
    return asked.all();
}

/// The access that reads a key of a kind, first, and those that it is made of or that may look first.
std::vector<std::string> accesses_of(KeyKind kind) {
    switch (kind) {
        case KeyKind::text: return {"text", "word"};  // a word of its own may be read as one
        case KeyKind::words: return {"words"};
        case KeyKind::plain_words: return {"plain words"};
        case KeyKind::list_of_words: return {"list of words"};
        case KeyKind::formula: return {"formula", "text"};
        case KeyKind::word: return {"word", "text"};
        case KeyKind::number: return {"number"};
        case KeyKind::positive: return {"positive", "number"};
        case KeyKind::not_negative: return {"not negative", "number"};
        case KeyKind::whole_number: return {"whole number"};
        case KeyKind::flag: return {"flag"};
        case KeyKind::vector: return {"vector", "numbers"};
        case KeyKind::direction: return {"direction", "vector", "numbers"};
        case KeyKind::numbers: return {"numbers"};
        case KeyKind::tensor: return {"matrix", "numbers"};
        case KeyKind::texts: return {"texts"};
        case KeyKind::table: return {"table"};
        case KeyKind::tables: return {"tables"};
        case KeyKind::any: return {"known"};
    }
    return {};
}

/// Keys of the schema by the path of their table and their name.
using Declared = std::map<std::pair<std::string, std::string>, Key>;

void declare(
    const std::vector<KeyTable>& tables, const std::string& name, const std::string& path,
    Declared& declared) {
    const auto table = std::ranges::find(tables, name, &KeyTable::name);
    INFO(name);
    REQUIRE(table != tables.end());
    for (const Key& key : table->keys) {
        CAPTURE(path, key.name);
        CHECK(declared.emplace(std::pair(path, key.name), key).second);
        CHECK_FALSE(key.about.empty());
        if (!key.table.empty()) {
            declare(tables, key.table, path.empty() ? key.name : path + '.' + key.name, declared);
        }
    }
}

Declared all_declared() {
    const std::vector<KeyTable> tables = key_tables();
    Declared declared;
    declare(tables, tables.front().name, "", declared);
    return declared;
}

void check_asked(const AskedKey& asked, const Key& key) {
    CAPTURE(asked.table, asked.key, asked.as);
    const std::vector<std::string> accesses = accesses_of(key.kind);
    CHECK((asked.as == "known" || std::ranges::find(accesses, asked.as) != accesses.end()));
    for (const std::string& word : asked.words) {
        CAPTURE(word);
        CHECK(std::ranges::find(key.words, word) != key.words.end());
    }
    // the reader takes any number for a format, to say which one it is
    if (asked.as != "whole number" || asked.key == "format") { return; }
    CHECK(key.least <= asked.least);
    CHECK(key.most >= asked.most);
}

}  // namespace

TEST_CASE("Whatever key the reader asks for is in the schema, with its type, words and range", "[schema]") {
    const Declared declared = all_declared();
    const std::set<AskedKey> asked = all_asked();
    CHECK(asked.size() > declared.size());
    for (const AskedKey& one : asked) {
        CAPTURE(one.table, one.key);
        const auto found = declared.find({one.table, one.key});
        CHECK(found != declared.end());
        if (found != declared.end()) { check_asked(one, found->second); }
    }
}

TEST_CASE("Whatever key is in the schema the reader asks for, as the schema says", "[schema]") {
    const std::set<AskedKey> asked = all_asked();
    for (const auto& [place, key] : all_declared()) {
        CAPTURE(place.first, place.second);
        const std::string as = accesses_of(key.kind).front();
        const auto is_key = [&, &table = place.first, &name = place.second](const AskedKey& one) {
            return one.table == table && one.key == name && one.as == as;
        };
        CHECK(std::ranges::any_of(asked, is_key));
    }
}

TEST_CASE("Nothing is noted where nobody listens, and reading is the same", "[schema]") {
    const std::string lesson = rare_lesson();
    const std::string before = read_lesson(lesson, "rare.toml").report();
    {
        const AskedKeys asked;
        CHECK(read_lesson(lesson, "rare.toml").report() == before);
        CHECK_FALSE(asked.all().empty());
    }
    CHECK(AskedKeys::listening() == nullptr);
}
