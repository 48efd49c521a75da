#include "app/snapshot/comparison.hpp"

#include <algorithm>
#include <cstdlib>

#include "app/host/frames/environment.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::snapshot {

namespace {

constexpr int kFewPixels = 5;  // of a thing: its edge may be rounded differently

std::string size_text(const render::Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

std::string per_cent(double part) { return short_number(100.0 * part, 3) + " %"; }

int depth_at(const render::Image& depth, int x, int y) { return 256 * depth.at(x, y)[0] + depth.at(x, y)[1]; }

/// Pixels with another depth where both pictures show the same thing. At the edge of a thing, another depth
/// is expected.
render::PixelMask depth_mask(const Snapshot& before, const Snapshot& now, int steps) {
    render::PixelMask mask(now.layers.depth.width, now.layers.depth.height);
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            const bool same = std::equal(
                before.layers.ids.at(x, y), before.layers.ids.at(x, y) + 3, now.layers.ids.at(x, y));
            const int away = std::abs(depth_at(before.layers.depth, x, y) - depth_at(now.layers.depth, x, y));
            mask.at(x, y) = same && away > steps;
        }
    }
    return mask;
}

LayerDifference layer_of(
    const render::Image& base, const render::PixelMask& mask, const SnapshotRules::Layer& rules) {
    LayerDifference difference;
    difference.is_equal = mask.count() == 0;
    if (difference.is_equal) { return difference; }
    difference.broken = broken_rule(mask, rules.share, rules.patch);
    difference.marked = render::marked_picture(base, mask);
    return difference;
}

/// Number of pixels of each thing in a picture of ids.
std::map<std::string, int> areas_of(const Snapshot& snapshot) {
    std::map<std::string, int> areas;
    const render::Image& ids = snapshot.layers.ids;
    for (int y = 0; y < ids.height; ++y) {
        for (int x = 0; x < ids.width; ++x) {
            const auto found = snapshot.record.things.find(colour_of(ids.at(x, y)));
            if (found != snapshot.record.things.end()) { ++areas[found->second]; }
        }
    }
    return areas;
}

std::vector<std::string> changed_things(const Snapshot& before, const Snapshot& now) {
    std::map<std::string, int> change = areas_of(now);
    for (const auto& [name, pixels] : areas_of(before)) { change[name] -= pixels; }
    std::vector<std::pair<int, std::string>> sorted;
    for (const auto& [name, pixels] : change) {
        if (std::abs(pixels) >= kFewPixels) { sorted.emplace_back(-std::abs(pixels), name); }
    }
    std::ranges::sort(sorted);
    std::vector<std::string> words;
    for (const auto& [size, name] : sorted) {
        words.push_back(
            name + ": " + std::to_string(-size) + (change[name] > 0 ? " pixels more" : " pixels fewer"));
    }
    return words;
}

bool have_same_size(const Snapshot& before, const Snapshot& now) {
    const auto same = [](const render::Image& a, const render::Image& b) {
        return a.width == b.width && a.height == b.height;
    };
    return same(before.layers.ids, now.layers.ids) && same(before.layers.depth, now.layers.depth);
}

void compare_layers(
    const Snapshot& before, const Snapshot& now, const SnapshotRules& rules, Difference& difference) {
    if (!have_same_size(before, now)) {
        difference.ids.is_equal = false;
        difference.ids.broken = "the picture is " + size_text(now.layers.ids) + ", it was " +
                                size_text(before.layers.ids) + " or damaged";
        return;
    }
    if (before.layers.ids == now.layers.ids && before.layers.depth == now.layers.depth) { return; }
    difference.ids =
        layer_of(now.layers.ids, render::differing(before.layers.ids, now.layers.ids, 0), rules.ids);
    difference.depth = layer_of(now.layers.ids, depth_mask(before, now, rules.depth_steps), rules.depth);
    difference.things = changed_things(before, now);
}

}  // namespace

std::string broken_rule(const render::PixelMask& mask, double share, int patch) {
    const double part = static_cast<double>(mask.count()) / static_cast<double>(mask.marked.size());
    const int largest = render::largest_patch(mask);
    if (largest > patch) {
        return std::to_string(largest) + " pixels that touch each other differ, and " +
               std::to_string(mask.count()) + " in all; " + std::to_string(patch) + " may touch";
    }
    if (part > share) {
        return std::to_string(mask.count()) + " pixels differ (" + per_cent(part) + "); " + per_cent(share) +
               " may";
    }
    return {};
}

LayerDifference compare_colours(
    const render::Image& before, const render::Image& now, const SnapshotRules::Colour& rules) {
    LayerDifference difference;
    if (before == now) { return difference; }
    difference.is_equal = false;
    if (before.width != now.width || before.height != now.height) {
        difference.broken = "the picture is " + size_text(now) + ", it was " + size_text(before);
        return difference;
    }
    const render::ImageDifference found = render::difference_of(before, now, rules.level);
    const render::PixelMask mask = render::differing(before, now, rules.level);
    difference.marked = render::marked_picture(now, mask);
    difference.broken = broken_rule(mask, rules.share, rules.patch);
    if (difference.broken.empty() && found.largest > rules.largest) {
        difference.broken = "a pixel differs by " + std::to_string(found.largest) + " of 255; " +
                            std::to_string(rules.largest) + " are allowed";
    }
    if (difference.broken.empty() && found.similarity < rules.similarity) {
        const int digits = writing::digits_apart(found.similarity, rules.similarity, 6);
        difference.broken = "the structural similarity is " + short_number(found.similarity, digits) +
                            "; at least " + short_number(rules.similarity, digits) + " is expected";
    }
    return difference;
}

std::optional<StepNumber> other_steps(const Record& before, const Record& now) {
    const std::optional<StepNumber> was = step_number_of(before.facts);
    const std::optional<StepNumber> is = step_number_of(now.facts);
    return was && is && was->steps != is->steps ? was : std::nullopt;
}

Difference difference_of(const Snapshot& before, const Snapshot& now, const SnapshotRules& rules) {
    Difference difference;
    difference.facts = changes_of(before.record.facts, now.record.facts);
    difference.steps_before = other_steps(before.record, now.record);
    if (difference.steps_before) {
        std::erase_if(difference.facts, [](const FactChange& change) {
            return change.name == kStepFact || change.name == kStepsFact;
        });
    }
    difference.loose = loose_tolerances(before.record.facts, now.record.facts);
    difference.drawn_otherwise = host::environment_change(before.record.drawn_with, now.record.drawn_with);
    compare_layers(before, now, rules, difference);
    difference.colour = compare_colours(before.colour, now.colour, rules.colour);
    return difference;
}

}  // namespace jw::snapshot
