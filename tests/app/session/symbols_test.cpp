#include <catch2/catch.hpp>

#include <map>

#include "app/session/output/describe.hpp"
#include "app/session/picture/pointable.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/math/text_parts.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

/// A of slide 12, entry by entry.
Mat3 nine_entries(const Vec4& p) {
    const double e0 = p(0), e1 = p(1), e2 = p(2), e3 = p(3);
    Mat3 A;
    // clang-format off
    A << e0*e0 + e1*e1 - 0.5, e1*e2 - e0*e3,       e1*e3 + e0*e2,
         e1*e2 + e0*e3,       e0*e0 + e2*e2 - 0.5, e2*e3 - e0*e1,
         e1*e3 - e0*e2,       e2*e3 + e0*e1,       e0*e0 + e3*e3 - 0.5;
    // clang-format on
    return 2.0 * A;
}

/// G (sign +1) or L (sign -1) of slide 13, entry by entry.
Eigen::Matrix<double, 3, 4> twelve_entries(const Vec4& p, double sign) {
    Eigen::Matrix<double, 3, 4> M;
    // clang-format off
    M << -p(1),         p(0), -sign * p(3),  sign * p(2),
         -p(2),  sign * p(3),         p(0), -sign * p(1),
         -p(3), -sign * p(2),  sign * p(1),         p(0);
    // clang-format on
    return M;
}

/// A body of the step with formulas of its own.
struct BodyOfStep {
    Vec3 r, r_dot, omega, omega_local;
    Vec4 p, p_dot;
    Mat3 A;

    BodyOfStep(const Step& step, int body) {
        const auto b = static_cast<std::size_t>(body);
        r = step.state.r[b];
        p = step.state.p[b];
        r_dot = step.velocity.r_dot[b];
        omega_local = step.velocity.omega_local[b];
        A = nine_entries(p);
        omega = A * omega_local;
        p_dot = 0.5 * twelve_entries(p, -1.0).transpose() * omega_local;
    }
};

std::optional<MatrixX> of_body(const BodyOfStep& b, const formula::Symbol& s, int dots) {
    if (dots == 1) {
        if (s.letter == "r") { return b.r_dot; }
        if (s.letter == "p") { return b.p_dot; }
        if (s.letter == "A") { return MatrixX(b.A * tilde(b.omega_local)); }
        return std::nullopt;
    }
    if (dots > 1) { return std::nullopt; }
    if (s.letter == "r") { return b.r; }
    if (s.letter == "p") { return b.p; }
    if (s.letter == "e" && s.index.empty()) { return b.p.tail<3>(); }
    if (s.letter == "e") { return MatrixX::Constant(1, 1, b.p(s.index[0] - '0')); }
    if (s.letter == "A") { return b.A; }
    if (s.letter == "G") { return twelve_entries(b.p, 1.0); }
    if (s.letter == "L") { return twelve_entries(b.p, -1.0); }
    if (s.letter == "ω") { return s.primes > 0 ? b.omega_local : b.omega; }
    return std::nullopt;
}

const Vec3* local_of(const JointGeometry& g, const formula::Symbol& s, bool i) {
    if (s.letter == "s" && s.marks.empty()) { return i ? &g.s_i_local : &g.s_j_local; }
    if (s.letter == "s" || s.letter == "r") { return i ? &g.P_i_local : &g.P_j_local; }
    if (s.letter == "h") { return i ? &g.h_i_local : &g.h_j_local; }
    return s.letter == "u" ? (i ? &g.u_i_local : &g.u_j_local) : nullptr;
}

std::optional<MatrixX> of_joint(const Step& step, const Joint& joint, const formula::Symbol& s, int dots) {
    const BodyOfStep i(step, joint.body_i);
    const BodyOfStep j(step, joint.body_j);
    const JointGeometry& g = joint.geometry;
    if (s.letter == "L" && s.index.empty()) { return MatrixX::Constant(1, 1, g.length); }
    if (s.letter == "d") {
        if (dots > 0) { return std::nullopt; }
        return MatrixX(j.r + j.A * g.P_j_local - i.r - i.A * g.P_i_local);
    }
    const bool of_i = s.index.ends_with("i");
    const BodyOfStep& body = of_i ? i : j;
    const Vec3* const local = local_of(g, s, of_i);
    if (s.letter == "r" && s.marks.empty()) { return dots == 0 ? MatrixX(body.r) : MatrixX(body.r_dot); }
    if (local == nullptr || dots > 1) { return std::nullopt; }
    const Vec3 vector = dots == 0 ? Vec3(body.A * *local) : Vec3(body.omega.cross(body.A * *local));
    if (s.letter == "r") { return MatrixX((dots == 0 ? body.r : body.r_dot) + vector); }
    return s.primes == 0 ? MatrixX(vector) : MatrixX(*local);
}

