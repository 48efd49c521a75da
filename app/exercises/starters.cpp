#include "app/exercises/starters.hpp"

#include "app/exercises/kinds.hpp"

namespace jw {

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
    return cpp_starter_text(lines_for(task, "    [[maybe_unused]] const Matrix& ", " = c.at(\"", "\");"));
}

}  // namespace

std::string starter_text(const Task& task, std::string_view ending) {
    if (ending == ".py") { return python_starter(task); }
    if (ending == ".cpp") { return cpp_starter(task); }
    if (ending == ".m") { return octave_starter(task); }
    return ending == ".js" ? javascript_starter(task) : std::string();
}

}  // namespace jw
