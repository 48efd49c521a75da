#include "tests/reference/general/measures.hpp"

#include "tests/reference/natural_spline.hpp"

namespace jw::reference::general {

namespace {

const Placed& at(const PlacedBodies& bodies, int body) { return bodies[static_cast<std::size_t>(body)]; }

TaylorVector between(const PlacedBodies& bodies, const Fixed& from, const Fixed& to) {
    return point_of(bodies, to) - point_of(bodies, from);
}

/// p(t) of a body that turns at constant ω: ṗ = ½ (0, ω) p.
Taylor euler_parameter(const Placed& body, int number) {
    const Vec4 spin(0.0L, body.omega.x(), body.omega.y(), body.omega.z());
    const Vec4 rate = 0.5L * product(spin, body.p);
    const Vec4 second = 0.5L * product(spin, rate);
    return {body.p[number], rate[number], second[number]};
}

/// c(u) of a curve and its first two derivatives.
std::array<Vec3, 3> curve_at(const OffCurve& m, Real u) {
    std::array<Vec3, 3> out{m.constant + u * m.linear, m.linear, Vec3::Zero()};
    for (std::size_t n = 0; n < m.waves.size(); ++n) {
        const Real k = static_cast<Real>(n + 1);
        const Real c = std::cos(k * u);
        const Real s = std::sin(k * u);
        out[0] += c * m.waves[n].cos + s * m.waves[n].sin;
        out[1] += k * (c * m.waves[n].sin - s * m.waves[n].cos);
        out[2] -= k * k * (c * m.waves[n].cos + s * m.waves[n].sin);
    }
    return out;
}

/// Parameter of the nearest point, by a search over the whole curve and bisection.
Real nearest_on(const OffCurve& m, const Vec3& point) {
    const auto distance = [&](Real u) { return (curve_at(m, u)[0] - point).squaredNorm(); };
    const Real square = m.linear.squaredNorm();
    const Real middle = square > 0.0L ? m.linear.dot(point - m.constant) / square : 0.0L;
    Real best = middle;
    const int looks = 400 * static_cast<int>(m.waves.size() + 1);
    for (int k = -looks; k <= looks; ++k) {
        const Real u = middle + 2.0L * kPi * k / looks;
        if (distance(u) < distance(best)) { best = u; }
    }
    // the slope of the distance changes its sign between the neighbours
    const auto slope = [&](Real u) {
        const auto c = curve_at(m, u);
        return c[1].dot(c[0] - point);
    };
    Real low = best - 2.0L * kPi / looks;
    Real high = best + 2.0L * kPi / looks;
    for (int n = 0; n < 80; ++n) {
        const Real half = 0.5L * (low + high);
        (slope(half) < 0.0L ? low : high) = half;
    }
    return 0.5L * (low + high);
}

/// Directions across a curve: along e_z if the curve is not, and across both.
std::array<Vec3, 2> across(const Vec3& tangent) {
    Eigen::Index least = 0;
    tangent.cwiseAbs().minCoeff(&least);
    const Vec3 a = tangent.cross(Vec3::Unit(least)).normalized();
    return {a, tangent.normalized().cross(a)};
}

/// Values of measures.
struct Value {
    const PlacedBodies& bodies;

