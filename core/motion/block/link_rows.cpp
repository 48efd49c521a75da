#include "core/motion/block/link_rows.hpp"

#include <Eigen/LU>

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

}  // namespace

LinkRows::LinkRows(const Centroidal& scene, std::vector<Link> links, const Baumgarte& baumgarte, int width)
    : width_(at(width)),
      baumgarte_(baumgarte),
      moving_(moving_bodies(scene)),
      order_of_body_(scene.mechanism.bodies.size(), -1),
      bodies_(scene.mechanism.bodies.size()) {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        order_of_body_[at(moving_[m].body)] = static_cast<int>(m);
    }
    for (Link& link : links) {
        const int i = order_of_body_[at(link.body_i)];
        const int j = order_of_body_[at(link.body_j)];
        if (i < 0 && j < 0) { continue; }  // between fixed bodies
        const unsigned all = (1U << link.rows) - 1U;
        counts_turns_ = counts_turns_ || std::ranges::any_of(link.equations, [](const LinkEquation& e) {
                            return jw::counts_turns(e.primitive);
                        });
        nodes_.push_back({std::move(link), i, j, all});
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = scene.mechanism.bodies[b];
        bodies_[b].r = body.r;
        bodies_[b].p = body.p;
        bodies_[b].A = OmegaLocal::rotation(body.p);
    }
    j_.assign(2 * nodes_.size() * 6 * width_, 0.0);
    for (std::vector<double>* v : {&phi_, &nu_, &gamma_}) { v->assign(nodes_.size() * width_, 0.0); }
}

void LinkRows::set_bodies(Content content, const double* y) {
    for (const MovingBody& moving : moving_) {
        Kinematics6& body = bodies_[at(moving.body)];
        body.r = vec3(y);
        body.p = vec4(y + 3);
        body.A = OmegaLocal::rotation(body.p);
        if (content == Content::motion) {
            body.r_dot = vec3(y + 7);
            OmegaLocal::set_motion(body, vec3(y + 10));
        }
        y += kNumbersPerBody;
    }
}

void LinkRows::tell_turns_at(Turns turns, double t, const double* y) {
    if (!counts_turns_) { return; }
    set_bodies(Content::motion, y);
    for (Node& node : nodes_) {
        for (LinkEquation& equation : node.link.equations) {
            tell_turns(
                equation.primitive, turns, t, bodies_[at(node.link.body_i)], bodies_[at(node.link.body_j)]);
        }
    }
}

/// Writes the Jacobian blocks of kept rows of link n; other rows stay zero.
template <class Jet>
void LinkRows::write_jacobian(std::size_t n, const LinkEquation& equation, const Jet& jet) {
    double* const of_i = &j_[12 * n * width_];
    double* const of_j = of_i + 6 * width_;
    int row = equation.first_row;
    for (int component = 0; component < Jet::kDim; ++component) {
        if (has(equation.left_out, component)) { continue; }
        if (has(nodes_[n].kept, row)) {
            if constexpr ((Jet::kSides & kBodyI) != 0) {
                double* target = of_i + row;
                for (int k = 0; k < 6; ++k) { target[at(k) * width_] = jet.block_i(component, k); }
            }
            if constexpr ((Jet::kSides & kBodyJ) != 0) {
                double* target = of_j + row;
                for (int k = 0; k < 6; ++k) { target[at(k) * width_] = jet.block_j(component, k); }
            }
        }
        ++row;
    }
}

void LinkRows::evaluate_links(Content content, double t) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const Node& node = nodes_[n];
        const Kinematics6& i = bodies_[at(node.link.body_i)];
        const Kinematics6& j = bodies_[at(node.link.body_j)];
        for (const LinkEquation& equation : node.link.equations) {
            const auto each_row = [&](int components, auto&& write) {
                std::size_t row = n * width_ + at(equation.first_row);
                for (int k = 0; k < components; ++k) {
                    if (!has(equation.left_out, k)) { write(row++, k); }
                }
            };
            visit_rows<Content::jacobian>(
                equation.primitive, i, j, t, [&](const auto& jet, double f_dot, double) {
                    write_jacobian(n, equation, jet);
                    each_row(jet.kDim, [&](std::size_t row, int k) {
                        phi_[row] = jet.value(k);
                        nu_[row] = f_dot;
                    });
                });
            if (content == Content::motion) {
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

}  // namespace jw