/// Expected value of the meaning; empty if this test has no formula for it.
std::optional<MatrixX> computed_again(const Step& step, const SymbolMeaning& meaning) {
    const auto symbol = formula::text_symbol_of(math::own_math(meaning.source).front());
    if (!symbol) { return std::nullopt; }
    const Mechanism& mechanism = step.system->mechanism();
    const SymbolPart& part = meaning.part;
    if (part.joint >= 0 && part.kind != SymbolPart::Kind::rows) {
        const Joint& joint = mechanism.joints[static_cast<std::size_t>(part.joint)];
        if (const auto value = of_joint(step, joint, symbol->name, symbol->dots)) { return value; }
    }
    if (part.kind != SymbolPart::Kind::body) { return std::nullopt; }
    formula::Symbol own = symbol->name;
    while (own.index.ends_with("i") || own.index.ends_with("j")) { own.index.pop_back(); }
    return of_body(BodyOfStep(step, part.body), own, symbol->dots);
}

/// Ten times the largest distance of |p|² from 1, as the author typed p or Newton left it: the nine entries,
/// which suppose 1, differ from G Lᵀ by about as much each, and several are added.
double off_unit(const Step& step) {
    double off = 0.0;
    for (const Vec4& p : step.state.p) { off = std::max(off, std::abs(p.squaredNorm() - 1.0)); }
    return 10.0 * off;
}

/// Number of meanings that could be compared; each of them is checked.
int compared(const Step& step, const std::vector<SymbolView>& symbols) {
    int count = 0;
    for (const SymbolView& symbol : symbols) {
        for (const SymbolMeaning& meaning : symbol.meanings) {
            std::optional<MatrixX> expected = computed_again(step, meaning);
            if (!expected) { continue; }
            const std::size_t axis = meaning.source.find_first_of("xyz");
            // "s_{(y)i}" is a component
            if (meaning.value.size() == 1 && expected->size() == 3 && axis != std::string::npos) {
                expected = MatrixX::Constant(1, 1, (*expected)(meaning.source[axis] - 'x', 0));
            }
            CAPTURE(symbol.source, meaning.source, meaning.owner, meaning.value, *expected);
            REQUIRE(meaning.value.rows() == expected->rows());
            REQUIRE(meaning.value.cols() == expected->cols());
            const double size = std::max(1.0, expected->cwiseAbs().maxCoeff());
            CHECK((meaning.value - *expected).cwiseAbs().maxCoeff() < (1e-12 + off_unit(step)) * size);
            ++count;
        }
    }
    return count;
}

/// Symbols in the texts of a view, and how often they stand for something.
struct Share {
    std::map<std::string, int> found;
    std::map<std::string, int> missing;

    void add(const View& view) {
        std::vector<std::string> texts{view.sentence, view.author_text};
        if (view.question) { texts.insert(texts.end(), {view.question->ask, view.question->why}); }
        for (const std::string& text : texts) {
            for (const math::TextPart& part : math::text_parts(text).parts) {
                formula::for_each_symbol(part.row, [&](const formula::TextSymbol& symbol) {
                    const bool known = index_of_symbol(view.symbols, {}, symbol.source) >= 0;
                    ++(known ? found : missing)[symbol.source];
                });
            }
        }
    }
    static int total(const std::map<std::string, int>& counts) {
        int all = 0;
        for (const auto& [symbol, count] : counts) { all += count; }
        return all;
    }
    std::string list_of_missing() const {
        std::string list;
        for (const auto& [symbol, count] : missing) { list += symbol + " x" + std::to_string(count) + "  "; }
        return list;
    }
};

}  // namespace

TEST_CASE("Every symbol of the shipped lessons has the value that formulas of their own give", "[symbols]") {
    int count = 0;
    Share share;
    for (const std::filesystem::path& file : all_lesson_files()) {
        CAPTURE(file);
        const Lesson lesson = without_motion(shipped(file));
        if (lesson.mechanism.bodies.size() > 40) { continue; }
        const Story story(lesson);
        for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
            const View view = view_of(story, k, ViewParts::without_matrix);
            count += compared(story.steps()[static_cast<std::size_t>(k)], view.symbols);
            share.add(view);
        }
    }
    CHECK(count > 1000);
    const int found = Share::total(share.found);
    const int missing = Share::total(share.missing);
    CAPTURE(found, missing, share.list_of_missing());
    CHECK(found > missing);
}

