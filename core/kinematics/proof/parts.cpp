#include "core/kinematics/proof/parts.hpp"

#include <algorithm>
#include <utility>

#include "core/eigen/decompositions.hpp"

namespace jw {

namespace {

constexpr double kTogether = 1e-6;        // least part of a free motion that is not rounding
constexpr std::size_t kMostSearched = 3;  // largest part that is searched for, in bodies: crank, dyad, triad

/// Search for parts, from the coordinates that are known to those that follow from them.
class PartSearch {
public:
    PartSearch(
        const CoordinateTable& table, const std::vector<ProvedEquation>& equations,
        const std::vector<EquationJacobian>& jacobians)
        : table_(table), equations_(equations), jacobians_(jacobians) {
        for (const ProvedEquation& equation : equations) { blocks_.push_back(table.blocks_of(equation)); }
        is_known_.assign(table.all().size(), false);
        const auto bodies = std::ranges::max(
            equations, {}, [](const ProvedEquation& e) { return std::max(e.body_i, e.body_j); });
        of_body_.resize(at(std::max(bodies.body_i, bodies.body_j) + 1));
        for (std::size_t e = 0; e < equations.size(); ++e) {
            for (const int body : bodies_of(e)) { of_body_[at(body)].push_back(static_cast<int>(e)); }
        }
    }

    std::vector<Part> all() {
        for (bool found = true; found;) {
            found = false;
            for (std::size_t size = 1; size <= kMostSearched && !found; ++size) { found = find(size); }
        }
        for (std::size_t k = 0; k < table_.all().size(); ++k) {
            const int body = table_.all()[k].body;
            if (is_known_[k] || body < 0) { continue; }
            Part part = part_of(linked_to(body));
            if (part.columns <= kMostProvedColumns) { find_rank(part); }
            take(std::move(part));
        }
        return std::move(parts_);
    }

private:
    /// Moving bodies of an equation.
    std::vector<int> bodies_of(std::size_t equation) const {
        std::vector<int> bodies;
        for (const int body : {equations_[equation].body_i, equations_[equation].body_j}) {
            if (table_.of_body(body) >= 0 && (bodies.empty() || bodies[0] != body)) {
                bodies.push_back(body);
            }
        }
        return bodies;
    }
    bool is_known(int body) const { return is_known_[at(table_.of_body(body))]; }

    /// Takes all parts of `size` bodies, each as soon as it is found.
    bool find(std::size_t size) {
        bool found = false;
        for (const Coordinates& c : table_.all()) {
            if (c.body < 0 || c.size != 3 || is_known(c.body)) { continue; }
            std::vector<int> bodies{c.body};
            found = grow(bodies, size) || found;
            if (found && size > 1) { return true; }
        }
        return found;
    }

    bool grow(std::vector<int>& bodies, std::size_t size) {
        if (bodies.size() == size) {
            Part part = part_of(bodies);
            if (part.rows < part.columns) { return false; }
            find_rank(part);
            if (part.rank < part.columns) { return false; }
            take(std::move(part));
            return true;
        }
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            for (const int e : of_body_[at(bodies[k])]) {
                for (const int next : bodies_of(at(e))) {
                    if (next <= bodies[0] || is_known(next) ||
                        std::ranges::find(bodies, next) != bodies.end()) {
                        continue;
                    }
                    bodies.push_back(next);
                    if (grow(bodies, size)) { return true; }
                    bodies.pop_back();
                }
            }
        }
        return false;
    }

    std::vector<int> linked_to(int body) const {
        std::vector<int> bodies{body};
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            for (const int e : of_body_[at(bodies[k])]) {
                for (const int next : bodies_of(at(e))) {
                    if (!is_known(next) && std::ranges::find(bodies, next) == bodies.end()) {
                        bodies.push_back(next);
                    }
                }
            }
        }
        return bodies;
    }

    Part part_of(const std::vector<int>& bodies) const {
        Part part;
        std::vector<bool> is_own(is_known_.size(), false);
        const auto own = [&](int k) {
            if (is_own[at(k)]) { return; }
            is_own[at(k)] = true;
            part.unknowns.push_back(k);
            part.columns += table_.all()[at(k)].size;
        };
        for (const int body : bodies) {
            own(table_.of_body(body));
            own(table_.of_body(body) + 1);
        }
        for (const int body : bodies) {
            for (const int e : of_body_[at(body)]) {
                const bool is_within = std::ranges::all_of(bodies_of(at(e)), [&](int other) {
                    return is_known(other) || is_own[at(table_.of_body(other))];
                });
                if (!is_within || std::ranges::find(part.equations, e) != part.equations.end()) { continue; }
                part.equations.push_back(e);
                part.rows += equations_[at(e)].rows;
                const int theta = blocks_[at(e)][kArtificial];
                if (theta >= 0) { own(theta); }
            }
        }
        std::ranges::sort(part.equations);
        for (const int e : part.equations) {
            for (const int k : blocks_[at(e)]) {
                const bool is_input = k >= 0 && !is_own[at(k)];
                if (is_input && std::ranges::find(part.inputs, k) == part.inputs.end()) {
                    part.inputs.push_back(k);
                }
            }
        }
        return part;
    }

