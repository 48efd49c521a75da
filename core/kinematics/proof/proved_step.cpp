#include "core/kinematics/proof/proved_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jw {

namespace {

template <std::size_t N>
double largest_norm(const std::array<Vec4, N>& vectors) {
    double square = 0.0;
    for (const Vec4& v : vectors) { square = std::max(square, v.squaredNorm()); }
    return std::sqrt(square);
}

Path path_of(const Vec4& x0, const Vec4& v0, const Vec4& x1, const Vec4& v1, double h) {
    Path path;
    path.control = {x0, x0 + h / 3.0 * v0, x1 - h / 3.0 * v1, x1};
    path.size = largest_norm(path.control);
    if (h == 0.0) { return path; }
    const auto& b = path.control;
    std::array<Vec4, 3> first;
    for (std::size_t k = 0; k < 3; ++k) { first[k] = 3.0 / h * (b[k + 1] - b[k]); }
    std::array<Vec4, 2> second;
    for (std::size_t k = 0; k < 2; ++k) { second[k] = 2.0 / h * (first[k + 1] - first[k]); }
    path.series[1] = largest_norm(first);
    path.series[2] = 0.5 * largest_norm(second);
    path.series[3] = (second[1] - second[0]).norm() / std::abs(6.0 * h);
    return path;
}

bool is_at(const StepEnd& end, const PathEnd& pose) {
    return end.t == pose.t && end.state.r == pose.state->r && end.state.p == pose.state->p &&
           end.state.theta == pose.state->theta && end.r_dot == pose.velocity->r_dot &&
           end.omega_local == pose.velocity->omega_local && end.theta_dot == pose.velocity->theta_dot;
}

}  // namespace

Vec4 Path::at(double share) const {
    const double left = 1.0 - share;
    return left * left * left * control[0] + 3.0 * share * left * left * control[1] +
           3.0 * share * share * left * control[2] + share * share * share * control[3];
}

ProvedStep::ProvedStep(const System& system)
    : length_(extent(system.mechanism())),
      table_(system),
      equations_(proved_equations(system)),
      jacobians_(equations_.size()),
      still_(zero_motion(system.mechanism())),
      paths_(table_.all().size()),
      targets_(equations_.size()),
      error_(paths_.size(), 0.0) {
    for (const ProvedEquation& equation : equations_) { blocks_.push_back(table_.blocks_of(equation)); }
}

Theta ProvedStep::theta_of(const ProvedEquation& equation, const StepEnd& end) const {
    Theta theta;
    if (equation.theta >= 0) {
        theta = {end.state.theta[at(equation.theta)], end.theta_dot[at(equation.theta)]};
    }
    if (equation.target == nullptr) { return theta; }
    const TimeFunction::Value target = equation.target->at(end.t);
    if (equation.theta >= 0) { return {theta.value - target.f, theta.rate - target.f_dot}; }
    return {target.f, target.f_dot};
}

/// Sets the coordinates of an end and the values that follow from them, but not those of equations.
void ProvedStep::set_pose(StepEnd& end, const PathEnd& pose) const {
    end.t = pose.t;
    end.state = *pose.state;
    end.r_dot = pose.velocity->r_dot;
    end.omega_local = pose.velocity->omega_local;
    end.theta_dot = pose.velocity->theta_dot;
    const std::size_t bodies = end.state.r.size();
    end.p_dot.resize(bodies);
    end.bodies.resize(bodies);
    for (std::size_t b = 0; b < bodies; ++b) {
        end.bodies[b] = kinematics_at<ModifiedEulerParameters>(
            end.state.r[b], end.state.p[b], end.r_dot[b], pose.velocity->omega_local[b]);
        end.p_dot[b] = end.bodies[b].p_dot;
    }
    end.thetas.resize(equations_.size());
    for (std::size_t e = 0; e < equations_.size(); ++e) { end.thetas[e] = theta_of(equations_[e], end); }
}

