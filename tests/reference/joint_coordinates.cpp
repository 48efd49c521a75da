#include "tests/reference/body_motion.hpp"
#include "tests/reference/formulations.hpp"

namespace jw::reference {

namespace {

using Columns = Eigen::Matrix<Real, 3, Eigen::Dynamic>;

/// Each column crossed with s: for columns of ω, the velocity of a point at s.
Columns crossed(const Columns& w, const Vec3& s) {
    Columns out(3, w.cols());
    for (Eigen::Index k = 0; k < w.cols(); ++k) { out.col(k) = w.col(k).cross(s); }
    return out;
}

/// v = V u, ω = W u; accelerations V u' + v_bias, W u' + w_bias.
struct Partial {
    Columns V, W;
    Vec3 v_bias = Vec3::Zero();
    Vec3 w_bias = Vec3::Zero();
};

/// A joint that brings a body: the indices of its coordinates, and its vectors in the two bodies.
struct Hinge {
    Joint joint;
    Eigen::Index q = 0;  ///< first position coordinate: an angle, a distance or four Euler parameters
    Eigen::Index u = 0;  ///< first speed: a rate, or the three components of the body's global ω
    Vec3 P_i, P_j, axis_i;
    Mat3 start;  ///< A_iᵀ A_j at t = 0
};

class JointCoordinates : public Ode {
public:
    explicit JointCoordinates(const Scene& scene)
        : scene_(scene), motions_(start_motions(scene)), partials_(scene.bodies.size()) {
        std::vector<std::size_t> hinge_of(scene.joints.size());
        for (std::size_t k = 0; k < scene.joints.size(); ++k) {
            const Joint& joint = scene.joints[k];
            if (joint.closes_loop) {
                loops_.emplace_back(joint, scene);
            } else {
                hinge_of[k] = hinges_.size();
                const bool shares = joint.same_as >= 0;
                add_hinge(
                    joint, shares ? &hinges_[hinge_of[static_cast<std::size_t>(joint.same_as)]] : nullptr);
            }
        }
        partials_[0].V = partials_[0].W = Columns::Zero(3, n_u_);
    }

    VecX start() const override {
        VecX y = VecX::Zero(n_q_ + n_u_);
        for (const Hinge& hinge : hinges_) {
            const Body& i = scene_.bodies[static_cast<std::size_t>(hinge.joint.i)];
            const Body& j = scene_.bodies[static_cast<std::size_t>(hinge.joint.j)];
            const Vec3 axis = rotation(i.p) * hinge.axis_i;
            if (hinge.joint.kind == JointKind::spherical) {
                y.segment<4>(hinge.q) = j.p.normalized();
                y.segment<3>(n_q_ + hinge.u) = j.omega;
            } else if (hinge.joint.kind == JointKind::prismatic) {
                y[n_q_ + hinge.u] = axis.dot(j.v - i.v - i.omega.cross(j.r - i.r));
            } else {
                y[n_q_ + hinge.u] = hinge.joint.sense * axis.dot(j.omega - i.omega);
            }
        }
        return y;
    }

    void begin_step(const VecX& y) override {
        kept_.clear();
        set_state(y);
        if (loops_.empty()) { return; }
        kept_ = independent_rows(J_ * mass_matrix().llt().solve(J_.transpose()));
    }

    void derivative(const VecX& y, VecX& y_dot) override {
        set_state(y);
        const VecX u = y.tail(n_u_);
        const auto mass = mass_matrix().llt();
        VecX u_dot = mass.solve(generalized_forces());
        if (!loops_.empty()) {
            VecX missing = -J_ * u_dot;
            for (std::size_t k = 0; k < rows_.size(); ++k) {
                missing[static_cast<Eigen::Index>(k)] += rows_[k].gamma - bias_of(rows_[k]);
            }
            u_dot += response(mass, missing);
        }
        y_dot.resize(y.size());
        y_dot << q_dot(y.head(n_q_), u), u_dot;
    }

