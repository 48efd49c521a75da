#pragma once

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "app/snapshot/facts/facts.hpp"

namespace jw::snapshot {

/// Gives a number the tolerance that belongs to this scale, and rounds it; see `set_tolerances`.
void set_tolerance(Fact& fact, double scale);

/// Collects facts, each under its own name.
class FactList {
public:
    void text(Weight weight, const std::string& name, const std::string& text) {
        if (!text.empty()) { add({weight, name, text, std::nullopt, {}, 0.0}); }
    }
    void count(Weight weight, const std::string& name, int count) {
        add({weight, name, {}, static_cast<double>(count), {}, 0.0});
    }
    /// A number that is not finite is kept as a word.
    void number(Weight weight, const std::string& name, double value, const std::string& unit) {
        if (!std::isfinite(value)) {
            text(weight, name, std::isnan(value) ? "not a number" : value > 0.0 ? "infinite" : "−infinite");
            return;
        }
        add({weight, name, {}, value, unit, kToBeSet});
    }
    /// A finite number of the lesson's file. It has its own scale, so that larger numbers of its unit do not
    /// hide it.
    /// @param scale  for a part of a vector or tensor: its norm
    void given(Weight weight, const std::string& name, double value, const std::string& unit, double scale) {
        Fact fact{weight, name, {}, value, unit, 0.0};
        set_tolerance(fact, scale > 0.0 ? scale : kScaleOfZero);
        add(std::move(fact));
    }
    void given(Weight weight, const std::string& name, double value, const std::string& unit) {
        given(weight, name, value, unit, std::abs(value));
    }
    void given(Weight weight, const std::string& name, const Vec3& v, const std::string& unit) {
        given(weight, name + " · x", v.x(), unit, v.norm());
        given(weight, name + " · y", v.y(), unit, v.norm());
        given(weight, name + " · z", v.z(), unit, v.norm());
    }
    void vector(Weight weight, const std::string& name, const Vec3& v, const std::string& unit) {
        number(weight, name + " · x", v.x(), unit);
        number(weight, name + " · y", v.y(), unit);
        number(weight, name + " · z", v.z(), unit);
    }

    std::vector<Fact> take() { return std::move(facts_); }

    /// Tolerance of numbers before `set_tolerances`.
    static constexpr double kToBeSet = -1.0;

private:
    static constexpr double kScaleOfZero = 1e-6;

    void add(Fact fact) {
        std::string name = fact.name;
        for (int k = 2; !names_.insert(name).second; ++k) {
            name = fact.name + " (" + std::to_string(k) + ")";
        }
        fact.name = std::move(name);
        facts_.push_back(std::move(fact));
    }

    std::vector<Fact> facts_;
    std::set<std::string> names_;
};

}  // namespace jw::snapshot
