#include <cmath>

#include <Eigen/Eigenvalues>

#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

// relative error of a tensor that is typed with four digits; a larger one is a mistake
constexpr double kTypedDigits = 1e-3;
// a moment that is smaller than this share of the largest is 0 up to rounding
constexpr double kNoMoment = 1e-13;

constexpr const char* kTensor = "[Jxx, Jyy, Jzz], [Jxx, Jyy, Jzz, Jxy, Jxz, Jyz] or three rows of three";

/// J' from three moments, six numbers or three rows.
std::optional<Located<Mat3>> read_tensor(Fields& fields) {
    if (fields.is_nested("inertia")) { return fields.matrix("inertia"); }
    const auto list = fields.numbers("inertia", 0, 9, kTensor);
    if (!list) { return std::nullopt; }
    const std::vector<double>& n = list->value;
    Mat3 J = Mat3::Zero();
    if (n.size() == 3 || n.size() == 6) {
        J.diagonal() << n[0], n[1], n[2];
        if (n.size() == 6) {
            J(0, 1) = J(1, 0) = n[3];
            J(0, 2) = J(2, 0) = n[4];
            J(1, 2) = J(2, 1) = n[5];
        }
        return Located<Mat3>{J, list->span};
    }
    fields.problems().add(
        Code::wrong_count, list->span,
        "'inertia' has " + std::to_string(n.size()) + (n.size() == 1 ? " entry" : " entries") +
            "; expected " + kTensor);
    return std::nullopt;
}

/// Reports moments of inertia that no body of positive mass has: 0 or less, or one larger than the other two
/// together.
/// @return true if `J` is possible; otherwise the reason has been reported
bool check_moments(Fields& fields, const Located<Mat3>& J) {
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(J.value, Eigen::EigenvaluesOnly).eigenvalues();
    const std::string text =
        short_number(moments(0)) + ", " + short_number(moments(1)) + ", " + short_number(moments(2));
    if (!(moments(0) > kNoMoment * moments(2)) || !(moments(2) > 0.0)) {
        fields.problems().add(
            Code::impossible_inertia, J.span,
            "'inertia' has the principal moments " + text + "; expected all of them above 0",
            "no body has zero thickness: a rod of radius r has m r²/2 about its axis");
        return false;
    }
    if (moments(2) > (1.0 + kTypedDigits) * (moments(0) + moments(1))) {
        fields.problems().add(
            Code::impossible_inertia, J.span,
            "'inertia' has the principal moments " + text +
                "; expected each at most as large as the other two together",
            "a box of edges a, b, c has m/12 [b² + c², a² + c², a² + b²]");
        return false;
    }
    return true;
}

std::optional<Mat3> read_inertia(Fields& fields) {
    auto J = read_tensor(fields);
    if (!J) { return std::nullopt; }
    const Mat3 skew = J->value - J->value.transpose();
    if (skew.cwiseAbs().maxCoeff() > kTypedDigits * J->value.cwiseAbs().maxCoeff()) {
        fields.problems().add(
            Code::impossible_inertia, J->span,
            "'inertia' is not symmetric; expected Jxy = Jyx, Jxz = Jzx and Jyz = Jzy");
        return std::nullopt;
    }
    J->value = 0.5 * (J->value + J->value.transpose()).eval();
    if (!check_moments(fields, *J)) { return std::nullopt; }
    return J->value;
}

}  // namespace

ReadMass read_mass(Fields& fields) {
    ReadMass out;
    for (const char* key : {"centre", "inertia", "mass"}) {
        if (!fields.has(key)) { continue; }
        out.span = fields.span(key);
        out.given = true;
    }
    if (!out.given) { return out; }
    const auto mass = fields.positive("mass");
    const auto J = read_inertia(fields);
    const auto centre = fields.vector("centre");
    fields.require("mass", "the mass in kg, beside 'inertia' and 'centre'");
    fields.require("inertia", "moments of inertia about the centre of mass [kg m²], beside 'mass'");
    if (mass && J) {
        out.properties = MassProperties{mass->value, centre ? centre->value : Vec3::Zero(), *J};
    }
    return out;
}

}  // namespace jw::reading
