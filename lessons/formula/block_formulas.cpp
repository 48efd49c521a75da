#include "lessons/formula/block_formulas.hpp"

namespace jw::formula {

namespace {

std::string bold(const std::string& letter, char body, const std::string& marks = {}) {
    return "\\mathbf{" + letter + "}_" + body + (marks.empty() ? "" : "^" + marks);
}

std::string tilde(const std::string& symbol) { return "\\tilde{\\mathbf{" + symbol + "}}"; }

/// Derivative of the arm A s′ of a body, the only part that depends on the choice of coordinates.
/// @param mark  "P" or "B" for an arm to a point, nothing for an axis
std::string arm(CoordinateChoice coordinates, const std::string& letter, char body, const std::string& mark) {
    const std::string index = std::string("_") + body;
    const std::string marks = mark.empty() ? "" : "^" + mark;
    const std::string local = "\\bar{\\mathbf{" + letter + "}}'" + index + marks;
    const std::string global = tilde(letter) + index + marks;
    switch (coordinates) {
        case CoordinateChoice::omega_local: return "(-" + global + " " + bold("A", body) + ")";
        case CoordinateChoice::omega_global: return "(-" + global + ")";
        case CoordinateChoice::modified_euler_parameters: return "2 " + bold("G", body) + " " + local;
        case CoordinateChoice::true_euler_parameters: break;
    }
    return "2 (" + bold("G", body) + " " + local + " + \\mathbf{" + letter + "}'" + index + marks + " " +
           bold("p", body, "T") + ")";
}

/// BodyBlocks of a body in the rows of a role, by its position and by its orientation.
struct BodyBlocks {
    std::string position = "0";
    std::string orientation = "0";
};

BodyBlocks blocks_of(Role role, CoordinateChoice c, bool i) {
    const char own = i ? 'i' : 'j';
    const char other = i ? 'j' : 'i';
    const std::string minus = i ? "-" : "";
    const std::string s = arm(c, "s", own, "");
    const std::string B = arm(c, "s", own, "B");
    switch (role) {
        case Role::same_point:
            return {i ? "\\mathbf{I}" : "-\\mathbf{I}", (i ? "" : "-") + arm(c, "s", own, "P")};
        case Role::axes_perpendicular: return {"0", bold("s", other, "T") + " " + s};
        case Role::sides_perpendicular: return {"0", bold("h", other, "T") + " " + arm(c, "h", own, "")};
        case Role::axes_parallel: return {"0", minus + tilde("s") + "_" + other + " " + s};
        case Role::distance_perpendicular:
            return {
                minus + bold("s", 'i', "T"), i ? "\\mathbf{d}^T " + s + " - " + bold("s", 'i', "T") + " " + B
                                               : bold("s", 'i', "T") + " " + B};
        case Role::distance_perpendicular_j:
            return {
                minus + bold("s", 'j', "T"),
                i ? "-" + bold("s", 'j', "T") + " " + B
                  : "\\mathbf{d}^T " + s + " + " + bold("s", 'j', "T") + " " + B};
        case Role::distance_parallel:
            return {
                minus + tilde("s") + "_i",
                i ? "-\\tilde{\\mathbf{d}} " + s + " - " + tilde("s") + "_i " + B : tilde("s") + "_i " + B};
        case Role::length:
            return {minus + "2 \\mathbf{d}^T", minus + "2 \\mathbf{d}^T " + arm(c, "s", own, "P")};
        case Role::formula:
        case Role::screw_advance:
        case Role::screw_angle:
        case Role::wheel_i:
        case Role::wheel_j:
        case Role::bevel_i:
        case Role::bevel_j:
        case Role::rack_advance:
        case Role::rack_angle:
        case Role::curve_x:
        case Role::curve_y:
        case Role::curve_z: break;
    }
    return {};
}

}  // namespace

std::string block_name(const Block& block) {
    const std::string phi = "\\boldsymbol{\\Phi}";
    const std::string index = block.body_i ? "_i" : "_j";
    if (!block.of_orientation) { return phi + "_{\\mathbf{r}" + index + "}"; }
    switch (block.coordinates) {
        case CoordinateChoice::true_euler_parameters: return phi + "_{\\mathbf{p}" + index + "}";
        case CoordinateChoice::modified_euler_parameters: return phi + "_{\\mathbf{p}" + index + "}^{(m)}";
        case CoordinateChoice::omega_local: return phi + "_{\\boldsymbol{\\omega}'" + index + "}";
        case CoordinateChoice::omega_global: break;
    }
    return phi + "_{\\boldsymbol{\\omega}" + index + "}";
}

std::optional<std::string> block_formula(const Block& block) {
    // the equations with θ, and those of authors, are not on slide 14
    if (has_theta(block.role) || block.role == Role::formula) { return std::nullopt; }
    const BodyBlocks blocks = blocks_of(block.role, block.coordinates, block.body_i);
    return block.of_orientation ? blocks.orientation : blocks.position;
}

}  // namespace jw::formula
