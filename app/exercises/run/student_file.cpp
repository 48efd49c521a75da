#include "app/exercises/run/student_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/exercises/run/handles.hpp"
#include "app/exercises/run/languages.hpp"
#include "app/exercises/run/safe_text.hpp"

namespace jw::exercises {
namespace {

constexpr std::size_t kLargestSource = 1U << 20U;

ProgramSearch refuse(const std::string& file, const std::string& reason) {
    return {ProgramSearch::Outcome::refused, {}, "'" + printable(file) + "' " + reason};
}

/// True for a name that is one plain word: it becomes part of a path here and in the sandbox.
bool is_plain(const std::string& name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    return !name.empty() && name.size() <= 100 && name[0] != '-' && std::ranges::all_of(name, allowed);
}

std::string kind_of(mode_t mode) {
    if (S_ISLNK(mode)) { return "a symbolic link"; }
    if (S_ISDIR(mode)) { return "a folder"; }
    if (S_ISFIFO(mode)) { return "a pipe"; }
    if (S_ISSOCK(mode)) { return "a socket"; }
    return "a device";
}

/// Reads an open file, up to one byte more than allowed. @return false if it cannot be read
bool read_all(const Handle& file, std::string& text) {
    text.resize(kLargestSource + 1);
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t count = ::read(file.fd(), text.data() + size, text.size() - size);
        if (count < 0 && errno == EINTR) { continue; }
        if (count < 0) { return false; }
        if (count == 0) { break; }
        size += static_cast<std::size_t>(count);
    }
    text.resize(size);
    return true;
}

/// Opens the file first and checks it afterwards, so that it cannot be exchanged in between. Opening a pipe
/// does not wait.
ProgramSearch read_in(const Handle& folder, const std::string& name, const Language& language) {
    struct stat about {};
    if (::fstatat(folder.fd(), name.c_str(), &about, AT_SYMLINK_NOFOLLOW) != 0) {
        return {ProgramSearch::Outcome::absent, {}, "there is no file '" + name + "'"};
    }
    // devices are not even opened, since opening one may have effects
    if (!S_ISREG(about.st_mode)) {
        return refuse(name, "is " + kind_of(about.st_mode) + ", not a regular file");
    }
    constexpr int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    const Handle file(::openat(folder.fd(), name.c_str(), flags));
    if (!file) { return refuse(name, std::string("cannot be read: ") + std::strerror(errno)); }
    if (::fstat(file.fd(), &about) != 0 || !S_ISREG(about.st_mode)) {
        return refuse(name, "is not a regular file");
    }
    ProgramSearch search{ProgramSearch::Outcome::found, {name, {}, &language}, {}};
    if (!read_all(file, search.program.source)) {
        return refuse(name, std::string("cannot be read: ") + std::strerror(errno));
    }
    if (search.program.source.size() > kLargestSource) { return refuse(name, "has more than 1 MB"); }
    return search;
}

/// True if anything in the folder has this name: a file, folder, link or device.
bool is_there(const Handle& folder, const std::string& name) {
    struct stat about {};
    return ::fstatat(folder.fd(), name.c_str(), &about, AT_SYMLINK_NOFOLLOW) == 0;
}

Handle open_folder(std::string path, std::string& problem) {
    // with a slash at its end, the link would be followed
    while (path.size() > 1 && path.ends_with('/')) { path.pop_back(); }
    struct stat about {};
    if (::lstat(path.c_str(), &about) == 0 && S_ISLNK(about.st_mode)) {
        problem = "is a symbolic link, not a folder";
        return {};
    }
    Handle folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!folder) { problem = std::string("cannot be opened: ") + std::strerror(errno); }
    return folder;
}

std::string known_extensions() {
    std::string all;
    for (const Language& language : kLanguages) {
        all += (all.empty() ? "" : ", ") + std::string(language.extension);
    }
    return all;
}

ProgramSearch absent(const std::string& exercise) {
    const std::string reason =
        "there is no program '" + exercise + "' with one of the extensions " + known_extensions();
    return {ProgramSearch::Outcome::absent, {}, reason};
}

}  // namespace

ProgramSearch find_program(const std::string& folder, const std::string& exercise) {
    if (!is_plain(exercise)) { return refuse(exercise, "is not the name of an exercise"); }
    std::string problem;
    const Handle open = open_folder(folder, problem);
    if (!open) { return refuse(folder, problem); }
    std::vector<const Language*> found;
    for (const Language& language : kLanguages) {
        if (is_there(open, exercise + std::string(language.extension))) { found.push_back(&language); }
    }
    if (found.empty()) { return absent(exercise); }
    const std::string name = exercise + std::string(found[0]->extension);
    if (found.size() > 1) {
        const std::string other = exercise + std::string(found[1]->extension);
        return refuse(name, "and '" + other + "' are both there: only one of them can be the answer");
    }
    return read_in(open, name, *found[0]);
}

ProgramSearch read_program(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    const std::size_t dot = std::min(name.rfind('.'), name.size());
    const Language* const language = language_of(name.substr(dot));
    if (!is_plain(name.substr(0, dot))) {
        return refuse(name, "has a name with other characters than a-z, A-Z, 0-9, _ and -");
    }
    if (language == nullptr) {
        return refuse(name, "is in no language that is run here: " + known_extensions());
    }
    std::string problem;
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    const Handle open = open_folder(folder, problem);
    if (!open) { return refuse(folder, problem); }
    return read_in(open, name, *language);
}

}  // namespace jw::exercises
