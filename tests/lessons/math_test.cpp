#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

#include "lessons/math/read_math.hpp"
#include "lessons/math/symbols.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/math/write_math.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/support.hpp"

namespace jw::math::test {

namespace {

struct Written {
    const char* source;
    const char* plain;
    const char* latex;
};

/// Formulas as the slides write them.
const Written kFormulas[] = {
    {R"(\boldsymbol{\Phi}^{(p1,2)} \equiv \tilde{\mathbf{s}}_i \mathbf{s}_j = \mathbf{0})",
     "Φ(p1,2) ≡ s̃ᵢ sⱼ = 0",
     R"(\boldsymbol{\Phi}^{\mathrm{(p1,2)}} \equiv \tilde{\boldsymbol{s}}_{i}\boldsymbol{s}_{j} = \mathbf{0})"},
    {R"(\mathbf{A}_i \mathbf{s}'^P_i)", "Aᵢ s′ᵢᴾ", R"(\mathbf{A}_{i}\boldsymbol{s}_{i}^{\prime P})"},
    {R"(\mathbf{A}_i \mathbf{s}_i'^P)", "Aᵢ s′ᵢᴾ", R"(\mathbf{A}_{i}\boldsymbol{s}_{i}^{\prime P})"},
    {R"(\mathbf{a}_i^T \mathbf{d} - \cos\theta)", "aᵢᵀ d − cos θ",
     R"(\boldsymbol{a}_{i}^{\mathsf{T}}\boldsymbol{d} - \cos\theta)"},
    {R"(\gamma^{\#} = -2 \dot{s}_i^T \dot{s}_j)", "γ# = −2s\u0307ᵢᵀ s\u0307ⱼ",
     R"(\gamma^{\#} = - 2\dot{s}_{i}^{\mathsf{T}}\dot{s}_{j})"},
    {R"(\Phi_{p_i}^{(m)} p)", "Φ_pᵢ(m) p", R"(\Phi_{p_{i}}^{\mathrm{(m)}}p)"},
    {R"(\boldsymbol{\Phi}_\mathbf{q} \ddot{\mathbf{q}})", "Φq q̈",
     R"(\boldsymbol{\Phi}_{\boldsymbol{q}}\ddot{\boldsymbol{q}})"},
    {R"(\frac{1}{2} L^T \omega')", "1/2 Lᵀ ω′", R"(\frac{1}{2}L^{\mathsf{T}}\omega^{\prime})"},
    {R"(\frac{a+b}{c} x)", "(a + b)/c x", R"(\frac{a + b}{c}x)"},
    {R"(\sqrt{3}/2)", "√3/2", R"(\sqrt{3}/2)"},
    {R"(|s_x| \le \|d\|)", "|sₓ| ≤ ‖d‖", R"(|s_{x}| \le \|d\|)"},
    {R"(\begin{bmatrix} M & \Phi_q^T \\ \Phi_q & 0 \end{bmatrix})", "[M, Φqᵀ; Φq, 0]",
     R"(\begin{bmatrix} M & \Phi_{q}^{\mathsf{T}} \\ \Phi_{q} & 0 \end{bmatrix})"},
    {R"(\left(\frac12\right)^{-1})", "(1/2)⁻¹", R"(\left( \frac{1}{2} \right)^{- 1})"},
    {R"(f(t)^2 - \alpha\,(\theta - \theta^0) = 0,\quad -x)", "f(t)² − α (θ − θ⁰) = 0,  −x",
     R"(f(t)^{2} - \alpha\,(\theta - \theta^{0}) = 0,\quad - x)"},
    {R"(\frac{d}{dt} \text{the angle} \operatorname{atan2}(y, x))", "d/dt the angle atan2(y, x)",
     R"(\frac{d}{dt}\text{the angle}\operatorname{atan2}(y,x))"},
};

struct Wrong {
    const char* source;
    std::size_t at;
    const char* message;
};

const Wrong kWrong[] = {
    {R"(\alhpa)", 0, "unknown command \\alhpa"},
    {R"(x + \frac{1}{2)", 14, "expected '}'"},
    {"x_a_b", 3, "already has a subscript"},
    {"x^", 2, "expected a sign or a group"},
    {"a }", 2, "closes nothing"},
    {R"(\left( x)", 8, "expected '\\right'"},
    {R"(\left x)", 6, "expected a delimiter"},
    {R"(\begin{bmatrix} a)", 17, "expected '\\end'"},
    {R"(\begin{bmatrix} a \end{pmatrix})", 22, "is closed by"},
    {R"(\begin{align} a \end{align})", 0, "unknown environment 'align'; expected one of bmatrix"},
    {"a \xe2\x82\xac b", 2, "means nothing"},
    {"^2", 0, "stands after no sign"},
};

/// A formula at random from commands, braces and scripts, mostly wrong.
std::string random_source(std::mt19937& random) {
    std::vector<std::string> pieces{
        "{",
        "}",
        "_",
        "^",
        "'",
        "&",
        "\\\\",
        "x",
        "12",
        " ",
        "$",
        "\\",
        "\\begin{bmatrix}",
        "\\end{bmatrix}",
        "\\frac",
        "\\sqrt",
        "\\text{",
        "\\left(",
        "\\right)",
        "\xce"};
    for (const Symbol& s : kSymbols) { pieces.emplace_back(s.command); }
    std::string source;
    std::uniform_int_distribution<std::size_t> pick(0, pieces.size() - 1);
    for (int k = 0; k < 12; ++k) { source += pieces[pick(random)] + (k % 3 == 0 ? " " : ""); }
    return source;
}

}  // namespace

TEST_CASE("formulas of the slides come out as Unicode and as LaTeX", "[lessons][math]") {
    for (const Written& f : kFormulas) {
        CAPTURE(f.source);
        const Reading reading = read_math(f.source);
        REQUIRE_FALSE(reading.problem);
        CHECK(write_plain(reading.row) == f.plain);
        CHECK(write_latex(reading.row) == f.latex);
        // written and read again it is the same formula
        CHECK(read_math(write_latex(reading.row)).row == reading.row);
    }
}

TEST_CASE("a wrong formula is reported at its place", "[lessons][math]") {
    for (const Wrong& wrong : kWrong) {
        CAPTURE(wrong.source);
        const Reading reading = read_math(wrong.source);
        REQUIRE(reading.problem);
        CHECK(reading.problem->at == wrong.at);
        CHECK_THAT(reading.problem->message, Catch::Contains(wrong.message));
    }
    CHECK(read_math(R"(\alhpa)").problem->hint == "did you mean '\\alpha'?");
}

TEST_CASE(
    "any text is read without harm, and what was read is written and read the same", "[lessons][math]") {
    constexpr unsigned seed = 17;
    CAPTURE(seed);
    std::mt19937 random(seed);
    int sound = 0;
    for (int k = 0; k < 20000; ++k) {
        const std::string source = random_source(random);
        const Reading reading = read_math(source);
        const std::string latex = write_latex(reading.row);
        CAPTURE(source, latex);
        write_mathml(reading.row, true);
        write_plain(reading.row);
        if (reading.problem) { continue; }
        ++sound;
        const Reading again = read_math(latex);
        REQUIRE_FALSE(again.problem);
        REQUIRE(write_latex(again.row) == latex);
    }
    CHECK(sound > 100);
}

TEST_CASE("dollar signs enclose formulas, and an escaped one is a dollar sign", "[lessons][math]") {
    const TextParts parts = text_parts("It costs \\$5: $s_i$ is\n$$A = G L^T$$ done.");
    REQUIRE(parts.problems.empty());
    REQUIRE(parts.parts.size() == 5);
    CHECK(parts.parts[0].words == "It costs $5: ");
    CHECK(parts.parts[1].kind == TextPart::Kind::formula);
    CHECK(parts.parts[3].kind == TextPart::Kind::display);
    CHECK(plain_words("The vector $\\mathbf{s}_i$ costs \\$5.") == "The vector sᵢ costs $5.");
    const TextParts code = text_parts("give `point_i`, `axis_i $1` or ` and $x$");
    REQUIRE(code.parts.size() == 6);
    CHECK(code.parts[1].kind == TextPart::Kind::code);
    CHECK(code.parts[1].words == "point_i");
    CHECK(code.parts[3].words == "axis_i $1");
    CHECK(code.parts[4].words == " or ` and ");
    CHECK(code.parts[5].kind == TextPart::Kind::formula);
    CHECK(code.problems.empty());
    CHECK(plain_words("give `point_i`") == "give `point_i`");
    const TextParts open = text_parts("from $s_i on");
    REQUIRE(open.problems.size() == 1);
    CHECK(open.problems[0].at == 5);
    CHECK(text_parts("ab $x + \\foo$").problems.at(0).at == 8);
}

TEST_CASE("MathML is well-formed and has every sign of the formula", "[lessons][math]") {
    for (const Written& f : kFormulas) {
        const std::string mathml = write_mathml(read_math(f.source).row, false);
        CAPTURE(f.source, mathml);
        std::vector<std::string> open;
        for (std::size_t at = mathml.find('<'); at != std::string::npos; at = mathml.find('<', at + 1)) {
            const std::size_t end = mathml.find_first_of(" >/", at + 2);
            if (mathml[at + 1] == '/') {
                REQUIRE_FALSE(open.empty());
                CHECK(open.back() == mathml.substr(at + 2, mathml.find('>', at) - at - 2));
                open.pop_back();
            } else if (mathml[mathml.find('>', at) - 1] != '/') {
                open.push_back(mathml.substr(at + 1, end - at - 1));
            }
        }
        CHECK(open.empty());
    }
    CHECK(
        write_mathml(read_math(R"(\dot{\mathbf{s}}_i < 2)").row, false) ==
        "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mover "
        "accent=\"true\"><mi>&#119956;</mi>"
        "<mo>˙</mo></mover><mi>i</mi></msub><mo>&lt;</mo><mn>2</mn></mrow></math>");
    // the sign of a number is not the operator of a difference
    const std::string prefix = "<mo form=\"prefix\">−</mo>";
    const std::string infix = "<mo>−</mo>";
    for (const char* number : {"-2", "a = -2", "(-2)", "a \\cdot -2"}) {
        INFO(number);
        CHECK(write_mathml(read_math(number).row, false).find(prefix) != std::string::npos);
    }
    CHECK(write_mathml(read_math("a - 2").row, false).find(infix) != std::string::npos);
    CHECK(write_mathml(read_math("(a) - 2").row, false).find(infix) != std::string::npos);
}

TEST_CASE("docs/mathematics.md lists every command, and nothing else", "[lessons][math][docs]") {
    const std::string text = jw::test::text_of_file("docs/mathematics.md");
    REQUIRE_FALSE(text.empty());
    std::vector<std::string> known{"\\frac", "\\sqrt",  "\\text",  "\\operatorname",
                                   "\\left", "\\right", "\\begin", "\\end"};
    const auto add = [&](const auto& table) {
        for (const auto& entry : table) { known.emplace_back(entry.command); }
    };
    add(kSymbols);
    add(kAccents);
    add(kSpaces);
    add(kAlphabets);
    for (const std::string& command : known) {
        CAPTURE(command);
        if (command.front() == '\\') { CHECK_THAT(text, Catch::Contains("`" + command)); }
    }
    for (const Environment& e : kEnvironments) {
        CHECK_THAT(text, Catch::Contains("`" + std::string(e.name) + "`"));
    }
    for (std::size_t at = text.find("`\\"); at != std::string::npos; at = text.find("`\\", at + 1)) {
        std::size_t end = at + 2;
        while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) { ++end; }
        const std::string command = text.substr(at + 1, std::max(end, at + 3) - at - 1);
        CAPTURE(command);
        CHECK((command == "\\$" || command == "\\\\" || std::ranges::find(known, command) != known.end()));
    }
}

