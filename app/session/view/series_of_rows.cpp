#include <algorithm>
#include <limits>
#include <numeric>

#include "app/session/view/series_parts.hpp"
#include "app/session/view/view_equations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"

namespace jw {

namespace {

std::string subscript_number(std::size_t number) {
    static constexpr const char* digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string text;
    for (const char c : std::to_string(number)) { text += digits[c - '0']; }
    return text;
}

/// Mark for all joints whose choice of rows differs from that in `before`: "sleeve p1, p2: x is left out";
/// without text if there are none.
Mark switches_between(const System& before, const System& now) {
    struct Switch {
        int joint = 0;
        int dropped = 0;
        std::string text;
    };
    const auto joint_of = [&](int joint) -> const Joint& { return now.mechanism().joints[at(joint)]; };
    std::vector<Switch> switches;
    for (std::size_t k = 0; k < now.constraints().size(); ++k) {
        const Constraint& c = now.constraints()[k];
        if (c.dropped == before.constraints()[k].dropped) { continue; }
        const Joint& joint = joint_of(c.joint);
        const std::string role = name_of_role(c.role, joint.parallel_form);
        if (!switches.empty() && switches.back().joint == c.joint && switches.back().dropped == c.dropped) {
            switches.back().text += ", " + role;
        } else {
            switches.push_back({c.joint, c.dropped, joint.name + " " + role});
        }
    }
    Mark mark;
    int joints = 0;
    for (std::size_t k = 0; k < switches.size(); ++k) {
        const Switch& s = switches[k];
        mark.text += (k == 0 ? "" : "; ") + tr("{0}: {1} is left out", s.text, axis_name(s.dropped));
        if (k > 0 && switches[k - 1].joint == s.joint) { continue; }
        mark.brief += (k == 0 ? "" : ", ") + joint_of(s.joint).name;
        ++joints;
    }
    mark.brief = tr_count(joints, "{1} switches", "{1} switch", mark.brief);
    mark.many = tr("switches of rows");
    return mark;
}

void add_switches(const Story& story, SeriesSet& set) {
    for (std::size_t k = 1; k < set.steps.size(); ++k) {
        const auto system_at = [&](std::size_t point) { return story.steps()[at(set.steps[point])].system; };
        if (system_at(k) == system_at(k - 1)) { continue; }
        Mark mark = switches_between(*system_at(k - 1), *system_at(k));
        if (mark.text.empty()) { continue; }
        mark.at = set.at[k];
        set.marks.push_back(std::move(mark));
    }
}

/// Adds one mark in the middle of each run of poses that are nearly singular.
void add_change_points(const Story& story, SeriesSet& set) {
    const auto is_one = [&](std::size_t point) { return story.steps()[at(set.steps[point])].change_point; };
    for (std::size_t first = 0; first < set.steps.size(); ++first) {
        if (!is_one(first)) { continue; }
        std::size_t last = first;
        while (last + 1 < set.steps.size() && is_one(last + 1)) { ++last; }
        set.marks.push_back({0.5 * (set.at[first] + set.at[last]), tr("change point")});
        first = last;
    }
}

std::string why_nothing_moves(const Story& story) {
    if (story.failure() != nullptr) {
        return tr("Nothing moves here: the mechanism could not be assembled.");
    }
    return tr("Nothing moves here: the lesson ends once the mechanism is assembled.");
}

/// Indices of the largest and smallest of many singular values, and of the threshold.
std::vector<int> largest_and_smallest(const SeriesSet& set) {
    constexpr int smallest = 4;
    const int count = static_cast<int>(set.series.size());
    std::vector<int> telling = series::all_of(set);
    if (count > smallest + 2) {
        telling.erase(telling.begin() + 1, telling.begin() + (count - 1 - smallest));
    }
    return telling;
}

}  // namespace

namespace series {

std::vector<int> all_of(const SeriesSet& set) {
    std::vector<int> indices(set.series.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

std::vector<int> motion_steps(const Story& story) {
    std::vector<int> indices;
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        if (step.kind == Step::Kind::motion && !step.failure) { indices.push_back(static_cast<int>(k)); }
    }
    return indices;
}

SeriesSet over_time(const Story& story) {
    SeriesSet set;
    set.axis = "t [s]";
    set.steps = motion_steps(story);
    for (const int k : set.steps) { set.at.push_back(story.steps()[at(k)].t); }
    add_switches(story, set);
    add_change_points(story, set);
    std::ranges::stable_sort(set.marks, {}, &Mark::at);
    if (set.at.empty()) { set.why_empty = why_nothing_moves(story); }
    return set;
}

SeriesSet over_curve(const Story& story) {
    SeriesSet set = over_time(story);
    if (story.curve().empty() || set.steps.empty()) { return set; }
    const std::vector<int> steps = std::move(set.steps);
    set.at.clear();
    set.steps.clear();
    set.of_curve = true;
    std::size_t next = 0;
    for (const Step& moment : story.curve()) {
        const auto time_of = [&](std::size_t k) { return story.steps()[at(steps[k])].t; };
        while (next + 1 < steps.size() && time_of(next) < moment.t) { ++next; }
        set.at.push_back(moment.t);
        set.steps.push_back(steps[next]);
    }
    return set;
}

}  // namespace series

SeriesSet singular_value_series(const Story& story) {
    SeriesSet set = series::over_time(story);
    set.logarithmic = true;
    for (std::size_t k = 0; k < set.steps.size(); ++k) {
        const Step& step = story.steps()[at(set.steps[k])];
        const RankReport report = rank_of(*step.system, step.state, step.t);
        const auto count = static_cast<std::size_t>(report.singular_values.size());
        if (k == 0) {
            for (std::size_t n = 1; n <= count; ++n) {
                set.series.push_back({"σ" + subscript_number(n), "-", {}, 0.0, false});
            }
            set.series.push_back({"threshold", "-", {}, 0.0, true});
        }
        for (std::size_t n = 0; n < count; ++n) {
            set.series[n].values.push_back(report.singular_values(static_cast<Eigen::Index>(n)));
        }
        set.series.back().values.push_back(report.threshold);
    }
    set.telling = largest_and_smallest(set);
    return set;
}

SeriesSet condition_series(const Story& story, int joint) {
    SeriesSet set = series::over_time(story);
    set.logarithmic = true;
    const System* before = nullptr;
    for (std::size_t k = 0; k < set.steps.size(); ++k) {
        const Step& step = story.steps()[at(set.steps[k])];
        const std::vector<RowChoice> choices = choices_of_joint(*step.system, joint, step.state, before);
        std::size_t next = 0;
        const auto add = [&](const std::string& name, double condition) {
            if (next == set.series.size()) { set.series.push_back({name, "-", {}, 0.0, false}); }
            const bool lost = !(condition < std::numeric_limits<double>::infinity());
            set.series[next++].values.push_back(lost ? std::numeric_limits<double>::quiet_NaN() : condition);
        };
        std::size_t choice = 0;
        for (const Constraint& c : step.system->constraints()) {
            if (c.joint != joint || !is_parallel(c.role)) { continue; }
            const RowChoice& reason = choices[choice++];
            const std::string role = name_of_role(c.role, ParallelForm::rule);
            for (int drop = 0; drop < 3; ++drop) {
                add(role + " drop " + axis_name(drop), reason.pair_condition[at(drop)]);
            }
            add(role + " in use", reason.form_condition);
        }
        before = step.system.get();
    }
    // the rows of p1; the same axis chooses those of p2, whose condition depends on a unit of length
    set.telling = series::all_of(set);
    if (set.telling.size() > 4) { set.telling.resize(4); }
    if (set.series.empty()) {
        set.at.clear();
        set.steps.clear();
        if (set.why_empty.empty()) {
            set.why_empty = tr("This joint has no p1 or p2: none of its equations is left out.");
        }
    }
    return set;
}

std::vector<Vec3> axis_directions(const Story& story, int joint, int last) {
    const Joint& axis = story.lesson().mechanism.joints[at(joint)];
    std::vector<Vec3> directions;
    for (int k = 0; k <= last; ++k) {
        const Step& step = story.steps()[at(k)];
        if (is_asked(step.kind)) { continue; }  // a question does not move anything
        const std::vector<int>& present = step.system->selection().joints;
        if (std::ranges::find(present, joint) == present.end()) { continue; }
        const Mat3 A = rotation_matrix(step.state.p[at(axis.body_i)]);
        directions.push_back((A * axis.geometry.s_i_local).normalized());
    }
    return directions;
}

}  // namespace jw
