#include "tests/bench/peers/sundials_solver.hpp"

#include <algorithm>

namespace jw::peers {

namespace {

OwnedContext new_context() {
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    return OwnedContext(context);
}

}  // namespace

SundialsSolver::SundialsSolver(CountedEquations& equations)
    : equations_(&equations), context_(new_context()), y_(new_vector()) {
    std::ranges::copy(equations.start(), N_VGetArrayPointer(y_.get()));
}

OwnedVector SundialsSolver::new_vector() const {
    return OwnedVector(N_VNew_Serial(equations_->size(), context_.get()));
}

OwnedVector SundialsSolver::around(double* numbers) const {
    return OwnedVector(N_VMake_Serial(equations_->size(), numbers, context_.get()));
}

void SundialsSolver::solve_densely() {
    matrix_.reset(SUNDenseMatrix(equations_->size(), equations_->size(), context_.get()));
    linear_solver_.reset(SUNLinSol_Dense(y_.get(), matrix_.get(), context_.get()));
}

}  // namespace jw::peers
