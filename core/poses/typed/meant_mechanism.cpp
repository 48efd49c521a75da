#include "core/poses/typed/meant_mechanism.hpp"

#include <algorithm>
#include <numeric>

#include "core/poses/large_rank.hpp"
#include "core/poses/typed/closed_parts.hpp"
#include "core/poses/typed/loose_motion.hpp"
#include "core/poses/typed/meant_search.hpp"

namespace jw {

namespace {

/// Largest part that is searched, in about 8 s: decompositions of larger ones take longer than a reader
/// waits.
constexpr int kMostTypedBodies = 25;

/// Rank of all joints at the start, as they are.
int rank_of_joints(const Mechanism& mechanism) {
    System system(mechanism, joints_of(mechanism));
    const State state = best_start(system);
    system.choose_rows(state);
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    return analyse_rank_of_any_size(system, assembler.sparse_jacobian(), VectorX::Zero(system.rows()), false)
        .rank;
}

class Judgement {
public:
    Judgement(const Mechanism& mechanism, const std::vector<TypedNumber>& numbers)
        : mechanism_(mechanism), numbers_(numbers) {}

    /// @param posed the mechanism with the poses from which the part is searched
    void judge(const Mechanism& posed, const ClosedPart& part);
    std::optional<MeantMechanism> result() const;

private:
    struct Found {
        ClosedPart part;
        MeantPart meant;
    };
    std::vector<TypedNumber> numbers_of(const ClosedPart& part, bool with_short) const;
    void judge_less(Mechanism posed, const ClosedPart& part, const RankDoubt& doubt);
    std::optional<MeantPart> search(
        const Mechanism& mechanism, const ClosedPart& part, const std::vector<TypedNumber>& long_numbers,
        const RankDoubt& doubt) const;

    const Mechanism& mechanism_;
    const std::vector<TypedNumber>& numbers_;
    std::vector<Found> found_;
};

/// Numbers that change the part; joints are numbered within the part.
std::vector<TypedNumber> Judgement::numbers_of(const ClosedPart& part, bool with_short) const {
    std::vector<TypedNumber> out;
    for (std::size_t k = 0; k < numbers_.size(); ++k) {
        const TypedNumber& number = numbers_[k];
        if (number.is_short && !with_short) { continue; }
        TypedNumber own{number.half_unit, {}, number.is_short, static_cast<int>(k)};
        for (TypedNumber::Change change : number.changes) {
            const auto found = std::ranges::lower_bound(part.joints, change.joint);
            if (found == part.joints.end() || *found != change.joint) { continue; }
            change.joint = static_cast<int>(found - part.joints.begin());
            own.changes.push_back(change);
        }
        if (!own.changes.empty()) { out.push_back(std::move(own)); }
    }
    return out;
}

/// Judges only the joints in doubt, without the others of the part.
void Judgement::judge_less(Mechanism posed, const ClosedPart& part, const RankDoubt& doubt) {
    for (std::size_t b = 0; b < posed.bodies.size(); ++b) {
        posed.bodies[b].r = doubt.start.r[b];
        posed.bodies[b].p = doubt.start.p[b];
    }
    std::vector<int> joints;
    for (const int j : doubt.joints) { joints.push_back(part.joints[at(j)]); }
    for (const ClosedPart& less : closed_parts(posed, joints)) { judge(posed, less); }
}

/// Result for the whole part. Short numbers count as rounded only if the long ones alone do not decide.
std::optional<MeantPart> Judgement::search(
    const Mechanism& mechanism, const ClosedPart& part, const std::vector<TypedNumber>& long_numbers,
    const RankDoubt& doubt) const {
    auto meant = find_meant(mechanism, long_numbers, doubt);
    if (!meant || meant->verdict.is_told) { return meant; }
    const std::vector<TypedNumber> numbers = numbers_of(part, true);
    const auto with_short = find_doubt(mechanism, numbers);
    auto found = with_short ? find_meant(mechanism, numbers, *with_short) : std::nullopt;
    return found ? found : meant;
}

void Judgement::judge(const Mechanism& posed, const ClosedPart& part) {
    const Mechanism mechanism = alone(posed, part);
    const std::vector<TypedNumber> numbers = numbers_of(part, false);
    const auto doubt = find_doubt(mechanism, numbers);
    if (!doubt) { return; }
    const std::size_t before = found_.size();
    if (doubt->joints.size() < part.joints.size()) {
        judge_less(posed, part, *doubt);
        const auto is_told = [](const Found& found) { return found.meant.verdict.is_told; };
        if (found_.size() > before && std::all_of(found_.begin() + before, found_.end(), is_told)) { return; }
    }
    if (mechanism.moving_bodies_count() > kMostTypedBodies) { return; }
    // a result for these joints alone is kept, unless one for the whole part is found
    auto meant = search(mechanism, part, numbers, *doubt);
    if (meant && (meant->verdict.is_told || found_.size() == before)) {
        found_.resize(before);
        found_.push_back({part, std::move(*meant)});
    }
}

std::optional<MeantMechanism> Judgement::result() const {
    if (found_.empty()) { return std::nullopt; }
    Mechanism meant = mechanism_;
    TypedVerdict whole;
    whole.is_told = true;
    int lost = 0;
    int lost_told = 0;
    VectorX effects = VectorX::Zero(static_cast<Eigen::Index>(numbers_.size()));
    for (const auto& [part, found] : found_) {
        const TypedVerdict& verdict = found.verdict;
        lost += verdict.rank_as_typed - verdict.rank;
        lost_told += verdict.is_told ? verdict.rank_as_typed - verdict.rank : 0;
        whole.misfit = std::max(whole.misfit, verdict.misfit);
        whole.share = std::max(whole.share, verdict.share);
        whole.is_told = whole.is_told && verdict.is_told;
        for (const auto& [number, effect] : found.effects) {
            effects(number) = std::max(effects(number), effect);
        }
        for (std::size_t k = 0; k < part.joints.size(); ++k) {
            meant.joints[at(part.joints[k])].geometry = found.geometry[k];
        }
    }
    whole.rank_as_typed = rank_of_joints(meant) + lost_told;
    whole.rank = whole.rank_as_typed - lost;
    MeantMechanism out{whole, {}, effects};
    for (const Joint& joint : meant.joints) { out.geometry.push_back(joint.geometry); }
    return out;
}

}  // namespace

std::optional<MeantMechanism> judge_typed_numbers(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers) {
    Judgement judgement(mechanism, numbers);
    std::vector<int> joints(mechanism.joints.size());
    std::iota(joints.begin(), joints.end(), 0);
    for (const ClosedPart& part : closed_parts(mechanism, joints)) { judgement.judge(mechanism, part); }
    return judgement.result();
}

}  // namespace jw