namespace {

/// A lesson whose text, in the quotes of TOML, is `quoted`.
std::string with_text(const std::string& quoted) {
    return "format = 1\ntitle = \"x\"\ntext = " + quoted + "\n[[body]]\nname = \"rod\"\n";
}

}  // namespace

TEST_CASE("a wrong formula of a lesson is reported at its line and column", "[lessons][math]") {
    struct Case {
        const char* quoted;
        int line;
        int column;
    };
    const Case cases[] = {
        {R"('a $\foo$')", 3, 12},
        {R"("a $\\foo$")", 3, 12},
        {R"("\u00e9 $\\foo$")", 3, 17},
        {"'''\nab\ncd $x \\foo$'''", 5, 7},
        {"\"\"\"\nab\ncd \\\n   $x \\\\foo$\"\"\"", 6, 7},
        {R"('é $\foo$')", 3, 12},
    };
    for (const Case& c : cases) {
        const std::string source = with_text(c.quoted);
        CAPTURE(source);
        const ReadResult read = read_lesson(source, "x.toml");
        REQUIRE_FALSE(read.lesson);
        REQUIRE(read.diagnostics.size() == 1);
        CHECK(read.diagnostics[0].span.line == c.line);
        CHECK(read.diagnostics[0].span.column == c.column);
        CHECK_THAT(read.diagnostics[0].message, Catch::Contains("unknown command"));
    }
}

TEST_CASE("texts with formulas are written so that they can be read, and read the same", "[lessons][math]") {
    for (const std::string text :
         {"a $\\tilde{s}$", "a $s'_i \\cdot x$", "two\nlines $\\Phi$", "ends $\\Phi'", "''' $\\Phi$",
          "\\\r$x$"}) {
        CAPTURE(text);
        Lesson lesson = *read_lesson(with_text("'x'"), "x.toml").lesson;
        lesson.text = text;
        const ReadResult again = read_lesson(lesson_text(lesson), "x.toml");
        if (again.lesson) { CHECK(again.lesson->text == text); }
        CHECK((again.lesson || text.starts_with("ends") || text.starts_with("\\\r")));
    }
    Lesson lesson = *read_lesson(with_text("'x'"), "x.toml").lesson;
    lesson.text = "a $\\tilde{s}$";
    CHECK_THAT(lesson_text(lesson), Catch::Contains("text = 'a $\\tilde{s}$'"));
}

}  // namespace jw::math::test
