#include "lessons/files/snapshot_rules.hpp"

#include "lessons/fields/fields.hpp"
#include "lessons/files/file_text.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

constexpr std::size_t kLargestRules = 1U << 16U;
constexpr int kMostPixels = 1 << 28;

/// Reads a fraction, 0 to 1.
void read_part(Fields& fields, const char* key, double& part) {
    const auto read = fields.not_negative(key);
    if (!read) { return; }
    if (read->value > 1.0) {
        fields.report(
            Code::out_of_range, read->span,
            "'" + std::string(key) + "' is " +
                short_number(read->value, writing::digits_apart(read->value, 1.0, 6)) + "; expected 0 to 1");
        return;
    }
    part = read->value;
}

void read_number(Fields& fields, const char* key, int most, int& number) {
    if (const auto read = fields.integer(key, 0, most)) { number = read->value; }
}

void read_layer(Fields fields, SnapshotRules::Layer& layer, int* steps) {
    read_part(fields, "share", layer.share);
    read_number(fields, "patch", kMostPixels, layer.patch);
    if (steps != nullptr) { read_number(fields, "steps", 65535, *steps); }
    fields.finish();
}

SnapshotRules rules_in(const toml::table& table, Problems& problems) {
    SnapshotRules rules;
    Fields fields(table, "rules of snapshots", problems);
    if (auto colour = fields.table("colour")) {
        read_number(*colour, "level", 255, rules.colour.level);
        read_number(*colour, "largest", 255, rules.colour.largest);
        read_part(*colour, "share", rules.colour.share);
        read_number(*colour, "patch", kMostPixels, rules.colour.patch);
        read_part(*colour, "similarity", rules.colour.similarity);
        colour->finish();
    }
    if (auto ids = fields.table("ids")) { read_layer(*ids, rules.ids, nullptr); }
    if (auto depth = fields.table("depth")) { read_layer(*depth, rules.depth, &rules.depth_steps); }
    fields.finish();
    return rules;
}

}  // namespace

SnapshotRulesRead read_snapshot_rules(const std::filesystem::path& file) {
    SnapshotRulesRead result;
    std::error_code error;
    // a broken link is a mistake, not a request for the defaults
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
        result.rules.emplace();
        return result;
    }
    FileText read = read_file_text(file, kLargestRules);
    if (!read.problem.empty()) {
        result.blame(file.string(), Code::file_unreadable, read.problem + "; expected a file of rules");
        return result;
    }
    const auto take = [&](const toml::table& table, Problems& problems) {
        const SnapshotRules rules = rules_in(table, problems);
        if (problems.errors_count() == 0) { result.rules = rules; }
    };
    read_toml(result, std::move(read.text), file.string(), take);
    return result;
}

}  // namespace jw
