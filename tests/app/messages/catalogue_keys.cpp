#include "tests/app/messages/catalogue_keys.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "app/session/wording/message_catalogue.hpp"
#include "tests/support/temporary_folder.hpp"

namespace jw::test {

namespace {

std::vector<unsigned char> bytes_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The template, with the English sentences as their own translations, compiled.
std::vector<unsigned char> compiled_template() {
    const TemporaryFolder folder;  // other tests collect the messages at the same time
    const std::string base = folder.path() / "sources";
    const std::string command = std::string(JW_SOURCE_ROOT "/dev messages --template ") + base + ".pot && " +
                                "msgen --output-file=" + base + ".po " + base + ".pot && " +
                                "msgfmt --endianness=little --output-file=" + base + ".mo " + base + ".po";
    if (std::system(command.c_str()) != 0) { throw std::runtime_error("cannot collect the messages"); }
    return bytes_of(base + ".mo");
}

}  // namespace

std::map<std::string, std::string> messages_of_sources() {
    const std::vector<unsigned char> bytes = compiled_template();
    const MessageCatalogue catalogue(bytes);
    std::map<std::string, std::string> messages;
    for (std::size_t k = 1; k < catalogue.size(); ++k) {
        const std::string key(catalogue.key(k));
        const std::size_t plural = key.find('\0');
        messages[key.substr(0, plural)] = plural == std::string::npos ? key : key.substr(plural + 1);
    }
    return messages;
}

}  // namespace jw::test
