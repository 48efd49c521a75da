#include "lessons/diagnostics/text_place.hpp"

#include <cctype>
#include <string>

#include "lessons/text/utf8.hpp"

namespace jw {

namespace {

/// A position in the file, with its line and column.
class Cursor {
public:
    explicit Cursor(std::string_view source) : source_(source) {}

    bool at_end() const { return at_ >= source_.size(); }
    bool starts_with(std::string_view text) const { return source_.substr(at_).starts_with(text); }
    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
    }
    int line() const { return line_; }
    int column() const { return column_; }

    void step() {
        if (at_end()) { return; }
        if (source_[at_] == '\n') {
            ++line_;
            column_ = 1;
        } else if (starts_character(source_[at_])) {
            ++column_;
        }
        ++at_;
    }
    /// Goes on to a line and column.
    void reach(const SourceSpan& place) {
        while (!at_end() && line_ < place.line) { step(); }
        while (!at_end() && line_ == place.line && column_ < place.column) { step(); }
    }
    void step(std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) { step(); }
    }
    std::string_view ahead(std::size_t from, std::size_t count) const {
        return source_.substr(at_ + from, count);
    }

private:
    std::string_view source_;
    std::size_t at_ = 0;
    int line_ = 1;
    int column_ = 1;
};

/// Bytes of a code point in UTF-8.
std::size_t bytes_of(unsigned long point) {
    return point < 0x80 ? 1 : (point < 0x800 ? 2 : (point < 0x10000 ? 3 : 4));
}

/// Steps over the source of the next bytes of the value. @return how many bytes
std::size_t step_value(Cursor& cursor, bool escapes, bool several_lines) {
    if (!escapes || cursor.peek() != '\\') {
        // toml++ reads the line end of Windows as one line feed
        if (several_lines && cursor.starts_with("\r\n")) { cursor.step(); }
        cursor.step();
        return 1;
    }
    const char c = cursor.peek(1);
    if (c == 'u' || c == 'U') {
        const std::size_t digits = c == 'u' ? 4 : 8;
        const std::string hex(cursor.ahead(2, digits));
        cursor.step(2 + digits);
        return bytes_of(std::stoul("0" + hex, nullptr, 16));
    }
    if (several_lines && std::isspace(static_cast<unsigned char>(c)) != 0) {
        cursor.step();
        while (std::isspace(static_cast<unsigned char>(cursor.peek())) != 0) { cursor.step(); }
        return 0;
    }
    cursor.step(2);
    return 1;
}

}  // namespace

SourceSpan place_in_text(std::string_view source, const SourceSpan& start, std::size_t at) {
    Cursor cursor(source);
    cursor.reach(start);
    const char quote = cursor.peek();
    if (cursor.line() != start.line || (quote != '"' && quote != '\'')) { return start; }
    const bool several_lines = cursor.peek(1) == quote && cursor.peek(2) == quote;
    cursor.step(several_lines ? 3 : 1);
    if (several_lines && cursor.starts_with("\r\n")) { cursor.step(2); }
    if (several_lines && cursor.peek() == '\n') { cursor.step(); }
    for (std::size_t bytes = 0; bytes < at && !cursor.at_end();) {
        bytes += step_value(cursor, quote == '"', several_lines);
    }
    return {cursor.line(), cursor.column(), 1};
}

std::string number_at(std::string_view source, const SourceSpan& start) {
    Cursor cursor(source);
    cursor.reach(start);
    std::string typed;
    for (; !cursor.at_end(); cursor.step()) {
        const char c = cursor.peek();
        if (c == '_') { continue; }
        if (std::isdigit(static_cast<unsigned char>(c)) == 0 &&
            std::string_view("+-.eE").find(c) == std::string_view::npos) {
            break;
        }
        typed += c;
    }
    return typed;
}

}  // namespace jw
