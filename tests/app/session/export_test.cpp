#include "app/session/output/export.hpp"

#include <catch2/catch.hpp>

#include <charconv>
#include <map>
#include <set>
#include <sstream>

#include "app/session/wording/labels.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/picture_lessons.hpp"

namespace jw::test {

namespace {

/// Fault at which LaTeX would stop: braces or environments that do not match, commands that neither LaTeX nor
/// amsmath has, characters that are not ASCII, two superscripts (subscripts) at one letter. Empty if there is
/// none.
std::string objection_to(const std::string& latex) {
    static const std::set<std::string> known{
        "alpha",       "begin", "boldsymbol",    "cdot",           "cos",
        "dot",         "ddot",  "end",           "equiv",          "gamma",
        "hline",       "infty", "mathbf",        "mathrm",         "mathsf",
        "multicolumn", "omega", "Phi",           "prime",          "quad",
        "setcounter",  "sigma", "sin",           "text",           "theta",
        "tilde",       "times", "textbackslash", "textasciitilde", "textasciicircum"};
    std::vector<std::string> environments;
    struct Level {
        bool above = false;
        bool below = false;
    };
    std::vector<Level> levels(1);
    bool script_next = false;
    for (std::size_t k = 0; k < latex.size(); ++k) {
        const char c = latex[k];
        if (static_cast<unsigned char>(c) > 0x7E) { return "not ASCII at " + std::to_string(k); }
        if (c == '\\') {
            std::size_t end = k + 1;
            while (end < latex.size() && std::isalpha(static_cast<unsigned char>(latex[end])) != 0) { ++end; }
            const std::string command = latex.substr(k + 1, end - k - 1);
            if (command.empty()) {
                ++k;
                continue;
            }
            if (!known.contains(command)) { return "unknown command " + command; }
            if (command == "begin" || command == "end") {
                const std::size_t close = latex.find('}', end);
                const std::string name = latex.substr(end + 1, close - end - 1);
                if (command == "begin") {
                    environments.push_back(name);
                } else if (environments.empty() || environments.back() != name) {
                    return "end of " + name;
                } else {
                    environments.pop_back();
                }
                end = close + 1;
            }
            if (!script_next) { levels.back() = {}; }
            k = end - 1;
        } else if (c == '{') {
            // the group of a script belongs to the letter before it
            if (!script_next && k > 0 && latex[k - 1] != '}' &&
                std::isalpha(static_cast<unsigned char>(latex[k - 1])) == 0) {
                levels.back() = {};
            }
            script_next = false;
            levels.emplace_back();
        } else if (c == '}') {
            if (levels.size() == 1) { return "} without {"; }
            levels.pop_back();
        } else if (c == '^' || c == '_') {
            bool& there = c == '^' ? levels.back().above : levels.back().below;
            if (there) { return std::string("twice ") + c + " at " + std::to_string(k); }
            there = true;
            script_next = true;
        } else {
            levels.back() = {};
        }
    }
    if (levels.size() != 1) { return "{ without }"; }
    return environments.empty() ? "" : "no end of " + environments.back();
}

/// Every formula that the program can show.
std::vector<std::string> all_formulas() {
    std::vector<std::string> formulas;
    for (const JointType& type : kJointTypes) {
        for (const ParallelForm form : {ParallelForm::rule, ParallelForm::pair}) {
            for (const ScrewAngleForm angle :
                 {ScrewAngleForm::rotation, ScrewAngleForm::cosine, ScrewAngleForm::sine}) {
                Lesson lesson = one_joint(type.name);
                lesson.mechanism.joints[0].parallel_form = form;
                lesson.mechanism.joints[0].geometry.screw_angle_form = angle;
                const System system(lesson.mechanism, everything(lesson.mechanism));
                for (const Constraint& c : system.constraints()) {
                    formulas.push_back(equation_text(system, c).formula);
                }
            }
        }
    }
    const Joint joint = one_joint("cylindrical").mechanism.joints[0];
    std::vector<Measure> measures{angle_of(joint), displacement_of(joint), ThetaMeasure{}};
    measures.emplace_back(SquaredDistanceMeasure{Vec3::Zero(), Vec3::Zero()});
    for (int k = 0; k < 7; ++k) { measures.emplace_back(CoordinateMeasure{k}); }
    for (const Measure& measure : measures) {
        Driver driver;
        driver.measure = measure;
        formulas.push_back(driver_text(driver).formula);
    }
    return formulas;
}

std::string written_again(const std::string& formula) { return math::write_latex(math::own_math(formula)); }

View view_at(const std::string& name, Step::Kind kind) {
    const ReadResult read = read_lesson_file(lesson_path(name));
    REQUIRE(read.lesson.has_value());
    const Story story(*read.lesson, poses_only(true));
    return view_of(story, first_of(story, kind));
}

std::vector<std::string> lines_of_text(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) { lines.push_back(line); }
    return lines;
}

}  // namespace

