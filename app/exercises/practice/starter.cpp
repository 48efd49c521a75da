#include "app/exercises/practice/starter.hpp"

#include <system_error>

#include "app/exercises/kinds.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/writer.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

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

std::string cpp_starter(const Task& task) {
    std::string names;
    for (const std::string& name : input_names(task.exercise())) { names += "//   " + name + "\n"; }
    return "// Standard input is JSON with a list of cases, each with these inputs:\n" + names +
           "// A vector is a list, a matrix a list of rows. Eigen can be included.\n#include <iostream>\n\n"
           "int main() {\n    std::cout << \"{\\\"answers\\\": []}\\n\";  // one answer for each case\n}\n";
}

/// Writes a file unless it is there. @return why it cannot be written
std::string write_new(const fs::path& file, const std::string& text) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(file, error))) { return {}; }
    if (file.has_parent_path()) { fs::create_directories(file.parent_path(), error); }
    std::string problem;
    write_lesson_file(file, text, problem);
    return problem;
}

}  // namespace

std::string starter_text(const Task& task, const std::string& ending) {
    if (ending == ".py") { return python_starter(task); }
    if (ending == ".m") { return octave_starter(task); }
    if (ending == ".js") { return javascript_starter(task); }
    return ending == ".cpp" ? cpp_starter(task) : std::string();
}

std::string write_starter(const Task& task, const fs::path& file) {
    const std::string text = starter_text(task, file.extension().string());
    if (text.empty()) { return tr("Name a file that ends with .py, .cpp, .m or .js in the field."); }
    fs::path input = file;
    input.replace_filename(file.stem().string() + "-input.json");
    std::string problem = write_new(file, text);
    if (problem.empty()) { problem = write_new(input, program_input(task)); }
    if (!problem.empty()) { return tr("The starter could not be written: {0}", problem); }
    return tr("The program is '{0}', its input '{1}'.", file.string(), input.filename().string());
}

}  // namespace jw
