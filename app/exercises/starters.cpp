#include "app/exercises/starters.hpp"

#include <system_error>

#include "app/exercises/kinds.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/write/writer.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr const char* kBeforeInputs = R"(#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

// A number is 1 x 1, a vector n x 1: v[k][0] is its entry k.
using Matrix = std::vector<std::vector<double>>;
using Case = std::map<std::string, Matrix>;

Matrix answer([[maybe_unused]] const Case& c) {
)";

constexpr const char* kAfterInputs =
    R"(    return {{0}};  // a number {{x}}, a vector {{x}, {y}, {z}}, or rows {{1, 2}, {3, 4}}
}

// ---- reads the cases and writes the answers; nothing below has to be changed

class Reader {
public:
    explicit Reader(std::string text) : text_(std::move(text)) {}

    std::vector<Case> cases() {
        std::vector<Case> all;
        at_ = text_.find("\"cases\"");
        at_ = at_ == std::string::npos ? text_.size() : at_ + 7;
        take(':');
        for (take('['); !take(']') && at_ < text_.size(); take(',')) { all.push_back(one_case()); }
        return all;
    }

private:
    // takes a sign if it comes next
    bool take(char sign) {
        at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
        const bool is_there = at_ < text_.size() && text_[at_] == sign;
        at_ += is_there ? 1 : 0;
        return is_there;
    }
    Case one_case() {
        Case inputs;
        for (take('{'); !take('}') && at_ < text_.size(); take(',')) {
            take('"');
            const std::size_t end = std::min(text_.find('"', at_), text_.size());
            const std::string name = text_.substr(at_, end - at_);
            at_ = end;
            take('"');
            take(':');
            inputs[name] = matrix();
        }
        return inputs;
    }
    double number() {
        char* end = nullptr;
        const double value = std::strtod(text_.c_str() + at_, &end);
        at_ = static_cast<std::size_t>(end - text_.c_str());
        return value;
    }
    Matrix matrix() {
        if (!take('[')) { return {{number()}}; }
        Matrix rows;
        for (; !take(']') && at_ < text_.size(); take(',')) {
            rows.emplace_back();
            if (!take('[')) {
                rows.back().push_back(number());
                continue;
            }
            for (; !take(']') && at_ < text_.size(); take(',')) { rows.back().push_back(number()); }
        }
        return rows;
    }

    std::string text_;
    std::size_t at_ = 0;
};

int main() {
    std::string text(std::istreambuf_iterator<char>(std::cin), {});
    std::cout.precision(17);
    std::cout << "{\"answers\": [";
    const char* before_answer = "";
    for (const Case& c : Reader(std::move(text)).cases()) {
        std::cout << before_answer << '[';
        before_answer = ", ";
        const char* before_row = "";
        for (const auto& row : answer(c)) {
            std::cout << before_row << '[';
            before_row = ", ";
            for (std::size_t k = 0; k < row.size(); ++k) { std::cout << (k > 0 ? ", " : "") << row[k]; }
            std::cout << ']';
        }
        std::cout << ']';
    }
    std::cout << "]}\n";
}
)";

/// One line for each input of a case.
std::string lines_for(
    const Task& task, const std::string& before, const std::string& between, const std::string& after) {
    std::string text;
    for (const std::string& name : input_names(task.exercise())) {
        text += before + name + between + name + after + "\n";
    }
    return text;
}

std::string python_starter(const Task& task) {
    return "import json\nimport sys\n\n\ndef answer(case):\n" + lines_for(task, "    ", " = case[\"", "\"]") +
           "    return 0  # a number, a list, or a list of rows\n\n\n"
           "data = json.load(sys.stdin)\n"
           "print(json.dumps({\"answers\": [answer(case) for case in data[\"cases\"]]}))\n";
}

std::string octave_starter(const Task& task) {
    return "1;  % a script\n\nfunction x = answer (c)\n" + lines_for(task, "  ", " = c.", ";") +
           "  x = 0;  % a number, a column, or a matrix\nend\n\n"
           "data = jsondecode (fread (stdin, Inf, 'char=>char')');\nanswers = {};\n"
           "for k = 1:numel (data.cases)\n"
           "  if (iscell (data.cases)) c = data.cases{k}; else c = data.cases(k); end\n"
           "  answers{k} = answer (c);\nend\n"
           "printf ('%s\\n', jsonencode (struct ('answers', {answers})));\n";
}

std::string javascript_starter(const Task& task) {
    return "const data = JSON.parse(require('fs').readFileSync(0, 'utf8'));\n\nfunction answer(c) {\n" +
           lines_for(task, "  const ", " = c.", ";") +
           "  return 0;  // a number, a list, or a list of rows\n}\n\n"
           "console.log(JSON.stringify({ answers: data.cases.map(answer) }));\n";
}

/// The starter in C++, with its own small JSON reader, since C++ has none.
std::string cpp_starter(const Task& task) {
    return kBeforeInputs + lines_for(task, "    [[maybe_unused]] const Matrix& ", " = c.at(\"", "\");") +
           kAfterInputs;
}

/// Writes a file unless it exists. @return why it cannot be written
std::string write_new(const fs::path& file, const std::string& text) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(file, error))) { return {}; }
    if (file.has_parent_path()) { fs::create_directories(file.parent_path(), error); }
    std::string problem;
    write_lesson_file(file, text, problem);
    return problem;
}

}  // namespace

std::string starter_text(const Task& task, std::string_view ending) {
    if (ending == ".py") { return python_starter(task); }
    if (ending == ".cpp") { return cpp_starter(task); }
    if (ending == ".m") { return octave_starter(task); }
    return ending == ".js" ? javascript_starter(task) : std::string();
}

std::string write_starter(const Task& task, const fs::path& file) {
    const std::string text = starter_text(task, file.extension().string());
    if (text.empty()) {
        return tr("Type the name of a file that ends in .py, .cpp, .m or .js into the field.");
    }
    fs::path input = file;
    input.replace_filename(file.stem().string() + "-input.json");
    std::string problem = write_new(file, text);
    if (problem.empty()) { problem = write_new(input, program_input(task)); }
    if (!problem.empty()) { return tr("The starter could not be written: {0}", problem); }
    return tr("The program is '{0}', its input '{1}'.", file.string(), input.filename().string());
}

}  // namespace jw
