#pragma once

#include <cstdint>
#include <string_view>

/// Numbers that are the same on every machine for the same seed.
namespace jw {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next();
    /// 0 to count − 1, with equal probability up to count / 2^64. @param count > 0
    int below(int count);

private:
    std::uint64_t state_;
};

/// Seed for an exercise of a student: depends on every byte of its three parts.
std::uint64_t seed_of(std::string_view secret, std::string_view student, std::string_view exercise);

}  // namespace jw
