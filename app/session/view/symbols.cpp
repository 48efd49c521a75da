#include "app/session/view/symbols.hpp"

#include <algorithm>
#include <array>

#include "app/session/view/quantities.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "core/quantity/names.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

/// More bodies or joints than this are not listed.
constexpr std::size_t kMostMeanings = 4;
/// Letter of a vector that is fixed in a body; not the joint type of the same name.
constexpr std::string_view kArm = "s";

/// Definition of a symbol in the book, the same for every body and joint.
struct SymbolFact {
    const char* letter;
    const char* marks;    ///< as in formula::Symbol; nullptr: any
    const char* meaning;  ///< to be translated
    const char* unit;     ///< without dots; "" if it has none
    const char* slide;    ///< where it is defined
};

constexpr std::array kFacts{
    SymbolFact{"r", "", tr_later("origin of the body"), "m", "slide 12"},
    SymbolFact{"r", nullptr, tr_later("attachment point of the joint"), "m", "slide 6"},
    SymbolFact{"p", "", tr_later("Euler parameters of the body"), "", "slide 12"},
    SymbolFact{"e", "", tr_later("Euler parameters of the body"), "", "slide 12"},
    SymbolFact{"A", "", tr_later("rotation matrix of the body"), "", "slide 12"},
    SymbolFact{"G", "", tr_later("matrix of the Euler parameters"), "", "slide 13"},
    SymbolFact{"L", "", tr_later("matrix of the Euler parameters"), "", "slide 13"},
    SymbolFact{"ω", "", tr_later("angular velocity of the body"), "rad/s", "slide 13"},
    SymbolFact{"s", "", tr_later("axis vector of the joint"), "", "slide 2"},
    SymbolFact{"s", nullptr, tr_later("from the origin of the body to the attachment point"), "m", "slide 6"},
    SymbolFact{"h", "", tr_later("side vector of the joint"), "", "slide 10"},
    SymbolFact{"u", "", tr_later("zero of the angle of the joint"), "", "slide 11"},
    SymbolFact{"d", "", tr_later("vector between the attachment points"), "m", "slide 2"},
    SymbolFact{"α", "", tr_later("advance of the screw per radian"), "m/rad", "slide 11"},
    SymbolFact{"θ", "", tr_later("angle of the joint"), "rad", "slide 11"},
    SymbolFact{"m", "", tr_later("mass of the body"), "kg", "slide 24"},
    SymbolFact{"J", "", tr_later("inertia of the body"), "kg m²", "slide 24"},
    SymbolFact{"f", "", tr_later("force on the body"), "N", "slide 24"},
    SymbolFact{"n", "", tr_later("torque on the body"), "N m", "slide 24"},
    SymbolFact{"Φ", nullptr, tr_later("left sides of the constraint equations"), "", "slide 2"},
    SymbolFact{"γ", nullptr, tr_later("right sides of the acceleration equations"), "", "slide 19"},
    SymbolFact{"q", "", tr_later("coordinates of the moving bodies"), "", "slide 18"},
    SymbolFact{"t", "", tr_later("time"), "s", ""},
    SymbolFact{"λ", "", tr_later("Lagrange multipliers"), "", "slide 24"},
    SymbolFact{"M", "", tr_later("mass matrix"), "", "slide 24"},
    SymbolFact{"Q", "", tr_later("applied forces"), "", "slide 24"},
};

/// @return nullptr for symbols that the book does not define
const SymbolFact* fact_of(const formula::Symbol& symbol) {
    for (const SymbolFact& fact : kFacts) {
        if (symbol.letter == fact.letter && (fact.marks == nullptr || symbol.marks == fact.marks)) {
            return &fact;
        }
    }
    return nullptr;
}

/// Unit of a symbol with dots: "m/s²" of "m" with two; empty for a symbol without unit and without dots.
std::string unit_of_rate(const std::string& unit, int dots) {
    if (dots == 0) { return unit; }
    if (unit.ends_with("/s")) { return unit + (dots == 1 ? "²" : "³"); }
    const std::string per = dots == 1 ? "s" : "s²";
    return (unit.empty() ? "1" : unit) + "/" + per;
}

