#include <algorithm>

#include "core/quantity/names.hpp"
#include "lessons/enum_words.hpp"
#include "lessons/schema/keys.hpp"

/// Keys of claims, questions, trials and texts of steps; and the list of all tables.
namespace jw {

namespace {

constexpr int kMostCounted = 100000;

std::vector<std::string> words_of_roles() {
    std::vector<std::string> roles;
    for (const JointType& type : kJointTypes) {
        for (const Role role : type.roles) {
            const std::string word(word_of(role));
            if (std::ranges::find(roles, word) == roles.end()) { roles.push_back(word); }
        }
    }
    return roles;
}

/// The key as it is and in all units of angles, their rates and accelerations.
void add_in_all_units(
    std::vector<Key>& keys, const std::string& name, KeyKind kind, const std::string& about) {
    keys.push_back({name, kind, about + ", in SI units"});
    for (const char* per : {"", "_per_s", "_per_s2"}) { add_angle(keys, name, kind, about, per); }
}

void add_moment(std::vector<Key>& keys) {
    keys.push_back({"after", KeyKind::text, "when: this joint or driver has been added"});
    keys.push_back({"at_s", KeyKind::number, "when: a time of the motion [s]"});
    keys.push_back(word_key("of", "which motion 'at_s' is a time of", {"motion", "dynamics"}));
    keys.push_back({"as_given", KeyKind::flag, "when: the start pose, nothing assembled"});
    keys.push_back({"any_state", KeyKind::flag, "when: random states; for formulas"});
}

void add_facts(std::vector<Key>& keys) {
    for (const EnumWord<Count>& count : kCounts) {
        const int least = count.value == Count::mobility_by_counting ? -kMostCounted : 0;
        keys.push_back(
            counted_key(count.word, KeyKind::whole_number, "how many there are", least, kMostCounted));
    }
    for (const EnumWord<Bound>& bound : kBounds) {
        keys.push_back({bound.word, KeyKind::positive, "a bound of the residual or of the condition number"});
    }
    for (const EnumWord<Verdict>& verdict : kVerdicts) {
        keys.push_back({verdict.word, KeyKind::flag, "whether it is so"});
    }
    keys.push_back({"dropped", KeyKind::text, "the equation that a joint leaves out, as \"hinge p1 z\""});
}

KeyTable claim_keys() {
    KeyTable claim{"claim", {{"why", KeyKind::words, "reason, shown if it fails"}}};
    add_moment(claim.keys);
    add_facts(claim.keys);
    claim.keys.push_back({"quantity", KeyKind::text, "what is measured, as \"crank.x\""});
    claim.keys.push_back(
        counted_key("derivative", KeyKind::whole_number, "1 for its rate, 2 for its acceleration", 0, 2));
    claim.keys.push_back({"point", KeyKind::vector, "the point of \"crank.point.x\", local [m]"});
    add_in_all_units(claim.keys, "value", KeyKind::number, "value of the quantity");
    add_in_all_units(claim.keys, "tolerance", KeyKind::positive, "largest allowed deviation");
    claim.keys.push_back({"formula", KeyKind::formula, "equation that holds (docs/mathematics.md)"});
    claim.keys.push_back({"joint", KeyKind::text, "joint that the formula is about"});
    claim.keys.push_back(word_key("primitive", "primitive of the joint that it is about", words_of_roles()));
    claim.keys.push_back({"body", KeyKind::text, "body that the formula is about"});
    claim.keys.push_back(
        word_key("coordinates", "choice of coordinates of a formula of the system", words_of(kChoices)));
    claim.keys.push_back({"where", KeyKind::texts, "definitions of further symbols"});
    claim.keys.push_back({"holds", KeyKind::flag, "false: the formula is a misprint"});
    return claim;
}

KeyTable question_keys() {
    KeyTable question{
        "question",
        {required(
             {"at", KeyKind::text, "\"bodies\", \"motion\", a joint or a driver, before which it is asked"}),
         required({"ask", KeyKind::words, "the question"}),
         {"why", KeyKind::words, "shown with the answer"},
         word_key("count", "answer: how many there are once the step is done", words_of(kCounts)),
         {"dropped", KeyKind::text, "answer: which of x, y, z is left out of \"hinge p1\""},
         {"quantity", KeyKind::text, "answer: a quantity at a time of the motion"},
         {"at_s", KeyKind::number, "time of the quantity or pose [s]"},
         {"point", KeyKind::vector, "the point of \"crank.point.x\", local [m]"},
         counted_key("choices", KeyKind::list_of_words, "answer: one of these sentences", 2, 8),
         counted_key("answer", KeyKind::whole_number, "number of the right choice, from 1", 1, 8),
         word_key("click", "answer: a thing of this kind, clicked or named", words_of(kThings)),
         {"right", KeyKind::texts, "names of the things that are right, as [\"hinge s_i\"]"},
         word_key("rows", "instead: rows that are found once the step is done", words_of(kRowsFound)),
         {"pose", KeyKind::text, "answer: the pose of this body, led there by hand"}}};
    add_in_all_units(question.keys, "tolerance", KeyKind::positive, "largest deviation that counts as right");
    return question;
}

}  // namespace

void add_claim_tables(std::vector<KeyTable>& tables) {
    tables.push_back(
        {"step",
         {{"at", KeyKind::text, "\"bodies\", \"motion\", a joint or a driver"},
          {"at_s", KeyKind::number, "instead: a time from which it is shown [s]"},
          required({"text", KeyKind::words, "the words to show"})}});
    tables.push_back(question_keys());
    tables.push_back(
        {"trial",
         {required({"text", KeyKind::words, "what to try, and what to look at"}),
          required(counted_key("do", KeyKind::texts, "experiments, as after --try", 1, 20)),
          {"breaks", KeyKind::flag, "the scene does not survive it, on purpose"}}});
    tables.push_back(claim_keys());
}

std::vector<KeyTable> key_tables() {
    std::vector<KeyTable> tables;
    add_scene_tables(tables);
    add_motion_tables(tables);
    add_claim_tables(tables);
    return tables;
}

}  // namespace jw
