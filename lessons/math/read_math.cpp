#include "lessons/math/read_math.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/math/symbols.hpp"
#include "lessons/text/utf8.hpp"

namespace jw::math {

namespace {

// nobody reads a formula with deeper nesting
constexpr int kDeepest = 40;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

struct Failed {
    Problem problem;
};

class Reader {
public:
    explicit Reader(std::string_view source) : source_(source) {}

    Reading run() {
        Reading reading;
        try {
            reading.row = read_row(Alphabet::italic);
            if (!at_end()) { fail(at_, "'" + std::string(next_token()) + "' closes nothing"); }
        } catch (Failed& failed) { reading.problem = std::move(failed.problem); }
        return reading;
    }

private:
    [[noreturn]] static void fail(std::size_t at, std::string message, std::string hint = {}) {
        throw Failed{{at, std::move(message), std::move(hint)}};
    }

    bool at_end() {
        while (at_ < source_.size() && is_blank(source_[at_])) { ++at_; }
        return at_ == source_.size();
    }

    /// The next token: a command, or one character.
    std::string_view next_token() {
        if (at_end()) { return {}; }
        std::size_t end = at_ + 1;
        if (source_[at_] == '\\' && end < source_.size()) {
            const bool word = is_letter(source_[end]);
            ++end;
            while (word && end < source_.size() && is_letter(source_[end])) { ++end; }
        } else {
            while (end < source_.size() && !starts_character(source_[end])) { ++end; }
        }
        return source_.substr(at_, end - at_);
    }

    bool take(std::string_view token) {
        if (next_token() != token) { return false; }
        at_ += token.size();
        return true;
    }

    void expect(std::string_view token, const std::string& what) {
        if (!take(token)) {
            fail(at_, "expected '" + std::string(token) + "' " + what + ", found " + described(next_token()));
        }
    }

    static std::string described(std::string_view token) {
        return token.empty() ? "the end of the formula" : "'" + std::string(token) + "'";
    }

    static bool ends_row(std::string_view token) {
        return token.empty() || token == "}" || token == "&" || token == "\\\\" || token == "\\right" ||
               token == "\\end";
    }

    Row read_row(Alphabet alphabet) {
        if (++depth_ > kDeepest) { fail(at_, "this formula is nested too deeply"); }
        Row row;
        while (!ends_row(next_token())) { row.push_back(read_node(alphabet)); }
        --depth_;
        return row;
    }

    Node read_node(Alphabet alphabet) {
        Node node = read_nucleus(alphabet);
        read_scripts(node, alphabet);
        node.to = at_;
        return node;
    }

    void read_scripts(Node& node, Alphabet alphabet) {
        bool lower = false;
        bool upper = false;
        for (;;) {
            const std::size_t at = at_;
            if (take("'") || take("′")) {
                node.above.push_back(made(Sign{"′", SignKind::ordinary}, at));
            } else if (take("_")) {
                if (std::exchange(lower, true)) { fail(at, "this symbol already has a subscript"); }
                node.below = read_argument("after '_'", inner_alphabet(alphabet));
            } else if (take("^")) {
                if (std::exchange(upper, true)) { fail(at, "this symbol already has a superscript"); }
                const Alphabet style = begins_name() ? Alphabet::upright : inner_alphabet(alphabet);
                Row above = read_argument("after '^'", style);
                set_upright(above);
                std::ranges::move(above, std::back_inserter(node.above));
            } else {
                return;
            }
        }
    }

    /// True before {(, the beginning of names like (p1,2); everything in them is upright.
    bool begins_name() {
        const std::size_t at = at_;
        const bool begins = take("{") && next_token() == "(";
        at_ = at;
        return begins;
    }

    /// A transpose and the letters of names are upright, however they are typed.
    static void set_upright(Row& above) {
        const bool name = !above.empty() && is_sign(above.front(), "(");
        for (Node& node : above) {
            Sign* const sign = std::get_if<Sign>(&node.nucleus);
            if (sign == nullptr || sign->kind != SignKind::letter) { continue; }
            if (name || sign->utf8 == "T") { sign->alphabet = Alphabet::upright; }
        }
    }

    /// The index of a bold letter is not bold.
    static Alphabet inner_alphabet(Alphabet alphabet) {
        return alphabet == Alphabet::bold ? Alphabet::italic : alphabet;
    }

