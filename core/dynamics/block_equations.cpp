#include <bit>
#include <limits>

#include <Eigen/LU>

#include "core/dynamics/block_matrix.hpp"
#include "core/dynamics/link_equations.hpp"
#include "core/dynamics/motion_equations.hpp"

namespace jw {

namespace {

using Kinematics6 = BodyKinematics<OmegaLocal>;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Eigen::Map<Vec3> vec3(double* numbers) { return Eigen::Map<Vec3>(numbers); }
Eigen::Map<const Vec3> vec3(const double* numbers) { return Eigen::Map<const Vec3>(numbers); }
Eigen::Map<Vec4> vec4(double* numbers) { return Eigen::Map<Vec4>(numbers); }
Eigen::Map<const Vec4> vec4(const double* numbers) { return Eigen::Map<const Vec4>(numbers); }

/// Rows whose pivot is below this share of their size repeat earlier ones: far above rounding (1e-15 times a
/// condition of 1e3), far below the pivots of sound joints (1e-3).
constexpr double kRepeats = 1e-9;

/// A body that moves: its number, its M⁻¹ and where it is.
struct MovingBody {
    int body = 0;
    double mass = 0.0;
    double inverse_mass = 0.0;
    Mat3 J = Mat3::Zero();
    Mat3 inverse_J = Mat3::Zero();
};

/// A link as it is evaluated: its equations, its bodies and the rows that are kept.
struct Node {
    Link link;
    int moving_i = -1;  ///< place among the moving bodies, -1 for a fixed one
    int moving_j = -1;
    unsigned kept = 0;  ///< bit r: row r is kept
};

/// One product W Jᵀ of the matrix Φq M⁻¹ Φqᵀ; sides are counted 2 node (+ 1 for body j).
struct Product {
    int block = 0;
    int w_side = 0;
    int j_side = 0;
};

template <int B>
class BlockEquations final : public MotionEquations {
public:
    BlockEquations(const Centroidal& scene, std::vector<Link> links);

    int size() const override { return kNumbersPerBody * static_cast<int>(moving_.size()); }
    RowsVerdict evaluate(double t, const double* y, double* y_dot) override;
    double project(double t, double* y) override;
    bool choose_rows(double t, const double* y) override;
    std::pair<double, double> violation(double t, const double* y) override;
    double kinetic_energy(const double* y) const override;
    double potential_energy(const double* y) const override;
    int rows() const override;
    int rows_left_out() const override;

private:
    static constexpr int kSide = 6 * B;

    double* j_transposed(int side) { return j_.data() + static_cast<std::ptrdiff_t>(side) * kSide; }
    double* w(int side) { return w_.data() + static_cast<std::ptrdiff_t>(side) * kSide; }

    void build_structure();
    template <bool WithMotion>
    void set_bodies(const double* y);
    /// Φ and Φq of every link, and γ if asked for.
    template <bool WithMotion>
    void evaluate_links(double t);
    template <class Jet>
    void write_jacobian(const Node& node, int side, const LinkEquation& equation, const Jet& jet);
    void weigh(bool by_mass);
    void form_matrix();
    double smallest_pivot() const;
    void add_forces(double t, const double* y);
    /// b_node -= J x for six numbers per moving body.
    void subtract_products(const double* x, double* b) const;
    /// x_body += Wᵀ λ
    void add_reactions(const double* lambda, double* x) const;

