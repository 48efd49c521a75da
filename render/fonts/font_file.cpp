#include "render/fonts/font_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace jw::render {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeadSize = 12;
constexpr std::size_t kRecordSize = 16;
// in table 'head': the only number that its checksum does not include
constexpr std::size_t kAdjustment = 8;

constexpr std::array<std::string_view, 5> kNeeded{"cmap", "head", "hhea", "hmtx", "maxp"};
constexpr std::array<std::string_view, 2> kOutlines{"glyf", "CFF "};

/// Big-endian number in the four bytes from `at` on, which must exist.
std::uint32_t number_at(Bytes bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < 4; ++k) { number = number << 8U | bytes[at + k]; }
    return number;
}

std::string_view tag_at(Bytes bytes, std::size_t at) {
    return {reinterpret_cast<const char*>(bytes.data()) + at, 4};
}

/// Sum modulo 2^32 of the table's 32-bit numbers; the last one is padded with zeros.
std::uint32_t checksum(Bytes table) {
    std::uint32_t sum = 0;
    std::size_t k = 0;
    for (; k + 4 <= table.size(); k += 4) { sum += number_at(table, k); }
    std::uint32_t rest = 0;
    for (std::size_t n = 0; n < 4; ++n) { rest = rest << 8U | (k + n < table.size() ? table[k + n] : 0U); }
    return sum + rest;
}

bool is_font(Bytes bytes) {
    if (bytes.size() < kHeadSize) { return false; }
    const std::string_view kind = tag_at(bytes, 0);
    return kind == std::string_view("\0\1\0\0", 4) || kind == "OTTO" || kind == "true";
}

}  // namespace

std::string fault_of_font(Bytes bytes) {
    if (!is_font(bytes)) { return "it is not a TrueType or OpenType font"; }
    const std::size_t tables = number_at(bytes, 4) >> 16U;
    if (kHeadSize + kRecordSize * tables > bytes.size()) { return "it ends too early"; }
    std::vector<std::string_view> found;
    for (std::size_t n = 0; n < tables; ++n) {
        const std::size_t record = kHeadSize + kRecordSize * n;
        const std::string_view tag = tag_at(bytes, record);
        const std::uint64_t begin = number_at(bytes, record + 8);
        const std::uint64_t length = number_at(bytes, record + 12);
        if (begin + length > bytes.size()) { return "it ends too early"; }
        const Bytes table = bytes.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(length));
        std::uint32_t sum = checksum(table);
        if (tag == "head" && length >= kAdjustment + 4) { sum -= number_at(table, kAdjustment); }
        if (sum != number_at(bytes, record + 4)) { return "a checksum is wrong: a part of it was changed"; }
        found.push_back(tag);
    }
    const auto has = [&](std::string_view tag) { return std::ranges::find(found, tag) != found.end(); };
    if (!std::ranges::all_of(kNeeded, has) || !std::ranges::any_of(kOutlines, has)) {
        return "a part of it is missing";
    }
    return {};
}

std::vector<std::uint8_t> read_font_file(const std::filesystem::path& path) {
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in) {
        throw std::runtime_error(
            "font '" + path.string() + "' cannot be read: " + std::generic_category().message(errno));
    }
    if (const std::string fault = fault_of_font(bytes); !fault.empty()) {
        throw std::runtime_error("font '" + path.string() + "' is damaged: " + fault);
    }
    return bytes;
}

}  // namespace jw::render
