#include "app/host/frames/frame_draft.hpp"

#include <sha256.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "render/files/atomic_file.hpp"
#include "render/files/png_chunks.hpp"

namespace jw::host {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRun = "run.json";

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) { refuse(path, "cannot be read"); }
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Content of a folder's run.json; `is_discarded` if the file is missing or not JSON.
Json run_in(const fs::path& folder) {
    std::ifstream in(folder / kRun, std::ios::binary);
    return Json::parse(std::string{std::istreambuf_iterator<char>(in), {}}, nullptr, false);
}

/// A value in one line; long values are cut off.
std::string line_of(const Json& value) {
    constexpr std::size_t most = 60;
    const std::string line = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return line.size() <= most ? line : line.substr(0, most) + " ...";
}

/// The first difference of two runs, in words.
std::string difference_of(const Json& before, const Json& now) {
    for (const auto& [key, value] : now.items()) {
        const auto found = before.is_object() ? before.find(key) : before.end();
        if (found == before.end()) { return key + ": nothing before, " + line_of(value) + " now"; }
        if (*found == value) { continue; }
        if (value.is_object() && found->is_object()) { return key + "." + difference_of(*found, value); }
        return key + ": " + line_of(*found) + " before, " + line_of(value) + " now";
    }
    return "something is no longer there";
}

bool is_ours(const std::string& name) {
    const std::string whole = name.substr(0, name.find(".part-"));
    return is_frame_name(whole) || whole == "manifest.json" || whole == kRun || whole.starts_with("film.") ||
           whole.starts_with("part-");
}

}  // namespace

std::string frame_name(int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%05d.png", number);
    return name.data();
}

bool is_frame_name(const std::string& name) {
    constexpr std::string_view begin = "frame_";
    constexpr std::string_view end = ".png";
    if (!name.starts_with(begin) || !name.ends_with(end) || name.size() < begin.size() + end.size() + 5) {
        return false;
    }
    const std::string digits = name.substr(begin.size(), name.size() - begin.size() - end.size());
    return digits.find_first_not_of("0123456789") == std::string::npos;
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        names.push_back(entry->path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

std::string sha256_of(const fs::path& file) { return sha256_of(bytes_of(file)); }

std::string sha256_of(std::span<const std::uint8_t> bytes) {
    std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
    if (SHA256Data(bytes.data(), bytes.size(), digits.data()) == nullptr) { throw std::bad_alloc(); }
    return digits.data();
}

FrameDraft::~FrameDraft() {
    if (is_own_) { clear(); }
}

void FrameDraft::lock(FolderLock::Kind kind) {
    lock_.take(folder_, kind, "is in use by another run; wait until that run ends, or give another folder");
}

void FrameDraft::empty() const {
    std::error_code ignored;
    if (fs::is_symlink(folder_, ignored)) { return; }
    for (const std::string& name : names_in(folder_)) {
        if (is_ours(name)) { fs::remove(folder_ / name, ignored); }
    }
}

void FrameDraft::clear() {
    is_begun_ = is_own_ = false;
    empty();
    std::error_code ignored;
    if (!fs::is_symlink(folder_, ignored)) { fs::remove(folder_, ignored); }
    lock_.let_go();
}

void FrameDraft::start(const Json& run) {
    is_begun_ = is_own_ = true;
    render::write_file_atomically(folder_ / kRun, json_document(run));
}

void FrameDraft::begin(const Json& run) {
    lock(FolderLock::Kind::alone);
    empty();
    if (fs::is_symlink(folder_) || !names_in(folder_).empty()) {
        refuse(
            folder_,
            "contains files that this program did not write; expected a folder that is only for pictures");
    }
    start(run);
}

void FrameDraft::check_run(const Json& run) const {
    const Json before = run_in(folder_);
    if (before == run) { return; }
    if (before.is_discarded()) {
        refuse(folder_, "has no run.json that tells what its pictures depend on; remove it to start again");
    }
    refuse(
        folder_, "has pictures of another run (" + difference_of(before, run) +
                     "); give the same options and lesson, or remove it to start again");
}

void FrameDraft::go_on(const Json& run) {
    lock(FolderLock::Kind::alone);
    if (names_in(folder_).empty()) {
        start(run);
        return;
    }
    check_run(run);
    is_begun_ = true;
    // partial files of writers that have ended
    for (const std::string& name : names_in(folder_)) {
        std::error_code ignored;
        if (is_ours(name) && name.find(".part-") != std::string::npos) {
            fs::remove(folder_ / name, ignored);
        }
    }
}

void FrameDraft::join(const Json& run, Joined as) {
    // a part does not lock the folder: the process that has begun it holds the lock
    if (as == Joined::shard) { lock(FolderLock::Kind::shared); }
    is_begun_ = true;
    if (!fs::exists(folder_ / kRun)) {
        // if several processes begin at the same time, the first one's run.json counts for all of them
        const fs::path mine =
            folder_ / (std::string(kRun) + ".part-" + std::to_string(std::hash<Json>()(run)));
        render::write_file_atomically(mine, json_document(run));
        std::error_code error;
        fs::create_hard_link(mine, folder_ / kRun, error);
        fs::remove(mine, error);
    }
    check_run(run);
}

bool FrameDraft::has(int number) const {
    const fs::path path = folder_ / frame_name(number);
    return fs::is_regular_file(path) && render::is_whole_png(bytes_of(path));
}

}  // namespace jw::host
