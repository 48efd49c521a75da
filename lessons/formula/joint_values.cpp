#include "lessons/formula/part_values.hpp"

#include <algorithm>
#include <variant>

#include "core/equations/assembler.hpp"
#include "core/quantity/names.hpp"

namespace jw::formula {

namespace {

/// Vectors and points of the joint's geometry that have a symbol.
struct GeometrySymbol {
    const char* letter;
    const char* marks;
    Vec3 JointGeometry::*local_i;
    Vec3 JointGeometry::*local_j;
};
constexpr GeometrySymbol kGeometry[] = {
    {"s", "", &JointGeometry::s_i_local, &JointGeometry::s_j_local},
    {"s", "P", &JointGeometry::P_i_local, &JointGeometry::P_j_local},
    {"s", "B", &JointGeometry::P_i_local, &JointGeometry::P_j_local},
    {"h", "", &JointGeometry::h_i_local, &JointGeometry::h_j_local},
    {"u", "", &JointGeometry::u_i_local, &JointGeometry::u_j_local},
};

/// Takes the letter i or j off the end of an index. @return 'i', 'j' or 0
char side_of(Symbol& symbol) {
    if (symbol.index.empty()) { return '\0'; }
    const char side = symbol.index.back();
    if (side != 'i' && side != 'j') { return '\0'; }
    symbol.index.pop_back();
    if (symbol.index.ends_with('_')) { symbol.index.pop_back(); }
    return side;
}

/// The joint at the instant.
class JointAt {
public:
    JointAt(const Instant& instant, int joint, std::optional<Role> role)
        : instant_(&instant),
          joint_(&instant.system->mechanism().joints[jw::at(joint)]),
          index_(joint),
          role_(role) {}

    std::optional<Value> value(const Symbol& symbol) const {
        if (symbol.letter == "Φ") { return phi(symbol); }
        if (symbol.letter == "γ") { return gamma(symbol); }
        if (symbol == Symbol{"d", 0, {}, {}}) { return distance(); }
        if (symbol == Symbol{"α", 0, {}, {}}) { return number(joint_->geometry.alpha); }
        if (symbol == Symbol{"θ", 0, {}, {}}) { return theta(); }
        if (symbol == Symbol{"L", 0, {}, {}}) { return number(joint_->geometry.length); }
        if (symbol == Symbol{"q", 0, {}, {}}) { return coordinates(); }
        Symbol own = symbol;
        const char side = side_of(own);
        if (side == '\0') { return std::nullopt; }
        return vector_of(own, side == 'i');
    }

private:
    BodyValues body(bool i) const { return values_of_body(*instant_, i ? joint_->body_i : joint_->body_j); }

    std::optional<Value> vector_of(const Symbol& symbol, bool i) const {
        const BodyValues values = body(i);
        for (const GeometrySymbol& g : kGeometry) {
            if (symbol.letter != g.letter || symbol.marks != g.marks || !symbol.index.empty()) { continue; }
            const Vec3& local = joint_->geometry.*(i ? g.local_i : g.local_j);
            if (symbol.primes > 1) { return std::nullopt; }
            return symbol.primes == 1 ? constant(local) : global_vector(values, local);
        }
        if (symbol == Symbol{"r", 0, "P", {}} || symbol == Symbol{"r", 0, "B", {}}) { return point(i); }
        return value_of_body_symbol(values, symbol);
    }

    Value point(bool i) const {
        const BodyValues values = body(i);
        const JointGeometry& g = joint_->geometry;
        return sum(values.r, global_vector(values, i ? g.P_i_local : g.P_j_local));
    }

    Value distance() const { return difference(point(false), point(true)); }

    Value coordinates() const {
        const BodyValues i = body(true);
        const BodyValues j = body(false);
        return stacked({{i.r}, {i.p}, {j.r}, {j.p}});
    }

    /// The angle of the joint; for a screw, this is θ.
    std::optional<Value> theta() const {
        const auto measures = measures_of(instant_->system->mechanism(), index_);
        for (const MeasureQuantity& m : measures) {
            const bool angle = std::holds_alternative<AngleMeasure>(m.measure) ||
                               std::holds_alternative<ThetaMeasure>(m.measure);
            if (!angle) { continue; }
            const QuantityValue v = evaluate(m, *instant_, instant_->acceleration ? 2 : 1);
            const auto as_matrix = [](double x) -> MatrixX { return MatrixX::Constant(1, 1, x); };
            return moving(
                as_matrix(v.value()), as_matrix(v.rate()), as_matrix(v.acceleration()),
                instant_->acceleration ? 2 : 1);
        }
        return std::nullopt;
    }

    // ---- Φ, Φq, γ -----------------------------------------------------------------------------

    /// Terms of the joint's constraints, or only of those with `role_` if it is set.
    template <class C>
    std::vector<ConstraintTerms> terms() const {
        std::vector<ConstraintTerms> all;
        for (const Constraint& c : instant_->system->constraints()) {
            if (c.joint != index_ || (role_ && c.role != *role_)) { continue; }
            all.push_back(terms_of<C>(c, instant_->state, instant_->velocity));
        }
        return all;
    }

