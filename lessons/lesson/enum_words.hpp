#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/jets/coordinates.hpp"
#include "core/model/joint_types.hpp"
#include "core/motion/loads.hpp"
#include "lessons/lesson/claims.hpp"
#include "lessons/lesson/questions.hpp"
#include "lessons/text/text.hpp"

/// Words of enumerators: one table for each enum, looked up both ways.
namespace jw {

template <class E>
struct EnumWord {
    E value;
    const char* word;        ///< in lessons, on the command line and in JSON
    const char* label = "";  ///< in the window
};

/// @throws std::invalid_argument for a value that the table lacks
template <class E, std::size_t N>
constexpr const EnumWord<E>& entry_of(const std::array<EnumWord<E>, N>& table, E value) {
    for (const EnumWord<E>& entry : table) {
        if (entry.value == value) { return entry; }
    }
    throw std::invalid_argument("an enumerator without a word");
}

template <class E, std::size_t N>
constexpr const char* word_of(const std::array<EnumWord<E>, N>& table, E value) {
    return entry_of(table, value).word;
}

template <class E, std::size_t N>
constexpr const char* label_of(const std::array<EnumWord<E>, N>& table, E value) {
    return entry_of(table, value).label;
}

template <class E, std::size_t N>
constexpr std::optional<E> value_of(const std::array<EnumWord<E>, N>& table, std::string_view word) {
    for (const EnumWord<E>& entry : table) {
        if (entry.word == word) { return entry.value; }
    }
    return std::nullopt;
}

/// Words of a table, in its order.
template <class E, std::size_t N>
std::vector<std::string> words_of(const std::array<EnumWord<E>, N>& table) {
    std::vector<std::string> words;
    for (const EnumWord<E>& entry : table) { words.emplace_back(entry.word); }
    return words;
}

inline constexpr std::array kChoices{
    EnumWord<CoordinateChoice>{CoordinateChoice::true_euler_parameters, "rp", tr_later("(r, p), true")},
    EnumWord<CoordinateChoice>{
        CoordinateChoice::modified_euler_parameters, "rp-modified", tr_later("(r, p), modified")},
    EnumWord<CoordinateChoice>{CoordinateChoice::omega_local, "omega-local", tr_later("(r, ω′), local")},
    EnumWord<CoordinateChoice>{CoordinateChoice::omega_global, "omega-global", tr_later("(r, ω), global")}};

inline constexpr std::array kParallelForms{
    EnumWord<ParallelForm>{ParallelForm::rule, "rule", tr_later("the rule chooses")},
    EnumWord<ParallelForm>{ParallelForm::drop_x, "drop x", tr_later("without x")},
    EnumWord<ParallelForm>{ParallelForm::drop_y, "drop y", tr_later("without y")},
    EnumWord<ParallelForm>{ParallelForm::drop_z, "drop z", tr_later("without z")},
    EnumWord<ParallelForm>{ParallelForm::all_three, "all three", tr_later("all three")},
    EnumWord<ParallelForm>{ParallelForm::pair, "pair", tr_later("pair of n1 (n2)")}};

inline constexpr std::array kAngleRows{
    EnumWord<ScrewAngleForm>{ScrewAngleForm::rotation, "rotation", tr_later("rotation row")},
    EnumWord<ScrewAngleForm>{ScrewAngleForm::cosine, "cosine", tr_later("cos row")},
    EnumWord<ScrewAngleForm>{ScrewAngleForm::sine, "sine", tr_later("sin row")}};

inline constexpr std::array kFrames{
    EnumWord<Frame>{Frame::global, "global"}, EnumWord<Frame>{Frame::local, "local"}};

inline constexpr std::array kInterpolations{
    EnumWord<TimeTable::Interpolation>{TimeTable::Interpolation::smooth, "smooth"},
    EnumWord<TimeTable::Interpolation>{TimeTable::Interpolation::monotone, "monotone"}};

// keys of [[expect]]
inline constexpr std::array kCounts{
    EnumWord<Count>{Count::rank, "rank"},
    EnumWord<Count>{Count::rows, "rows"},
    EnumWord<Count>{Count::columns, "columns"},
    EnumWord<Count>{Count::dof, "dof"},
    EnumWord<Count>{Count::redundant, "redundant"},
    EnumWord<Count>{Count::mobility_by_counting, "mobility_by_counting"}};
inline constexpr std::array kThings{
    EnumWord<Thing::Kind>{Thing::Kind::body, "body"}, EnumWord<Thing::Kind>{Thing::Kind::joint, "joint"},
    EnumWord<Thing::Kind>{Thing::Kind::vector, "vector"}, EnumWord<Thing::Kind>{Thing::Kind::row, "row"}};
inline constexpr std::array kRowsFound{
    EnumWord<RowsFound>{RowsFound::dropped, "dropped"},
    EnumWord<RowsFound>{RowsFound::redundant, "redundant"}};
inline constexpr std::array kBounds{
    EnumWord<Bound>{Bound::residual_below, "residual_below"},
    EnumWord<Bound>{Bound::condition_below, "condition_below"},
    EnumWord<Bound>{Bound::condition_above, "condition_above"}};
inline constexpr std::array kVerdicts{
    EnumWord<Verdict>{Verdict::change_point, "change_point"}, EnumWord<Verdict>{Verdict::closes, "closes"},
    EnumWord<Verdict>{Verdict::stable, "stable"}};

}  // namespace jw
