#include "render/animation/colour_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace jw::render {

namespace {

// weights of squared differences in red, green and blue: the eye sees green best, but blue changes the hue
constexpr std::array<int, 3> kWeights{2, 4, 3};
// share of all pixels: a colour that covers more is a flat area
constexpr double kFlatShare = 0.0005;
constexpr int kRefinements = 8;  // of the means; more of them change the means by less than a level

struct Counted {
    std::array<double, 3> colour;
    double weight;
};

std::uint32_t packed(const std::uint8_t* rgb) {
    return static_cast<std::uint32_t>(rgb[0]) << 16U | static_cast<std::uint32_t>(rgb[1]) << 8U | rgb[2];
}

Rgb unpacked(std::uint32_t colour) {
    return {
        static_cast<std::uint8_t>(colour >> 16U), static_cast<std::uint8_t>(colour >> 8U),
        static_cast<std::uint8_t>(colour)};
}

/// Colours that are near each other.
class Cluster {
public:
    explicit Cluster(std::vector<Counted> members) : members_(std::move(members)) {
        double sum = 0.0;
        for (const Counted& member : members_) {
            sum += member.weight;
            for (std::size_t c = 0; c < 3; ++c) { mean_[c] += member.weight * member.colour[c]; }
        }
        for (double& mean : mean_) { mean /= sum; }
        std::array<double, 3> spread{};
        for (const Counted& member : members_) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = member.colour[c] - mean_[c];
                spread[c] += kWeights[c] * member.weight * off * off;
            }
        }
        widest_ = static_cast<std::size_t>(std::ranges::max_element(spread) - spread.begin());
        error_ = spread[widest_];
    }

    const std::array<double, 3>& mean() const { return mean_; }
    /// Error along the channel in which its colours differ most; 0: all are equal.
    double error() const { return error_; }

    /// Cuts the cluster at its mean in that channel. Neither half is empty while there is an error.
    std::pair<Cluster, Cluster> halves() const {
        std::vector<Counted> low;
        std::vector<Counted> high;
        for (const Counted& member : members_) {
            (member.colour[widest_] <= mean_[widest_] ? low : high).push_back(member);
        }
        return {Cluster(std::move(low)), Cluster(std::move(high))};
    }

private:
    std::vector<Counted> members_;
    std::array<double, 3> mean_{};
    std::size_t widest_ = 0;
    double error_ = 0.0;
};

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) { sum += kWeights[c] * (a[c] - b[c]) * (a[c] - b[c]); }
    return sum;
}

/// Means of at most `most` clusters; the cluster with the largest error is cut until there are enough.
std::vector<std::array<double, 3>> cut(const std::vector<Counted>& colours, std::size_t most) {
    std::vector<Cluster> clusters;
    clusters.emplace_back(colours);
    while (clusters.size() < most) {
        const auto worst = std::ranges::max_element(clusters, {}, &Cluster::error);
        // differences of a thousandth of a level are rounding of the mean
        if (worst->error() < 1e-6) { break; }
        auto [low, high] = worst->halves();
        *worst = std::move(low);
        clusters.push_back(std::move(high));
    }
    std::vector<std::array<double, 3>> means;
    means.reserve(clusters.size());
    for (const Cluster& cluster : clusters) { means.push_back(cluster.mean()); }
    return means;
}

/// Moves each of the means after the first `fixed` ones to the mean of the colours that are nearest to it.
void refine(
    std::vector<std::array<double, 3>>& means, std::size_t fixed, const std::vector<Counted>& colours) {
    std::vector<Counted> sums(means.size());
    for (const Counted& counted : colours) {
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < means.size(); ++k) {
            const double off = distance(means[k], counted.colour);
            if (off < least) {
                least = off;
                nearest = k;
            }
        }
        Counted& sum = sums[nearest];
        sum.weight += counted.weight;
        for (std::size_t c = 0; c < 3; ++c) { sum.colour[c] += counted.weight * counted.colour[c]; }
    }
    for (std::size_t k = fixed; k < means.size(); ++k) {
        if (sums[k].weight <= 0.0) { continue; }
        for (std::size_t c = 0; c < 3; ++c) { means[k][c] = sums[k].colour[c] / sums[k].weight; }
    }
}

}  // namespace

void ColourCensus::add(const Image& image) {
    const std::size_t pixels = image.rgb.size() / 3;
    for (std::size_t n = 0; n < pixels; ++n) { ++counts_[packed(&image.rgb[3 * n])]; }
    pixels_ += pixels;
}