    const Centroidal* scene_;
    std::vector<MovingBody> moving_;
    std::vector<int> order_of_body_;
    std::vector<Node> nodes_;
    std::vector<Product> products_;
    BlockStructure structure_;
    BlockMatrix<B> matrix_;
    std::vector<Kinematics6> bodies_;  ///< of all bodies, fixed ones included
    std::vector<double> j_;            ///< Jᵀ of every side, 6 x B row-major
    std::vector<double> w_;            ///< J M⁻¹ of every side, B x 6 row-major
    std::vector<double> phi_;
    std::vector<double> nu_;
    std::vector<double> gamma_;
    std::vector<double> lambda_;
    std::vector<double> row_size_;  ///< diagonal of Φq M⁻¹ Φqᵀ
    double extent_ = 1.0;
    std::vector<double> acceleration_;  ///< 6 per moving body
};

std::vector<MovingBody> moving_bodies(const Centroidal& scene) {
    std::vector<MovingBody> moving;
    for (std::size_t b = 0; b < scene.mechanism.bodies.size(); ++b) {
        if (scene.mechanism.bodies[b].fixed) { continue; }
        const MassProperties& m = *scene.loads.masses[b];
        moving.push_back({static_cast<int>(b), m.mass, 1.0 / m.mass, m.J_local, m.J_local.inverse()});
    }
    return moving;
}

/// Nodes that share a moving body.
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

template <int B>
BlockEquations<B>::BlockEquations(const Centroidal& scene, std::vector<Link> links)
    : scene_(&scene),
      moving_(moving_bodies(scene)),
      order_of_body_(scene.mechanism.bodies.size(), -1),
      matrix_(structure_),
      bodies_(scene.mechanism.bodies.size()) {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        order_of_body_[at(moving_[m].body)] = static_cast<int>(m);
    }
    for (Link& link : links) {
        const int i = order_of_body_[at(link.body_i)];
        const int j = order_of_body_[at(link.body_j)];
        if (i < 0 && j < 0) { continue; }  // between fixed bodies: nothing can move
        const unsigned all = (1U << link.rows) - 1U;
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
    acceleration_.assign(6 * moving_.size(), 0.0);
    extent_ = extent(scene.mechanism);
}

template <int B>
void BlockEquations<B>::build_structure() {
    structure_ = BlockStructure(neighbours_of(nodes_, moving_.size()));
    matrix_ = BlockMatrix<B>(structure_);
    std::vector<std::vector<int>> sides(moving_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        if (nodes_[n].moving_i >= 0) { sides[at(nodes_[n].moving_i)].push_back(2 * static_cast<int>(n)); }
        if (nodes_[n].moving_j >= 0) { sides[at(nodes_[n].moving_j)].push_back(2 * static_cast<int>(n) + 1); }
    }
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
void BlockEquations<B>::set_bodies(const double* y) {
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
template <class Jet>
void BlockEquations<B>::write_jacobian(
    const Node& node, int side, const LinkEquation& equation, const Jet& jet) {
    int row = equation.first_row;
    for (int component = 0; component < Jet::kDim; ++component) {
        if (((equation.left_out >> component) & 1U) != 0) { continue; }
        if (((node.kept >> row) & 1U) != 0) {
            if constexpr ((Jet::kSides & kBodyI) != 0) {
                double* target = j_transposed(side) + row;
                for (int k = 0; k < 6; ++k) { target[k * B] = jet.block_i(component, k); }
            }
            if constexpr ((Jet::kSides & kBodyJ) != 0) {
                double* target = j_transposed(side + 1) + row;
                for (int k = 0; k < 6; ++k) { target[k * B] = jet.block_j(component, k); }
            }
        }
        ++row;
    }
}

template <int B>
template <bool WithMotion>
void BlockEquations<B>::evaluate_links(double t) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const Node& node = nodes_[n];
        const Kinematics6& i = bodies_[at(node.link.body_i)];
        const Kinematics6& j = bodies_[at(node.link.body_j)];
        const int side = 2 * static_cast<int>(n);
        for (const LinkEquation& equation : node.link.equations) {
            const std::size_t first = n * B + at(equation.first_row);
            const auto each_row = [&](int components, auto&& write) {
                std::size_t row = first;
                for (int k = 0; k < components; ++k) {
                    if (((equation.left_out >> k) & 1U) == 0) { write(row++, k); }
                }
            };
            visit_rows<Content::jacobian>(
                equation.primitive, i, j, t, [&](const auto& jet, double f_dot, double) {
                    write_jacobian(node, side, equation, jet);
                    each_row(jet.kDim, [&](std::size_t row, int k) {
                        phi_[row] = jet.value(k);
                        nu_[row] = f_dot;
                    });
                });
            if constexpr (WithMotion) {
                visit_rows<Content::motion>(
                    equation.primitive, i, j, t, [&](const auto& jet, double, double f_ddot) {
                        each_row(
                            jet.kDim, [&](std::size_t row, int k) { gamma_[row] = f_ddot - jet.bias(k); });
                    });
            }
        }
    }
}

/// W = J M⁻¹ of every side; for the choice of rows with an M that knows no masses: a turn counts as the way
/// of a point one extent away.
template <int B>
void BlockEquations<B>::weigh(bool by_mass) {
    const Mat3 geometric_J = Mat3::Identity() / (extent_ * extent_);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int s = 0; s < 2; ++s) {
            const int moving = s == 0 ? nodes_[n].moving_i : nodes_[n].moving_j;
            if (moving < 0) { continue; }
            const int side = 2 * static_cast<int>(n) + s;
            const MovingBody& body = moving_[at(moving)];
            const double inverse_mass = by_mass ? body.inverse_mass : 1.0;
            const Mat3 inverse_J = by_mass ? body.inverse_J : geometric_J;
            const double* j = j_transposed(side);
            double* out = w(side);
            for (int row = 0; row < B; ++row) {
                for (int k = 0; k < 3; ++k) { out[row * 6 + k] = inverse_mass * j[k * B + row]; }
                for (int k = 0; k < 3; ++k) {
                    out[row * 6 + 3 + k] = j[3 * B + row] * inverse_J(0, k) +
                                           j[4 * B + row] * inverse_J(1, k) +
                                           j[5 * B + row] * inverse_J(2, k);
                }
            }
        }
    }
}

