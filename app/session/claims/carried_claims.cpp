#include "app/session/claims/carried_claims.hpp"

#include <algorithm>
#include <optional>

#include "core/numerics/variants.hpp"

namespace jw {

namespace {

/// The same moment in the changed lesson; nothing if the joint or driver that it comes after is gone.
std::optional<Moment> carried(const Moment& when, const Lesson& written, const Lesson& changed) {
    using Carried = std::optional<Moment>;
    return std::visit(
        Overloaded{
            [](const AsGiven& given) -> Carried { return given; },
            [](const AnyState& any) -> Carried { return any; },
            [](const AtRest& rest) -> Carried { return rest; },
            [&](const AfterAddition& after) -> Carried {
                if (after.count == 0) { return after; }
                const Addition& addition = written.order[static_cast<std::size_t>(after.count - 1)];
                const auto found = std::ranges::find(changed.order, addition);
                if (found == changed.order.end()) { return std::nullopt; }
                return AfterAddition{static_cast<int>(found - changed.order.begin()) + 1};
            },
            [](const AtTime& at) -> Carried { return at; },
        },
        when);
}

}  // namespace

std::vector<Claim> carried_claims(const Lesson& written, const Lesson& changed) {
    std::vector<Claim> claims;
    for (const Claim& claim : written.claims) {
        const Addition subject = subject_of(claim.fact);
        if (subject.index >= 0 && std::ranges::find(changed.order, subject) == changed.order.end()) {
            continue;
        }
        if (const std::optional<Moment> when = carried(claim.when, written, changed)) {
            claims.push_back(claim);
            claims.back().when = *when;
        }
    }
    return claims;
}

}  // namespace jw