    void project(VecX& y) override {
        for (const Hinge& hinge : hinges_) {
            if (hinge.joint.kind == JointKind::spherical) { y.segment<4>(hinge.q).normalize(); }
        }
        if (loops_.empty()) { return; }
        for (int iteration = 0; iteration < 2; ++iteration) {
            set_state(y);
            VecX residual(J_.rows());
            for (std::size_t k = 0; k < rows_.size(); ++k) {
                residual[static_cast<Eigen::Index>(k)] = -rows_[k].phi;
            }
            y.head(n_q_) += q_dot(y.head(n_q_), response(mass_matrix().llt(), residual));
        }
        set_state(y);
        const VecX residual = -J_ * y.tail(n_u_);
        y.tail(n_u_) += response(mass_matrix().llt(), residual);
    }

    Sample sample(const VecX& y) override {
        set_state(y);
        const BodyMotion& m = motions_[static_cast<std::size_t>(scene_.body)];
        const Vec3 s = m.A * local_point(scene_, scene_.body, scene_.point);
        return {m.r + s, m.v + m.omega.cross(s)};
    }

private:
    void add_hinge(const Joint& joint, const Hinge* shared) {
        const bool ball = joint.kind == JointKind::spherical;
        const Mat3 A_i = rotation(scene_.bodies[static_cast<std::size_t>(joint.i)].p);
        const Mat3 A_j = rotation(scene_.bodies[static_cast<std::size_t>(joint.j)].p);
        Hinge hinge;
        hinge.joint = joint;
        hinge.q = shared != nullptr ? shared->q : n_q_;
        hinge.u = shared != nullptr ? shared->u : n_u_;
        hinge.P_i = local_point(scene_, joint.i, joint.point);
        hinge.P_j = local_point(scene_, joint.j, joint.point);
        hinge.axis_i = A_i.transpose() * joint.axis.normalized();
        hinge.start = A_i.transpose() * A_j;
        hinges_.push_back(hinge);
        if (shared == nullptr) {
            n_q_ += ball ? 4 : 1;
            n_u_ += ball ? 3 : 1;
        }
    }

    /// Computes motions and partial velocities from the ground outwards, then the rows of the loops.
    void set_state(const VecX& y) {
        for (const Hinge& hinge : hinges_) { place(hinge, y); }
        rows_.clear();
        for (const JointRows& loop : loops_) { loop.append(motions_, rows_); }
        for (std::size_t k = 0; k < kept_.size(); ++k) {
            rows_[k] = rows_[static_cast<std::size_t>(kept_[k])];
        }
        if (!kept_.empty()) { rows_.resize(kept_.size()); }
        J_.resize(static_cast<Eigen::Index>(rows_.size()), n_u_);
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const Row& row = rows_[k];
            const Partial& i = partials_[static_cast<std::size_t>(row.i)];
            const Partial& j = partials_[static_cast<std::size_t>(row.j)];
            J_.row(static_cast<Eigen::Index>(k)) = row.v_i.transpose() * i.V + row.w_i.transpose() * i.W +
                                                   row.v_j.transpose() * j.V + row.w_j.transpose() * j.W;
        }
    }

    /// Places body j from body i across one joint.
    void place(const Hinge& hinge, const VecX& y) {
        const BodyMotion& i = motions_[static_cast<std::size_t>(hinge.joint.i)];
        const Partial& of_i = partials_[static_cast<std::size_t>(hinge.joint.i)];
        BodyMotion& j = motions_[static_cast<std::size_t>(hinge.joint.j)];
        Partial& of_j = partials_[static_cast<std::size_t>(hinge.joint.j)];
        const Vec3 axis = i.A * hinge.axis_i;
        const Real sense = hinge.joint.sense;
        const Real rate = sense * y[n_q_ + hinge.u];
        Vec3 s_i = i.A * hinge.P_i;
        Vec3 slid = Vec3::Zero();  // relative velocity of the joint's points

        // orientation and ω
        of_j.W = of_i.W;
        of_j.w_bias = of_i.w_bias;
        j.omega = i.omega;
        j.A = i.A * hinge.start;
        if (hinge.joint.kind == JointKind::spherical) {
            j.A = rotation(y.segment<4>(hinge.q));
            j.omega = y.segment<3>(n_q_ + hinge.u);
            of_j.W.setZero();
            of_j.W.middleCols<3>(hinge.u).setIdentity();
            of_j.w_bias.setZero();
        } else if (hinge.joint.kind == JointKind::revolute) {
            j.A = i.A * rotation(turn(hinge.axis_i, sense * y[hinge.q])) * hinge.start;
            j.omega += rate * axis;
            of_j.W.col(hinge.u) += sense * axis;
            of_j.w_bias += i.omega.cross(rate * axis);
        } else {
            s_i += y[hinge.q] * axis;
            slid = rate * axis;
        }

        // the joint's point as part of i, then the centre of j
        const Vec3 s_j = j.A * hinge.P_j;
        j.r = i.r + s_i - s_j;
        j.v = i.v + i.omega.cross(s_i) + slid - j.omega.cross(s_j);
        of_j.V = of_i.V + crossed(of_i.W, s_i) - crossed(of_j.W, s_j);
        if (hinge.joint.kind == JointKind::prismatic) { of_j.V.col(hinge.u) += axis; }
        of_j.v_bias = of_i.v_bias + of_i.w_bias.cross(s_i) + i.omega.cross(i.omega.cross(s_i)) +
                      2.0L * i.omega.cross(slid) - of_j.w_bias.cross(s_j) - j.omega.cross(j.omega.cross(s_j));
    }

