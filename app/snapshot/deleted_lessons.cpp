#include "app/snapshot/deleted_lessons.hpp"

#include <algorithm>
#include <stdexcept>

#include "lessons/files/file_text.hpp"
#include "render/files/atomic_file.hpp"

namespace jw::snapshot {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRemoved = "removed.json";
constexpr const char* kRemovedFormat = "jointwise removed snapshots";
constexpr int kRemovedVersion = 1;
constexpr std::size_t kLargestRemoved = 1U << 23U;

/// Entries of `removed.json`, the last one at the end; none if the file is not there.
Json removed_so_far(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(file, error))) { return Json::array(); }
    const Json json = Json::parse(read_file_text(file, kLargestRemoved).text, nullptr, false);
    const bool known = json.is_object() && json.value("format", Json()) == kRemovedFormat &&
                       json.value("version", Json()) == kRemovedVersion &&
                       json.value("removed", Json()).is_array();
    if (!known) {
        throw std::runtime_error(
            "'" + file.string() + "' is damaged, or of another version; expected \"format\" \"" +
            kRemovedFormat + "\" and \"version\" " + std::to_string(kRemovedVersion));
    }
    return json["removed"];
}

}  // namespace

std::vector<std::string> deleted_lessons(
    const std::vector<std::string>& paths, const std::vector<SuiteLesson>& suite, const fs::path& golden) {
    const auto is_folder = [](const std::string& path) {
        std::error_code error;
        return fs::is_directory(path, error);
    };
    if (std::ranges::none_of(paths, is_folder)) { return {}; }
    std::vector<std::string> deleted = GoldenFolder::recorded_below(golden);
    std::erase_if(deleted, [&](const std::string& name) {
        return std::ranges::find(suite, name, &SuiteLesson::name) != suite.end();
    });
    return deleted;
}

std::vector<SuiteLesson> suite_or_emptied(const std::vector<std::string>& paths, const fs::path& golden) {
    std::vector<SuiteLesson> suite = suite_of(paths, EmptyFolders::allowed);
    const bool lost_some = !deleted_lessons(paths, suite, golden).empty();
    const bool is_known = lost_some || (suite.empty() && !removed_so_far(golden / kRemoved).empty());
    return is_known ? suite : suite_of(paths);
}

LessonResult result_of_deleted(const std::string& name, const fs::path& golden) {
    LessonResult result;
    result.lesson = {{}, name};
    result.is_deleted = true;
    const GoldenFolder folder(golden / name);
    for (const std::string& snapshot : folder.names()) {
        result.snapshots.push_back(gone_snapshot(folder, snapshot));
    }
    return result;
}

void bless_deletion(const std::string& name, const fs::path& golden, const std::string& reason) {
    const fs::path file = golden / kRemoved;
    Json removed = removed_so_far(file);
    const Json entry{{"lesson", name}, {"reason", reason}};
    // not twice, if the removal was interrupted before
    if (removed.empty() || removed.back() != entry) { removed.push_back(entry); }
    render::write_file_atomically(
        file,
        json_document(
            Json{{"format", kRemovedFormat}, {"version", kRemovedVersion}, {"removed", std::move(removed)}}));
    GoldenFolder(golden / name).remove_lesson(golden);
}

}  // namespace jw::snapshot
