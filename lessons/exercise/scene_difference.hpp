#pragma once

#include <string>
#include <vector>

/// Differences between two lesson files; keys are the paths of scene_edits.hpp.
namespace jw {

/// Parts of a lesson file that are compared.
enum class SceneParts {
    mechanics,  ///< the mechanism itself, without appearance, texts and claims
    all,
};

/// A list whose entries are in a different order.
struct OtherOrder {
    std::string path;                 ///< "body"
    std::vector<std::string> before;  ///< names, or numbers from 0
    std::vector<std::string> after;

    bool operator==(const OtherOrder&) const = default;
};

/// Keys whose values differ between two lesson files. A table that only one file has counts once, under its
/// own path; an entry without a name is numbered as in that file. The order of keys does not matter.
struct SceneDifference {
    std::vector<std::string> changed;
    std::vector<std::string> added;
    std::vector<std::string> removed;
    std::vector<OtherOrder> reordered;

    /// Number of keys, without lists in another order.
    std::size_t count() const { return changed.size() + added.size() + removed.size(); }
};
SceneDifference difference_of(
    const std::string& before, const std::string& after, SceneParts parts = SceneParts::mechanics);

}  // namespace jw
