#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "tests/mutation/marks.hpp"

/// mark_mutants LIST ROOT OUT: copies the sources of LIST (see sources.txt) from ROOT to OUT with their marks
/// and writes OUT/mutants.txt, one mutant a line: number, kind, place, head of the function, line; tabs
/// between.
namespace {

using namespace jw::mutation;
namespace fs = std::filesystem;

/// Place whose result stays right with the other sign, and the reason.
struct Exemption {
    std::string text;
    std::string reason;
    bool found = false;
};

struct Source {
    std::string path;
    Besides besides;
    std::vector<Exemption> exemptions;
};

std::string content_of(const fs::path& path) {
    std::ifstream stream(path);
    if (!stream) { throw std::runtime_error("cannot read " + path.string()); }
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Writes a file unless it stays the same, so that nothing is built again because of it.
void write(const fs::path& path, const std::string& text) {
    if (fs::exists(path) && content_of(path) == text) { return; }
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

std::vector<Source> sources_of(const fs::path& list) {
    std::istringstream lines(content_of(list));
    std::vector<Source> sources;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with('#')) { continue; }
        if (line.starts_with("  except ")) {
            sources.back().exemptions.push_back({line.substr(9), {}});
        } else if (line.starts_with("    ")) {
            sources.back().exemptions.back().reason += line.substr(4);
        } else {
            std::istringstream words(line);
            Source source;
            words >> source.path;
            for (std::string word; words >> word;) {
                if (word != "jets" && word != "branches") { throw std::runtime_error("unknown: " + line); }
                (word == "jets" ? source.besides.jets : source.besides.branches) = true;
            }
            sources.push_back(source);
        }
    }
    return sources;
}

/// True if the list has this text, a line or "NAME OF A MUTANT: line".
bool is_exempt(Source& source, const std::string& text) {
    const auto exemption = std::ranges::find(source.exemptions, text, &Exemption::text);
    if (exemption == source.exemptions.end()) { return false; }
    exemption->found = true;
    return true;
}

void require_true_list(const Source& source, std::size_t marks) {
    if (marks == 0) { throw std::runtime_error(source.path + ": nothing in it can be made wrong"); }
    for (const Exemption& exemption : source.exemptions) {
        if (!exemption.found) {
            throw std::runtime_error(source.path + ": no mutant here: " + exemption.text);
        }
        if (exemption.reason.empty()) {
            throw std::runtime_error(source.path + ": no reason given for: " + exemption.text);
        }
    }
}

std::vector<std::string> names_of(Kind kind) {
    switch (kind) {
        case Kind::loop: return {"loop"};
        case Kind::branch: return {"branch"};
        case Kind::jet: return {"first block", "last block", "rate", "bias"};
        case Kind::value: return {"value"};
        case Kind::term: return {"term"};
        case Kind::number: break;
    }
    return {"number"};
}

/// @return lines for mutants.txt
std::string mark(Source& source, int first, const fs::path& root, const fs::path& out) {
    const std::string text = content_of(root / source.path);
    std::vector<Mark> marks = marks_of(text, source.besides);
    std::erase_if(marks, [&](const Mark& m) { return is_exempt(source, line_at(text, m.begin)); });
    write(
        out / source.path, "#include \"tests/mutation/switch.hpp\"\n#line 1\n" + marked(text, marks, first));

    std::ostringstream lines;
    for (const Mark& m : marks) {
        const std::string line = line_at(text, m.begin);
        const std::string place = " at column " + std::to_string(m.begin - text.rfind('\n', m.begin));
        for (const std::string& name : names_of(m.kind)) {
            const int number = first++;
            if (is_exempt(source, name + place + ": " + line)) { continue; }
            lines << number << '\t' << name << place << '\t' << source.path << ':'
                  << line_number_at(text, m.begin) << '\t' << head_at(text, m.begin) << '\t' << line << '\n';
        }
    }
    require_true_list(source, marks.size());
    return lines.str();
}

}  // namespace

int main(int count, char** arguments) {
    try {
        if (count != 4) { throw std::runtime_error("usage: mark_mutants LIST ROOT OUT"); }
        std::string mutants;
        // a thousand numbers for each file: a change in one file leaves the numbers of the others
        int first = 1000;
        for (Source& source : sources_of(arguments[1])) {
            mutants += mark(source, first, arguments[2], arguments[3]);
            first += 1000;
        }
        write(fs::path(arguments[3]) / "mutants.txt", mutants);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "mark_mutants: " << error.what() << '\n';
        return 1;
    }
}