    void find_rank(Part& part) const {
        std::vector<int> first(table_.all().size(), -1);
        int column = 0;
        for (const int k : part.unknowns) {
            first[at(k)] = column;
            column += table_.all()[at(k)].size;
        }
        MatrixX transposed = MatrixX::Zero(part.columns, part.rows);
        int row = 0;
        for (const int e : part.equations) {
            for_each_block(blocks_[at(e)], jacobians_[at(e)], [&](int k, const MatrixX& block) {
                if (first[at(k)] < 0) { return; }
                transposed.block(first[at(k)], row, block.cols(), block.rows()) += block.transpose();
            });
            row += equations_[at(e)].rows;
        }
        Eigen::ColPivHouseholderQR<MatrixX> qr(transposed);
        qr.setThreshold(kIndependent);
        part.rank = static_cast<int>(qr.rank());
        if (part.rank == part.columns) { return; }
        MatrixX q = MatrixX::Identity(part.columns, part.columns);
        multiply_by_q(qr.householderQ(), q);
        const MatrixX free = q.rightCols(part.free_columns());
        const MatrixX projector = free * free.transpose();
        for (const int k : part.unknowns) {
            for (const int l : part.unknowns) {
                const Coordinates& a = table_.all()[at(k)];
                const Coordinates& b = table_.all()[at(l)];
                const bool is_alone = a.body == b.body && a.theta == b.theta;
                const auto together = projector.block(first[at(k)], first[at(l)], a.size, b.size);
                part.is_underdriven = part.is_underdriven || (!is_alone && together.norm() > kTogether);
            }
        }
    }

    void take(Part part) {
        for (const int k : part.unknowns) { is_known_[at(k)] = true; }
        parts_.push_back(std::move(part));
    }

    const CoordinateTable& table_;
    const std::vector<ProvedEquation>& equations_;
    const std::vector<EquationJacobian>& jacobians_;
    std::vector<std::array<int, kBlocks>> blocks_;
    std::vector<std::vector<int>> of_body_;
    std::vector<bool> is_known_;
    std::vector<Part> parts_;
};

}  // namespace

CoordinateTable::CoordinateTable(const System& system) {
    const Mechanism& mechanism = system.mechanism();
    of_body_.assign(mechanism.bodies.size(), -1);
    of_theta_.assign(at(mechanism.thetas_count()), -1);
    const double length = extent(mechanism);
    for (const int body : system.moving_bodies()) {
        of_body_[at(body)] = static_cast<int>(all_.size());
        all_.push_back({body, -1, 3, length});
        all_.push_back({body, -1, 4, 1.0});
    }
    for (const int theta : system.active_thetas()) {
        of_theta_[at(theta)] = static_cast<int>(all_.size());
        all_.push_back({-1, theta, 1, 1.0});
    }
}

std::array<int, kBlocks> CoordinateTable::blocks_of(const ProvedEquation& equation) const {
    std::array<int, kBlocks> blocks;
    blocks.fill(-1);
    const int i = of_body(equation.body_i);
    const int j = of_body(equation.body_j);
    if (i >= 0) {
        blocks[kR_i] = i;
        blocks[kP_i] = i + 1;
    }
    if (j >= 0) {
        blocks[kR_j] = j;
        blocks[kP_j] = j + 1;
    }
    if (equation.theta >= 0) { blocks[kArtificial] = of_theta(equation.theta); }
    return blocks;
}

void compute_jacobian(
    const ProvedEquation& equation, const BodyKinematics<ModifiedEulerParameters>& i,
    const BodyKinematics<ModifiedEulerParameters>& j, const Theta& theta, double length,
    EquationJacobian& out) {
    visit_equation<Content::jacobian>(equation, i, j, theta, [&](const auto& jet) {
        using J = std::decay_t<decltype(jet)>;
        const auto write = [&](Block block, const auto& columns, double scale) {
            MatrixX& to = out.blocks[block];
            to.resize(equation.rows, columns.cols());
            int row = 0;
            for (int k = 0; k < J::kDim; ++k) {
                if (equation.has_row(k)) { to.row(row++) = scale / equation.unit * columns.row(k); }
            }
        };
        if constexpr ((J::kSides & kBodyI) != 0) {
            write(kR_i, jet.block_i.template leftCols<3>(), length);
            write(kP_i, jet.block_i.template rightCols<4>(), 1.0);
        }
        if constexpr ((J::kSides & kBodyJ) != 0) {
            write(kR_j, jet.block_j.template leftCols<3>(), length);
            write(kP_j, jet.block_j.template rightCols<4>(), 1.0);
        }
        if constexpr ((J::kSides & kTheta) != 0) { write(kArtificial, jet.block_theta, 1.0); }
    });
}

std::vector<Part> find_parts(
    const CoordinateTable& table, const std::vector<ProvedEquation>& equations,
    const std::vector<EquationJacobian>& jacobians) {
    return PartSearch(table, equations, jacobians).all();
}

}  // namespace jw
