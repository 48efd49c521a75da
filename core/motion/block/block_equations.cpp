#include "core/motion/block/block_equations.hpp"

#include <bit>
#include <limits>

#include <Eigen/LU>

#include "core/numerics/flatten.hpp"

namespace jw {

namespace {

std::vector<MovingBody> moving_bodies(const Centroidal& scene) {
    std::vector<MovingBody> moving;
    for (std::size_t b = 0; b < scene.mechanism.bodies.size(); ++b) {
        if (scene.mechanism.bodies[b].fixed) { continue; }
        const MassProperties& m = *scene.loads.masses[b];
        moving.push_back({static_cast<int>(b), m.mass, 1.0 / m.mass, m.J_local, m.J_local.inverse()});
    }
    return moving;
}

/// Neighbours of every node: nodes that share a moving body with it.
std::vector<std::vector<int>> neighbours_of(const std::vector<Node>& nodes, std::size_t bodies) {
    std::vector<std::vector<int>> on_body(bodies);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        for (const int moving : {nodes[n].moving_i, nodes[n].moving_j}) {
            if (moving >= 0) { on_body[at(moving)].push_back(static_cast<int>(n)); }
        }
    }
    std::vector<std::vector<int>> neighbours(nodes.size());
    for (const std::vector<int>& group : on_body) {
        for (const int a : group) {
            for (const int b : group) {
                auto& list = neighbours[at(a)];
                if (a != b && std::ranges::find(list, b) == list.end()) { list.push_back(b); }
            }
        }
    }
    return neighbours;
}

/// Pivot below which iterative refinement recovers digits: reactions are wrong by 1e-16 / pivot, and the
/// accelerations that they give a light body by 1e-16 / pivot². 1e-8 was seen at 7e-4.
constexpr double kFewDigitsAreLost = 1e-3;

}  // namespace

template <int B>
BlockEquations<B>::BlockEquations(
    const Centroidal& scene, std::vector<Link> links, const Baumgarte& baumgarte)
    : scene_(&scene),
      baumgarte_(baumgarte),
      moving_(moving_bodies(scene)),
      order_of_body_(scene.mechanism.bodies.size(), -1),
      matrix_(structure_),
      bodies_(scene.mechanism.bodies.size()),
      forces_(scene.mechanism.bodies.size()),
      six_(6 * moving_.size(), 0.0),
      extent_(extent(scene.mechanism)) {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        order_of_body_[at(moving_[m].body)] = static_cast<int>(m);
    }
    for (Link& link : links) {
        const int i = order_of_body_[at(link.body_i)];
        const int j = order_of_body_[at(link.body_j)];
        if (i < 0 && j < 0) { continue; }  // between fixed bodies
        const unsigned all = (1U << link.rows) - 1U;
        has_screws_ = has_screws_ || std::ranges::any_of(link.equations, [](const LinkEquation& e) {
                          return std::holds_alternative<ScrewTurned>(e.primitive);
                      });
        nodes_.push_back({std::move(link), i, j, all});
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = scene.mechanism.bodies[b];
        bodies_[b].r = body.r;
        bodies_[b].p = body.p;
        bodies_[b].A = OmegaLocal::rotation(body.p);
    }
    build_structure();
    j_.assign(2 * nodes_.size() * kSide, 0.0);
    w_.assign(2 * nodes_.size() * kSide, 0.0);
    for (std::vector<double>* v : {&phi_, &nu_, &gamma_, &lambda_, &row_size_}) {
        v->assign(nodes_.size() * B, 0.0);
    }
    inverse_unit_.assign(nodes_.size() * B, 1.0);
}

template <int B>
void BlockEquations<B>::build_structure() {
    structure_ = BlockStructure(neighbours_of(nodes_, moving_.size()));
    matrix_ = BlockMatrix<B>(structure_);
    std::vector<std::vector<int>> sides(moving_.size());
    for_each_side([&](std::size_t, int side, std::size_t moving) { sides[moving].push_back(side); });
    for (const std::vector<int>& group : sides) {
        for (const int a : group) {
            for (const int b : group) {
                const int node_a = a / 2;
                const int node_b = b / 2;
                if (structure_.position(node_a) > structure_.position(node_b)) { continue; }
                products_.push_back({structure_.block_of(node_a, node_b), a, b});
            }
        }
    }
}

template <int B>
template <bool WithMotion>
JW_FLATTEN void BlockEquations<B>::set_bodies(const double* y) {
    for (const MovingBody& moving : moving_) {
        Kinematics6& body = bodies_[at(moving.body)];
        body.r = vec3(y);
        body.p = vec4(y + 3);
        body.A = OmegaLocal::rotation(body.p);
        if constexpr (WithMotion) {
            body.r_dot = vec3(y + 7);
            OmegaLocal::set_motion(body, vec3(y + 10));
        }
        y += kNumbersPerBody;
    }
}

