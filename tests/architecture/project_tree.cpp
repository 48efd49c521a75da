#include "tests/architecture/project_tree.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace jw::architecture {
namespace {

namespace fs = std::filesystem;

constexpr std::array kReadFolders{".ci",     "app",     "cmake",  "core", "docs",
                                  "lessons", "library", "render", "tests"};
constexpr std::array kPictures{".png", ".jpg", ".svg"};

void append(std::vector<SourceFile>& files, const fs::directory_entry& entry) {
    if (!entry.is_regular_file() || std::ranges::count(kPictures, entry.path().extension()) > 0) { return; }
    SourceFile file{entry.path().lexically_relative(JW_SOURCE_ROOT).generic_string(), {}};
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) { file.lines.push_back(line); }
    files.push_back(std::move(file));
}

std::vector<SourceFile> read_project() {
    std::vector<SourceFile> files;
    for (const auto& entry : fs::directory_iterator(JW_SOURCE_ROOT)) {
        // .git, a file in a second working tree of git, is not part of the project
        if (entry.path().filename() != ".git") { append(files, entry); }
    }
    for (const char* folder : kReadFolders) {
        const fs::path path = fs::path(JW_SOURCE_ROOT) / folder;
        if (!fs::exists(path)) { continue; }
        for (const auto& entry : fs::recursive_directory_iterator(path)) { append(files, entry); }
    }
    std::ranges::sort(files, {}, &SourceFile::path);
    return files;
}

}  // namespace

const std::vector<SourceFile>& project_files() {
    static const std::vector<SourceFile> files = read_project();
    return files;
}

bool is_cpp(const SourceFile& file) { return file.path.ends_with(".hpp") || file.path.ends_with(".cpp"); }

}  // namespace jw::architecture
