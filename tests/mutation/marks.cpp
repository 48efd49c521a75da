#include "tests/mutation/marks.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace jw::mutation {

namespace {

constexpr std::size_t kNone = std::string_view::npos;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

void blank(std::string& text, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < std::min(end, text.size()); ++k) {
        if (text[k] != '\n') { text[k] = ' '; }
    }
}

bool is_fixed_at_compile_time(std::string_view line) {
    const auto has = [&](std::string_view word) { return line.find(word) != kNone; };
    return line.starts_with("#") || line.starts_with("template <") || has("static_assert") ||
           (has("constexpr ") && !has("if constexpr "));
}

/// Source in which everything that is never marked is blank; offsets stay.
std::string code_of(std::string_view source) {
    std::string code(source);
    for (std::size_t k = 0; k < code.size(); ++k) {
        if (code.compare(k, 2, "//") == 0) { blank(code, k, code.find('\n', k)); }
        if (code[k] == '"') {
            const std::size_t end = code.find('"', k + 1);
            blank(code, k + 1, end);
            k = end;
        }
    }
    for (std::size_t k = 0; k < code.size();) {
        const std::size_t end = std::min(code.find('\n', k), code.size());
        if (is_fixed_at_compile_time(line_at(code, k))) { blank(code, k, end); }
        k = end + 1;
    }
    return code;
}

std::size_t after_spaces(const std::string& code, std::size_t at) {
    return std::min(code.find_first_not_of(" \n", at), code.size());
}

std::size_t after_word(const std::string& code, std::size_t at) {
    while (at < code.size() && is_word(code[at])) { ++at; }
    return at;
}

std::size_t after_number(const std::string& code, std::size_t at) {
    while (is_word(code[at]) || code[at] == '.' || (code[at] == '-' && code[at - 1] == 'e')) { ++at; }
    return at;
}

bool is_real(std::string_view number) { return number.find('.') != kNone; }

bool is_index(const std::string& code, std::size_t at) {
    return is_digit(code[at]) && !is_real(code.substr(at, after_number(code, at) - at));
}

struct Marker {
    std::string_view source;
    const std::string& code;
    std::vector<Mark>& marks;

    void number(std::size_t begin, std::size_t end) const {
        const std::string text = code.substr(begin, end - begin);
        if (is_real(text) && std::stod(text) != 0.0) { marks.push_back({Kind::number, begin, end}); }
    }

    /// @return where to go on
    std::size_t sign(std::size_t at) const {
        const char next = code[at + 1];
        if (next == code[at] || next == '>') { return at + 2; }  // ++, --, ->
        const std::size_t operand = after_spaces(code, at + (next == '=' ? 2 : 1));
        const bool is_name = at >= 8 && code.compare(at - 8, 8, "operator") == 0;
        const bool is_text = code[operand] == '"' || code[code.find_last_not_of(" \n", at - 1)] == '"';
        if (is_name || is_text || is_index(code, operand)) { return operand; }
        if (next == '=') {
            marks.push_back({Kind::value, operand, code.find(';', operand)});
        } else {
            marks.push_back({Kind::term, operand, operand});
        }
        return operand;
    }

    /// Assignments like `a.b(c) = d`, but not declarations: there a type stands before the name.
    void assigned(std::size_t line) const {
        const std::size_t begin = after_spaces(code, line);
        const std::size_t equals = std::min(code.find(" = ", begin), code.find(" =\n", begin));
        const std::size_t name = after_word(code, begin);
        const bool is_old = name == equals || code[name] == '.' || code[name] == '(' || code[name] == '[';
        if (equals >= code.find('\n', line) || name == begin || !is_old) { return; }
        const std::size_t value = after_spaces(code, equals + 2);
        const auto is = [&](std::string_view word) { return code.compare(value, word.size(), word) == 0; };
        const bool is_number = !is("0.0;") && !is("default;") && !is_index(code, value);
        if (code[value] == '{' || code[value] == '[' || !is_number) { return; }
        marks.push_back({Kind::value, value, code.find(';', value)});
    }

    /// @param at the bracket behind `if`, `while` or `for`; a loop over a range has no condition
    void condition(Kind kind, std::size_t at) const {
        int depth = 0;
        std::vector<std::size_t> ends{at};
        for (; at < code.size() && ends.size() < 4; ++at) {
            if (code[at] == '(') { ++depth; }
            if (code[at] == ')' && --depth == 0) { break; }
            if (code[at] == ';' && depth == 1) { ends.push_back(at); }
        }
        const bool is_counted = ends.size() == 3;
        if (is_counted) { at = ends[2]; }
        const bool is_range = ends.size() == 1 && code.compare(ends[0] - 4, 4, "for ") == 0;
        const std::size_t begin = after_spaces(code, ends[is_counted ? 1 : 0] + 1);
        if (!is_range && begin < at) { marks.push_back({kind, begin, at}); }
    }