    Taylor operator()(const Product& m) const {
        return dot(direction_of(bodies, m.a), direction_of(bodies, m.b));
    }
    Taylor operator()(const CrossProduct& m) const {
        return cross(direction_of(bodies, m.a), direction_of(bodies, m.b))[m.axis];
    }
    Taylor operator()(const Along& m) const {
        return dot(direction_of(bodies, m.a), between(bodies, m.from, m.to));
    }
    Taylor operator()(const CrossDistance& m) const {
        return cross(direction_of(bodies, m.a), between(bodies, m.from, m.to))[m.axis];
    }
    Taylor operator()(const Gap& m) const { return between(bodies, m.from, m.to)[m.axis]; }
    Taylor operator()(const SquaredDistance& m) const {
        const TaylorVector d = between(bodies, m.from, m.to);
        return dot(d, d);
    }
    Taylor operator()(const Angle& m) const { return angle_value(m, bodies); }
    Taylor operator()(const Coordinate& m) const {
        if (m.number >= 3) { return euler_parameter(at(bodies, m.body), m.number - 3); }
        return point_of(bodies, {m.body, Vec3::Zero()})[m.number];
    }
    Taylor operator()(const ThreadAngle& m) const {
        Taylor angle = angle_value(m.angle, bodies);
        const Real by_advance = m.theta_0 + ((*this)(m.along).value - m.d_0) / m.alpha;
        angle.value += 2.0L * kPi * std::round((by_advance - angle.value) / (2.0L * kPi));
        return angle;
    }
    Taylor operator()(const Thread& m) const {
        const ThreadAngle& thread = m.angle;
        Taylor out = (*this)(thread.along) - thread.alpha * (*this)(thread);
        out.value -= thread.d_0 - thread.alpha * thread.theta_0;
        return out;
    }
    TaylorVector line_of(const WheelAngle& m) const {
        switch (m.line) {
            case WheelAngle::Line::centres: return between(bodies, m.from, m.to);
            case WheelAngle::Line::normal: return cross(direction_of(bodies, m.a), direction_of(bodies, m.b));
            case WheelAngle::Line::rack: break;
        }
        return direction_of(bodies, m.a);
    }
    Taylor operator()(const WheelAngle& m) const {
        const TaylorVector e = line_of(m);
        const TaylorVector u = direction_of(bodies, m.u);
        return angle_of(dot(cross(e, u), direction_of(bodies, m.s)), dot(e, u));
    }
    Taylor operator()(const Mesh& m) const {
        Taylor out = (*this)(m.second) - m.ratio * (*this)(m.first);
        Real best = 2.0L * kPi;
        const Real turned = out.value;
        for (int turns = -40; turns <= 40; ++turns) {
            const Real left = std::remainder(turned - 2.0L * kPi * m.ratio * turns, 2.0L * kPi);
            if (std::abs(left) < std::abs(best)) { best = left; }
        }
        out.value = best;
        return out;
    }
    Taylor operator()(const OffCurve& m) const {
        TaylorVector y;
        for (int k = 0; k < 3; ++k) {
            const Taylor component = (*this)(Along{{m.from.body, Vec3::Unit(k)}, m.from, m.to});
            y.value[k] = component.value;
            y.rate[k] = component.rate;
            y.second[k] = component.second;
        }
        const Real u = nearest_on(m, y.value);
        const auto c = curve_at(m, u);
        const Real u_rate = c[1].dot(y.rate) / c[1].squaredNorm();
        const Vec3 n = across(c[1])[m.second ? 1 : 0];
        return {n.dot(y.value - c[0]), n.dot(y.rate), n.dot(y.second) - u_rate * u_rate * n.dot(c[2])};
    }
    Taylor operator()(const Rolling& m) const {
        Taylor out = (*this)(m.along) - m.alpha * (*this)(m.angle);
        out.value = std::remainder(out.value - m.d_0 + m.alpha * m.theta_0, 2.0L * kPi * m.alpha);
        return out;
    }
    TaylorVector vector_of(const OfVectors::Vector& v) const {
        switch (v.kind) {
            case OfVectors::Vector::Kind::point: return point_of(bodies, v.to);
            case OfVectors::Vector::Kind::way: return between(bodies, v.from, v.to);
            case OfVectors::Vector::Kind::direction: break;
        }
        return direction_of(bodies, v.to);
    }
    Taylor operator()(const OfVectors& m) const {
        std::vector<Taylor> variables;
        for (const OfVectors::Vector& v : m.vectors) {
            const TaylorVector vector = vector_of(v);
            for (Eigen::Index k = 0; k < 3; ++k) { variables.push_back(vector[k]); }
        }
        return value_of(m.formula, variables);
    }
};

/// Gradients by virtual work: a measure changes by Σ g · δu over the vectors u that it is made of; for a
/// direction δu = δω × u, for a point δu = δv + δω × arm.
class Work {
public:
    explicit Work(const PlacedBodies& bodies) : bodies_(bodies) {}