template <int B>
void BlockEquations<B>::form_matrix() {
    matrix_.set_zero();
    for (const Product& product : products_) {
        kernels::add_product<B, 6>(
            matrix_.block(product.block), w(product.w_side), j_transposed(product.j_side));
    }
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        double* diagonal = matrix_.block(static_cast<int>(n));
        for (int row = 0; row < B; ++row) {
            if (((nodes_[n].kept >> row) & 1U) == 0) { diagonal[row * B + row] = 1.0; }
            row_size_[n * B + at(row)] = diagonal[row * B + row];
        }
    }
}

template <int B>
double BlockEquations<B>::smallest_pivot() const {
    double largest = 0.0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const double inverse =
                row_size_[n * B + at(row)] * matrix_.inverse_pivot(static_cast<int>(n), row);
            // a pivot that rounding made negative is none at all
            largest = std::max(largest, inverse > 0.0 ? inverse : std::numeric_limits<double>::infinity());
        }
    }
    return largest > 0.0 ? 1.0 / largest : 1.0;
}

/// M⁻¹ Q of every body.
template <int B>
void BlockEquations<B>::add_forces(double t, const double* y) {
    const Loads& loads = scene_->loads;
    const auto force_at = [&](int body) -> double* {
        const int moving = order_of_body_[at(body)];
        return moving < 0 ? nullptr : acceleration_.data() + static_cast<std::ptrdiff_t>(moving) * 6;
    };
    const auto add = [&](int body, const Vec3& f, const Vec3& n_local) {
        double* q = force_at(body);
        if (q == nullptr) { return; }
        vec3(q) += f;
        vec3(q + 3) += n_local;
    };
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const Vec3 omega_local = vec3(y + kNumbersPerBody * static_cast<std::ptrdiff_t>(m) + 10);
        Eigen::Map<Vec3> f(acceleration_.data() + 6 * m);
        Eigen::Map<Vec3> n_local(acceleration_.data() + 6 * m + 3);
        f = moving_[m].mass * loads.gravity;
        n_local = -omega_local.cross(moving_[m].J * omega_local);
    }
    for (const AppliedForce& force : loads.forces) {
        const Mat3& A = bodies_[at(force.body)].A;
        const Vec3 f = force.magnitude.at(t).f *
                       (force.frame == Frame::global ? force.direction : (A * force.direction).eval());
        add(force.body, f, force.point_local.cross(A.transpose() * f));
    }
    for (const AppliedTorque& torque : loads.torques) {
        const Mat3& A = bodies_[at(torque.body)].A;
        const Vec3 n = torque.magnitude.at(t).f * torque.direction;
        add(torque.body, Vec3::Zero(), torque.frame == Frame::local ? n : (A.transpose() * n).eval());
    }
    for (const Spring& spring : loads.springs) {
        const Kinematics6& i = bodies_[at(spring.body_i)];
        const Kinematics6& j = bodies_[at(spring.body_j)];
        const Vec3 d = j.r + j.A * spring.P_j_local - i.r - i.A * spring.P_i_local;
        const Vec3 d_dot = j.r_dot + j.A_dot * spring.P_j_local - i.r_dot - i.A_dot * spring.P_i_local;
        const double length = d.norm();
        if (length == 0.0) { continue; }  // no direction to pull in
        const Vec3 along = d / length;
        const double pull =
            spring.stiffness * (length - spring.free_length) + spring.damping * along.dot(d_dot);
        const Vec3 f = pull * along;
        add(spring.body_i, f, spring.P_i_local.cross(i.A.transpose() * f));
        add(spring.body_j, -f, -spring.P_j_local.cross(j.A.transpose() * f));
    }
    for (const RotationalSpring& spring : loads.rotational_springs) {
        const Kinematics6& i = bodies_[at(spring.body_i)];
        const Kinematics6& j = bodies_[at(spring.body_j)];
        const auto angle = measured<Content::motion>(spring.angle, i, j, Theta{});
        const double torque =
            -spring.stiffness * std::remainder(angle.value(0) - spring.free_angle, 2.0 * std::numbers::pi) -
            spring.damping * angle.rate(0);
        const Vec3 n = torque * (i.A * spring.angle.s_i_local);
        add(spring.body_i, Vec3::Zero(), -(i.A.transpose() * n));
        add(spring.body_j, Vec3::Zero(), j.A.transpose() * n);
    }
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        Eigen::Map<Vec3> f(acceleration_.data() + 6 * m);
        Eigen::Map<Vec3> n_local(acceleration_.data() + 6 * m + 3);
        f *= moving_[m].inverse_mass;
        n_local = (moving_[m].inverse_J * n_local).eval();
    }
}

