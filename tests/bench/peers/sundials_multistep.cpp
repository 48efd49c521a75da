#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <cvode/cvode_proj.h>
#include <ida/ida.h>
#include <ida/ida_ls.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "tests/bench/peers/sundials_callbacks.hpp"
#include "tests/bench/peers/sundials_solver.hpp"

/// Multistep methods of SUNDIALS. They choose their first steps, of order 1, themselves.
namespace jw::peers {

namespace {

void free_cvode(void* memory) { CVodeFree(&memory); }
void free_ida(void* memory) { IDAFree(&memory); }

class CvodeSolver final : public SundialsSolver {
public:
    CvodeSolver(CountedEquations& counted, int method)
        : SundialsSolver(counted), memory_(CVodeCreate(method, context())) {
        void* const memory = memory_.get();
        CVodeSetErrHandlerFn(memory, ignore_message, nullptr);
        CVodeInit(memory, rate_of, 0.0, y_.get());
        CVodeSetUserData(memory, &counted);
        CVodeWFtolerances(memory, error_weights);
        if (method == CV_ADAMS) {
            iteration_.reset(SUNNonlinSol_FixedPoint(y_.get(), 0, context()));
            CVodeSetNonlinearSolver(memory, iteration_.get());
            return;
        }
        solve_densely();
        CVodeSetLinearSolver(memory, linear_solver(), matrix());
        if (counted.has_loops()) { CVodeSetProjFn(memory, correction_of_end); }
    }

    bool step(double t_end) override {
        CVodeSetStopTime(memory_.get(), t_end);
        return CVode(memory_.get(), t_end, y_.get(), &t_, CV_ONE_STEP) >= CV_SUCCESS;
    }
    bool interpolate(double t, double* y) override {
        return CVodeGetDky(memory_.get(), t, 0, around(y).get()) == CV_SUCCESS;
    }

private:
    OwnedNonlinearSolver iteration_;
    Owned<void*, free_cvode> memory_;
};

class IdaSolver final : public SundialsSolver {
public:
    explicit IdaSolver(CountedEquations& counted)
        : SundialsSolver(counted), y_dot_(new_vector()), memory_(IDACreate(context())) {
        void* const memory = memory_.get();
        rate_of(0.0, y_.get(), y_dot_.get(), &counted);
        IDASetErrHandlerFn(memory, ignore_message, nullptr);
        IDAInit(memory, residual_of, 0.0, y_.get(), y_dot_.get());
        IDASetUserData(memory, &counted);
        IDAWFtolerances(memory, error_weights);
        solve_densely();
        IDASetLinearSolver(memory, linear_solver(), matrix());
    }

    bool step(double t_end) override {
        IDASetStopTime(memory_.get(), t_end);
        return IDASolve(memory_.get(), t_end, &t_, y_.get(), y_dot_.get(), IDA_ONE_STEP) >= IDA_SUCCESS;
    }
    bool interpolate(double t, double* y) override {
        return IDAGetDky(memory_.get(), t, 0, around(y).get()) == IDA_SUCCESS;
    }

private:
    OwnedVector y_dot_;
    Owned<void*, free_ida> memory_;
};

}  // namespace

std::unique_ptr<SundialsSolver> adams_solver(CountedEquations& equations) {
    return std::make_unique<CvodeSolver>(equations, CV_ADAMS);
}
std::unique_ptr<SundialsSolver> bdf_solver(CountedEquations& equations) {
    return std::make_unique<CvodeSolver>(equations, CV_BDF);
}
std::unique_ptr<SundialsSolver> ida_solver(CountedEquations& equations) {
    return std::make_unique<IdaSolver>(equations);
}

}  // namespace jw::peers