    void operator()(const Product& m) {
        turn(m.a, arm(m.b));
        turn(m.b, arm(m.a));
    }
    void operator()(const CrossProduct& m) {
        // e · (a × b) = a · (b × e) = b · (e × a)
        const Vec3 e = Vec3::Unit(m.axis);
        turn(m.a, arm(m.b).cross(e));
        turn(m.b, e.cross(arm(m.a)));
    }
    void operator()(const Along& m) {
        turn(m.a, distance(m.from, m.to));
        part(m.from, m.to, arm(m.a));
    }
    void operator()(const CrossDistance& m) {
        const Vec3 e = Vec3::Unit(m.axis);
        turn(m.a, distance(m.from, m.to).cross(e));
        part(m.from, m.to, e.cross(arm(m.a)));
    }
    void operator()(const Gap& m) { part(m.from, m.to, Vec3::Unit(m.axis)); }
    void operator()(const SquaredDistance& m) { part(m.from, m.to, 2.0L * distance(m.from, m.to)); }
    void operator()(const Angle& m) { angle(m, 1.0L); }
    void operator()(const Coordinate& m) {
        if (m.number < 3) {
            move({m.body, Vec3::Zero()}, Vec3::Unit(m.number));
            return;
        }
        // δe0 = -½ e · δω;  δe = ½ (e0 δω + δω × e)
        const Vec4& p = at(bodies_, m.body).p;
        const Vec3 e = p.tail<3>();
        Vec3 torque = -0.5L * e;
        if (m.number > 3) {
            const Vec3 axis = Vec3::Unit(m.number - 4);
            torque = 0.5L * (p[0] * axis + e.cross(axis));
        }
        pulls_.push_back({m.body, Vec3::Zero(), torque});
    }
    void operator()(const ThreadAngle& m) { angle(m.angle, 1.0L); }
    void operator()(const Thread& m) {
        (*this)(m.angle.along);
        angle(m.angle.angle, -m.angle.alpha);
    }

    void operator()(const OffCurve& m) {
        const Mat3& A = at(bodies_, m.from.body).A;
        const Vec3 y = A.transpose() * distance(m.from, m.to);
        const Vec3 n = across(curve_at(m, nearest_on(m, y))[1])[m.second ? 1 : 0];
        (*this)(Along{{m.from.body, n}, m.from, m.to});
    }
    void operator()(const WheelAngle& m) { wheel(m, 1.0L); }
    void operator()(const Mesh& m) {
        wheel(m.second, 1.0L);
        wheel(m.first, -m.ratio);
    }
    void operator()(const Rolling& m) {
        (*this)(m.along);
        wheel(m.angle, -m.alpha);
    }
    /// The slope by a variable is the rate of the formula where that variable alone has the rate 1.
    void operator()(const OfVectors& m) {
        std::vector<Taylor> variables;
        for (const OfVectors::Vector& v : m.vectors) {
            const Vec3 at_rest = Value{bodies_}.vector_of(v).value;
            for (Eigen::Index k = 0; k < 3; ++k) { variables.push_back({at_rest[k]}); }
        }
        auto variable = variables.begin();
        for (const OfVectors::Vector& v : m.vectors) {
            Vec3 g;
            for (Eigen::Index k = 0; k < 3; ++k, ++variable) {
                variable->rate = 1.0L;
                g[k] = value_of(m.formula, variables).rate;
                variable->rate = 0.0L;
            }
            switch (v.kind) {
                case OfVectors::Vector::Kind::direction: turn(v.to, g); break;
                case OfVectors::Vector::Kind::point: move(v.to, g); break;
                case OfVectors::Vector::Kind::way: part(v.from, v.to, g); break;
            }
        }
    }

    Gradient take() { return std::move(pulls_); }

private:
    Vec3 arm(const Fixed& direction) const { return at(bodies_, direction.body).A * direction.local; }
    Vec3 lever(const Fixed& point) const {
        const Placed& body = at(bodies_, point.body);
        return body.A * (point.local - body.centre);
    }
    Vec3 distance(const Fixed& from, const Fixed& to) const {
        return at(bodies_, to.body).c + lever(to) - at(bodies_, from.body).c - lever(from);
    }
    void turn(const Fixed& direction, const Vec3& g) {
        pulls_.push_back({direction.body, Vec3::Zero(), arm(direction).cross(g)});
    }
    void move(const Fixed& point, const Vec3& g) { pulls_.push_back({point.body, g, lever(point).cross(g)}); }
    void part(const Fixed& from, const Fixed& to, const Vec3& g) {
        move(to, g);
        move(from, -g);
    }
    /// Adds to the gradient the contributions of s and u to an angle from e to u about s.
    /// δθ = (C δS - S δC) / (S² + C²) with S = (e × u) · s and C = e · u.
    /// @return the factor of δe
    Vec3 angle_from(const Vec3& e, const Fixed& to, const Fixed& about, Real weight) {
        const Vec3 s = arm(about);
        const Vec3 u = arm(to);
        const Real S = e.cross(u).dot(s);
        const Real C = e.dot(u);
        const Real of_S = weight * C / (S * S + C * C);
        const Real of_C = -weight * S / (S * S + C * C);
        turn(about, of_S * e.cross(u));
        turn(to, of_S * s.cross(e) + of_C * e);
        return of_S * u.cross(s) + of_C * u;
    }
    void angle(const Angle& m, Real weight) { turn(m.u_i, angle_from(arm(m.u_i), m.u_j, m.s, weight)); }

