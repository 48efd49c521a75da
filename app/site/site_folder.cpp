#include "app/site/site_folder.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <vector>

#include "app/host/frames/frame_draft.hpp"
#include "app/session/output/json.hpp"
#include "render/atomic_file.hpp"

namespace jw::site {

namespace fs = std::filesystem;

namespace {

constexpr const char* kManifest = "site.json";
constexpr const char* kDraft = "unfinished-site";
constexpr const char* kFormat = "jointwise site";
constexpr int kVersion = 1;

/// Files and folders at the top of a site that was written before; none if there is no site.
std::set<std::string> top_of_site_in(const fs::path& folder) {
    std::ifstream in(folder / kManifest, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const Json manifest = Json::parse(text, nullptr, false);
    std::set<std::string> names;
    if (!manifest.is_object() || manifest.value("format", "") != kFormat || !manifest["top"].is_array()) {
        return names;
    }
    for (const Json& name : manifest["top"]) {
        // a name that leads elsewhere is none of ours
        if (name.is_string() && fs::path(name.get<std::string>()).filename() == name.get<std::string>() &&
            name != "." && name != "..") {
            names.insert(name.get<std::string>());
        }
    }
    return names;
}

/// Names that stay whatever is written: those of version control.
bool is_hidden(const std::string& name) { return name.starts_with('.'); }

}  // namespace

SiteFolder::SiteFolder(fs::path folder) : folder_(std::move(folder)), draft_(folder_ / kDraft) {
    std::error_code error;
    is_new_ = fs::create_directories(folder_, error);
    if (error) { host::refuse(folder_, "cannot be made: " + error.message()); }
    const std::set<std::string> ours = top_of_site_in(folder_);
    for (const std::string& name : host::names_in(folder_)) {
        if (is_hidden(name) || name == kDraft || name == kManifest || ours.contains(name)) { continue; }
        host::refuse(
            folder_ / name, "is no part of a site; expected an empty folder, or one with a site of before");
    }
    fs::remove_all(draft_, error);
    fs::create_directory(draft_, error);
    if (error) { host::refuse(draft_, "cannot be made: " + error.message()); }
}

SiteFolder::~SiteFolder() {
    std::error_code ignored;
    fs::remove_all(draft_, ignored);
    // made for a site that failed: it is empty
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
    Json manifest{{"format", kFormat}, {"version", kVersion}, {"top", made}};
    const std::set<std::string> before = top_of_site_in(folder_);
    // until everything is in its place both are ours
    Json both = manifest;
    for (const std::string& name : before) {
        if (std::ranges::find(made, name) == made.end()) { both["top"].push_back(name); }
    }
    render::write_file_atomically(folder_ / kManifest, json_document(both));
    for (const std::string& name : before) { fs::remove_all(folder_ / name); }
    for (const std::string& name : made) {
        fs::remove_all(folder_ / name);
        fs::rename(draft_ / name, folder_ / name);
    }
    render::write_file_atomically(folder_ / kManifest, json_document(manifest));
}

}  // namespace jw::site