TEST_CASE("Symbols have their values in the middle of a motion", "[symbols]") {
    int count = 0;
    for (const std::string& name : few_lessons()) {
        CAPTURE(name);
        const Lesson lesson = lesson_named(name);
        const Story story(lesson);
        const int last = static_cast<int>(story.steps().size()) - 1;
        for (int k = story.last_assembled(); k <= last; k += 7) {
            const View view = view_of(story, k, ViewParts::without_matrix);
            count += compared(story.steps()[static_cast<std::size_t>(k)], view.symbols);
        }
    }
    CHECK(count > 10);
}

TEST_CASE("Symbols have the values of any state with any velocity", "[symbols]") {
    const std::string text =
        R"($\mathbf{s}_i \mathbf{s}'_j \mathbf{d} \mathbf{A} \mathbf{A}_i \mathbf{p}_j e_2 \dot{\mathbf{p}}$
           $\boldsymbol{\omega}' \boldsymbol{\omega}_j \dot{\mathbf{s}}_j \mathbf{r}_i^P \mathbf{s}_j^{\prime P}
           \tilde{\mathbf{s}}_i^T \mathbf{G} \mathbf{L}_j \dot{\mathbf{r}}$)";
    for (const std::string& name : few_lessons()) {
        const Lesson lesson = without_motion(lesson_named(name));
        const Story story(lesson);
        for (unsigned seed = 1; seed <= 5; ++seed) {
            CAPTURE(name, seed);
            Step step = story.steps()[static_cast<std::size_t>(story.last_assembled())];
            const Instant any = formula::arbitrary_instant(step.system, seed);
            step.kind = Step::Kind::motion;
            step.state = any.state;
            step.velocity = any.velocity;
            step.acceleration = *any.acceleration;
            const auto symbols = symbols_of(step, lesson.coordinates, {{0}, -1}, {text}, {});
            CHECK(compared(step, symbols) >= 12);
        }
    }
}

TEST_CASE("The index of a body makes it the one that a symbol is about", "[symbols]") {
    const Lesson lesson = without_motion(lesson_named("loops/four-bar"));
    const Story story(lesson);
    const Step& step = story.steps().back();
    const auto symbols = symbols_of(
        step, lesson.coordinates, {{0}, -1},
        {R"($\mathbf{p}_{crank}$ and $\mathbf{r}_{\text{rocker}}$ $\mathbf{c}$)"}, {});
    REQUIRE(symbols.size() == 2);
    CHECK(symbols[0].meanings.at(0).owner == "crank");
    CHECK(symbols[1].meanings.at(0).owner == "rocker");
    CHECK(compared(step, symbols) == 2);
}

TEST_CASE(
    "A symbol that says not whose it is has a meaning for each, and an unknown one has none", "[symbols]") {
    const Lesson lesson = without_motion(lesson_named("loops/four-bar"));
    const Story story(lesson);
    const Step& step = story.steps().back();
    const std::vector<std::string> texts{R"($\boldsymbol{\Phi}$ $\mathbf{s}$ $\mathbf{C}$ $\mathrm{m}$)"};
    const auto symbols = symbols_of(step, lesson.coordinates, {{0}, -1}, texts, {});
    REQUIRE(symbols.size() == 2);
    CHECK(symbols[0].meanings.size() == 2);  // s and p1 of a revolute
    CHECK(symbols[1].meanings.size() == 2);  // s_i and s_j
    const std::vector<std::string> tip = symbol_tip(symbols[1]);
    CHECK(tip.size() == 3);
    CHECK_THAT(tip[1], Catch::Contains("\\begin{bmatrix}"));
}

TEST_CASE("A symbol lights its vector, the rows of its primitive or its body", "[symbols]") {
    const Lesson lesson = without_motion(lesson_named("loops/four-bar"));
    const Story story(lesson);
    const Step& step = story.steps().back();
    const std::vector<std::string> texts{R"($\mathbf{s}_j$ $\boldsymbol{\gamma}$ $\mathbf{A}_j$)"};
    const auto symbols = symbols_of(step, lesson.coordinates, {{0}, -1}, texts, {});
    REQUIRE(symbols.size() == 3);
    CHECK(links_of(symbols[0], *step.system) == std::vector{Pointable::vector(0, Pointable::kVectorJ)});
    const std::vector<Pointable> rows = links_of(symbols[1], *step.system);
    CHECK(rows.size() == 5);
    CHECK(rows.front().kind == Pointable::Kind::row);
    const int body = lesson.mechanism.joints[0].body_j;
    CHECK(links_of(symbols[2], *step.system) == std::vector{Pointable::body(body)});
}

}  // namespace jw::test
