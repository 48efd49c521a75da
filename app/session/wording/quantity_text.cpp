#include "app/session/wording/quantity_text.hpp"

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

bool is_shown_in_degrees(const Quantity& quantity) {
    return dimension_of(quantity) == UnitRate{Unit::radian, 0};
}

}  // namespace

std::string unit_text(UnitRate dimension, int derivative, bool in_degrees) {
    const std::string per(per_seconds(dimension.per_s + derivative));
    const bool is_angle = dimension.unit == Unit::radian;
    const std::string symbol(in_degrees && is_angle ? "deg" : symbol_of(dimension.unit));
    return symbol.empty() && !per.empty() ? "1" + per : symbol + per;
}

std::string unit_text(const Quantity& quantity, int derivative) {
    const std::string text = unit_text(dimension_of(quantity), derivative, is_shown_in_degrees(quantity));
    return text.empty() ? "-" : text;
}

double factor_of_unit(const Quantity& quantity) {
    return is_shown_in_degrees(quantity) ? kDegreesPerRadian : 1.0;
}

std::string absence_text(Absence absence) {
    switch (absence) {
        case Absence::none: return "";
        case Absence::no_masses: return tr("there are no masses and forces here");
        case Absence::no_acceleration: return tr("no accelerations are known here");
        case Absence::no_derivative: return tr("it has no such derivative");
        case Absence::not_unique: return tr("it is not unique: redundant equations leave it open");
        case Absence::not_there: return tr("its joint or driver is not present here");
        case Absence::no_motion_of_it: return tr("the pose is not part of the motion by masses and forces");
        case Absence::rank_lost: return tr("the rows have lost rank, so they have no condition number");
        case Absence::singular: break;
    }
    return tr("it is not differentiable here");
}

std::string column_of_before(const std::string& today) {
    if (today == "energy.kinetic") { return "kinetic_J"; }
    if (today == "energy.potential") { return "potential_J"; }
    for (const std::string dot : {"", "_dot", "_ddot"}) {
        const std::string end = ".angle" + dot;
        if (today.ends_with(end)) { return today.substr(0, today.size() - end.size()) + ".theta" + dot; }
    }
    return today;
}

}  // namespace jw