/// Letters of an index, words included: "crank".
std::string written_index(const math::Row& below) {
    std::string text;
    for (const math::Node& node : below) {
        if (const auto* const sign = std::get_if<math::Sign>(&node.nucleus)) {
            text += sign->utf8 == "−" ? "-" : sign->utf8;
        } else if (const auto* const words = std::get_if<math::Words>(&node.nucleus)) {
            text += words->utf8;
        }
    }
    return text;
}

bool belongs_to(const formula::Symbol& symbol, std::string_view letters) {
    return !symbol.letter.empty() && letters.find(symbol.letter) != std::string_view::npos;
}

math::Node with_index(math::Node node, const char* index) {
    math::Node sign;
    sign.nucleus = math::Sign{index, math::SignKind::letter, math::Alphabet::italic};
    node.below.push_back(sign);
    return node;
}

/// Finds what a symbol stands for at one step.
///
/// Its owner: a body that its index names; else the joint of the step, once for each of its primitives where
/// they differ; else the moving body of that joint; else the whole system. Without a joint, all moving bodies
/// and all present joints are possible owners.
class Finder {
public:
    Finder(const Step& step, CoordinateChoice coordinates, const formula::TextSymbol& symbol)
        : system_(step.system.get()),
          mechanism_(&step.system->mechanism()),
          instant_(instant_of(step)),
          coordinates_(coordinates),
          symbol_(&symbol) {}

    std::vector<SymbolMeaning> found(const SymbolSubject& subject) {
        if (of_time() || of_named_body()) { return meanings_; }
        const bool given = !subject.joints.empty();
        const std::vector<int> joints = given ? subject.joints : present_joints();
        // without an index of the joint's bodies, "r" of a text is not that of a joint
        for (const int joint : joints) { of_joint(joint); }
        if (meanings_.empty()) {
            for (const int body : given ? bodies_of(joints) : bodies_without_joint(subject)) {
                of_body(body, symbol_->node);
            }
        }
        const bool is_matrix = symbol_->name.letter == "Φ" && !symbol_->name.index.empty();
        if (meanings_.empty() || is_matrix || !given) { of_system(); }
        return meanings_;
    }

    /// Meanings within the formula of a joint's primitive, where Φ is that of the primitive.
    std::vector<SymbolMeaning> found(int joint, Role role) {
        of_primitive(joint, role);
        return meanings_;
    }

private:
    const Joint& joint_of(int joint) const { return mechanism_->joints[at(joint)]; }

    std::optional<MatrixX> value_of(const formula::Subject& subject, const math::Node& node) const {
        formula::Subject of = subject;
        of.coordinates = coordinates_;
        try {
            const formula::Value value =
                formula::evaluate_expression({node}, formula::meanings_of(of, instant_));
            if (value.kind == formula::Value::Kind::matrix && value.d[0].size() > 0 &&
                value.d[0].allFinite()) {
                return value.d[0];
            }
        } catch (const formula::NotEvaluated&) {
            // the symbol stands for nothing there
        }
        return std::nullopt;
    }

    bool add(
        const formula::Subject& subject, const math::Node& node, const std::string& owner,
        const std::string& frame, const SymbolPart& part) {
        const std::optional<MatrixX> value = value_of(subject, node);
        // a bold letter is not a number: L of a body is not the length of a joint
        const bool is_number = value && value->size() == 1;
        const bool one_row = belongs_to(symbol_->name, "Φγλ");
        if (!value || (is_number && symbol_->bold && !one_row)) { return false; }
        meanings_.push_back({owner, math::write_latex({node}), *value, frame, part});
        return true;
    }

    bool of_time() {
        if (symbol_->name != formula::Symbol{"t", 0, {}, {}} || symbol_->bold || symbol_->dots > 0) {
            return false;
        }
        SymbolPart part;
        part.kind = SymbolPart::Kind::none;
        meanings_.push_back({{}, symbol_->source, MatrixX::Constant(1, 1, instant_.t), {}, part});
        return true;
    }

    /// Adds the body that the index names, if it does: "p_{crank}", "e_{1, crank}".
    bool of_named_body() {
        const std::string index = written_index(symbol_->node.below);
        for (std::size_t b = 0; b < mechanism_->bodies.size(); ++b) {
            const std::string& name = mechanism_->bodies[b].name;
            if (!index.ends_with(name)) { continue; }
            math::Node node = symbol_->node;
            node.below.clear();
            std::string rest = index.substr(0, index.size() - name.size());
            while (rest.ends_with(",") || rest.ends_with(" ")) { rest.pop_back(); }
            if (!rest.empty()) { node = with_index(node, rest.c_str()); }
            if (of_body(static_cast<int>(b), node)) { return true; }
        }
        return false;
    }

