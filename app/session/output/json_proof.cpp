#include <algorithm>

#include "app/session/output/json_fields.hpp"
#include "core/kinematics/proof/proof_record.hpp"

namespace jw {

namespace {

const char* word_of(NoProof reason) {
    switch (reason) {
        case NoProof::none: return "";
        case NoProof::nothing_drives: return "nothing drives the motion";
        case NoProof::leaves_bodies_free: return "drivers leave several bodies free together";
        case NoProof::too_large: return "a part of more than 40 bodies is not proved";
        case NoProof::singular: return "near a singular pose, where rounding hides the branch";
    }
    return "";
}

Json list(const VectorX& numbers) { return jw::json_of(numbers); }

Json json_of(const TimeFunction& function) {
    Json json{
        {"polynomial", function.polynomial},
        {"harmonics", list_of(
                          function.harmonics,
                          [](const auto& h) -> Json {
                              return {h.amplitude, h.omega, h.phase};
                          })},
        {"smooth_steps", list_of(function.steps, [](const auto& s) -> Json {
             return {s.from, s.to, s.start, s.end};
         })}};
    if (function.table) {
        const TimeTable& table = *function.table;
        Json pieces = Json::array();
        for (std::size_t k = 0; k <= table.times.size(); ++k) {
            pieces.push_back({table.piece(k).start, table.piece(k).c});
        }
        json["table"] = {{"times", table.times}, {"pieces", pieces}};
    }
    if (function.formula) {
        const auto operation = [](const FormulaStep& step) {
            return step_json(step, [](int) { return "t"; });
        };
        const auto& steps = function.formula->formula.steps;
        json["formula"] = {{"unit", function.formula->unit}, {"steps", list_of(steps, operation)}};
    }
    return json;
}

const char* kind_of(const N1& /*c*/) { return "n1"; }
const char* kind_of(const N2& /*c*/) { return "n2"; }
const char* kind_of(const N2J& /*c*/) { return "n2 j"; }
const char* kind_of(const P1& /*c*/) { return "p1"; }
const char* kind_of(const P2& /*c*/) { return "p2"; }
const char* kind_of(const S& /*c*/) { return "s"; }
const char* kind_of(const Distance& /*c*/) { return "distance"; }
const char* kind_of(const N1Pair& /*c*/) { return "n1 pair"; }
const char* kind_of(const N2Pair& /*c*/) { return "n2 pair"; }
const char* kind_of(const ScrewAdvance& /*c*/) { return "screw advance"; }
const char* kind_of(const ScrewAngle& /*c*/) { return "screw angle"; }
const char* kind_of(const Wheel& /*c*/) { return "wheel"; }
const char* kind_of(const OnCurve& /*c*/) { return "on curve"; }
const char* kind_of(const FormulaEquation& /*c*/) { return "formula"; }

/// Kind and data of an equation, vectors in the frames of its bodies.
struct Geometry {
    /// Fields of a primitive. The ending "_local" is left out of their names, since all vectors are local
    /// here.
    Json operator()(const auto& primitive) const {
        Json all{{"kind", kind_of(primitive)}};
        primitive.for_each_field([&](std::string_view name, const auto& value) {
            all[std::string(name.substr(0, name.find("_local")))] = field(value);
        });
        return all;
    }
    Json operator()(const UnitLength& /*c*/) const { return {{"kind", "unit length"}}; }
    Json operator()(const AngleMeasure& m) const {
        return {
            {"kind", "angle"},
            {"s_i", list(m.s_i_local)},
            {"u_i", list(m.u_i_local)},
            {"u_j", list(m.u_j_local)}};
    }
    Json operator()(const DisplacementMeasure& m) const {
        return {
            {"kind", "displacement"},
            {"s_i", list(m.s_i_local)},
            {"B_i", list(m.B_i_local)},
            {"B_j", list(m.B_j_local)}};
    }
    Json operator()(const SquaredDistanceMeasure& m) const {
        return {{"kind", "driven distance"}, {"P_i", list(m.P_i_local)}, {"P_j", list(m.P_j_local)}};
    }
    Json operator()(const CoordinateMeasure& m) const {
        return {{"kind", "coordinate"}, {"coordinate", m.coordinate}};
    }
    Json operator()(const ThetaMeasure& /*m*/) const { return {{"kind", "theta"}}; }
};

std::string theta_name(int theta, const Mechanism& mechanism) {
    const std::vector<int> thetas = mechanism.theta_indices();
    const auto joint = at(std::ranges::find(thetas, theta) - thetas.begin());
    return "theta of " + mechanism.joints[joint].name;
}

/// Names of the equations in the order of proved_equations.
std::vector<std::string> names_of(const System& system) {
    const Mechanism& mechanism = system.mechanism();
    std::vector<std::string> names;
    for (const Constraint& c : system.constraints()) {
        names.push_back(mechanism.joints[at(c.joint)].name + ": " + std::string(traits_of(c.role).name));
    }
    for (const DriverConstraint& d : system.drivers()) {
        names.push_back("driver " + mechanism.drivers[at(d.driver)].name);
    }
    for (const int body : system.moving_bodies()) {
        names.push_back("unit length of " + mechanism.bodies[at(body)].name);
    }
    return names;
}

Json equations_of(const ProofRecord& proof, const System& system) {
    const std::vector<std::string> names = names_of(system);
    Json all = Json::array();
    for (std::size_t e = 0; e < proof.equations.size(); ++e) {
        const ProvedEquation& equation = proof.equations[e];
        const auto name = [&](int body) { return system.mechanism().bodies[at(body)].name; };
        Json one{{"name", names[e]}, {"i", name(equation.body_i)}, {"j", name(equation.body_j)}};
        if (equation.theta >= 0) { one["theta"] = theta_name(equation.theta, system.mechanism()); }
        one.update(std::visit(Geometry{}, equation.primitive));
        if (equation.target != nullptr) { one["function"] = json_of(*equation.target); }
        Json components = Json::array();
        for (int k = 0; static_cast<int>(components.size()) < equation.rows; ++k) {
            if (equation.has_row(k)) { components.push_back(k); }
        }
        one["components"] = components;
        all.push_back(std::move(one));
    }
    return all;
}

Json row_json(const ProofRow& row) { return {row.equation, row.component}; }

Json json_of(const StepRecord& step, std::size_t from, const Json& coordinates) {
    const auto part_json = [&](const PartRecord& part) {
        Json one{
            {"coordinates", list_of(part.unknowns, [&](int k) { return coordinates[at(k)][0]; })},
            {"rows", list_of(part.rows, row_json)},
            {"rho", list(part.radius)},
            {"M", jw::json_of(part.inverse)}};
        if (part.kept.rows() > 0) { one["kept"] = jw::json_of(part.kept); }
        return one;
    };
    Json all{{"from", from}, {"to", from + 1}, {"parts", list_of(step.parts, part_json)}};
    if (step.reason != NoProof::none) { all["not_proved"] = word_of(step.reason); }
    return all;
}

Json json_of(const RankRecord& rank) {
    if (rank.rows.empty()) { return {}; }
    const auto repeated_json = [](const RankRecord::Repeated& r) -> Json {
        return {{"row", row_json(r.row)}, {"combination", list(r.combination)}, {"misfit", r.misfit}};
    };
    return {
        {"rows", list_of(rank.rows, row_json)},
        {"columns", rank.columns},
        {"inverse", jw::json_of(rank.inverse)},
        {"repeated", list_of(rank.repeated, repeated_json)}};
}

}  // namespace

Json json_of(const ProofRecord& proof, const System& system, const Lesson& lesson) {
    const Mechanism& mechanism = system.mechanism();
    Json coordinates = Json::array();
    for (const Coordinates& c : proof.coordinates) {
        const std::string name = c.theta >= 0  ? theta_name(c.theta, mechanism)
                                 : c.size == 3 ? "r of " + mechanism.bodies[at(c.body)].name
                                               : "p of " + mechanism.bodies[at(c.body)].name;
        coordinates.push_back({name, c.size});
    }
    Json fixed = Json::object();
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        if (!mechanism.bodies[b].fixed) { continue; }
        fixed["r of " + mechanism.bodies[b].name] = list(proof.fixed.r[b]);
        fixed["p of " + mechanism.bodies[b].name] = list(proof.fixed.p[b]);
    }
    const auto pose_json = [](const PoseRecord& pose) -> Json {
        return {{"t", pose.t}, {"x", list(pose.x)}, {"x_dot", list(pose.x_dot)}};
    };
    Json steps = Json::array();
    for (const StepRecord& step : proof.steps) { steps.push_back(json_of(step, steps.size(), coordinates)); }
    return {
        {"format", "jointwise proof"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"coordinates", coordinates},
        {"fixed", fixed},
        {"equations", equations_of(proof, system)},
        {"rank", json_of(proof.rank)},
        {"poses", list_of(proof.poses, pose_json)},
        {"steps", steps}};
}

}  // namespace jw