void ProvedStep::set_end(StepEnd& end, const PathEnd& pose) const {
    set_pose(end, pose);
    end.phi.resize(equations_.size());
    end.rate.resize(equations_.size());
    for (std::size_t e = 0; e < equations_.size(); ++e) {
        const ProvedEquation& equation = equations_[e];
        visit_equation<Content::motion>(
            equation, end.bodies[at(equation.body_i)], end.bodies[at(equation.body_j)], end.thetas[e],
            [&](const auto& jet) {
                double phi = 0.0;
                double rate = 0.0;
                for (int k = 0; k < std::decay_t<decltype(jet)>::kDim; ++k) {
                    if (!equation.has_row(k)) { continue; }
                    phi += jet.value(k) * jet.value(k);
                    rate += jet.rate(k) * jet.rate(k);
                }
                end.phi[e] = std::sqrt(phi) / equation.unit;
                end.rate[e] = std::sqrt(rate) / equation.unit;
            });
    }
}

Path ProvedStep::path_of_coordinates(const Coordinates& c) const {
    const StepEnd& a = ends_[0];
    const StepEnd& b = ends_[1];
    if (c.theta >= 0) {
        const auto one = [](double x) { return Vec4(x, 0.0, 0.0, 0.0); };
        const std::size_t n = at(c.theta);
        return path_of(
            one(a.state.theta[n]), one(a.theta_dot[n]), one(b.state.theta[n]), one(b.theta_dot[n]), h());
    }
    const std::size_t n = at(c.body);
    if (c.size == 3) {
        const auto padded = [](const Vec3& v) { return Vec4(v.x(), v.y(), v.z(), 0.0); };
        return path_of(
            padded(a.state.r[n]), padded(a.r_dot[n]), padded(b.state.r[n]), padded(b.r_dot[n]), h());
    }
    // p and -p are the same pose: the nearer one is used
    const double sign = a.state.p[n].dot(b.state.p[n]) < 0.0 ? -1.0 : 1.0;
    return path_of(a.state.p[n], a.p_dot[n], sign * b.state.p[n], sign * b.p_dot[n], h());
}

void ProvedStep::set(const PathEnd& from, const PathEnd& to) {
    if (is_at(ends_[1], from)) {
        std::swap(ends_[0], ends_[1]);
    } else if (!is_at(ends_[0], from)) {
        set_end(ends_[0], from);
    }
    set_end(ends_[1], to);
    for (std::size_t k = 0; k < paths_.size(); ++k) { paths_[k] = path_of_coordinates(table_.all()[k]); }
    const auto [first, last] = std::minmax(from.t, to.t);
    for (std::size_t e = 0; e < equations_.size(); ++e) {
        if (equations_[e].target != nullptr) {
            targets_[e] = equations_[e].target->taylor_bounds(first, last);
        }
    }
}

State ProvedStep::state_at(double share) const {
    State state = from().state;
    for (std::size_t k = 0; k < paths_.size(); ++k) {
        const Coordinates& c = table_.all()[k];
        const Vec4 x = paths_[k].at(share);
        if (c.theta >= 0) {
            state.theta[at(c.theta)] = x(0);
        } else if (c.size == 3) {
            state.r[at(c.body)] = x.head<3>();
        } else {
            state.p[at(c.body)] = x;
        }
    }
    return state;
}

const StepEnd& ProvedStep::ahead(double time) {
    State state = state_at(1.0 + time / std::abs(h()));
    for (Vec4& p : state.p) { p.normalize(); }
    set_pose(ahead_, {to().t + std::copysign(time, h()), &state, &still_});
    return ahead_;
}

const EquationJacobian& ProvedStep::jacobian_at(const StepEnd& end, int equation) {
    const ProvedEquation& e = equations_[at(equation)];
    EquationJacobian& jacobian = jacobians_[at(equation)];
    compute_jacobian(
        e, end.bodies[at(e.body_i)], end.bodies[at(e.body_j)], end.thetas[at(equation)], length_, jacobian);
    return jacobian;
}

}  // namespace jw