    std::string frame_in(int body, int primes) const {
        if (!belongs_to(symbol_->name, "rsdhuωJfn")) { return {}; }
        return primes > 0 ? tr("in the frame of body {0}", mechanism_->bodies[at(body)].name)
                          : std::string(tr("in the global frame"));
    }

    bool of_body(int body, const math::Node& node) {
        formula::Subject subject;
        subject.body = body;
        SymbolPart part;
        part.body = body;
        return add(
            subject, node, mechanism_->bodies[at(body)].name, frame_in(body, symbol_->name.primes), part);
    }

    void of_joint(int joint) {
        if (belongs_to(symbol_->name, "Φγ")) {
            for (const Constraint& c : system_->constraints()) {
                if (c.joint == joint) { of_primitive(joint, c.role); }
            }
            return;
        }
        if (vector_of_joint(joint, symbol_->node)) { return; }
        // s without an index may belong to either body
        if (symbol_->name.index.empty() && belongs_to(symbol_->name, "shu")) {
            vector_of_joint(joint, with_index(symbol_->node, "i"));
            vector_of_joint(joint, with_index(symbol_->node, "j"));
        }
    }

    void of_primitive(int joint, Role role) {
        if (!belongs_to(symbol_->name, "Φγ")) {
            vector_of_joint(joint, symbol_->node);
            return;
        }
        formula::Subject subject;
        subject.joint = joint;
        subject.role = role;
        const std::string name = name_of_role(role, joint_of(joint).parallel_form);
        const bool alone = joint_of(joint).type->roles.size() == 1;
        SymbolPart part{SymbolPart::Kind::rows, joint, -1, 0, role};
        add(subject, symbol_->node, joint_of(joint).name + (alone ? "" : " · " + name), {}, part);
    }

    bool vector_of_joint(int joint, const math::Node& node) {
        const Joint& j = joint_of(joint);
        const std::string index = written_index(node.below);
        const bool of_j = index.ends_with("j");
        SymbolPart part;
        part.joint = joint;
        part.body = of_j ? j.body_j : j.body_i;
        part.vector = symbol_->name.letter == "d" ? 2 : (of_j ? 1 : 0);
        if (belongs_to(symbol_->name, "shud")) {
            if (!is_used(*j.type)) { return false; }
            part.kind = SymbolPart::Kind::vector;
        } else if (!of_j && !index.ends_with("i") && !is_used(*j.type)) {
            return false;
        }
        const bool of_body = part.kind == SymbolPart::Kind::body && (of_j || index.ends_with("i"));
        const std::string& owner = of_body ? mechanism_->bodies[at(part.body)].name : j.name;
        formula::Subject subject;
        subject.joint = joint;
        return add(subject, node, owner, frame_in(part.body, symbol_->name.primes), part);
    }

    /// False for vectors and numbers that the joint's type does not use: they stand for nothing.
    bool is_used(const JointType& type) const {
        const formula::Symbol& name = symbol_->name;
        if (name.letter == kArm && name.marks.empty()) {
            return type.uses(Vectors(kAxisI)) || type.uses(Vectors(kAxisJ));
        }
        if (name.letter == kArm || name.letter == "d") { return type.uses(kPoints) || type.uses(kD); }
        if (name.letter == "h") { return type.uses(kSidesH); }
        if (name.letter == "u") { return type.has_angle() || type.uses(kSidesU); }
        if (name.letter == "L") { return type.has_distance(); }
        if (name.letter == "α") { return type.artificial > 0; }
        return name.letter == "θ" || name.letter == "q";
    }

    std::vector<int> present_joints() const {
        std::vector<int> joints;
        for (const Constraint& c : system_->constraints()) {
            if (std::ranges::find(joints, c.joint) == joints.end()) { joints.push_back(c.joint); }
        }
        return joints;
    }

    std::vector<int> bodies_of(const std::vector<int>& joints) const {
        std::vector<int> bodies;
        for (const int joint : joints) {
            for (const int body : {joint_of(joint).body_j, joint_of(joint).body_i}) {
                const bool known = std::ranges::find(bodies, body) != bodies.end();
                if (!mechanism_->bodies[at(body)].fixed && !known) { bodies.push_back(body); }
            }
        }
        return bodies;
    }

