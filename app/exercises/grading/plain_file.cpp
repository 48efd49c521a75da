#include "app/exercises/grading/plain_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "app/session/wording/messages.hpp"

namespace jw {

PlainFile read_plain_file(const std::filesystem::path& path, std::size_t most) {
    PlainFile file;
    const std::string name = path.filename().string();
    // without O_NONBLOCK, opening a pipe would wait
    const int handle = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (handle < 0) {
        file.absent = errno == ENOENT;
        file.problem = file.absent ? tr("There is no file '{0}'.", name)
                                   : tr("'{0}' cannot be read; expected a regular file, not a link.", name);
        return file;
    }
    struct stat status {};
    if (fstat(handle, &status) != 0 || !S_ISREG(status.st_mode)) {
        file.problem = tr("'{0}' is not a regular file.", name);
    } else if (static_cast<std::size_t>(status.st_size) > most) {
        file.problem = tr("'{0}' is larger than {1} kB.", name, most / 1000);
    } else {
        std::array<char, 65536> part{};
        for (ssize_t count = 0;
             file.text.size() <= most && (count = read(handle, part.data(), part.size())) > 0;) {
            file.text.append(part.data(), static_cast<std::size_t>(count));
        }
    }
    close(handle);
    return file;
}

}  // namespace jw