template <int B>
void BlockEquations<B>::subtract_products(const double* x, double* b) const {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int s = 0; s < 2; ++s) {
            const int moving = s == 0 ? nodes_[n].moving_i : nodes_[n].moving_j;
            if (moving < 0) { continue; }
            const double* j = j_.data() + (2 * n + at(s)) * kSide;
            const double* six = x + static_cast<std::ptrdiff_t>(moving) * 6;
            double* rows = b + n * B;
            for (int k = 0; k < 6; ++k) {
                for (int row = 0; row < B; ++row) { rows[row] -= j[k * B + row] * six[k]; }
            }
        }
    }
}

template <int B>
void BlockEquations<B>::add_reactions(const double* lambda, double* x) const {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int s = 0; s < 2; ++s) {
            const int moving = s == 0 ? nodes_[n].moving_i : nodes_[n].moving_j;
            if (moving < 0) { continue; }
            const double* weights = w_.data() + (2 * n + at(s)) * kSide;
            double* six = x + static_cast<std::ptrdiff_t>(moving) * 6;
            for (int row = 0; row < B; ++row) {
                for (int k = 0; k < 6; ++k) { six[k] += weights[row * 6 + k] * lambda[n * B + at(row)]; }
            }
        }
    }
}

template <int B>
RowsVerdict BlockEquations<B>::evaluate(double t, const double* y, double* y_dot) {
    set_bodies<true>(y);
    evaluate_links<true>(t);
    weigh(true);
    form_matrix();
    matrix_.factor();

    add_forces(t, y);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const std::size_t k = n * B + at(row);
            lambda_[k] = ((nodes_[n].kept >> row) & 1U) != 0 ? gamma_[k] : 0.0;
        }
    }
    subtract_products(acceleration_.data(), lambda_.data());
    matrix_.solve(lambda_.data());
    add_reactions(lambda_.data(), acceleration_.data());

    const double* a = acceleration_.data();
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const Kinematics6& body = bodies_[at(moving_[m].body)];
        vec3(y_dot) = body.r_dot;
        vec4(y_dot + 3) = body.p_dot;
        for (int k = 0; k < 6; ++k) { y_dot[7 + k] = a[k]; }
        a += 6;
        y_dot += kNumbersPerBody;
    }
    RowsVerdict verdict{smallest_pivot(), 0.0};
    for (std::size_t k = 0; k < phi_.size(); ++k) {
        verdict.violation = std::max(verdict.violation, std::abs(phi_[k]));
    }
    return verdict;
}