template <int B>
void BlockEquations<B>::tell_turns_at(Turns turns, double t, const double* y) {
    if (!has_screws_) { return; }
    set_bodies<true>(y);
    for (Node& node : nodes_) {
        for (LinkEquation& equation : node.link.equations) {
            tell_turns(
                equation.primitive, turns, t, bodies_[at(node.link.body_i)], bodies_[at(node.link.body_j)]);
        }
    }
}

/// Writes the Jacobian blocks of kept rows; other rows stay zero.
template <int B>
template <class Jet>
void BlockEquations<B>::write_jacobian(
    const Node& node, int side, const LinkEquation& equation, const Jet& jet) {
    int row = equation.first_row;
    for (int component = 0; component < Jet::kDim; ++component) {
        if (has(equation.left_out, component)) { continue; }
        if (has(node.kept, row)) {
            if constexpr ((Jet::kSides & kBodyI) != 0) {
                double* target = &j_[side_at(side)] + row;
                for (int k = 0; k < 6; ++k) { target[k * B] = jet.block_i(component, k); }
            }
            if constexpr ((Jet::kSides & kBodyJ) != 0) {
                double* target = &j_[side_at(side + 1)] + row;
                for (int k = 0; k < 6; ++k) { target[k * B] = jet.block_j(component, k); }
            }
        }
        ++row;
    }
}

template <int B>
template <bool WithMotion>
JW_FLATTEN void BlockEquations<B>::evaluate_links(double t) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const Node& node = nodes_[n];
        const Kinematics6& i = bodies_[at(node.link.body_i)];
        const Kinematics6& j = bodies_[at(node.link.body_j)];
        for (const LinkEquation& equation : node.link.equations) {
            const auto each_row = [&](int components, auto&& write) {
                std::size_t row = n * B + at(equation.first_row);
                for (int k = 0; k < components; ++k) {
                    if (!has(equation.left_out, k)) { write(row++, k); }
                }
            };
            visit_rows<Content::jacobian>(
                equation.primitive, i, j, t, [&](const auto& jet, double f_dot, double) {
                    write_jacobian(node, 2 * static_cast<int>(n), equation, jet);
                    each_row(jet.kDim, [&](std::size_t row, int k) {
                        phi_[row] = jet.value(k);
                        nu_[row] = f_dot;
                    });
                });
            if constexpr (WithMotion) {
                visit_rows<Content::motion>(
                    equation.primitive, i, j, t, [&](const auto& jet, double f_dot, double f_ddot) {
                        each_row(jet.kDim, [&](std::size_t row, int k) {
                            gamma_[row] = f_ddot - jet.bias(k) -
                                          2.0 * baumgarte_.alpha * (jet.rate(k) - f_dot) -
                                          baumgarte_.beta * baumgarte_.beta * phi_[row];
                        });
                    });
            }
        }
    }
}

template <int B>
void BlockEquations<B>::weigh(Metric metric) {
    const bool by_mass = metric == Metric::mass;
    const Mat3 geometric_J = Mat3::Identity() / (extent_ * extent_);
    for_each_side([&](std::size_t, int side, std::size_t moving) {
        const MovingBody& body = moving_[moving];
        const double inverse_mass = by_mass ? body.inverse_mass : 1.0;
        const Mat3& inverse_J = by_mass ? body.inverse_J : geometric_J;
        const double* j = &j_[side_at(side)];
        double* out = &w_[side_at(side)];
        for (int row = 0; row < B; ++row) {
            for (int k = 0; k < 3; ++k) { out[row * 6 + k] = inverse_mass * j[k * B + row]; }
            for (int k = 0; k < 3; ++k) {
                out[row * 6 + 3 + k] = j[3 * B + row] * inverse_J(0, k) + j[4 * B + row] * inverse_J(1, k) +
                                       j[5 * B + row] * inverse_J(2, k);
            }
        }
    });
}

template <int B>
void BlockEquations<B>::form_matrix() {
    matrix_.set_zero();
    for (const Product& product : products_) {
        kernels::add_product<B, 6>(
            matrix_.block(product.block), &w_[side_at(product.w_side)], &j_[side_at(product.j_side)]);
    }
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        double* diagonal = matrix_.block(static_cast<int>(n));
        for (int row = 0; row < B; ++row) {
            if (!has(nodes_[n].kept, row)) { diagonal[row * B + row] = 1.0; }
            row_size_[n * B + at(row)] = diagonal[row * B + row];
        }
    }
}

template <int B>
void BlockEquations<B>::factor_in_metric() {
    weigh(masses_apart_ ? Metric::geometry : Metric::mass);
    form_matrix();
    matrix_.factor();
}