TEST_CASE("every formula of the program is LaTeX that amsmath understands", "[app][export]") {
    const std::vector<std::string> formulas = all_formulas();
    REQUIRE(formulas.size() > 60);
    for (const std::string& formula : formulas) {
        const std::string latex = written_again(formula);
        CAPTURE(formula, latex);
        CHECK(objection_to(latex).empty());
    }
}

TEST_CASE("the check of LaTeX finds what LaTeX stops at", "[app][export]") {
    CHECK(objection_to("\\boldsymbol{s}_{i}^{\\prime P} + x^{2}").empty());
    CHECK_FALSE(objection_to("\\boldsymbol{s}^{\\prime}_{i}^{P}").empty());
    CHECK_FALSE(objection_to("{x").empty());
    CHECK_FALSE(objection_to("x}").empty());
    CHECK_FALSE(objection_to("\\thta").empty());
    CHECK_FALSE(objection_to("θ").empty());
    CHECK_FALSE(objection_to("\\begin{array}{c}\\end{bmatrix}").empty());
}

TEST_CASE("names with characters of LaTeX's own come out as they were typed", "[app][export]") {
    CHECK(latex_text("50% of rod_1 & {x}") == "50\\% of rod\\_1 \\& \\{x\\}");
    CHECK(latex_text("e₀") == "e$_{0}$");
    CHECK(latex_text("ω′x") == "$\\omega$${}^{\\prime}$x");
}

TEST_CASE("matrices of lessons are LaTeX with an entry in every column", "[app][export]") {
    for (const char* name : {"loops/four-bar.toml", "joints/screw.toml", "screws/screw-jack.toml"}) {
        for (const Step::Kind kind : {Step::Kind::bodies, Step::Kind::equations, Step::Kind::assembled}) {
            const MatrixView matrix = view_at(name, kind).matrix;
            const std::string bare = matrix_latex(matrix, MatrixStyle::brackets);
            const std::string labelled = matrix_latex(matrix, MatrixStyle::labelled);
            CAPTURE(name, static_cast<int>(kind), bare, labelled);
            CHECK(objection_to(bare).empty());
            CHECK(objection_to(labelled).empty());
            std::size_t rows = 0;
            for (const std::string& line : lines_of_text(bare)) {
                if (!line.ends_with("\\\\")) { continue; }
                ++rows;
                CHECK(std::ranges::count(line, '&') == matrix.values.cols() - 1);
            }
            CHECK(rows == matrix.rows.size());
            if (matrix.columns.size() > 10) { CHECK(bare.starts_with("\\setcounter{MaxMatrixCols}{")); }
        }
    }
}

TEST_CASE("the matrix as a table reads back exactly", "[app][export]") {
    const MatrixView matrix = view_at("loops/four-bar.toml", Step::Kind::assembled).matrix;
    const std::vector<std::string> lines = lines_of_text(matrix_csv(matrix));
    REQUIRE(lines.size() == matrix.rows.size() + 1);
    CHECK(lines[0].starts_with("belongs to,row,crank x,crank y,crank z,crank e₀"));
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
        std::istringstream cells(lines[row + 1]);
        std::string cell;
        std::getline(cells, cell, ',');
        CHECK(cell == matrix.rows[row].owner);
        std::getline(cells, cell, ',');
        for (Eigen::Index k = 0; k < matrix.values.cols(); ++k) {
            std::getline(cells, cell, ',');
            double value = -1.0;
            std::from_chars(cell.data(), cell.data() + cell.size(), value);
            REQUIRE(value == matrix.values(static_cast<Eigen::Index>(row), k));
        }
    }
}

}  // namespace jw::test
