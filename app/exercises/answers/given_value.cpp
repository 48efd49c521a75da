#include "app/exercises/answers/given_value.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/exercises/answers/spelling.hpp"
#include "app/session/wording/messages.hpp"
#include "core/elementary/elementary.hpp"
#include "core/numerics/decimal.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

constexpr std::size_t kLongest = 20000;
constexpr std::size_t kMostEntries = 4096;
constexpr int kDeepest = 50;

/// Reason why an answer cannot be read.
class NotRead : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class GivenReader {
public:
    /// @param single  one number is expected: "2 pi" is a product
    GivenReader(std::string text, bool single) : text_(std::move(text)), single_(single) {}

    /// Rows of numbers; the text after them is not read.
    std::vector<std::vector<double>> rows() {
        skip();
        if (peek() == '[' || (peek() == '(' && (is_list(at_) || is_whole_answer()))) { return list(); }
        return loose_rows();
    }
    std::string_view rest() {
        skip();
        return std::string_view(text_).substr(at_);
    }

private:
    using Rows = std::vector<std::vector<double>>;

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip() {
        while (peek() == ' ' || peek() == '\n' || peek() == '\r') { ++at_; }
    }
    /// Takes blanks and `c` if `c` follows. Otherwise blanks stay: in a list they show where a number ends.
    bool take(char c) {
        const std::size_t before = at_;
        skip();
        const bool there = peek() == c;
        at_ = there ? at_ + 1 : before;
        return there;
    }
    [[noreturn]] void fail(const std::string& expected) const {
        const std::string_view rest = std::string_view(text_).substr(std::min(at_, text_.size()));
        throw NotRead(
            rest.empty() ? tr("the answer ends too early; expected {0}", expected)
                         : tr("cannot read {0}; expected {1}", in_quotes(rest), expected));
    }

    /// True if a parenthesis is a list: it has a comma or semicolon at its own depth, or begins with a list.
    bool is_list(std::size_t from, int deep = 0) const {
        if (deep > kDeepest) { return false; }
        const std::size_t first = text_.find_first_not_of(" \n\r", from + 1);
        if (first == std::string::npos) { return false; }
        if (text_[first] == '[' || (text_[first] == '(' && is_list(first, deep + 1))) { return true; }
        int depth = 0;
        for (std::size_t k = from; k < text_.size(); ++k) {
            if (text_[k] == '(' || text_[k] == '[') { ++depth; }
            if (text_[k] == ')' || text_[k] == ']') {
                if (--depth == 0) { return false; }
            }
            if (depth == 1 && (text_[k] == ',' || text_[k] == ';')) { return true; }
        }
        return false;
    }

    /// True if a parenthesis of several numbers is the whole answer, except for its unit: "(1 2 3) m".
    bool is_whole_answer() {
        int depth = 0;
        std::size_t k = at_;
        for (; k < text_.size(); ++k) {
            if (text_[k] == '(') { ++depth; }
            if (text_[k] == ')' && --depth == 0) { break; }
        }
        const std::size_t behind = text_.find_first_not_of(" \n\r", k + 1);
        if (single_ || behind == std::string::npos) { return !single_; }
        const std::size_t here = std::exchange(at_, behind);
        const bool unit = is_letter(peek()) && !starts_word();
        at_ = here;
        return unit;
    }

    /// [1, 2, 3], [[1, 2], [3, 4]], [1 2; 3 4]
    Rows list() {
        if (++depth_ > kDeepest) { fail(tr("fewer brackets")); }
        const char close = text_[at_++] == '[' ? ']' : ')';
        Rows rows;
        skip();
        if (peek() == '[' || (peek() == '(' && is_list(at_))) {
            while (!take(close)) {
                Rows inner = list();
                if (inner.size() != 1) { fail(tr("rows of numbers")); }
                rows.push_back(std::move(inner.front()));
                if (!take(',')) { take(';'); }
                skip();
                if (peek() == '\0') { fail(tr("a bracket that closes the list")); }
                if (peek() != close && peek() != '[' && peek() != '(') {
                    fail(tr("the next row in brackets"));
                }
            }
            --depth_;
            return rows;
        }
        rows = separated(close);
        if (!take(close)) { fail(std::string("'") + close + "'"); }
        --depth_;
        return rows;
    }