template <int B>
double BlockEquations<B>::smallest_pivot() const {
    double largest = 0.0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const double inverse =
                row_size_[n * B + at(row)] * matrix_.inverse_pivot(static_cast<int>(n), row);
            // a pivot that rounding made negative counts as 0
            largest = std::max(largest, inverse > 0.0 ? inverse : std::numeric_limits<double>::infinity());
        }
    }
    return largest > 0.0 ? 1.0 / largest : 1.0;
}

template <int B>
void BlockEquations<B>::subtract_products(const double* x, double* b) const {
    for_each_side([&](std::size_t n, int side, std::size_t moving) {
        const double* j = &j_[side_at(side)];
        const double* six = x + 6 * moving;
        double* rows = b + n * B;
        for (int k = 0; k < 6; ++k) {
            for (int row = 0; row < B; ++row) { rows[row] -= j[k * B + row] * six[k]; }
        }
    });
}

template <int B>
void BlockEquations<B>::add_reactions(const double* lambda, double* x) const {
    for_each_side([&](std::size_t n, int side, std::size_t moving) {
        const double* weights = &w_[side_at(side)];
        double* six = x + 6 * moving;
        for (int row = 0; row < B; ++row) {
            for (int k = 0; k < 6; ++k) { six[k] += weights[row * 6 + k] * lambda[n * B + at(row)]; }
        }
    });
}

template <int B>
void BlockEquations<B>::set_lambda(const std::vector<double>& numbers) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const std::size_t k = n * B + at(row);
            lambda_[k] = has(nodes_[n].kept, row) ? numbers[k] : 0.0;
        }
    }
}

template <int B>
RowsVerdict BlockEquations<B>::evaluate(double t, const double* y, double* y_dot) {
    set_bodies<true>(y);
    evaluate_links<true>(t);
    factor_in_metric();
    evaluate_forces(t, y);
    const double pivot = smallest_pivot();
    constrain_accelerations(pivot < kFewDigitsAreLost ? 2 : 1);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const Kinematics6& body = bodies_[at(moving_[m].body)];
        vec3(body_numbers(y_dot, m)) = body.r_dot;
        vec4(body_numbers(y_dot, m) + 3) = body.p_dot;
    }
    write_accelerations(y_dot);
    return {pivot, largest(phi_, true), largest(phi_, false)};
}

template <int B>
void BlockEquations<B>::constrain_accelerations(int passes) {
    if (masses_apart_) {
        solve_by_pivoting();
        return;
    }
    for (int pass = 0; pass < passes; ++pass) {
        set_lambda(gamma_);
        subtract_products(six_.data(), lambda_.data());
        matrix_.solve(lambda_.data());
        add_reactions(lambda_.data(), six_.data());
    }
}

template <int B>
void BlockEquations<B>::write_accelerations(double* y_dot) const {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        std::copy_n(&six_[6 * m], 6, body_numbers(y_dot, m) + 7);
    }
}

template <int B>
void BlockEquations<B>::refine(double* y_dot) {
    constrain_accelerations(1);
    write_accelerations(y_dot);
}

template <int B>
void BlockEquations<B>::set_driver(int driver, double f0, double f1) {
    for (Node& node : nodes_) {
        for (LinkEquation& equation : node.link.equations) {
            if (equation.driver != driver) { continue; }
            std::get<Driven>(equation.primitive).function.polynomial.assign({f0, f1});
        }
    }
}

template <int B>
int BlockEquations<B>::rows() const {
    int rows = 0;
    for (const Node& node : nodes_) { rows += node.link.rows; }
    return rows;
}

template <int B>
int BlockEquations<B>::rows_left_out() const {
    int out = 0;
    for (const Node& node : nodes_) { out += node.link.rows - std::popcount(node.kept); }
    return out;
}

template class BlockEquations<3>;
template class BlockEquations<5>;
template class BlockEquations<6>;
// members that the other sources need
template void BlockEquations<3>::evaluate_links<false>(double);
template void BlockEquations<5>::evaluate_links<false>(double);
template void BlockEquations<6>::evaluate_links<false>(double);
template void BlockEquations<3>::set_bodies<false>(const double*);
template void BlockEquations<5>::set_bodies<false>(const double*);
template void BlockEquations<6>::set_bodies<false>(const double*);

std::unique_ptr<DrivableEquations> block_equations(const Centroidal& centroidal, const Baumgarte& baumgarte) {
    std::vector<Link> links = with_drivers_joined(links_of(centroidal.mechanism));
    int most = 0;
    for (const Link& link : links) { most = std::max(most, link.rows); }
    // spherical joints; revolute and prismatic ones; everything else
    if (most <= 3) { return std::make_unique<BlockEquations<3>>(centroidal, std::move(links), baumgarte); }
    if (most <= 5) { return std::make_unique<BlockEquations<5>>(centroidal, std::move(links), baumgarte); }
    return std::make_unique<BlockEquations<6>>(centroidal, std::move(links), baumgarte);
}

}  // namespace jw
