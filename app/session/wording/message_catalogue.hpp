#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jw {

/// Translations in the format of GNU gettext's compiled catalogues (.mo), read in place in memory.
///
/// A key is the English message; for a message with a count, its singular. Nothing is copied or allocated.
class MessageCatalogue {
public:
    /// @param bytes  must outlive the catalogue, little-endian as `msgfmt --endianness=little` writes them;
    ///               anything else is a catalogue without messages
    constexpr explicit MessageCatalogue(std::span<const unsigned char> bytes) : bytes_(bytes) {}

    /// The translation of `english`, ended by a NUL; nullptr if there is none.
    /// @param count  picks the form of a message with a count. If the language has two forms, the first
    ///               is for 1; if it has one form, it is for all counts
    const char* find(std::string_view english, int count = 1) const;

    /// Number of messages; the first is the header, with the empty key.
    std::size_t size() const;
    /// A message with all its forms, separated by NULs; messages are in ascending order of bytes.
    std::string_view key(std::size_t index) const;
    std::string_view translation(std::size_t index) const;

private:
    std::uint32_t number(std::size_t offset) const;
    std::string_view text(std::size_t table, std::size_t index) const;

    std::span<const unsigned char> bytes_;
};

}  // namespace jw
