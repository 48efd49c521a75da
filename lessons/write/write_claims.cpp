#include <algorithm>
#include <array>

#include "core/numerics/variants.hpp"
#include "core/quantity/names.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writing.hpp"

namespace jw::writing {

namespace {

/// Place of a fact's key among those of an [[expect]]: the reader takes them in this order.
int place_of(const Fact& fact) {
    struct Place {
        int operator()(const CountClaim& c) const { return static_cast<int>(c.count); }
        int operator()(const BoundClaim& c) const { return 10 + static_cast<int>(c.bound); }
        int operator()(const VerdictClaim& c) const { return 20 + static_cast<int>(c.verdict); }
        int operator()(const DroppedClaim& /*c*/) const { return 30; }
        int operator()(const QuantityClaim& /*c*/) const { return 40; }
        int operator()(const FormulaClaim& /*c*/) const { return 50; }
    };
    return std::visit(Place{}, fact);
}

/// True if the thing that the claim is about is in the file.
bool has_meaning(const Claim& claim, const Written& written) {
    const auto* after = std::get_if<AfterAddition>(&claim.when);
    if (after != nullptr && after->count > static_cast<int>(written.order.size())) { return false; }
    if (after != nullptr && after->count == 0 && !written.order.empty()) { return false; }
    const Addition subject = subject_of(claim.fact);
    return subject.index < 0 || written.has(subject);
}

void write_moment(const Moment& when, const Written& written, Lines& lines) {
    std::visit(
        Overloaded{
            [&](const AsGiven&) { lines.key("as_given", "true"); },
            [&](const AnyState&) { lines.key("any_state", "true"); },
            [&](const AtRest&) { lines.key("at_rest", "true"); },
            [&](const AtTime& at) {
                lines.key("at_s", at.t);
                // without [motion], only dynamics can be meant
                if (at.by_forces && written.lesson->motion) { lines.key("of", string_text("dynamics")); }
            },
            [&](const AfterAddition& after) {
                if (after.count == 0) { return; }
                const auto last = static_cast<std::size_t>(after.count - 1);
                lines.key("after", string_text(written.name_of(written.order[last])));
            },
        },
        when);
}

struct FactWriter {
    const Written& written;
    Lines& lines;

    void operator()(const CountClaim& c) const {
        lines.key(word_of(kCounts, c.count), std::to_string(c.value));
    }
    void operator()(const BoundClaim& c) const { lines.key(word_of(kBounds, c.bound), c.limit); }
    void operator()(const VerdictClaim& c) const {
        lines.key(word_of(kVerdicts, c.verdict), c.value ? "true" : "false");
    }
    void operator()(const DroppedClaim& c) const {
        const std::string joint = written.name_of({Addition::Kind::joint, c.joint});
        const std::string component(kCoordinates[jw::at(c.component)]);
        lines.key("dropped", string_text(joint + ' ' + std::string(word_of(c.role)) + ' ' + component));
    }
    void operator()(const QuantityClaim& c) const {
        lines.key("quantity", string_text(c.text));
        const int derivative = c.derivative - c.named_derivative;
        if (derivative != 0) { lines.key("derivative", std::to_string(derivative)); }
        write_point(c.quantity, c.text, lines);
        write_values(
            c.quantity, c.derivative, c.in_degrees, {{"value", c.value}, {"tolerance", c.tolerance}}, lines);
    }
    void operator()(const FormulaClaim& c) const {
        const formula::Subject& subject = c.formula.subject;
        if (subject.joint >= 0) {
            lines.key("joint", string_text(written.name_of({Addition::Kind::joint, subject.joint})));
        }
        if (subject.body >= 0) { lines.key("body", string_text(written.body(subject.body))); }
        if (subject.role) { lines.key("primitive", string_text(std::string(word_of(*subject.role)))); }
        if (subject.coordinates != formula::Subject{}.coordinates) {
            lines.key("coordinates", string_text(word_of(kChoices, subject.coordinates)));
        }
        lines.key("formula", string_text(c.formula.source));
        if (!c.formula.where.empty()) { lines.key("where", list_text(c.formula.where, string_text)); }
        if (!c.holds) { lines.key("holds", "false"); }
    }
};

/// One [[expect]] for facts of one moment.
void write_block(std::vector<const Claim*> block, const Written& written, Lines& lines) {
    lines.table("[[expect]]");
    write_moment(block.front()->when, written, lines);
    // the numbers of equations and unknowns stand before the rank
    const auto is_rank = [](const Claim* claim) {
        const auto* count = std::get_if<CountClaim>(&claim->fact);
        return count != nullptr && count->count == Count::rank;
    };
    if (is_rank(block.front())) {
        const auto sizes = std::ranges::find_if_not(block.begin() + 1, block.end(), [](const Claim* claim) {
            const auto* count = std::get_if<CountClaim>(&claim->fact);
            return count != nullptr && (count->count == Count::rows || count->count == Count::columns);
        });
        std::rotate(block.begin(), block.begin() + 1, sizes);
    }
    for (const Claim* claim : block) { std::visit(FactWriter{written, lines}, claim->fact); }
    const Text& why = block.front()->why;
    if (!why.own().empty()) { lines.text("why", why); }
}

}  // namespace

void write_point(const Quantity& quantity, const std::string& name, Lines& lines) {
    Quantity copy = quantity;
    // a name that contains the point does not need the key
    const Vec3* const point = reading::point_of(copy);
    if (point != nullptr && name.find('[') == std::string::npos) { lines.key("point", *point, "m"); }
}

void write_values(
    const Quantity& quantity, int derivative, bool in_degrees, const std::vector<NamedValue>& values,
    Lines& lines) {
    const std::vector<std::string> endings = reading::unit_endings(quantity, derivative);
    std::vector<double> numbers;
    for (const NamedValue& value : values) { numbers.push_back(value.second); }
    const bool degrees = in_degrees && endings.size() > 1;
    const AngleTexts typed = degrees ? typed_angles(numbers) : AngleTexts{"rad", numbers};
    const std::string& ending = typed.unit == "deg" ? endings.front() : endings.back();
    for (std::size_t k = 0; k < values.size(); ++k) { lines.key(values[k].first + ending, typed.values[k]); }
}

void write_claims(const Written& written, Lines& lines) {
    std::vector<std::vector<const Claim*>> blocks;
    for (const Claim& claim : written.lesson->claims) {
        if (!has_meaning(claim, written)) { continue; }
        const Claim* before = blocks.empty() ? nullptr : blocks.back().back();
        // the reader must take the facts in this order
        const bool same_block = before != nullptr && before->when == claim.when &&
                                same_in_all_languages(before->why, claim.why) &&
                                place_of(before->fact) < place_of(claim.fact);
        if (!same_block) { blocks.emplace_back(); }
        blocks.back().push_back(&claim);
    }
    if (!blocks.empty()) { lines.section("claims: proved by `jointwise check`"); }
    for (auto& block : blocks) { write_block(std::move(block), written, lines); }
}

}  // namespace jw::writing
