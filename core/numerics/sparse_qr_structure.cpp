#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/numerics/sparse_qr.hpp"

namespace jw {

namespace {

/// Rows of Φq that are eliminated together.
struct RowGroup {
    std::vector<int> rows;
    std::vector<int> unknowns;  ///< bodies and θ that they involve, as indices into the list of all
};

/// All groups, in the order of their first rows, and the unknowns that they involve.
struct Groups {
    std::vector<RowGroup> groups;
    std::vector<SparseQrStructure::Unknowns> unknowns;
    std::vector<std::vector<int>> groups_of_unknowns;
    std::vector<std::array<int, 3>> unknowns_of_row;  ///< unknowns of body i, body j and θ; -1: none
};

void number_unknowns(const SparseRows& rows, Groups& all) {
    std::map<int, int> place_of;  // by first column
    const auto place = [&](int first, int count) {
        if (first < 0) { return -1; }
        const auto [entry, is_new] = place_of.try_emplace(first, static_cast<int>(all.unknowns.size()));
        if (is_new) { all.unknowns.push_back({first, count, {}}); }
        return entry->second;
    };
    for (const SparseRow& row : rows.rows) {
        all.unknowns_of_row.push_back(
            {place(row.first_column[0], rows.width), place(row.first_column[1], rows.width),
             place(row.theta_column, 1)});
    }
    all.groups_of_unknowns.resize(all.unknowns.size());
}

/// @param group_of_row ascending; if empty, rows with the same columns form a group
Groups groups_of(const SparseRows& rows, const std::vector<int>& group_of_row) {
    Groups all;
    number_unknowns(rows, all);
    std::map<std::array<int, 3>, std::size_t> by_unknowns;
    for (std::size_t r = 0; r < rows.rows.size(); ++r) {
        const std::array<int, 3>& key = all.unknowns_of_row[r];
        const std::size_t group = group_of_row.empty()
                                      ? by_unknowns.try_emplace(key, all.groups.size()).first->second
                                      : at(group_of_row[r]);
        if (group >= all.groups.size()) { all.groups.resize(group + 1); }
        all.groups[group].rows.push_back(static_cast<int>(r));
        std::vector<int>& unknowns = all.groups[group].unknowns;
        for (const int u : key) {
            if (u < 0 || std::ranges::find(unknowns, u) != unknowns.end()) { continue; }
            unknowns.push_back(u);
            all.groups_of_unknowns[at(u)].push_back(static_cast<int>(group));
        }
    }
    return all;
}

/// Neighbours of every group: groups that share a body or a θ with it.
std::vector<std::set<int>> neighbours_of(const Groups& all) {
    std::vector<std::set<int>> neighbours(all.groups.size());
    for (const std::vector<int>& sharing : all.groups_of_unknowns) {
        for (const int a : sharing) {
            for (const int b : sharing) {
                if (a != b) { neighbours[at(a)].insert(b); }
            }
        }
    }
    return neighbours;
}

struct Elimination {
    std::vector<int> order;               ///< groups
    std::vector<std::vector<int>> later;  ///< of each, the neighbours left when it is eliminated
};

/// Eliminates the groups by minimum degree or in the given order; the neighbours of a group become neighbours
/// of one another.
Elimination eliminated(const Groups& all, bool by_degree) {
    std::vector<std::set<int>> left = neighbours_of(all);
    std::set<std::pair<std::size_t, int>> waiting;
    const auto key = [&](int g) { return std::pair{by_degree ? left[at(g)].size() : 0, g}; };
    for (int g = 0; g < static_cast<int>(left.size()); ++g) { waiting.insert(key(g)); }
    Elimination result;
    while (!waiting.empty()) {
        const int group = waiting.begin()->second;
        waiting.erase(waiting.begin());
        const std::set<int> touched = std::move(left[at(group)]);
        for (const int a : touched) {
            waiting.erase(key(a));
            left[at(a)].erase(group);
            for (const int b : touched) {
                if (a != b) { left[at(a)].insert(b); }
            }
            waiting.insert(key(a));
        }
        result.order.push_back(group);
        result.later.emplace_back(touched.begin(), touched.end());
    }
    return result;
}

}  // namespace

SparseQrStructure::SparseQrStructure(const SparseRows& rows, const std::vector<int>& group_of_row)
    : columns_of_rows_(rows.rows), columns_(rows.columns) {
    Groups all = groups_of(rows, group_of_row);
    const Elimination elimination = eliminated(all, group_of_row.empty());
    std::vector<int> front_of(all.groups.size());
    for (std::size_t f = 0; f < elimination.order.size(); ++f) {
        front_of[at(elimination.order[f])] = static_cast<int>(f);
    }

    // columns of every front: its own rows, then those of later groups in their order of elimination
    fronts_.resize(elimination.order.size());
    std::vector<std::map<int, int>> column_of(fronts_.size());  // group -> first column in the front
    for (std::size_t f = 0; f < fronts_.size(); ++f) {
        Front& front = fronts_[f];
        std::vector<int> groups = elimination.later[f];
        std::ranges::sort(groups, {}, [&](int g) { return front_of[at(g)]; });
        groups.insert(groups.begin(), elimination.order[f]);
        for (const int g : groups) {
            column_of[f][g] = static_cast<int>(front.rows.size());
            front.rows.insert(front.rows.end(), all.groups[at(g)].rows.begin(), all.groups[at(g)].rows.end());
        }
        front.own = static_cast<int>(all.groups[at(groups.front())].rows.size());
        if (groups.size() == 1) { continue; }
        // the next group takes over the remainder: all others are its neighbours by now
        fronts_[at(front_of[at(groups[1])])].children.push_back(static_cast<int>(f));
    }

    // every body and θ belongs to the first front that involves it
    for (std::size_t u = 0; u < all.unknowns.size(); ++u) {
        const std::vector<int>& sharing = all.groups_of_unknowns[u];
        const int f =
            front_of[at(*std::ranges::min_element(sharing, {}, [&](int g) { return front_of[at(g)]; }))];
        Unknowns& unknowns = all.unknowns[u];
        for (const int g : sharing) {
            const RowGroup& group = all.groups[at(g)];
            const int first = column_of[at(f)].at(g);
            for (std::size_t k = 0; k < group.rows.size(); ++k) {
                const std::array<int, 3>& touched = all.unknowns_of_row[at(group.rows[k])];
                const auto side = std::ranges::find(touched, static_cast<int>(u)) - touched.begin();
                if (side == 3) { continue; }
                unknowns.entries.push_back(
                    {group.rows[k], static_cast<int>(side), first + static_cast<int>(k)});
            }
        }
        fronts_[at(f)].unknowns.push_back(std::move(unknowns));
    }

    for (std::size_t f = 0; f < fronts_.size(); ++f) {
        Front& front = fronts_[f];
        for (const Unknowns& unknowns : front.unknowns) { front.most_lines += unknowns.count; }
        for (const int child : front.children) {
            Front& handing = fronts_[at(child)];
            const int left = static_cast<int>(handing.rows.size()) - handing.own;
            front.most_lines += std::min(handing.most_lines, left);
            // groups keep their rows together in every front
            for (std::size_t k = at(handing.own); k < handing.rows.size(); ++k) {
                const auto place = std::ranges::find(front.rows, handing.rows[k]);
                handing.to_parent.push_back(static_cast<int>(place - front.rows.begin()));
            }
        }
    }
}

bool SparseQrStructure::fits(const SparseRows& rows) const {
    return columns_ == rows.columns &&
           std::ranges::equal(rows.rows, columns_of_rows_, [](const SparseRow& a, const SparseRow& b) {
               return a.same_columns(b);
           });
}

}  // namespace jw
