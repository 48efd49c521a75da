#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include "tests/bench/peers/sundials_callbacks.hpp"
#include "tests/bench/peers/sundials_solver.hpp"

/// One-step methods of SUNDIALS.
namespace jw::peers {

namespace {

void free_erk(void* memory) { ERKStepFree(&memory); }
void free_ark(void* memory) { ARKStepFree(&memory); }

class ErkSolver final : public SundialsSolver {
public:
    ErkSolver(CountedEquations& counted, ARKODE_ERKTableID table, int order)
        : SundialsSolver(counted), memory_(ERKStepCreate(rate_or_huge, 0.0, y_.get(), context())) {
        void* const memory = memory_.get();
        ERKStepSetErrHandlerFn(memory, ignore_message, nullptr);
        ERKStepSetUserData(memory, &counted);
        ERKStepWFtolerances(memory, error_weights);
        ERKStepSetTableNum(memory, table);
        ERKStepSetInitStep(memory, counted.first_step(order));
        // set also where nothing drifts: otherwise ERKStep 5.4 uses the rate of a last stage at the end of
        // the step for that of the next start, although only their times agree, and loses its order
        ERKStepSetPostprocessStepFn(memory, project_end);
    }

    bool step(double t_end) override {
        ERKStepSetStopTime(memory_.get(), t_end);
        return ERKStepEvolve(memory_.get(), t_end, y_.get(), &t_, ARK_ONE_STEP) >= ARK_SUCCESS;
    }
    bool interpolate(double t, double* y) override {
        return ERKStepGetDky(memory_.get(), t, 0, around(y).get()) == ARK_SUCCESS;
    }

private:
    Owned<void*, free_erk> memory_;
};

class DirkSolver final : public SundialsSolver {
public:
    DirkSolver(CountedEquations& counted, ARKODE_DIRKTableID table, int order)
        : SundialsSolver(counted), memory_(ARKStepCreate(nullptr, rate_of, 0.0, y_.get(), context())) {
        void* const memory = memory_.get();
        ARKStepSetErrHandlerFn(memory, ignore_message, nullptr);
        ARKStepSetUserData(memory, &counted);
        ARKStepWFtolerances(memory, error_weights);
        ARKStepSetTableNum(memory, table, ARKODE_ERK_NONE);
        solve_densely();
        ARKStepSetLinearSolver(memory, linear_solver(), matrix());
        // the rate of a stage follows from the stage: no evaluation is spent on it
        ARKStepSetDeduceImplicitRhs(memory, 1);
        ARKStepSetInterpolantType(memory, ARK_INTERP_LAGRANGE);
        ARKStepSetInitStep(memory, counted.first_step(order));
        ARKStepSetPostprocessStepFn(memory, counted.has_loops() ? project_end : nullptr);
    }

    bool step(double t_end) override {
        ARKStepSetStopTime(memory_.get(), t_end);
        return ARKStepEvolve(memory_.get(), t_end, y_.get(), &t_, ARK_ONE_STEP) >= ARK_SUCCESS;
    }
    bool interpolate(double t, double* y) override {
        return ARKStepGetDky(memory_.get(), t, 0, around(y).get()) == ARK_SUCCESS;
    }

private:
    Owned<void*, free_ark> memory_;
};

}  // namespace

std::unique_ptr<SundialsSolver> erk_solver(CountedEquations& equations, ARKODE_ERKTableID table, int order) {
    return std::make_unique<ErkSolver>(equations, table, order);
}

std::unique_ptr<SundialsSolver> dirk_solver(
    CountedEquations& equations, ARKODE_DIRKTableID table, int order) {
    return std::make_unique<DirkSolver>(equations, table, order);
}

}  // namespace jw::peers