    /// Numbers up to a closing bracket or the end of the text; rows end with ';'.
    Rows separated(char close) {
        Rows rows(1);
        while (skip(), peek() != close && peek() != '\0') {
            rows.back().push_back(sum());
            if (++entries_ > kMostEntries) { fail(tr("at most {0} numbers", kMostEntries)); }
            skip();
            if (is_letter(peek()) && !starts_word()) {
                fail(tr("a comma or the closing bracket; write the unit once, after the list"));
            }
            if (take(',')) { continue; }
            if (take(';')) { rows.emplace_back(); }
        }
        if (rows.back().empty() && rows.size() > 1) { rows.pop_back(); }
        return rows;
    }

    /// Without brackets: one number, or several numbers separated by commas or blanks.
    Rows loose_rows() {
        Rows rows(1);
        rows.back().push_back(sum());
        for (;;) {
            skip();
            const bool comma = take(',');
            const bool semicolon = !comma && take(';');
            skip();
            const char c = peek();
            const bool number =
                (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '+' || c == '(' || starts_word();
            if (!number && (comma || semicolon)) { fail(tr("a number")); }
            if (!number) { return rows; }
            if (semicolon) { rows.emplace_back(); }
            rows.back().push_back(sum());
            if (++entries_ > kMostEntries) { fail(tr("at most {0} numbers", kMostEntries)); }
        }
    }

    /// True if a sign begins the next number of a list: "1 -2" is two numbers, "1 - 2" and "1-2" are one.
    bool begins_next() const {
        const bool before = at_ > 0 && text_[at_ - 1] == ' ';
        const bool after = at_ + 1 < text_.size() && text_[at_ + 1] == ' ';
        return before && !after;
    }

    double sum() {
        if (++depth_ > kDeepest) { fail(tr("fewer parentheses")); }
        double value = term();
        for (;;) {
            skip();
            const char c = peek();
            if ((c != '+' && c != '-') || (inside_ == 0 && begins_next())) { break; }
            ++at_;
            const double next = term();
            value += c == '+' ? next : -next;
        }
        --depth_;
        return value;
    }

    double term() {
        double value = factor();
        bool divided = false;
        for (;;) {
            const std::size_t behind = at_;
            skip();
            if (peek() == '*') {
                ++at_;
                value *= factor();
            } else if (starts_word() && (single_ || at_ == behind)) {
                if (divided) { fail(tr("a sign or parentheses: 1/2*pi or 1/(2*pi)")); }
                value *= factor();
            } else if (peek() == '/') {
                // in "3 /s", the slash belongs to the unit
                const std::size_t here = at_++;
                skip();
                const char c = peek();
                if (!((c >= '0' && c <= '9') || c == '(' || c == '.' || c == '-' || starts_word())) {
                    at_ = here;
                    return value;
                }
                value /= factor();
                divided = true;
            } else {
                return value;
            }
        }
    }

    static bool is_letter(char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80U;
    }

    bool starts_word() const {
        for (const std::string_view word :
             {"sqrt", "sin", "cos", "tan", "pi", "exp", "asin", "acos", "atan"}) {
            if (std::string_view(text_).substr(at_).starts_with(word)) { return true; }
        }
        return false;
    }

    double factor() {
        if (++depth_ > kDeepest) { fail(tr("fewer parentheses")); }
        skip();
        double value = 0.0;
        if (take('-')) {
            value = -factor();
        } else if (take('+')) {
            value = factor();
        } else {
            value = atom();
            if (take('^')) { value = elementary::pow(value, factor()); }
        }
        --depth_;
        return value;
    }

    double atom() {
        skip();
        if (take('(')) {
            ++inside_;
            const double value = sum();
            if (!take(')')) { fail("')'"); }
            --inside_;
            return value;
        }
        if (starts_word()) { return function(); }
        return number();
    }

    double number() {
        double value = 0.0;
        const char* const begin = text_.data() + at_;
        const auto [end, error] = read_decimal(begin, text_.data() + text_.size(), value);
        if (error != std::errc()) { fail(tr("a number, such as 0.5, 1/3 or sqrt(3)/2")); }
        at_ += static_cast<std::size_t>(end - begin);
        return value;
    }

    std::string word() {
        std::string found;
        while ((peek() >= 'a' && peek() <= 'z') || (!found.empty() && peek() == '2')) {
            found += text_[at_++];
        }
        return found;
    }

    double function() {
        const std::string name = word();
        if (name == "pi") { return std::numbers::pi; }
        if (!take('(')) { fail(tr("'(' after {0}", name)); }
        ++inside_;
        const double x = sum();
        const double second = take(',') ? sum() : 0.0;
        if (!take(')')) { fail("')'"); }
        --inside_;
        if (name == "sqrt") { return std::sqrt(x); }
        if (name == "sin") { return elementary::sin(x); }
        if (name == "cos") { return elementary::cos(x); }
        if (name == "tan") { return elementary::tan(x); }
        if (name == "asin") { return elementary::asin(x); }
        if (name == "acos") { return elementary::acos(x); }
        if (name == "atan") { return elementary::atan(x); }
        if (name == "atan2") { return elementary::atan2(x, second); }
        if (name == "exp") { return elementary::exp(x); }
        fail(tr("a function: sqrt, sin, cos, tan, asin, acos, atan, atan2 or exp"));
    }

    std::string text_;
    bool single_;
    std::size_t at_ = 0;
    std::size_t entries_ = 0;
    int depth_ = 0;
    int inside_ = 0;
};

MatrixX matrix_of(const std::vector<std::vector<double>>& rows) {
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    if (columns == 0) { throw NotRead(tr("there is no number in it; expected at least one")); }
    MatrixX m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        if (rows[r].size() != columns) {
            throw NotRead(
                tr("row {0} has {1} numbers, the first has {2}; expected rows of the same length", r + 1,
                   rows[r].size(), columns));
        }
        for (std::size_t c = 0; c < columns; ++c) {
            if (!std::isfinite(rows[r][c])) {
                throw NotRead(tr("it is not finite; expected finite numbers"));
            }
            m(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = rows[r][c];
        }
    }
    return m;
}

double factor_between(std::string_view given, std::string_view asked) {
    const std::optional<WrittenUnit> unit = read_unit(given);
    const std::optional<WrittenUnit> wanted = read_unit(asked);
    if (!unit) {
        throw NotRead(
            asked.empty() ? tr("cannot read {0}; expected nothing after the numbers", in_quotes(given))
                          : tr("cannot read {0}; expected the unit {1}", in_quotes(given), asked));
    }
    if (given.empty()) { return 1.0; }
    if (!wanted || unit->powers != wanted->powers) {
        throw NotRead(
            asked.empty() ? tr("the answer is a number without a unit; you wrote {0}", in_quotes(given))
                          : tr("the answer is in {0}; you wrote {1}", asked, in_quotes(given)));
    }
    return unit->factor / wanted->factor;
}

}  // namespace

GivenValue read_given_value(std::string_view text, std::string_view unit, std::ptrdiff_t entries) {
    GivenValue given;
    try {
        if (text.size() > kLongest) { throw NotRead(tr("it is longer than {0} bytes", kLongest)); }
        std::string spelt = with_signs_of_keyboard(text);
        if (spelt.find_first_not_of(" \n\r") == std::string::npos) {
            throw NotRead(tr("there is no answer"));
        }
        GivenReader reader(with_decimal_points(std::move(spelt), entries), entries == 1);
        given.value = matrix_of(reader.rows());
        std::string_view rest = reader.rest();
        while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\n' || rest.back() == '\r')) {
            rest.remove_suffix(1);
        }
        given.value *= factor_between(rest, unit);

    } catch (const NotRead& problem) { given.problem = problem.what(); }
    return given;
}

}  // namespace jw
