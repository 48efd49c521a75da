#include "app/site/site.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/commands/program/add_command.hpp"
#include "app/session/wording/messages.hpp"
#include "app/site/live_page.hpp"
#include "app/site/page_frame.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/files/catalogue.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSlides = "slides.pdf";
// reading and proving take a small part of the time
constexpr double kReadingPart = 0.1;

struct SiteSetup {
    std::string folder;
    std::string out;
    std::string exercises;
    std::string title;
    std::string slides;
    std::string page;
};

bool is_url(const std::string& text) { return text.starts_with("https://") || text.starts_with("http://"); }

void check_folder(const std::string& what, const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) { return; }
    throw bad_input(what + in_quotes(folder.string()) + " is not a folder; expected a folder of .toml files");
}

/// True if a path, which need not exist, is a folder or lies below it, after following links.
bool lies_in(const fs::path& path, const fs::path& folder) {
    const fs::path way = fs::weakly_canonical(fs::absolute(path))
                             .lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
    return !way.empty() && *way.begin() != "..";
}

void check_slides(const std::string& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        throw bad_input("--slides: there is no file " + in_quotes(file) + "; expected a PDF file or a URL");
    }
    std::string first(5, '\0');
    std::ifstream(file, std::ios::binary).read(first.data(), static_cast<std::streamsize>(first.size()));
    if (first == "%PDF-") { return; }
    throw bad_input("--slides: " + in_quotes(file) + " is not a PDF; expected a PDF file or a URL");
}

/// Reports files in the folder of lessons that are not lessons, and so are not in the site.
void tell_left_out(const fs::path& folder, const Streams& streams) {
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code unknown;
        std::string why;
        const bool hidden = is_hidden(entry->path());
        if (hidden) { entry.disable_recursion_pending(); }
        if (!hidden && entry->is_directory(unknown) && ::access(entry->path().c_str(), R_OK | X_OK) != 0) {
            why = "this folder cannot be read";
        } else if (entry->path().extension() == ".toml" && !entry->is_regular_file(unknown)) {
            why = "this is not a regular file";
        } else if (hidden && entry->path().extension() == ".toml") {
            why = "its name begins with a dot";
        }
        if (!why.empty()) {
            streams.err << "jointwise: note: " << entry->path().string() << ": " << why
                        << ", and is left out\n";
        }
    }
}

/// Checks everything that is read before anything is computed.
void check_setup(const SiteSetup& setup) {
    if (setup.out.empty()) { throw bad_input("--out: the name is empty; expected a folder"); }
    check_folder("", setup.folder);
    if (!setup.exercises.empty()) { check_folder("--exercises ", setup.exercises); }
    if (lessons_below(setup.folder).empty()) {
        throw bad_input(
            "no lessons are below " + in_quotes(setup.folder) + "; expected files of lessons, *.toml");
    }
    const std::string problem = site::problem_of_page(setup.page);
    if (!problem.empty()) { throw bad_input("--page: " + problem); }
    if (!setup.slides.empty() && !is_url(setup.slides)) { check_slides(setup.slides); }
    for (const std::string& read : {setup.folder, setup.exercises, setup.page}) {
        if (read.empty()) { continue; }
        if (lies_in(setup.out, read) || lies_in(read, setup.out)) {
            throw bad_input(
                "--out: one of " + in_quotes(setup.out) + " and " + in_quotes(read) +
                " (which is read) contains the other; expected a folder elsewhere");
        }
    }
}

Exit make_site(const SiteSetup& given, const Streams& streams) {
    SiteSetup setup = given;
    if (setup.page.empty()) { setup.page = (data_folder() / "page").string(); }
    check_setup(setup);
    tell_left_out(setup.folder, streams);
    // exercises name lessons of this course, not of the one that comes with the program
    ::setenv("JOINTWISE_LESSONS", setup.folder.c_str(), 1);
    ProgressBar progress(streams, "site");
    site::SiteCourseRead read = site::read_site_course(
        setup.folder, setup.exercises, [&](double share) { progress.show(kReadingPart * share); });
    if (!read.report.empty()) { throw CommandError(Exit::bad_input, read.report); }
    if (!read.failed_claims.empty()) {
        throw CommandError(
            Exit::check_failed, read.failed_claims +
                                    "jointwise: error: what these lessons claim does not hold; 'jointwise "
                                    "check' tells more, and no site is written");
    }
    for (const std::string& note : read.notes) { streams.err << "jointwise: note: " << note << '\n'; }
    const bool is_blank = site::words_plain(setup.title).empty();
    read.course.title = is_blank ? tr("Lessons") : setup.title;
    read.course.program = "Jointwise " JW_VERSION;
    site::SiteOutput output{setup.out, setup.page, {}};
    if (is_url(setup.slides)) {
        read.course.slides = setup.slides;
    } else if (!setup.slides.empty()) {
        read.course.slides = kSlides;
        output.slides = setup.slides;
    }
    site::write_site(read.course, output, [&](double share) {
        progress.show(kReadingPart + (1.0 - kReadingPart) * share);
    });
    streams.out << "the site is in '" << setup.out << "': " << read.course.lessons.size()
                << (read.course.lessons.size() == 1 ? " lesson" : " lessons") << "; put it on a web server\n";
    return Exit::done;
}

}  // namespace

void add_site(const CommandLine& line) {
    auto [command, setup] = add_command<SiteSetup>(
        line, "site", "write the lessons of a folder as a web site that contains the program", make_site,
        "Example: jointwise site lessons/catalogue --out public --title 'Spatial kinematics' --slides "
        "slides.pdf");
    add_value(command, "FOLDER", setup.folder, "", "folder of lessons, with course.toml for their order")
        ->required();
    add_value(command, "--out", setup.out, "DIR", "folder of the site; an earlier site in it is replaced")
        ->required();
    add_value(
        command, "--exercises", setup.exercises, "FOLDER",
        "folder of files of exercises (default: 'exercises' beside the lessons, if it exists)");
    add_value(command, "--title", setup.title, "TEXT", "title of the course");
    add_value(
        command, "--slides", setup.slides, "FILE",
        "slides that lessons refer to: a PDF file to copy, or a URL");
    add_value(
        command, "--page", setup.page, "FOLDER",
        "files of the web version of the program (default: those that were built or installed)");
}

}  // namespace jw
