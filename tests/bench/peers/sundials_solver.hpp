#pragma once

#include <memory>

#include <arkode/arkode_butcher_dirk.h>
#include <arkode/arkode_butcher_erk.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "tests/bench/peers/counted_equations.hpp"

namespace jw::peers {

/// Deleter for objects of SUNDIALS, which are freed by functions of its own.
template <auto destroy>
struct Destroyer {
    template <class T>
    void operator()(T* object) const {
        destroy(object);
    }
};
inline void destroy_context(SUNContext context) { SUNContext_Free(&context); }
template <class Handle, auto destroy>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Destroyer<destroy>>;
using OwnedContext = Owned<SUNContext, destroy_context>;
using OwnedVector = Owned<N_Vector, N_VDestroy>;
using OwnedMatrix = Owned<SUNMatrix, SUNMatDestroy>;
using OwnedLinearSolver = Owned<SUNLinearSolver, SUNLinSolFree>;
using OwnedNonlinearSolver = Owned<SUNNonlinearSolver, SUNNonlinSolFree>;

/// One integrator of SUNDIALS, a step at a time.
class SundialsSolver {
public:
    explicit SundialsSolver(CountedEquations& equations);
    virtual ~SundialsSolver() = default;
    SundialsSolver(const SundialsSolver&) = delete;
    SundialsSolver& operator=(const SundialsSolver&) = delete;

    /// One step, which does not pass `t_end`. @return false where it gave up
    virtual bool step(double t_end) = 0;
    /// y within the last step, by its own polynomial.
    virtual bool interpolate(double t, double* y) = 0;

    double t() const { return t_; }
    const double* y() const { return N_VGetArrayPointer(y_.get()); }

protected:
    OwnedVector new_vector() const;
    /// A vector around numbers that it does not own.
    OwnedVector around(double* numbers) const;
    CountedEquations& equations() { return *equations_; }
    SUNContext context() const { return context_.get(); }
    /// Dense linear solver of implicit methods; set by `solve_densely`.
    SUNLinearSolver linear_solver() const { return linear_solver_.get(); }
    SUNMatrix matrix() const { return matrix_.get(); }
    void solve_densely();

    double t_ = 0.0;

private:
    CountedEquations* equations_;
    OwnedContext context_;

protected:
    OwnedVector y_;

private:
    OwnedMatrix matrix_;
    OwnedLinearSolver linear_solver_;
};

std::unique_ptr<SundialsSolver> erk_solver(CountedEquations& equations, ARKODE_ERKTableID table, int order);
/// Diagonally implicit, with Newton's iteration.
std::unique_ptr<SundialsSolver> dirk_solver(CountedEquations& equations, ARKODE_DIRKTableID table, int order);
/// Adams' methods, by functional iteration: no Jacobians.
std::unique_ptr<SundialsSolver> adams_solver(CountedEquations& equations);
/// CVODE's, with Newton's iteration.
std::unique_ptr<SundialsSolver> bdf_solver(CountedEquations& equations);
/// IDA's BDF of 0 = f(t, y) - ẏ.
std::unique_ptr<SundialsSolver> ida_solver(CountedEquations& equations);

}  // namespace jw::peers
