#pragma once

#include <string>
#include <vector>

namespace jw::architecture {

struct SourceFile {
    std::string path;  ///< from the project's root, "core/poses/rank.cpp"
    std::vector<std::string> lines;
};

/// Every text file of the project's own folders and of its root; nothing that was built or drawn.
const std::vector<SourceFile>& project_files();

bool is_cpp(const SourceFile& file);

}  // namespace jw::architecture
