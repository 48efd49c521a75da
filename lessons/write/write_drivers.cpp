#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/numerics/variants.hpp"
#include "core/quantity/quantity.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writing.hpp"

namespace jw::writing {

namespace {

// digits of a frequency that somebody typed
constexpr int kFrequencyDigits = 12;

/// Polynomial with these coefficients: "30 deg + 90 deg/s t".
std::string formula_of(std::span<const double> coefficients, const std::string& unit) {
    std::string text;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        const double c = coefficients[k];
        if (c == 0.0 && coefficients.size() > 1) { continue; }
        const std::string size = short_number(text.empty() ? c : std::abs(c), 4);
        text += text.empty() ? "" : c < 0.0 ? " - " : " + ";
        text += size + ' ' + unit;
        if (k >= 1) { text += "/s" + (k > 1 ? "^" + std::to_string(k) : "") + " t"; }
        if (k > 1) { text += '^' + std::to_string(k); }
    }
    return text;
}

void write_polynomial(const std::vector<double>& polynomial, bool angle, Lines& lines) {
    if (polynomial.empty()) { return; }
    const AngleTexts typed = angle ? typed_angles(polynomial) : AngleTexts{"", polynomial};
    const std::string name = angle ? "polynomial_" + typed.unit : "polynomial";
    // a coordinate e0..e3 has no unit, and for a length the comment would not tell anything new
    const std::string comment = angle ? formula_of(typed.values, typed.unit) : std::string();
    lines.key(name, list_text(typed.values), comment);
}

std::string harmonic_text(const TimeFunction::Harmonic& harmonic, bool angle) {
    Inline keys;
    keys.add("amplitude", harmonic.amplitude, angle);
    const auto reads_back = [&](double hertz) { return omega_of_frequency(hertz) == harmonic.omega; };
    const auto hertz = typed_number(harmonic.omega / (2.0 * std::numbers::pi), kFrequencyDigits, reads_back);
    // the author probably typed the shorter of the two
    const bool in_hertz = hertz && number_text(*hertz).size() <= number_text(harmonic.omega).size();
    keys.add(in_hertz ? "frequency_hz" : "omega_rad_per_s", in_hertz ? *hertz : harmonic.omega);
    if (harmonic.phase != 0.0) { keys.add("phase", harmonic.phase, true); }
    return keys.text();
}

std::string step_text(const TimeFunction::SmoothStep& step, bool angle) {
    Inline keys;
    if (step.from != 0.0) { keys.add("from", step.from, angle); }
    keys.add("to", step.to, angle);
    if (step.start != 0.0) { keys.add("start_s", step.start); }
    return keys.add("end_s", step.end).text();
}

std::string table_text(const TimeTable& table, bool angle) {
    const AngleTexts typed = angle ? typed_angles(table.values) : AngleTexts{"", table.values};
    Inline keys;
    keys.add("times_s", list_text(table.times));
    keys.add(angle ? "values_" + typed.unit : "values", list_text(typed.values));
    if (table.interpolation != TimeTable::Interpolation::smooth) {
        keys.add("interpolation", string_text(word_of(kInterpolations, table.interpolation)));
    }
    return keys.text();
}

/// Writes one table alone, several as a list.
template <class Part>
void write_parts(
    const std::string& name, const std::vector<Part>& parts, std::string (*text_of)(const Part&, bool),
    bool angle, Lines& lines) {
    const auto text = [&](const Part& part) { return text_of(part, angle); };
    if (!parts.empty()) { lines.key(name, parts.size() == 1 ? text(parts[0]) : list_text(parts, text)); }
}

[[noreturn]] void refuse(const Driver& driver) {
    throw std::invalid_argument(
        "the driver '" + driver.name + "' is none of a lesson: measure " +
        std::to_string(driver.measure.index()) + " along joint " + std::to_string(driver.joint));
}

/// Writes the driven measure. @return true if it is an angle
bool write_place(const Written& written, const Driver& driver, Lines& lines) {
    const auto quantity = [&](const char* name) { lines.key("quantity", string_text(name)); };
    const auto along_joint = [&](const char* name) {
        if (driver.joint < 0) { refuse(driver); }
        lines.key("joint", string_text(written.name_of({Addition::Kind::joint, driver.joint})));
        quantity(name);
    };
    std::visit(
        Overloaded{
            [&](const AngleMeasure&) { along_joint("angle"); },
            [&](const ThetaMeasure&) { along_joint("angle"); },
            [&](const DisplacementMeasure&) { along_joint("displacement"); },
            [&](const SquaredDistanceMeasure& m) {
                quantity("distance");
                lines.key("bodies", written.pair(driver.body_i, driver.body_j));
                lines.key("point_i", m.P_i_local);
                lines.key("point_j", m.P_j_local);
            },
            [&](const CoordinateMeasure& m) {
                const auto k = static_cast<std::size_t>(m.coordinate);
                quantity("coordinate");
                lines.key("body", string_text(written.body(driver.body_j)));
                lines.key("coordinate", string_text(std::string(kCoordinates[k])));
            },
        },
        driver.measure);
    return unit_of(driver.measure) == Unit::radian;
}

}  // namespace

void write_time_function(const TimeFunction& function, bool angle, Lines& lines) {
    write_polynomial(function.polynomial, angle, lines);
    write_parts("harmonics", function.harmonics, harmonic_text, angle, lines);
    write_parts("step", function.steps, step_text, angle, lines);
    if (function.table) { lines.key("table", table_text(*function.table, angle)); }
    if (function.formula) {
        const TimeFormula& formula = *function.formula;
        const std::string unit = !angle ? "" : formula.unit == 1.0 ? "_rad" : "_deg";
        lines.key("formula" + unit, string_text(formula.formula.source));
    }
    // a function without parts
    if (function.polynomial.empty() && function.harmonics.empty() && function.steps.empty() &&
        !function.table && !function.formula) {
        lines.key("harmonics", "[]", "0 at all times");
    }
}

void write_drivers(const Written& written, Lines& lines) {
    const std::vector<Driver>& drivers = written.lesson->mechanism.drivers;
    bool any = false;
    for (std::size_t k = 0; k < drivers.size(); ++k) {
        if (!written.has({Addition::Kind::driver, static_cast<int>(k)})) { continue; }
        if (!any) { lines.section("drivers: what is prescribed, as a function of time t"); }
        any = true;
        lines.table("[[driver]]");
        lines.key("name", string_text(drivers[k].name));
        const bool angle = write_place(written, drivers[k], lines);
        write_time_function(drivers[k].function, angle, lines);
        const Text& text = written.lesson->step_texts.drivers[k];
        if (!text.own().empty()) { lines.text("text", text); }
    }
}

}  // namespace jw::writing