    std::vector<int> bodies_without_joint(const SymbolSubject& subject) const {
        return subject.body >= 0 ? std::vector<int>{subject.body} : system_->moving_bodies();
    }

    void of_system() {
        // in the choices of ω there is no q, only its rates
        if (symbol_->name.letter == "q" && symbol_->dots == 0) { return; }
        SymbolPart part;
        part.kind = SymbolPart::Kind::rows;
        add({}, symbol_->node, {}, {}, part);
    }

    const System* system_;
    const Mechanism* mechanism_;
    Instant instant_;
    CoordinateChoice coordinates_;
    const formula::TextSymbol* symbol_;
    std::vector<SymbolMeaning> meanings_;
};

std::string unit_in_words(const Step& step, const formula::Symbol& symbol, const SymbolMeaning& meaning) {
    if (symbol.letter != "Φ" || !meaning.part.role || !symbol.index.empty()) { return {}; }
    for (const Constraint& c : step.system->constraints()) {
        if (c.joint != meaning.part.joint || c.role != *meaning.part.role) { continue; }
        const std::string unit = equation_text(*step.system, c).unit;
        return unit == "-" ? "" : unit;
    }
    return {};
}

std::optional<SymbolView> viewed(
    const Step& step, const formula::TextSymbol& symbol, std::vector<SymbolMeaning> meanings) {
    if (meanings.empty()) { return std::nullopt; }
    SymbolView view;
    view.source = symbol.source;
    if (const SymbolFact* const fact = fact_of(symbol.name)) {
        view.what = tr(fact->meaning);
        view.unit = unit_of_rate(fact->unit, symbol.dots);
        view.defined = fact->slide;
    }
    if (meanings.size() == 1 && symbol.name.letter == "Φ") {
        view.unit = unit_in_words(step, symbol.name, meanings[0]);
    }
    view.more = static_cast<int>(meanings.size()) - static_cast<int>(kMostMeanings);
    view.more = std::max(0, view.more);
    if (view.more > 0) { meanings.resize(kMostMeanings); }
    view.meanings = std::move(meanings);
    return view;
}

void add_symbols(
    std::vector<SymbolView>& list, const std::string& scope, const math::Row& row,
    const std::function<std::optional<SymbolView>(const formula::TextSymbol&)>& view_of_symbol) {
    formula::for_each_symbol(row, [&](const formula::TextSymbol& symbol) {
        if (index_of_symbol(list, scope, symbol.source) >= 0) { return; }
        if (std::optional<SymbolView> view = view_of_symbol(symbol)) {
            view->scope = scope;
            list.push_back(std::move(*view));
        }
    });
}

}  // namespace

std::string scope_of(const EquationGroup& group) {
    return group.role ? std::to_string(group.joint) + " " + std::string(word_of(*group.role)) : std::string();
}

std::vector<SymbolView> symbols_of(
    const Step& step, CoordinateChoice coordinates, const SymbolSubject& subject,
    const std::vector<std::string>& texts, const std::vector<EquationGroup>& equations) {
    std::vector<SymbolView> list;
    for (const std::string& text : texts) {
        for (const math::TextPart& part : math::text_parts(text).parts) {
            add_symbols(list, {}, part.row, [&](const formula::TextSymbol& symbol) {
                return viewed(step, symbol, Finder(step, coordinates, symbol).found(subject));
            });
        }
    }
    for (const EquationGroup& group : equations) {
        if (!group.role) { continue; }
        add_symbols(
            list, scope_of(group), math::read_math(group.formula).row,
            [&](const formula::TextSymbol& symbol) {
                return viewed(
                    step, symbol,
                    Finder(step, CoordinateChoice::omega_local, symbol).found(group.joint, *group.role));
            });
    }
    return list;
}

int index_of_symbol(const std::vector<SymbolView>& symbols, std::string_view scope, std::string_view source) {
    const auto found = std::ranges::find_if(
        symbols, [&](const SymbolView& s) { return s.scope == scope && s.source == source; });
    return found == symbols.end() ? -1 : static_cast<int>(found - symbols.begin());
}

}  // namespace jw
