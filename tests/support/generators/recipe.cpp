#include "tests/support/generators/recipe.hpp"

#include <cctype>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>

namespace jw::test {

std::ostream& operator<<(std::ostream& out, const Recipe& r) {
    out << "recipe family " << static_cast<int>(r.family) << " near " << r.near << " length 1e"
        << r.length_decade << " gravity " << r.gravity << " rest " << r.at_rest << " all driven "
        << r.drive_all << (r.afloat ? " afloat" : "") << " seed " << r.seed << '\n';
    for (const BodyRecipe& b : r.bodies) {
        out << "  body on " << b.parent << " joint " << b.joint << " form " << b.form << " mass 1e"
            << b.mass_decade << " offset " << b.offset << " seed " << b.seed << '\n';
    }
    for (const JointRecipe& j : r.joints) {
        out << "  joint " << j.type << " of " << j.i << ' ' << j.j << " form " << j.form << " repeats "
            << j.repeats << " without " << j.without << " seed " << j.seed << '\n';
    }
    for (const DriverRecipe& d : r.drivers) {
        out << "  driver " << d.quantity << " joint " << d.joint << " of " << d.i << ' ' << d.j
            << " function " << d.function << " seed " << d.seed << '\n';
    }
    for (const LoadRecipe& l : r.loads) {
        out << "  load " << l.kind << " of " << l.i << ' ' << l.j << " damped " << l.damped << " seed "
            << l.seed << '\n';
    }
    return out;
}

namespace {

/// A line of a recipe without its names: 'mass 1e-3' is -3.
class Numbers {
public:
    explicit Numbers(const std::string& line) {
        std::istringstream words(line);
        for (std::string word; words >> word;) {
            if (word.starts_with("1e")) { word.erase(0, 2); }
            const char last = word.back();
            if (std::isdigit(static_cast<unsigned char>(last)) != 0) { numbers_.push_back(std::stoi(word)); }
        }
    }

    template <class... T>
    void into(T&... to) const {
        if (numbers_.size() != sizeof...(to)) { throw std::invalid_argument("no line of a recipe"); }
        std::size_t next = 0;
        ((to = static_cast<T>(numbers_[next++])), ...);
    }

private:
    std::vector<int> numbers_;
};

void read_line(const std::string& line, Recipe& r) {
    const Numbers numbers(line);
    if (line.starts_with("  body ")) {
        BodyRecipe& b = r.bodies.emplace_back();
        numbers.into(b.parent, b.joint, b.form, b.mass_decade, b.offset, b.seed);
    } else if (line.starts_with("  joint ")) {
        JointRecipe& j = r.joints.emplace_back();
        numbers.into(j.type, j.i, j.j, j.form, j.repeats, j.without, j.seed);
    } else if (line.starts_with("  driver ")) {
        DriverRecipe& d = r.drivers.emplace_back();
        numbers.into(d.quantity, d.joint, d.i, d.j, d.function, d.seed);
    } else {
        LoadRecipe& l = r.loads.emplace_back();
        numbers.into(l.kind, l.i, l.j, l.damped, l.seed);
    }
}

}  // namespace

std::optional<Recipe> recipe_in(std::istream& text) {
    std::string line;
    while (std::getline(text, line) && !line.starts_with("recipe ")) {}
    if (!text) { return std::nullopt; }
    Recipe r;
    Numbers(line).into(r.family, r.near, r.length_decade, r.gravity, r.at_rest, r.drive_all, r.seed);
    r.afloat = line.find(" afloat ") != std::string::npos;
    while (std::getline(text, line) && line.starts_with("  ")) { read_line(line, r); }
    return r;
}

}  // namespace jw::test
