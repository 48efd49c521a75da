#include "app/session/story/story_telling.hpp"

#include "core/equations/assembler.hpp"
#include "core/poses/large_rank.hpp"

namespace jw {

RankReport rank_of(const System& system, const State& state, double t, bool spectrum) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, t);
    return analyse_rank_of_any_size(system, assembler.sparse_jacobian(), assembler.phi(), spectrum);
}

int count_of(const RankReport& report, Count count) {
    switch (count) {
        case Count::rank: return report.rank;
        case Count::rows: return report.rows;
        case Count::columns: return report.columns;
        case Count::dof: return report.dof;
        case Count::redundant: return report.redundant();
        case Count::mobility_by_counting: break;
    }
    return report.mobility_by_counting;
}

RankReport rank_verdict_of(const System& system, const State& state, double t) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, t);
    return analyse_rank_verdict(system, assembler.sparse_jacobian(), assembler.phi());
}

RankWhenAsked::RankWhenAsked(std::shared_ptr<const System> system, State state, double t)
    : pose_(std::make_shared<Pose>(Pose{std::move(system), std::move(state), t, std::nullopt})) {}

const RankReport& RankWhenAsked::operator*() const {
    if (!pose_->report) { pose_->report = rank_of(*pose_->system, pose_->state, pose_->t); }
    return *pose_->report;
}

RankWhenAsked StoryTelling::present_rank() const {
    return options_.with_ranks ? RankWhenAsked(system_, state_, start_time_) : nullptr;
}

}  // namespace jw
