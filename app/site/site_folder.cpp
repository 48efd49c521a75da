#include "app/site/site_folder.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "app/host/frames/frame_draft.hpp"
#include "app/session/output/json.hpp"
#include "lessons/files/file_text.hpp"
#include "render/files/atomic_file.hpp"

namespace jw::site {

namespace fs = std::filesystem;

namespace {

constexpr const char* kManifest = "site.json";
constexpr const char* kDraft = ".unfinished-site";
constexpr const char* kReplaced = ".replaced-site";
constexpr const char* kFormat = "jointwise site";
constexpr int kVersion = 1;
constexpr std::size_t kMostOfManifest = 1U << 20U;  // bytes

/// True for names that are never touched: hidden ones, such as those of version control.
bool is_hidden(const std::string& name) { return name.starts_with('.'); }

/// True for a name that can be part of a site, and cannot lead out of its folder.
bool is_part(const std::string& name) {
    return !name.empty() && !is_hidden(name) && name != kManifest && fs::path(name).filename() == name;
}

/// Files and folders at the top of the site in a folder; none if the folder has no manifest.
/// @throws std::runtime_error if the manifest is not one of the program
std::set<std::string> top_of_site_in(const fs::path& folder) {
    const fs::path file = folder / kManifest;
    std::error_code error;
    if (!fs::exists(fs::symlink_status(file, error))) { return {}; }
    if (!fs::is_regular_file(file, error)) {
        host::refuse(file, "is not a regular file; expected another folder");
    }
    const Json manifest = Json::parse(read_file_text(file, kMostOfManifest).text, nullptr, false);
    const bool is_ours = manifest.is_object() && manifest.contains("format") &&
                         manifest["format"] == kFormat && manifest.contains("version") &&
                         manifest["version"].is_number_integer() && manifest.contains("top") &&
                         manifest["top"].is_array();
    if (!is_ours) {
        host::refuse(
            file, "is not the list of a site; expected an empty folder, or one with an earlier site");
    }
    if (manifest["version"].get<int>() > kVersion) {
        host::refuse(
            file, "was written by a newer Jointwise; expected a site of version 1, or an empty folder");
    }
    std::set<std::string> names;
    for (const Json& name : manifest["top"]) {
        if (name.is_string() && is_part(name.get<std::string>())) { names.insert(name.get<std::string>()); }
    }
    return names;
}

/// Renames that are all undone unless all of them succeed.
class Renames {
public:
    ~Renames() {
        std::error_code ignored;
        for (auto done = done_.rbegin(); done != done_.rend(); ++done) {
            fs::rename(done->second, done->first, ignored);
        }
    }
    void move(const fs::path& from, const fs::path& to) {
        fs::rename(from, to);
        done_.emplace_back(from, to);
    }
    void keep() { done_.clear(); }

private:
    std::vector<std::pair<fs::path, fs::path>> done_;
};

}  // namespace

SiteFolder::SiteFolder(fs::path folder)
    : folder_(std::move(folder)), draft_(folder_ / kDraft), replaced_(folder_ / kReplaced) {
    std::error_code error;
    is_new_ = fs::create_directories(folder_, error);
    if (error) { host::refuse(folder_, "cannot be made: " + error.message()); }
    const bool is_made_again = lock_.take(
        folder_, host::FolderLock::Kind::alone,
        "is not free; does another run write a site into it? Wait until it has ended, or give another "
        "folder");
    is_new_ = is_new_ || is_made_again;
    const std::set<std::string> ours = top_of_site_in(folder_);
    for (const std::string& name : host::names_in(folder_)) {
        if (is_hidden(name) || name == kManifest || ours.contains(name)) { continue; }
        host::refuse(
            folder_ / name, "is not part of a site; expected an empty folder, or one with an earlier site");
    }
    // a run was killed while it replaced the old site: put the old site back
    for (const std::string& name : host::names_in(replaced_)) {
        fs::remove_all(folder_ / name);
        fs::rename(replaced_ / name, folder_ / name);
    }
    fs::remove_all(replaced_, error);
    fs::remove_all(draft_, error);
    fs::create_directory(draft_, error);
    if (error) { host::refuse(draft_, "cannot be made: " + error.message()); }
}

SiteFolder::~SiteFolder() {
    std::error_code ignored;
    fs::remove_all(draft_, ignored);
    // created for a site that failed, so it is empty
    if (is_new_) { fs::remove(folder_, ignored); }
}

void SiteFolder::write(const std::string& path, std::string_view text) const {
    write(path, render::bytes_of(text));
}

void SiteFolder::write(const std::string& path, std::span<const std::uint8_t> bytes) const {
    fs::create_directories((draft_ / path).parent_path());
    render::write_file_atomically(draft_ / path, bytes);
}

void SiteFolder::finish() {
    const std::vector<std::string> made = host::names_in(draft_);
    const std::set<std::string> before = top_of_site_in(folder_);
    Json manifest{{"format", kFormat}, {"version", kVersion}, {"top", made}};
    // until everything is in its place, the files of both sites are listed
    Json both = manifest;
    for (const std::string& name : before) {
        if (std::ranges::find(made, name) == made.end()) { both["top"].push_back(name); }
    }
    render::write_file_atomically(folder_ / kManifest, json_document(both));
    fs::create_directory(replaced_);
    Renames renames;
    for (const std::string& name : before) {
        if (fs::exists(fs::symlink_status(folder_ / name))) {
            renames.move(folder_ / name, replaced_ / name);
        }
    }
    for (const std::string& name : made) { renames.move(draft_ / name, folder_ / name); }
    // written while the renames can still be undone: there may be no room for the list
    render::write_file_atomically(folder_ / kManifest, json_document(manifest));
    renames.keep();
    std::error_code ignored;
    fs::remove_all(replaced_, ignored);
}

}  // namespace jw::site
