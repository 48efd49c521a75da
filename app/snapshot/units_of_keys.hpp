#pragma once

#include <string>
#include <string_view>

namespace jw::snapshot {

/// "radius" of "body.crank.shape.0.rod.radius"
inline std::string_view last_key(std::string_view path) { return path.substr(path.find_last_of('.') + 1); }

/// "body" of "body.crank.shape.0.rod.radius"
inline std::string_view table_of(std::string_view path) { return path.substr(0, path.find('.')); }

/// "body.crank" of "body.crank.shape.0.rod.radius"; all of a shorter path
inline std::string entry_of(const std::string& path) {
    const std::size_t first = path.find('.');
    return first == std::string::npos ? path : path.substr(0, path.find('.', first + 1));
}

/// Unit of the coefficient of t^power in a function of time with this unit: "N", "N/s", "N/s^2".
std::string unit_of_coefficient(const std::string& unit, std::size_t power);

/// Units of the numbers in a lesson file.
class UnitsOfKeys {
public:
    /// @param lesson  text of the file, must outlive this: a function of time is a force or a factor of one,
    /// and other keys of its table decide which
    explicit UnitsOfKeys(const std::string& lesson) : lesson_(lesson) {}

    /// The difference of a number with its unit: "1 mm", "0.2 m", "5 deg", "1 N"; without a unit if it is not
    /// known.
    /// @param path   of the key, as `difference_of` names it
    /// @param index  of the number in its list, 0 for a single one
    std::string amount(const std::string& path, std::size_t index, double amount) const;

private:
    std::string unit(const std::string& path, std::size_t index) const;
    std::string unit_of_load(const std::string& path, std::size_t index) const;

    const std::string& lesson_;
};

}  // namespace jw::snapshot
