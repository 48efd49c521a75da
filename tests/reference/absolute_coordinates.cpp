#include "tests/reference/body_motion.hpp"
#include "tests/reference/formulations.hpp"

namespace jw::reference {

namespace {

constexpr Eigen::Index kPerBody = 13;

/// Accelerations, or changes of position, of a body.
struct Twist {
    Vec3 v = Vec3::Zero();
    Vec3 w = Vec3::Zero();
};
using Twists = std::vector<Twist>;

class AbsoluteCoordinates : public Ode {
public:
    explicit AbsoluteCoordinates(const Scene& scene) : scene_(scene), motions_(start_motions(scene)) {
        for (const Joint& joint : scene_.joints) { joints_.emplace_back(joint, scene_); }
        J_inverse_.resize(motions_.size(), Mat3::Zero());
    }

    VecX start() const override {
        VecX y(kPerBody * static_cast<Eigen::Index>(motions_.size() - 1));
        for (std::size_t b = 1; b < motions_.size(); ++b) {
            const Body& body = scene_.bodies[b];
            y.segment<kPerBody>(place(b)) << body.r, body.p.normalized(), body.v, body.omega;
        }
        return y;
    }

    void begin_step(const VecX& y) override {
        set_state(y);
        kept_.clear();
        find_rows();
        kept_ = independent_rows(S_matrix());
    }

    void derivative(const VecX& y, VecX& y_dot) override {
        set_state(y);
        find_rows();
        const Twists a = accelerations();
        y_dot.resize(y.size());
        for (std::size_t b = 1; b < motions_.size(); ++b) {
            const BodyMotion& m = motions_[b];
            const Vec4 p = y.segment<4>(place(b) + 3);
            const Vec4 p_dot = 0.5L * product(Vec4(0.0L, m.omega.x(), m.omega.y(), m.omega.z()), p);
            y_dot.segment<kPerBody>(place(b)) << m.v, p_dot, a[b].v, a[b].w;
        }
    }

    void project(VecX& y) override {
        // Newton doubles the digits: a step's drift is at most 1e-15
        for (int iteration = 0; iteration < 2; ++iteration) {
            set_state(y);
            find_rows();
            VecX residual(rows_count());
            for (Eigen::Index k = 0; k < residual.size(); ++k) { residual[k] = -row(k).phi; }
            const Twists change = response(residual);
            for (std::size_t b = 1; b < motions_.size(); ++b) {
                y.segment<3>(place(b)) += change[b].v;
                const Vec3 half = 0.5L * change[b].w;
                const Vec4 p = y.segment<4>(place(b) + 3);
                y.segment<4>(place(b) + 3) =
                    product(Vec4(1.0L, half.x(), half.y(), half.z()), p).normalized();
            }
        }
        set_state(y);
        find_rows();
        VecX residual(rows_count());
        for (Eigen::Index k = 0; k < residual.size(); ++k) {
            const Row& r = row(k);
            residual[k] =
                -(r.v_i.dot(at(r.i).v) + r.w_i.dot(at(r.i).omega) + r.v_j.dot(at(r.j).v) +
                  r.w_j.dot(at(r.j).omega));
        }
        const Twists change = response(residual);
        for (std::size_t b = 1; b < motions_.size(); ++b) {
            y.segment<3>(place(b) + 7) += change[b].v;
            y.segment<3>(place(b) + 10) += change[b].w;
        }
    }

    Sample sample(const VecX& y) override {
        set_state(y);
        const BodyMotion& m = at(scene_.body);
        const Vec3 s = m.A * local_point(scene_, scene_.body, scene_.point);
        return {m.r + s, m.v + m.omega.cross(s)};
    }

private:
    static Eigen::Index place(std::size_t body) { return kPerBody * static_cast<Eigen::Index>(body - 1); }
    const BodyMotion& at(int body) const { return motions_[static_cast<std::size_t>(body)]; }
    const Row& row(Eigen::Index k) const { return rows_[static_cast<std::size_t>(k)]; }
    Eigen::Index rows_count() const { return static_cast<Eigen::Index>(rows_.size()); }

    void set_state(const VecX& y) {
        for (std::size_t b = 1; b < motions_.size(); ++b) {
            BodyMotion& m = motions_[b];
            m.r = y.segment<3>(place(b));
            m.A = rotation(y.segment<4>(place(b) + 3));
            m.v = y.segment<3>(place(b) + 7);
            m.omega = y.segment<3>(place(b) + 10);
            J_inverse_[b] = m.A * scene_.bodies[b].J.cwiseInverse().asDiagonal() * m.A.transpose();
        }
    }