    /// Reads one sign or a group in braces.
    Row read_argument(const std::string& where, Alphabet alphabet) {
        const std::size_t at = at_;
        if (take("{")) {
            Row row = read_row(alphabet);
            expect("}", "to close the group that starts " + where);
            return opened(std::move(row));
        }
        const std::string_view token = next_token();
        if (ends_row(token) || token == "_" || token == "^") {
            fail(at, "expected a sign or a group in braces " + where + ", found " + described(token));
        }
        Row row;
        row.push_back(is_digit(token.front()) ? one_digit() : read_nucleus(alphabet));
        row.back().to = at_;
        return row;
    }

    /// A row that is only a group in braces becomes the content of that group.
    static Row opened(Row row) {
        const Group* const group = row.size() == 1 ? std::get_if<Group>(&row[0].nucleus) : nullptr;
        const bool bare = group != nullptr && group->open.empty() && group->close.empty() &&
                          row[0].below.empty() && row[0].above.empty();
        return bare ? Row(group->inner) : row;
    }

    Node one_digit() {
        const std::size_t from = at_++;
        return made(Sign{std::string(1, source_[from]), SignKind::number}, from);
    }

    /// A node without scripts, read from `from` on.
    template <class Nucleus>
    Node made(Nucleus&& nucleus, std::size_t from) const {
        return {std::forward<Nucleus>(nucleus), {}, {}, from, at_};
    }

    Node read_nucleus(Alphabet alphabet) {
        const std::string_view token = next_token();
        const std::size_t from = at_;
        if (token == "{") { return group_of(read_argument("here", alphabet), from); }
        if (token == "_" || token == "^" || token == "'") {
            fail(at_, "'" + std::string(token) + "' stands after no sign", "write {}" + std::string(token));
        }
        if (token.front() == '\\') { return read_command(token, alphabet); }
        if (is_digit(token.front())) { return read_number(alphabet); }
        at_ += token.size();
        if (is_letter(token.front())) {
            return made(Sign{std::string(token), SignKind::letter, alphabet}, from);
        }
        if (token == "~") { return made(Space{0.33}, from); }
        const Symbol* symbol = symbol_of_command(token);
        if (symbol == nullptr) { symbol = symbol_of_character(token); }
        if (symbol == nullptr) {
            fail(
                from, "'" + std::string(token) + "' means nothing in a formula",
                "docs/mathematics.md lists what can be written");
        }
        return sign_of(*symbol, alphabet, from);
    }

    Node sign_of(const Symbol& symbol, Alphabet alphabet, std::size_t from) const {
        const bool styled = symbol.kind == SignKind::letter;
        return made(Sign{std::string(symbol.utf8), symbol.kind, styled ? alphabet : Alphabet::italic}, from);
    }

    /// A group of one node is that node, so that scripts belong to it.
    Node group_of(Row row, std::size_t from) const {
        if (row.size() == 1 && row[0].below.empty() && row[0].above.empty()) {
            Node node = std::move(row[0]);
            node.from = from;
            node.to = at_;
            return node;
        }
        return made(Group{"", "", std::move(row)}, from);
    }

    Node read_number(Alphabet alphabet) {
        const std::size_t from = at_;
        const auto digits = [this] {
            while (at_ < source_.size() && is_digit(source_[at_])) { ++at_; }
        };
        digits();
        if (at_ + 1 < source_.size() && source_[at_] == '.' && is_digit(source_[at_ + 1])) {
            ++at_;
            digits();
        }
        const Alphabet style = alphabet == Alphabet::bold ? alphabet : Alphabet::italic;
        return made(Sign{std::string(source_.substr(from, at_ - from)), SignKind::number, style}, from);
    }

    Node read_command(std::string_view token, Alphabet alphabet) {
        const std::size_t from = at_;
        at_ += token.size();
        if (const Symbol* const symbol = symbol_of_command(token)) {
            return sign_of(*symbol, alphabet, from);
        }
        for (const AlphabetCommand& c : kAlphabets) {
            if (c.command == token) {
                return group_of(read_argument("after " + std::string(token), c.alphabet), from);
            }
        }
        for (const AccentCommand& c : kAccents) {
            if (c.command != token) { continue; }
            Row inner = read_argument("after " + std::string(token), alphabet);
            return made(Accent{c.kind, std::move(inner)}, from);
        }
        for (const SpaceCommand& c : kSpaces) {
            if (c.command == token) { return made(Space{c.em}, from); }
        }
        return read_structure(token, alphabet, from);
    }

