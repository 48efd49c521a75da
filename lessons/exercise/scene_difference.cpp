#include "lessons/exercise/scene_difference.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "lessons/exercise/scene_nodes.hpp"

namespace jw {

namespace {

// keys of the mechanism itself; the others are its appearance, its texts, or claims about it
constexpr std::array<std::string_view, 12> kMechanical{
    "body",  "joint",  "driver", "motion", "dynamics",          "order",
    "force", "torque", "spring", "format", "rotational_spring", "coordinates"};
constexpr std::array<std::string_view, 4> kLooks{"text", "colour", "shape", "why"};

bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

double number_in(const toml::node& node) {
    return node.is_integer() ? static_cast<double>(node.as_integer()->get())
                             : node.as_floating_point()->get();
}

bool are_equal(const toml::node& a, const toml::node& b) {
    if (a.is_number() && b.is_number()) { return number_in(a) == number_in(b); }
    if (a.is_array() && b.is_array()) {
        return std::ranges::equal(*a.as_array(), *b.as_array(), [](const toml::node& x, const toml::node& y) {
            return are_equal(x, y);
        });
    }
    return a.type() == b.type() && node_text(a) == node_text(b);
}

bool are_tables(const toml::array& list) {
    return !list.empty() && std::ranges::all_of(list, [](const toml::node& n) { return n.is_table(); });
}

bool are_named(const toml::array& list) {
    return std::ranges::all_of(list, [](const toml::node& n) { return (*n.as_table())["name"].is_string(); });
}

std::string name_of_entry(const toml::array& list, std::size_t k) {
    const auto name = (*list[k].as_table())["name"].value<std::string>();
    return name ? *name : std::to_string(k);
}

class Comparer {
public:
    explicit Comparer(SceneParts parts) : parts_(parts) {}

    SceneDifference found;

    void compare(const std::string& path, const toml::table& a, const toml::table& b) {
        for (const auto& [key, value] : a) {
            if (skips(path, key.str())) { continue; }
            const toml::node* const other = b.get(key.str());
            const std::string here = below(path, key.str());
            if (other == nullptr) {
                add_all(here, value, found.removed);
            } else {
                compare(here, value, *other);
            }
        }
        for (const auto& [key, value] : b) {
            if (!skips(path, key.str()) && !a.contains(key.str())) {
                add_all(below(path, key.str()), value, found.added);
            }
        }
    }

private:
    bool skips(const std::string& path, std::string_view key) const {
        if (parts_ == SceneParts::all) { return false; }
        return path.empty() ? !is_one_of(kMechanical, key) : is_one_of(kLooks, key);
    }
    static std::string below(const std::string& path, std::string_view key) {
        return path.empty() ? std::string(key) : path + "." + std::string(key);
    }

    /// Adds the path of a node; for a list of tables, the paths of the tables.
    static void add_all(const std::string& path, const toml::node& node, std::vector<std::string>& to) {
        const toml::array* const list = node.as_array();
        if (list == nullptr || !are_tables(*list)) {
            to.push_back(path);
            return;
        }
        for (std::size_t k = 0; k < list->size(); ++k) { to.push_back(below(path, name_of_entry(*list, k))); }
    }

    void compare(const std::string& path, const toml::node& a, const toml::node& b) {
        if (a.is_table() && b.is_table()) { return compare(path, *a.as_table(), *b.as_table()); }
        const bool lists = a.is_array() && b.is_array();
        if (lists && are_tables(*a.as_array()) && are_tables(*b.as_array())) {
            const bool have_names = are_named(*a.as_array()) && are_named(*b.as_array());
            return have_names ? compare_named(path, *a.as_array(), *b.as_array())
                              : compare_nameless(path, *a.as_array(), *b.as_array());
        }
        if (!are_equal(a, b)) { found.changed.push_back(path); }
    }

    void compare_named(const std::string& path, const toml::array& a, const toml::array& b) {
        OtherOrder order{path, {}, {}};
        for (std::size_t k = 0; k < a.size(); ++k) {
            const std::string name = name_of_entry(a, k);
            const auto other = index_of_entry(b, name);
            if (other) {
                order.before.push_back(name);
                compare(below(path, name), *a[k].as_table(), *b[*other].as_table());
            } else {
                found.removed.push_back(below(path, name));
            }
        }
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::string name = name_of_entry(b, k);
            if (index_of_entry(a, name)) {
                order.after.push_back(name);
            } else {
                found.added.push_back(below(path, name));
            }
        }
        if (order.before != order.after) { found.reordered.push_back(std::move(order)); }
    }

    /// @param path  of their list; it decides which keys are compared
    bool are_same(const std::string& path, const toml::node& a, const toml::node& b) const {
        Comparer inner(parts_);
        inner.compare(path, *a.as_table(), *b.as_table());
        return inner.found.count() == 0 && inner.found.reordered.empty();
    }

    /// Equal entries are matched in order. The remaining entries are compared if they have the same number in
    /// both lists; otherwise they count as added or removed.
    void compare_nameless(const std::string& path, const toml::array& a, const toml::array& b) {
        if (a.size() == b.size() && is_other_order(path, a, b)) { return; }
        std::vector<std::size_t> removed;
        std::vector<std::size_t> added;
        std::size_t next = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            // in lists of the same length, entries are matched by their number
            std::size_t same = a.size() == b.size() ? k : next;
            const std::size_t end = a.size() == b.size() ? k + 1 : b.size();
            while (same < end && !are_same(path, a[k], b[same])) { ++same; }
            if (same == end) {
                removed.push_back(k);
                continue;
            }
            for (; next < same; ++next) { added.push_back(next); }
            ++next;
        }
        for (; next < b.size(); ++next) { added.push_back(next); }
        for (const std::size_t k : removed) {
            const std::string here = below(path, std::to_string(k));
            if (std::erase(added, k) > 0) {
                compare(here, *a[k].as_table(), *b[k].as_table());
            } else {
                found.removed.push_back(here);
            }
        }
        for (const std::size_t k : added) { found.added.push_back(below(path, std::to_string(k))); }
    }

    /// True if both lists have the same entries; a different order is then recorded.
    bool is_other_order(const std::string& path, const toml::array& a, const toml::array& b) {
        OtherOrder order{path, {}, {}};
        std::vector<std::size_t> left;
        for (std::size_t k = 0; k < a.size(); ++k) {
            order.before.push_back(std::to_string(k));
            left.push_back(k);
        }
        for (const toml::node& entry : b) {
            const auto same =
                std::ranges::find_if(left, [&](std::size_t k) { return are_same(path, a[k], entry); });
            if (same == left.end()) { return false; }
            order.after.push_back(std::to_string(*same));
            left.erase(same);
        }
        if (order.before != order.after) { found.reordered.push_back(std::move(order)); }
        return true;
    }

    SceneParts parts_;
};

}  // namespace

SceneDifference difference_of(const std::string& before, const std::string& after, SceneParts parts) {
    const auto a = scene_tree(before);
    const auto b = scene_tree(after);
    Comparer comparer(parts);
    if (a && b) { comparer.compare("", *a, *b); }
    return comparer.found;
}

}  // namespace jw