    /// Adds an angle from a line, with the contributions of the vectors that the line is made of.
    void wheel(const WheelAngle& m, Real weight) {
        const bool of_centres = m.line == WheelAngle::Line::centres;
        const bool of_axes = m.line == WheelAngle::Line::normal;
        const Vec3 e = of_centres ? distance(m.from, m.to) : of_axes ? arm(m.a).cross(arm(m.b)) : arm(m.a);
        const Vec3 g = angle_from(e, m.u, m.s, weight);
        if (of_centres) {
            part(m.from, m.to, g);
        } else if (of_axes) {
            // g · (a × b) = a · (b × g) = b · (g × a)
            turn(m.a, arm(m.b).cross(g));
            turn(m.b, g.cross(arm(m.a)));
        } else {
            turn(m.a, g);
        }
    }

    const PlacedBodies& bodies_;
    Gradient pulls_;
};

Taylor ramp(const Ramp& r, Real t) {
    const Real u = (t - r.start) / (r.end - r.start);
    if (u <= 0.0L) { return {r.from}; }
    if (u >= 1.0L) { return {r.to}; }
    const Taylor way{u, 1.0L / (r.end - r.start), 0.0L};
    const Taylor cube = way * way * way;
    const Taylor share = 10.0L * cube - 15.0L * (cube * way) + 6.0L * (cube * way * way);
    return Taylor{r.from} + (r.to - r.from) * share;
}

}  // namespace

TaylorVector direction_of(const PlacedBodies& bodies, const Fixed& direction) {
    const Placed& body = at(bodies, direction.body);
    const Vec3 s = body.A * direction.local;
    const Vec3 rate = body.omega.cross(s);
    return {s, rate, body.omega.cross(rate)};
}

TaylorVector point_of(const PlacedBodies& bodies, const Fixed& point) {
    const Placed& body = at(bodies, point.body);
    const TaylorVector s = direction_of(bodies, {point.body, point.local - body.centre});
    return TaylorVector{body.c, body.v, Vec3::Zero()} + s;
}

Taylor time_function(const TimeFunction& f, Real t) {
    Taylor out;
    Taylor power{1.0L};
    const Taylor time{t, 1.0L, 0.0L};
    for (const Real c : f.polynomial) {
        out = out + c * power;
        power = power * time;
    }
    for (const Harmonic& h : f.harmonics) {
        const Real sine = h.amplitude * std::sin(h.omega * t + h.phase);
        const Real cosine = h.amplitude * std::cos(h.omega * t + h.phase);
        out = out + Taylor{sine, h.omega * cosine, -h.omega * h.omega * sine};
    }
    for (const Ramp& r : f.ramps) { out = out + ramp(r, t); }
    for (const Table& table : f.tables) {
        const auto [value, rate, second] = natural_spline_at<Real>(table.times, table.values, t);
        out = out + Taylor{value, rate, second};
    }
    for (const FormulaTree& formula : f.formulas) { out = out + value_of(formula, {time}); }
    return out;
}

Taylor angle_value(const Angle& m, const PlacedBodies& bodies) {
    const TaylorVector u_i = direction_of(bodies, m.u_i);
    const TaylorVector u_j = direction_of(bodies, m.u_j);
    return angle_of(dot(cross(u_i, u_j), direction_of(bodies, m.s)), dot(u_i, u_j));
}

Taylor measured(const Measure& measure, const PlacedBodies& bodies) {
    return std::visit(Value{bodies}, measure);
}

Taylor phi_of(const Equation& equation, const PlacedBodies& bodies, Real t) {
    Taylor target = time_function(equation.target, t);
    if (equation.squared) { target = target * target; }
    Taylor phi = measured(equation.measure, bodies) - target;
    phi.value -= equation.constant;
    if (equation.turns) { phi.value = std::remainder(phi.value, 2.0L * kPi); }
    return phi;
}

Gradient gradient_of(const Equation& equation, const PlacedBodies& bodies) {
    Work work(bodies);
    std::visit(work, equation.measure);
    return work.take();
}

}  // namespace jw::reference::general