    Node read_structure(std::string_view token, Alphabet alphabet, std::size_t from) {
        if (token == "\\frac") {
            Row above = read_argument("after \\frac", alphabet);
            Row below = read_argument("after the numerator of \\frac", alphabet);
            return made(Fraction{std::move(above), std::move(below)}, from);
        }
        if (token == "\\sqrt") { return made(Root{read_argument("after \\sqrt", alphabet)}, from); }
        if (token == "\\text") { return made(Words{read_words(token)}, from); }
        if (token == "\\operatorname") {
            return made(Sign{read_words(token), SignKind::function, Alphabet::upright}, from);
        }
        if (token == "\\left") { return read_delimited(alphabet, from); }
        if (token == "\\begin") { return read_matrix(alphabet, from); }
        fail(from, "unknown command " + std::string(token), nearest_command(token));
    }

    static std::string nearest_command(std::string_view token) {
        std::vector<std::string> names{"\\frac", "\\sqrt", "\\text", "\\operatorname", "\\left", "\\begin"};
        for (const Symbol& s : kSymbols) { names.emplace_back(s.command); }
        for (const AccentCommand& s : kAccents) { names.emplace_back(s.command); }
        for (const AlphabetCommand& s : kAlphabets) { names.emplace_back(s.command); }
        const std::string near = did_you_mean(token, names);
        return near.empty() ? "docs/mathematics.md lists the commands" : near;
    }

    /// Reads an argument literally, as that of \text.
    std::string read_words(std::string_view command) {
        expect("{", "after " + std::string(command));
        const std::size_t end = source_.find('}', at_);
        if (end == std::string_view::npos) {
            fail(
                at_, "expected '}' to close the words after " + std::string(command) +
                         ", found the end of the formula");
        }
        std::string words(source_.substr(at_, end - at_));
        at_ = end + 1;
        return words;
    }

    std::string read_delimiter(std::string_view after) {
        const std::string_view token = next_token();
        const auto found = std::ranges::find(kDelimiters, token, &Delimiter::typed);
        if (found == kDelimiters.end()) {
            fail(
                at_, "expected a delimiter after " + std::string(after) + ", found " + described(token),
                "one of ( ) [ ] \\{ \\} | \\| or . for none");
        }
        at_ += token.size();
        return std::string(found->drawn);
    }

    Node read_delimited(Alphabet alphabet, std::size_t from) {
        Group group;
        group.open = read_delimiter("\\left");
        group.inner = read_row(alphabet);
        expect("\\right", "to close the \\left before");
        group.close = read_delimiter("\\right");
        return made(std::move(group), from);
    }

    Node read_matrix(Alphabet alphabet, std::size_t from) {
        const std::string name = read_words("\\begin");
        const auto found = std::ranges::find(kEnvironments, name, &Environment::name);
        if (found == kEnvironments.end()) {
            std::vector<std::string> names;
            for (const Environment& e : kEnvironments) { names.emplace_back(e.name); }
            fail(from, "unknown environment '" + name + "'; expected one of " + comma_list(names));
        }
        Matrix matrix{found->kind, {{}}};
        do {
            matrix.rows.back().push_back(read_row(alphabet));
            if (take("&")) { continue; }
            if (!take("\\\\")) { break; }
            if (next_token() != "\\end") { matrix.rows.emplace_back(); }
        } while (next_token() != "\\end");
        // a row that ends with & has a last, empty cell
        if (matrix.rows.back().empty()) { matrix.rows.back().emplace_back(); }
        expect("\\end", "to close \\begin{" + name + "}");
        const std::size_t at = at_;
        if (const std::string closed = read_words("\\end"); closed != name) {
            fail(at, "\\begin{" + name + "} is closed by \\end{" + closed + "}");
        }
        std::size_t columns = 0;
        for (const auto& row : matrix.rows) { columns = std::max(columns, row.size()); }
        for (auto& row : matrix.rows) { row.resize(columns); }
        return made(std::move(matrix), from);
    }

    std::string_view source_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

Reading read_math(std::string_view source) { return Reader(source).run(); }

Row own_math(std::string_view source) {
    Reading reading = read_math(source);
    if (reading.problem) {
        throw std::invalid_argument("formula '" + std::string(source) + "': " + reading.problem->message);
    }
    return std::move(reading.row);
}

}  // namespace jw::math