template <int B>
double BlockEquations<B>::project(double t, double* y) {
    // quadratic convergence: from the error of a step three rounds reach rounding
    constexpr int most_rounds = 10;
    double before = 0.0;
    std::vector<double>& delta = acceleration_;
    for (int round = 0; round < most_rounds; ++round) {
        set_bodies<false>(y);
        evaluate_links<false>(t);
        double worst = 0.0;
        for (std::size_t k = 0; k < lambda_.size(); ++k) {
            const bool kept = ((nodes_[k / B].kept >> (k % B)) & 1U) != 0;
            lambda_[k] = kept ? -phi_[k] : 0.0;
            worst = std::max(worst, std::abs(lambda_[k]));
        }
        if (round == 0) { before = worst; }
        weigh(true);
        form_matrix();
        matrix_.factor();
        if (worst < 1e-14) { break; }
        matrix_.solve(lambda_.data());
        std::fill(delta.begin(), delta.end(), 0.0);
        add_reactions(lambda_.data(), delta.data());
        for (std::size_t m = 0; m < moving_.size(); ++m) {
            double* numbers = y + static_cast<std::ptrdiff_t>(m) * kNumbersPerBody;
            vec3(numbers) += vec3(delta.data() + 6 * m);
            Eigen::Map<Vec4> p(numbers + 3);
            p = turned_local(p.normalized(), vec3(delta.data() + 6 * m + 3));
        }
    }
    // velocities: the factorisation of the last round serves
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const double* numbers = y + static_cast<std::ptrdiff_t>(m) * kNumbersPerBody;
        for (std::size_t k = 0; k < 6; ++k) { delta[6 * m + k] = numbers[7 + k]; }
    }
    for (std::size_t k = 0; k < lambda_.size(); ++k) {
        lambda_[k] = ((nodes_[k / B].kept >> (k % B)) & 1U) != 0 ? nu_[k] : 0.0;
    }
    subtract_products(delta.data(), lambda_.data());
    matrix_.solve(lambda_.data());
    add_reactions(lambda_.data(), delta.data());
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        double* numbers = y + static_cast<std::ptrdiff_t>(m) * kNumbersPerBody;
        for (std::size_t k = 0; k < 6; ++k) { numbers[7 + k] = delta[6 * m + k]; }
    }
    return before;
}

/// Which rows of a block of Φq Φqᵀ, reduced by the nodes before it, do not repeat others: diagonal pivoting.
template <int B>
unsigned independent_rows_of(const double* block, const double* row_size, unsigned candidates) {
    double a[B * B];
    std::copy(block, block + B * B, a);
    unsigned chosen = 0;
    for (;;) {
        int best = -1;
        double best_ratio = kRepeats;
        for (int row = 0; row < B; ++row) {
            const bool open = ((candidates >> row) & 1U) != 0 && ((chosen >> row) & 1U) == 0;
            const double ratio = a[row * B + row] / row_size[row];
            if (open && ratio > best_ratio) {
                best = row;
                best_ratio = ratio;
            }
        }
        if (best < 0) { return chosen; }
        chosen |= 1U << best;
        for (int row = 0; row < B; ++row) {
            if (row == best) { continue; }
            const double factor = a[row * B + best] / a[best * B + best];
            for (int k = 0; k < B; ++k) { a[row * B + k] -= factor * a[best * B + k]; }
        }
    }
}

template <int B>
bool BlockEquations<B>::choose_rows(double t, const double* y) {
    std::vector<unsigned> before;
    for (Node& node : nodes_) {
        before.push_back(node.kept);
        node.kept = (1U << node.link.rows) - 1U;
    }
    set_bodies<false>(y);
    evaluate_links<false>(t);
    weigh(false);
    form_matrix();
    matrix_.factor([&](int n, double* diagonal) {
        Node& node = nodes_[at(n)];
        node.kept = independent_rows_of<B>(diagonal, &row_size_[at(n) * B], node.kept);
        for (int row = 0; row < B; ++row) {
            if (((node.kept >> row) & 1U) != 0) { continue; }
            for (int k = 0; k < B; ++k) { diagonal[row * B + k] = diagonal[k * B + row] = 0.0; }
            diagonal[row * B + row] = 1.0;
            for (const auto& upper : structure_.pivots()[at(structure_.position(n))].uppers) {
                double* x = matrix_.block(upper.block) + row * B;
                std::fill(x, x + B, 0.0);
            }
        }
    });
    bool changed = false;
    std::fill(j_.begin(), j_.end(), 0.0);
    for (std::size_t n = 0; n < nodes_.size(); ++n) { changed = changed || nodes_[n].kept != before[n]; }
    return changed;
}

