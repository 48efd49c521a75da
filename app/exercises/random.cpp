#include "app/exercises/random.hpp"

namespace jw {

std::uint64_t Random::next() {
    // SplitMix64
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}

int Random::below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

std::uint64_t seed_of(std::string_view secret, std::string_view student, std::string_view exercise) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const std::string_view part : {secret, student, exercise}) {
        for (const char c : part) {
            // FNV-1a
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
        }
        // marks the end of a part, so that "ab", "c" differs from "a", "bc"; mixed, so that similar names
        // differ much
        hash = Random(hash ^ 0xFFU).next();
    }
    return hash;
}

}  // namespace jw