    MatX mass_matrix() const {
        MatX M = MatX::Zero(n_u_, n_u_);
        for (std::size_t b = 1; b < motions_.size(); ++b) {
            const Columns W = motions_[b].A.transpose() * partials_[b].W;
            M += scene_.bodies[b].mass * partials_[b].V.transpose() * partials_[b].V +
                 W.transpose() * scene_.bodies[b].J.asDiagonal() * W;
        }
        return M;
    }

    VecX generalized_forces() const {
        std::vector<Wrench> wrenches(motions_.size());
        add_loads(scene_, motions_, wrenches);
        VecX Q = VecX::Zero(n_u_);
        for (std::size_t b = 1; b < motions_.size(); ++b) {
            const BodyMotion& m = motions_[b];
            const Mat3 J = m.A * scene_.bodies[b].J.asDiagonal() * m.A.transpose();
            Q += partials_[b].V.transpose() *
                     (wrenches[b].force - scene_.bodies[b].mass * partials_[b].v_bias) +
                 partials_[b].W.transpose() *
                     (wrenches[b].torque - m.omega.cross(J * m.omega) - J * partials_[b].w_bias);
        }
        return Q;
    }

    /// The smallest change of speeds, measured by M, that the rows of the loops map to `image`.
    template <class Mass>
    VecX response(const Mass& mass, const VecX& image) const {
        const MatX X = mass.solve(J_.transpose());
        return X * (J_ * X).llt().solve(image);
    }

    Real bias_of(const Row& row) const {
        const Partial& i = partials_[static_cast<std::size_t>(row.i)];
        const Partial& j = partials_[static_cast<std::size_t>(row.j)];
        return row.v_i.dot(i.v_bias) + row.w_i.dot(i.w_bias) + row.v_j.dot(j.v_bias) + row.w_j.dot(j.w_bias);
    }

    VecX q_dot(const VecX& q, const VecX& u) const {
        VecX out = VecX::Zero(n_q_);
        for (const Hinge& hinge : hinges_) {
            if (hinge.joint.kind == JointKind::spherical) {
                const Vec3 w = u.segment<3>(hinge.u);
                const Vec4 p = q.segment<4>(hinge.q);
                out.segment<4>(hinge.q) = 0.5L * product(Vec4(0.0L, w.x(), w.y(), w.z()), p);
            } else {
                out[hinge.q] = u[hinge.u];
            }
        }
        return out;
    }

    Scene scene_;
    Motions motions_;
    std::vector<Partial> partials_;
    std::vector<Hinge> hinges_;
    std::vector<JointRows> loops_;
    Eigen::Index n_q_ = 0;
    Eigen::Index n_u_ = 0;
    std::vector<int> kept_;
    std::vector<Row> rows_;
    MatX J_;  ///< of the loops, on u
};

}  // namespace

std::unique_ptr<Ode> joint_coordinates(const Scene& scene) {
    return std::make_unique<JointCoordinates>(scene);
}

}  // namespace jw::reference
