#pragma once

#include <optional>
#include <vector>

#include "app/session/view/symbols.hpp"
#include "core/equations/system.hpp"
#include "lessons/lesson/things.hpp"

/// Places on the screen that belong together: a number in a panel, its symbol in the formula, its row in the
/// matrix, its vector and its bodies in 3D. Pointing at one highlights the others.
namespace jw {

/// Something that can be pointed at.
struct Pointable {
    enum class Kind {
        none,
        row,       ///< index: of the system
        column,    ///< index: of Φq in the coordinates shown
        body,      ///< index: in the mechanism
        joint,     ///< index: in the mechanism
        vector,    ///< index: joint; part: kVectorI, kVectorJ, kVectorD
        symbol,    ///< index: in View::symbols
        equation,  ///< of a joint, not a row of the system; index: joint; part: number of its equation
    };
    static constexpr int kVectorI = Thing::kVectorI;  ///< fixed in body i
    static constexpr int kVectorJ = Thing::kVectorJ;  ///< fixed in body j
    static constexpr int kVectorD = Thing::kVectorD;  ///< between the two

    Kind kind = Kind::none;
    int index = -1;
    int part = 0;

    bool operator==(const Pointable&) const = default;
    explicit operator bool() const { return kind != Kind::none; }

    static Pointable row(int index) { return {Kind::row, index}; }
    static Pointable column(int index) { return {Kind::column, index}; }
    static Pointable body(int index) { return {Kind::body, index}; }
    static Pointable joint(int index) { return {Kind::joint, index}; }
    static Pointable symbol(int index) { return {Kind::symbol, index}; }
    static Pointable equation(int joint, int number) { return {Kind::equation, joint, number}; }
    static Pointable vector(int joint, int part) { return {Kind::vector, joint, part}; }
};

/// Id of a link that is drawn in 3D (a body, joint or vector), and back; 0 for all others.
int picture_id(const Pointable& link);
Pointable pointable_of(int picture_id);

/// Columns of a body beyond those of r: 4 in the (r, p) choices, else 3.
int angular_of(CoordinateChoice choice);

/// Links to everything that a symbol stands for.
std::vector<Pointable> links_of(const SymbolView& symbol, const System& system);

/// Set of all things that are highlighted together.
class Emphasis {
public:
    Emphasis() = default;
    /// Highlights everything that belongs to `pointed_at`.
    /// @param angular see angular_of
    Emphasis(const System& system, int angular, const Pointable& pointed_at) {
        light(system, angular, pointed_at);
    }

    /// Adds everything that belongs to `link`.
    void light(const System& system, int angular, const Pointable& link);

    bool contains(const Pointable& link) const;
    bool empty() const { return links_.empty(); }

private:
    void add(const Pointable& link);
    void add_row_and_its_vectors(const System& system, int row);
    void add_vectors(const System& system, int joint, Role role);
    void add_coming_equation(const System& system, int joint, int number);
    void add_rows_of_joint(const System& system, int joint);
    void add_rows_with_vector(const System& system, int joint, int part);
    void add_columns_of_body(const System& system, int angular, int body);

    std::vector<Pointable> links_;
};

struct View;

/// The thing of kind `wanted` at a place of a step's picture or panels: for a vector also its joint, for a
/// column of the matrix its body, for a symbol what it stands for; nothing if there is none of that kind.
std::optional<Thing> thing_at(const Step& step, const View& view, const Pointable& place, Thing::Kind wanted);

/// Place of a thing at a step: for a row that the system does not have, the equation of its joint; nothing
/// for the row of a driver that is not added.
Pointable place_of(const Step& step, const Thing& thing);

/// Highlights the right things when the answer to a question about things is shown.
void light_answer(const Step& step, CoordinateChoice coordinates, const View& view, Emphasis& lit);

}  // namespace jw
