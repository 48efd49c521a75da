#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "app/snapshot/comparison.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {

namespace {

const std::string kRoot = std::string(JW_SOURCE_ROOT) + "/";

}  // namespace

bool draws_goldens() { return std::getenv("JW_REGENERATE_GOLDEN") != nullptr; }

std::string broken_rule_of(const render::Image& then, const render::Image& now) {
    const SnapshotRulesRead read = read_snapshot_rules(kRoot + "tests/golden/lessons/rules.toml");
    INFO(read.report());
    REQUIRE(read.rules);
    return snapshot::compare_colours(then, now, read.rules->colour).broken;
}

void compare_with_golden(const std::string& file, const render::Image& now) {
    const std::string path = kRoot + file;
    if (draws_goldens()) {
        render::write_file_atomically(path, render::encode_png(now));
        return;
    }
    INFO(file);
    CHECK(broken_rule_of(read_png(path), now) == "");
}

}  // namespace jw::test
