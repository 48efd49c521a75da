#include "core/numerics/envelope_matrix.hpp"

#include <algorithm>
#include <utility>

namespace jw {

EnvelopeMatrix::EnvelopeMatrix(std::vector<int> first) : first_(std::move(first)) {
    std::size_t size = 0;
    for (std::size_t row = 0; row < first_.size(); ++row) {
        start_.push_back(size);
        size += row + 1 - static_cast<std::size_t>(first_[row]);
    }
    numbers_.assign(size, 0.0);
}

void EnvelopeMatrix::factor() {
    EnvelopeMatrix& K = *this;
    for (int a = 0; a < rows(); ++a) {
        for (int b = first(a); b < a; ++b) {
            double sum = K(a, b);
            for (int c = std::max(first(a), first(b)); c < b; ++c) { sum -= K(a, c) * K(b, c); }
            K(a, b) = sum;
        }
        for (int b = first(a); b < a; ++b) {
            const double scaled = K(a, b) / K(b, b);
            K(a, a) -= K(a, b) * scaled;
            K(a, b) = scaled;
        }
    }
}

void EnvelopeMatrix::solve(double* x) const {
    const EnvelopeMatrix& L = *this;
    for (int a = 0; a < rows(); ++a) {
        for (int b = first(a); b < a; ++b) { x[a] -= L(a, b) * x[b]; }
    }
    for (int a = 0; a < rows(); ++a) { x[a] /= L(a, a); }
    for (int a = rows(); a-- > 0;) {
        for (int b = first(a); b < a; ++b) { x[b] -= L(a, b) * x[a]; }
    }
}

}  // namespace jw