std::vector<Rgb> ColourCensus::choose(int most) const {
    // in the order of the colours: the order of a hash table does not depend on the pictures alone
    std::vector<std::pair<std::uint32_t, std::uint64_t>> counts(counts_.begin(), counts_.end());
    std::ranges::sort(counts);
    const auto limit = static_cast<std::size_t>(most);
    if (counts.size() <= limit) {
        std::vector<Rgb> all;
        for (const auto& [colour, count] : counts) { all.push_back(unpacked(colour)); }
        return all;
    }
    std::vector<std::pair<std::uint32_t, std::uint64_t>> frequent = counts;
    std::ranges::stable_sort(frequent, std::greater(), [](const auto& entry) { return entry.second; });
    std::vector<std::array<double, 3>> means;
    for (const auto& [colour, count] : frequent) {
        // half of the colours are reserved for shaded areas
        if (means.size() >= limit / 2 ||
            static_cast<double>(count) < kFlatShare * static_cast<double>(pixels_)) {
            break;
        }
        const Rgb rgb = unpacked(colour);
        means.push_back({double(rgb[0]), double(rgb[1]), double(rgb[2])});
    }
    std::vector<Counted> colours;
    colours.reserve(counts.size());
    for (const auto& [colour, count] : counts) {
        const Rgb rgb = unpacked(colour);
        // square root: a small body in its own colour is as important as a large area
        colours.push_back(
            {{double(rgb[0]), double(rgb[1]), double(rgb[2])}, std::sqrt(static_cast<double>(count))});
    }
    const std::size_t fixed = means.size();
    const std::vector<std::array<double, 3>> middles = cut(colours, limit - fixed);
    means.insert(means.end(), middles.begin(), middles.end());
    for (int k = 0; k < kRefinements; ++k) { refine(means, fixed, colours); }
    std::vector<Rgb> chosen;
    for (const std::array<double, 3>& mean : means) {
        Rgb rgb{};
        for (std::size_t c = 0; c < 3; ++c) { rgb[c] = static_cast<std::uint8_t>(std::lround(mean[c])); }
        if (std::ranges::find(chosen, rgb) == chosen.end()) { chosen.push_back(rgb); }
    }
    return chosen;
}

ColourTable::ColourTable(std::vector<Rgb> colours) : colours_(std::move(colours)) {
    for (const Rgb& colour : colours_) {
        luminance_.push_back(std::inner_product(colour.begin(), colour.end(), kWeights.begin(), 0));
    }
}

int ColourTable::nearest(const std::array<int, 3>& colour) const {
    int best = 0;
    int least = std::numeric_limits<int>::max();
    for (std::size_t k = 0; k < colours_.size(); ++k) {
        int off = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int difference = colour[c] - colours_[k][c];
            off += kWeights[c] * difference * difference;
        }
        if (off < least) {
            least = off;
            best = static_cast<int>(k);
        }
    }
    return best;
}

/// Sixteen colours whose mean is as near to `colour` as possible: each corrects errors of those before it.
ColourTable::Pattern ColourTable::mixed(const Rgb& colour) const {
    Pattern pattern{};
    std::array<int, 3> error{};
    for (std::uint8_t& entry : pattern) {
        std::array<int, 3> wanted{};
        for (std::size_t c = 0; c < 3; ++c) { wanted[c] = std::clamp(colour[c] + error[c], 0, 255); }
        const auto found = static_cast<std::size_t>(nearest(wanted));
        entry = static_cast<std::uint8_t>(found);
        for (std::size_t c = 0; c < 3; ++c) { error[c] += colour[c] - colours_[found][c]; }
    }
    std::ranges::stable_sort(pattern, {}, [this](std::uint8_t index) { return luminance_[index]; });
    return pattern;
}

std::uint8_t ColourTable::index(const std::uint8_t* rgb, int x, int y) {
    // each half of the places is spread evenly, and so is each quarter
    static constexpr std::array<std::uint8_t, 16> kOrder{0, 8,  2, 10, 12, 4, 14, 6,
                                                         3, 11, 1, 9,  15, 7, 13, 5};
    const std::uint32_t colour = packed(rgb);
    if (colour != last_) {
        last_ = colour;
        const auto [found, is_new] = patterns_.try_emplace(colour);
        if (is_new) { found->second = mixed(unpacked(colour)); }
        last_pattern_ = &found->second;
    }
    return (*last_pattern_)[kOrder[static_cast<std::size_t>((y & 3) * 4 + (x & 3))]];
}

}  // namespace jw::render