    /// One member of all terms, stacked vertically.
    template <class Member>
    static MatrixX stack(const std::vector<ConstraintTerms>& terms, Member member) {
        Eigen::Index rows = 0;
        for (const ConstraintTerms& part : terms) { rows += (part.*member).rows(); }
        MatrixX all(rows, terms.empty() ? 0 : (terms.front().*member).cols());
        Eigen::Index top = 0;
        for (const ConstraintTerms& part : terms) {
            all.middleRows(top, (part.*member).rows()) = part.*member;
            top += (part.*member).rows();
        }
        return all;
    }

    std::optional<Value> phi(const Symbol& symbol) const {
        if (symbol.primes != 0) { return std::nullopt; }
        if (symbol.index.empty()) { return named(symbol).value_of_phi(); }
        const bool modified = symbol.marks.find("(m)") != std::string::npos;
        const JointAt joint = named(symbol);
        const MatrixX block = modified ? joint.block<ModifiedEulerParameters>(symbol.index)
                                       : joint.block_of_choice(symbol.index);
        if (block.size() == 0) { return std::nullopt; }
        Value value = constant(block);
        value.order = 0;
        return value;
    }

    /// The joint with the primitive that the marks name: Φ^(p1,2).
    JointAt named(const Symbol& symbol) const {
        JointAt joint = *this;
        for (const Role role : joint_->type->roles) {
            const std::string name(traits_of(role).name);
            if (symbol.marks.find("(" + name + ",") != std::string::npos) {
                joint.role_ = role;
                break;
            }
        }
        return joint;
    }

    Value value_of_phi() const {
        const std::vector<ConstraintTerms> all = terms<OmegaLocal>();
        MatrixX second = stack(all, &ConstraintTerms::bias);
        if (instant_->acceleration) {
            second += theta_acceleration(all);
            for (const bool i : {true, false}) {
                const std::size_t b = jw::at(i ? joint_->body_i : joint_->body_j);
                Eigen::Matrix<double, 6, 1> q_ddot;
                q_ddot << instant_->acceleration->r_dot[b], instant_->acceleration->omega_local[b];
                second += stack(all, i ? &ConstraintTerms::block_i : &ConstraintTerms::block_j) * q_ddot;
            }
        }
        Value phi = moving(
            stack(all, &ConstraintTerms::value), stack(all, &ConstraintTerms::rate), second,
            instant_->acceleration ? 2 : 1);
        // Φ = 0 is a sum of terms that are not 0
        for (const Constraint& c : instant_->system->constraints()) {
            if (c.joint == index_) { phi.scale[0] = std::max(phi.scale[0], c.unit); }
        }
        return phi;
    }

    /// Part of Φ̈ that comes from the artificial coordinate.
    MatrixX theta_acceleration(const std::vector<ConstraintTerms>& all) const {
        const MatrixX columns = stack(all, &ConstraintTerms::block_theta);
        for (const Constraint& c : instant_->system->constraints()) {
            if (c.joint == index_ && c.theta >= 0) {
                return columns * instant_->acceleration->theta_dot[jw::at(c.theta)];
            }
        }
        return MatrixX::Zero(columns.rows(), columns.cols());
    }

    /// Columns that an index names in the coordinates C; empty if it names none.
    template <class C>
    MatrixX block(const std::string& index) const {
        if (index == "q") {
            const std::vector<ConstraintTerms> all = terms<C>();
            MatrixX both(stack(all, &ConstraintTerms::value).rows(), 2 * kColumnsPerBody<C>);
            both << stack(all, &ConstraintTerms::block_i), stack(all, &ConstraintTerms::block_j);
            return both;
        }
        Symbol variable{{}, 0, {}, index};
        const char side = side_of(variable);
        if (side == '\0') { return {}; }
        const MatrixX all =
            stack(terms<C>(), side == 'i' ? &ConstraintTerms::block_i : &ConstraintTerms::block_j);
        if (variable.index == "r") { return all.leftCols(3); }
        const std::string angular =
            C::kNormalised ? "p" : (C::kChoice == CoordinateChoice::omega_global ? "ω" : "ω′");
        return variable.index == angular ? MatrixX(all.rightCols(C::kAngular)) : MatrixX();
    }

    MatrixX block_of_choice(const std::string& index) const {
        for (const MatrixX& found :
             {block<TrueEulerParameters>(index), block<OmegaLocal>(index), block<OmegaGlobal>(index)}) {
            if (found.size() > 0) { return found; }
        }
        return {};
    }

    template <class C>
    MatrixX right_side() const {
        return -stack(terms<C>(), &ConstraintTerms::bias);
    }

    std::optional<Value> gamma(const Symbol& symbol) const {
        if (symbol.primes != 0 || !symbol.index.empty()) { return std::nullopt; }
        const JointAt joint = named(symbol);
        const bool modified = symbol.marks.find("(m)") != std::string::npos;
        const bool of_omega = symbol.marks.find('#') != std::string::npos;
        Value value = constant(
            modified ? joint.right_side<ModifiedEulerParameters>()
                     : (of_omega ? joint.right_side<OmegaLocal>() : joint.right_side<TrueEulerParameters>()));
        value.order = 0;
        return value;
    }

    const Instant* instant_;
    const Joint* joint_;
    int index_;
    std::optional<Role> role_;
};

}  // namespace

std::optional<Value> value_of_joint_symbol(
    const Instant& instant, int joint, std::optional<Role> role, const Symbol& symbol) {
    return JointAt(instant, joint, role).value(symbol);
}

}  // namespace jw::formula