template <int B>
std::pair<double, double> BlockEquations<B>::violation(double t, const double* y) {
    set_bodies<true>(y);
    double position = 0.0;
    double velocity = 0.0;
    for (const Node& node : nodes_) {
        const Kinematics6& i = bodies_[at(node.link.body_i)];
        const Kinematics6& j = bodies_[at(node.link.body_j)];
        for (const LinkEquation& equation : node.link.equations) {
            visit_rows<Content::motion>(
                equation.primitive, i, j, t, [&](const auto& jet, double f_dot, double) {
                    for (int k = 0; k < jet.kDim; ++k) {
                        if (((equation.left_out >> k) & 1U) != 0) { continue; }
                        position = std::max(position, std::abs(jet.value(k)));
                        velocity = std::max(velocity, std::abs(jet.rate(k) - f_dot));
                    }
                });
        }
    }
    return {position, velocity};
}

template <int B>
double BlockEquations<B>::kinetic_energy(const double* y) const {
    double energy = 0.0;
    for (const MovingBody& body : moving_) {
        const Eigen::Map<const Vec3> r_dot(y + 7);
        const Eigen::Map<const Vec3> omega_local(y + 10);
        energy += 0.5 * (body.mass * r_dot.squaredNorm() + omega_local.dot(body.J * omega_local));
        y += kNumbersPerBody;
    }
    return energy;
}

template <int B>
double BlockEquations<B>::potential_energy(const double* y) const {
    double energy = 0.0;
    const auto point = [&](int body, const Vec3& s_local) -> Vec3 {
        const int moving = order_of_body_[at(body)];
        if (moving < 0) { return bodies_[at(body)].r + bodies_[at(body)].A * s_local; }
        const double* numbers = y + static_cast<std::ptrdiff_t>(moving) * kNumbersPerBody;
        return vec3(numbers) + rotation_matrix(vec4(numbers + 3).normalized()) * s_local;
    };
    for (const MovingBody& body : moving_) {
        energy -= body.mass * scene_->loads.gravity.dot(point(body.body, Vec3::Zero()));
    }
    for (const Spring& spring : scene_->loads.springs) {
        const double stretch =
            (point(spring.body_j, spring.P_j_local) - point(spring.body_i, spring.P_i_local)).norm() -
            spring.free_length;
        energy += 0.5 * spring.stiffness * stretch * stretch;
    }
    return energy;
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

}  // namespace

std::unique_ptr<MotionEquations> block_equations(const Centroidal& centroidal) {
    std::vector<Link> links = links_of(centroidal.mechanism);
    const bool small = std::ranges::all_of(links, [](const Link& link) { return link.rows <= 3; });
    if (small) { return std::make_unique<BlockEquations<3>>(centroidal, std::move(links)); }
    return std::make_unique<BlockEquations<6>>(centroidal, std::move(links));
}

void pack(const State& state, const Motion& motion, std::span<const int> moving, double* y) {
    for (const int body : moving) {
        vec3(y) = state.r[at(body)];
        vec4(y + 3) = state.p[at(body)];
        vec3(y + 7) = motion.r_dot[at(body)];
        vec3(y + 10) = motion.omega_local[at(body)];
        y += kNumbersPerBody;
    }
}

void unpack(const double* y, std::span<const int> moving, State& state, Motion& motion) {
    for (const int body : moving) {
        state.r[at(body)] = vec3(y);
        state.p[at(body)] = vec4(y + 3);
        motion.r_dot[at(body)] = vec3(y + 7);
        motion.omega_local[at(body)] = vec3(y + 10);
        y += kNumbersPerBody;
    }
}

}  // namespace jw
