#include "app/commands/program/outputs.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include "app/commands/program/command.hpp"
#include "app/host/frames/frame_draft.hpp"
#include "app/session/output/json.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "render/files/atomic_file.hpp"
#include "render/fonts/fonts.hpp"

namespace jw {

namespace fs = std::filesystem;

void check_output(const std::string& option, const fs::path& output, const std::vector<fs::path>& inputs) {
    render::check_can_be_written(output);
    std::error_code error;
    if (!fs::exists(output, error)) { return; }
    const auto refuse = [&](const fs::path& input, const std::string& what) {
        if (!fs::equivalent(output, input, error) || error) { return; }
        throw bad_input(
            option + ' ' + in_quotes(output.string()) + " is " + what +
            ", and would be overwritten; expected another file");
    };
    for (const fs::path& input : inputs) { refuse(input, "a file that is read here"); }
    for (const render::FontSource& font : render::find_fonts()) { refuse(font.path, "a font"); }
}

bool is_own_output(const fs::path& path) {
    struct stat file {};
    if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) { return false; }
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat into {};
        if (::fstat(stream, &into) == 0 && into.st_dev == file.st_dev && into.st_ino == file.st_ino) {
            return true;
        }
    }
    return false;
}

void write_proof(
    const std::filesystem::path& file, const ProofRecord& proof, const System& system, const Lesson& lesson) {
    std::string text = json_document(json_of(proof, system, lesson), -1);
    text.resize(text.rfind('}'));
    const std::string hash = host::sha256_of(render::bytes_of(text));
    render::write_file_atomically(file, text + ",\"sha256\":\"" + hash + "\"}\n");
}

}  // namespace jw
