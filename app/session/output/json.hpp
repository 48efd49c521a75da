#pragma once

#include <nlohmann/json.hpp>

#include "app/session/view/dynamics_view.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/view/view.hpp"

/// JSON of everything that the program can report; docs/command-line.md describes the layout. Numbers have
/// full double precision; what is not finite is null.
namespace jw {

/// JSON that keeps the order in which keys were written.
using Json = nlohmann::ordered_json;

/// Version of the layout: a new key keeps it, a removed or changed key needs a new version.
inline constexpr int kJsonVersion = 1;

/// `json` as a document that ends with a line feed. Bytes that are not UTF-8 become U+FFFD; control
/// characters up to U+009F are escaped, so that a terminal only shows the text.
/// @param indent  -1: all in one line
std::string json_document(const Json& json, int indent = 1);

Json json_of(const Inspection& inspection, const Lesson& lesson);
Json json_of(const Story& story, int until);
/// @param judgements one per free motion, or empty
Json json_of(const RankReport& report, const System& system, const FreedomJudgements& judgements);
/// Object with `verdict`, `motion_beside` and `departure`.
Json json_of(const FreedomJudgement& judgement, const Mechanism& mechanism);
/// Equations of motion; null where there are none.
Json json_of(const std::optional<DynamicsView>& dynamics);
struct RestView;
Json json_of(const RestView& view, const Lesson& lesson);

// tables over time, as `solve` and `simulate` write them
struct Sweep;
enum class Analysis;
Json json_of(const Sweep& sweep, Analysis analysis, const Lesson& lesson);

struct DynamicsTable;
Json json_of(const DynamicsTable& table, const Lesson& lesson);

struct ProofRecord;
/// The proof of a motion: docs/proofs.md describes it, docs/proofs/check_proof.py checks it.
/// @param system  whose motion was recorded
Json json_of(const ProofRecord& proof, const System& system, const Lesson& lesson);
/// Object with `value` and the `bound` that rounding puts on it.
Json json_of(const EquationResidual& residual);
/// Bodies with positions and velocities, in the order of the lesson.
Json json_of(const Mechanism& mechanism, const State& state, const Motion& velocity);

/// A number; null if it is not finite.
Json number(double value);
/// A text; null if it is empty.
Json text_or_null(const std::string& text);
/// Array of what `item_json` makes of each item.
template <class Items, class ItemJson>
Json list_of(const Items& items, ItemJson&& item_json) {
    Json list = Json::array();
    for (const auto& item : items) { list.push_back(item_json(item)); }
    return list;
}

/// Name of a kind in the JSON of steps: "bodies", "equations", ...
const char* kind_name(Step::Kind kind);

Json json_of(const Vec3& v);
Json json_of(const VectorX& v);
Json json_of(const MatrixX& m);

}  // namespace jw
