#include "lessons/read/reading.hpp"

#include <algorithm>

namespace jw::reading {

namespace {

/// "x, e0, omega.x, |r|": what can follow a name; of three components, only the first.
std::string words_behind(
    const std::string& owner, const std::vector<NamedQuantity>& list, const Mechanism& m) {
    std::vector<std::string> words;
    for (const NamedQuantity& named : list) {
        if (named.derivative > 0) { continue; }
        std::string word = name_of(named.quantity, 0, m);
        const bool is_further = word.ends_with(".y") || word.ends_with(".z") || word.ends_with(".b") ||
                                word.ends_with(".e1") || word.ends_with(".e2") || word.ends_with(".e3");
        if (is_further) { continue; }
        words.push_back(word.erase(word.find(owner), owner.size() + 1));
    }
    return comma_list(words);
}

void refuse(Fields& fields, const Located<std::string>& text, const Named& named, const Mechanism& m) {
    const std::string owner(owner_in(text.value));
    std::string of = word_for(named.kind) + (" " + in_quotes(owner));
    std::string possible;
    switch (named.kind) {
        case Named::Kind::body:
            possible = words_behind(owner, quantities_of_body(named.index), m) +
                       ", point.x (with the key 'point'), point.speed";
            break;
        case Named::Kind::joint: {
            const Joint& joint = m.joints[jw::at(named.index)];
            of += " of type " + std::string(joint.type->name);
            possible = words_behind(owner, quantities_of_joint(m, named.index), m);
            break;
        }
        case Named::Kind::driver: possible = words_behind(owner, quantities_of_driver(m, named.index), m);
    }
    fields.report(
        Code::unknown_quantity, text.span,
        in_quotes(text.value) + " is not a quantity of " + of + "; expected one of " + possible);
}

/// Finds the owner in a quantity's name; reports it if there is none.
const Named* owner_of(Fields& fields, const Located<std::string>& text, const Reading& reading) {
    const std::string owner(owner_in(text.value));
    const auto found = reading.names.find(owner);
    const bool has_word = text.value.find('.') != std::string::npos;
    if (has_word && found != reading.names.end()) { return &found->second; }
    std::vector<std::string> names;
    for (const auto& [name, named] : reading.names) { names.push_back(name); }
    names.emplace_back("energy");
    fields.report(
        Code::unknown_quantity, text.span,
        in_quotes(text.value) + " is not a quantity; expected NAME.WHAT with NAME one of " +
            comma_list(names),
        has_word ? did_you_mean(owner, names) : "for example " + owner + ".x");
    return nullptr;
}

}  // namespace

std::vector<std::string> unit_endings(const Quantity& quantity, int derivative) {
    const UnitRate dimension = dimension_of(quantity);
    if (dimension.unit != Unit::radian) { return {""}; }
    const int order = derivative + dimension.per_s;
    const std::string per = order == 0 ? "" : order == 1 ? "_per_s" : "_per_s2";
    return {"_deg" + per, "_rad" + per};
}

Vec3* point_of(Quantity& quantity) {
    if (auto* point = std::get_if<PointQuantity>(&quantity)) { return &point->s_local; }
    auto* speed = std::get_if<PointSpeedQuantity>(&quantity);
    return speed != nullptr ? &speed->s_local : nullptr;
}

std::optional<NamedQuantity> read_quantity(
    Fields& fields, const Located<std::string>& text, const Reading& reading) {
    const Mechanism& mechanism = reading.lesson.mechanism;
    const bool of_everything = text.value.starts_with("energy.") || text.value.starts_with("jacobian.");
    const bool is_named = reading.names.contains(owner_in(text.value));
    const Named* named = of_everything && !is_named ? nullptr : owner_of(fields, text, reading);
    if (named == nullptr && !of_everything) { return std::nullopt; }
    if (named != nullptr && !named->sound) { return std::nullopt; }
    const std::optional<ReadName> read = read_name(text.value, mechanism);
    if (!read && named != nullptr) {
        refuse(fields, text, *named, mechanism);
        return std::nullopt;
    }
    if (!read) {
        fields.report(
            Code::unknown_quantity, text.span,
            in_quotes(text.value) +
                " is not a quantity; expected energy.kinetic, energy.potential, "
                "energy.sum or jacobian.smallest_singular_value");
        return std::nullopt;
    }
    if (!read->name_of_today.empty()) {
        fields.problems().warn(
            Code::old_name, text.span,
            in_quotes(text.value) + " is now called " + in_quotes(read->name_of_today),
            "the next version will not accept the old name");
    }
    NamedQuantity out = read->named;
    if (read->wants_point) {
        const auto point = fields.vector("point");
        fields.require("point", "the point in the body's frame, three numbers in m");
        Vec3* const into = point_of(out.quantity);
        if (into != nullptr && point) { *into = point->value; }
    }
    if (needs_masses(out.quantity) && !reading.lesson.dynamics) {
        fields.report(
            Code::needs_dynamics, text.span,
            in_quotes(text.value) + " needs masses and forces; expected a table [dynamics]");
    }
    return out;
}

}  // namespace jw::reading