    void branched(std::size_t word) const {
        const auto is = [&](std::string_view text) { return code.compare(word, text.size(), text) == 0; };
        if (is("if (")) { condition(Kind::branch, word + 3); }
        if (is("for (")) { condition(Kind::loop, word + 4); }
        if (is("while (")) { condition(Kind::loop, word + 6); }
    }

    void returned(std::size_t value, bool jets) const {
        if (code[value] == '(' && code[value + 1] != '-') {
            marks.push_back({Kind::term, value + 1, value + 1});
        }
        if (jets && head_at(source, value).find("Content K") != kNone) {
            marks.push_back({Kind::jet, value, code.find(';', value)});
        }
    }
};

struct Insertion {
    std::size_t at;
    std::string text;
};

void insert_calls(const Mark& mark, int mutant, std::vector<Insertion>& insertions) {
    const std::string number = std::to_string(mutant);
    const auto insert = [&](const std::string& before, const std::string& after) {
        insertions.push_back({mark.begin, "jw::mutation::" + before});
        insertions.push_back({mark.end, after});
    };
    switch (mark.kind) {
        case Kind::loop: insert("never(" + number + ", ", ")"); break;
        case Kind::branch: insert("otherwise(" + number + ", ", ")"); break;
        case Kind::jet: insert("jet(" + number + ", ", ")"); break;
        case Kind::value: insert("sign(" + number + ") * (", ")"); break;
        case Kind::term: insert("sign(" + number + ") * ", ""); break;
        case Kind::number: insert("number(" + number + ", ", ")"); break;
    }
}

}  // namespace

std::vector<Mark> marks_of(std::string_view source, const Besides& besides) {
    const std::string code = code_of(source);
    std::vector<Mark> marks;
    const Marker mark{source, code, marks};
    int brackets = 0;
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t begin = at++;
        if (code[begin] == '[') { ++brackets; }
        if (code[begin] == ']') { --brackets; }
        if (brackets > 0 && (code[begin] == '+' || code[begin] == '-')) { continue; }
        if (code[begin] == '\n' || code.compare(begin, 2, "{ ") == 0) { mark.assigned(at); }
        if (code[begin] == '+' || code[begin] == '-') { at = mark.sign(begin); }
        if (is_digit(code[begin])) {
            at = after_number(code, begin);
            mark.number(begin, at);
        } else if (is_word(code[begin])) {
            at = after_word(code, begin);
            if (code.compare(begin, 7, "return ") == 0) { mark.returned(begin + 7, besides.jets); }
            if (besides.branches) { mark.branched(begin); }
        }
    }
    std::ranges::stable_sort(marks, {}, [](const Mark& m) { return std::pair(m.begin, m.kind); });
    return marks;
}

std::string marked(std::string_view source, const std::vector<Mark>& marks, int first) {
    std::vector<Insertion> insertions;
    for (const Mark& mark : marks) {
        insert_calls(mark, first, insertions);
        first += mutants_of(mark.kind);
    }
    std::ranges::stable_sort(insertions, {}, &Insertion::at);
    std::string out;
    std::size_t done = 0;
    for (const Insertion& insertion : insertions) {
        out += source.substr(done, insertion.at - done);
        out += insertion.text;
        done = insertion.at;
    }
    out += source.substr(done);
    return out;
}

std::string line_at(std::string_view source, std::size_t at) {
    const std::size_t before = at == 0 ? kNone : source.rfind('\n', at - 1);
    const std::size_t begin = source.find_first_not_of(' ', before == kNone ? 0 : before + 1);
    if (begin == kNone) { return {}; }
    const std::size_t end = std::min(source.find('\n', begin), source.size());
    return std::string(source.substr(begin, end - begin));
}

int line_number_at(std::string_view source, std::size_t at) {
    return 1 + static_cast<int>(std::ranges::count(source.substr(0, at), '\n'));
}

std::string head_at(std::string_view source, std::size_t at) {
    const std::size_t block = source.rfind("\n}", at);
    const std::size_t begin = block == kNone ? 0 : source.find('\n', block + 1) + 1;
    const std::size_t end = std::min(source.find(" {\n", begin), at);
    std::istringstream lines{std::string(source.substr(begin, end - begin))};
    std::string head;
    for (std::string line; std::getline(lines, line);) {
        const std::string text = line_at(line, 0);
        if (text.empty()) { head.clear(); }
        if (!text.empty() && !text.starts_with("//")) { head += (head.empty() ? "" : " ") + text; }
    }
    return head;
}

}  // namespace jw::mutation