    /// Finds all rows, or only the kept ones once they are chosen.
    void find_rows() {
        rows_.clear();
        for (const JointRows& joint : joints_) { joint.append(motions_, rows_); }
        if (kept_.empty()) { return; }
        for (std::size_t k = 0; k < kept_.size(); ++k) {
            rows_[k] = rows_[static_cast<std::size_t>(kept_[k])];
        }
        rows_.resize(kept_.size());
    }

    /// M⁻¹ times a force and torque on a body; the ground does not move.
    Twist moved(int body, const Vec3& force, const Vec3& torque) const {
        if (body == 0) { return {}; }
        const auto b = static_cast<std::size_t>(body);
        return {force / scene_.bodies[b].mass, J_inverse_[b] * torque};
    }

    /// S = J M⁻¹ Jᵀ
    MatX S_matrix() const {
        MatX S = MatX::Zero(rows_count(), rows_count());
        for (Eigen::Index a = 0; a < S.rows(); ++a) {
            const Row& x = row(a);
            const Twist i = moved(x.i, x.v_i, x.w_i);
            const Twist j = moved(x.j, x.v_j, x.w_j);
            for (Eigen::Index b = 0; b <= a; ++b) {
                const Row& z = row(b);
                if (z.i == x.i) { S(a, b) += i.v.dot(z.v_i) + i.w.dot(z.w_i); }
                if (z.j == x.i) { S(a, b) += i.v.dot(z.v_j) + i.w.dot(z.w_j); }
                if (z.i == x.j) { S(a, b) += j.v.dot(z.v_i) + j.w.dot(z.w_i); }
                if (z.j == x.j) { S(a, b) += j.v.dot(z.v_j) + j.w.dot(z.w_j); }
                S(b, a) = S(a, b);
            }
        }
        return S;
    }

    /// The smallest change, measured by M, that J maps to `image`.
    Twists response(const VecX& image) const {
        Twists out(motions_.size());
        if (rows_.empty()) { return out; }
        const VecX lambda = S_matrix().llt().solve(image);
        std::vector<Wrench> wrenches(motions_.size());
        for (Eigen::Index k = 0; k < lambda.size(); ++k) {
            const Row& r = row(k);
            wrenches[static_cast<std::size_t>(r.i)].force += lambda[k] * r.v_i;
            wrenches[static_cast<std::size_t>(r.i)].torque += lambda[k] * r.w_i;
            wrenches[static_cast<std::size_t>(r.j)].force += lambda[k] * r.v_j;
            wrenches[static_cast<std::size_t>(r.j)].torque += lambda[k] * r.w_j;
        }
        for (std::size_t b = 1; b < out.size(); ++b) {
            out[b] = moved(static_cast<int>(b), wrenches[b].force, wrenches[b].torque);
        }
        return out;
    }

    /// Accelerations without joints, plus the changes by the joints so that J a = gamma.
    Twists accelerations() const {
        std::vector<Wrench> wrenches(motions_.size());
        add_loads(scene_, motions_, wrenches);
        Twists a(motions_.size());
        for (std::size_t b = 1; b < a.size(); ++b) {
            const BodyMotion& m = motions_[b];
            const Vec3 momentum = m.A * scene_.bodies[b].J.asDiagonal() * (m.A.transpose() * m.omega).eval();
            a[b] =
                moved(static_cast<int>(b), wrenches[b].force, wrenches[b].torque - m.omega.cross(momentum));
        }
        VecX missing(rows_count());
        for (Eigen::Index k = 0; k < missing.size(); ++k) {
            const Row& r = row(k);
            const Twist& i = a[static_cast<std::size_t>(r.i)];
            const Twist& j = a[static_cast<std::size_t>(r.j)];
            missing[k] = r.gamma - r.v_i.dot(i.v) - r.w_i.dot(i.w) - r.v_j.dot(j.v) - r.w_j.dot(j.w);
        }
        const Twists added = response(missing);
        for (std::size_t b = 1; b < a.size(); ++b) {
            a[b].v += added[b].v;
            a[b].w += added[b].w;
        }
        return a;
    }

    Scene scene_;
    Motions motions_;
    std::vector<JointRows> joints_;
    std::vector<int> kept_;
    std::vector<Row> rows_;
    std::vector<Mat3> J_inverse_;  ///< global
};

}  // namespace

std::unique_ptr<Ode> absolute_coordinates(const Scene& scene) {
    return std::make_unique<AbsoluteCoordinates>(scene);
}

}  // namespace jw::reference
