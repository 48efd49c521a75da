#include "app/exercises/task.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "app/exercises/formulas/mistakes.hpp"
#include "app/exercises/random.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/text/text.hpp"

namespace jw {

namespace {

// number of variants that distinguish mistakes that always agree from those that agree by chance
constexpr int kSamples = 8;
constexpr int kMostSampleDraws = 60;
constexpr int kMostDraws = 400;
/// Answers of mistakes differ by at least this many tolerances.
constexpr double kTolerancesApart = 10.0;
constexpr std::size_t kMostChoices = 4;

Message by_author(const std::string& words) { return {"{0}", {words}}; }

/// Adds a mistake that belongs to no formula.
void add_mistake(Task& task, std::string name, Message title, Message says, MatrixX answer) {
    task.asked.mistakes.push_back(
        {std::move(name), {std::move(title)}, std::move(says), "", std::move(answer), {}});
}

bool is_computed(const Exercise& exercise) { return !exercise.asked.empty(); }

/// Largest difference of answers that count as equal at any tolerance.
double smallest_difference(const Asked& asked) {
    const double size = asked.right.size() > 0 ? std::max(1.0, asked.right.cwiseAbs().maxCoeff()) : 1.0;
    return 1e-7 * size;
}

bool are_same(const MatrixX& a, const MatrixX& b, const Asked& asked) {
    return difference_from(a, b, asked) <= smallest_difference(asked);
}

std::vector<int> shuffled_places(std::size_t count, Random& random) {
    std::vector<int> places(count);
    std::iota(places.begin(), places.end(), 0);
    for (std::size_t k = 0; k + 1 < count; ++k) {
        std::swap(places[k], places[k + static_cast<std::size_t>(random.below(static_cast<int>(count - k)))]);
    }
    return places;
}

void show_in_places(Task& task, const std::vector<std::string>& texts, Random& random) {
    task.place = shuffled_places(texts.size(), random);
    for (const int place : task.place) { task.shown.push_back(texts[static_cast<std::size_t>(place)]); }
}

MatrixX number_of_choice(const Task& task, int place) {
    const auto found = std::ranges::find(task.place, place);
    return MatrixX::Constant(1, 1, static_cast<double>(found - task.place.begin() + 1));
}

/// Shows choices in the words of the author.
void show_choices(Task& task, Random& random) {
    const Exercise& exercise = task.exercise();
    std::vector<std::string> texts;
    for (const ExerciseChoice& choice : exercise.choices) { texts.push_back(choice.text); }
    show_in_places(task, texts, random);
    for (std::size_t k = 0; k < exercise.choices.size(); ++k) {
        const MatrixX number = number_of_choice(task, static_cast<int>(k));
        if (static_cast<int>(k) == exercise.right_choice) {
            task.asked.right = number;
        } else {
            add_mistake(
                task, "choice-" + std::to_string(k + 1), by_author(exercise.choices[k].text),
                by_author(exercise.choices[k].why), number);
        }
    }
    task.asked.tolerance = 0.0;
}

/// Shows choices among the right formula and mistaken ones.
void show_formulas(Task& task, Random& random) {
    std::vector<KnownMistake> wrong;
    for (const int k : shuffled_places(task.asked.mistakes.size(), random)) {
        KnownMistake& mistake = task.asked.mistakes[static_cast<std::size_t>(k)];
        const bool is_new = mistake.shown != task.asked.latex &&
                            std::ranges::find(wrong, mistake.shown, &KnownMistake::shown) == wrong.end();
        if (is_new && wrong.size() + 1 < kMostChoices) { wrong.push_back(mistake); }
    }
    std::vector<std::string> texts{"$" + task.asked.latex + "$"};
    for (const KnownMistake& mistake : wrong) { texts.push_back("$" + mistake.shown + "$"); }
    show_in_places(task, texts, random);
    for (std::size_t k = 0; k < wrong.size(); ++k) {
        wrong[k].answer = number_of_choice(task, static_cast<int>(k) + 1);
    }
    task.asked.right = number_of_choice(task, 0);
    task.asked.mistakes = std::move(wrong);
    task.asked.tolerance = 0.0;
}

void show_components(Task& task) {
    task.shown = {"x", "y", "z"};
    task.place = {0, 1, 2};
}

/// The answer in numbers that puts the exercise's items into this order.
MatrixX numbers_in_order(const Task& task, const std::vector<int>& order) {
    MatrixX numbers(static_cast<Eigen::Index>(order.size()), 1);
    for (std::size_t k = 0; k < order.size(); ++k) {
        numbers(static_cast<Eigen::Index>(k), 0) = number_of_choice(task, order[k])(0, 0);
    }
    return numbers;
}

void show_items(Task& task, Random& random) {
    const std::vector<Text>& texts = task.exercise().items;
    const std::vector<std::string> items(texts.begin(), texts.end());
    show_in_places(task, items, random);
    std::vector<int> order(items.size());
    std::iota(order.begin(), order.end(), 0);
    task.asked.right = numbers_in_order(task, order);
    for (std::size_t k = 0; k + 1 < items.size(); ++k) {
        std::vector<int> swapped = order;
        std::swap(swapped[k], swapped[k + 1]);
        add_mistake(
            task, "order-" + std::to_string(k + 1), {tr_later("two neighbours exchanged"), {}},
            {tr_later("Two neighbours are exchanged: \"{0}\" must come before \"{1}\"."),
             {items[k], items[k + 1]}},
            numbers_in_order(task, swapped));
    }
    std::ranges::reverse(order);
    add_mistake(
        task, "reversed", {tr_later("the order reversed"), {}},
        {tr_later("This is the right order, but reversed."), {}}, numbers_in_order(task, order));
}

/// Message about the first unknown name in the list of mistakes to look for; empty if all are known.
std::string unknown_mistake(const Exercise& exercise) {
    const std::vector<std::string> names = mistake_names();
    for (const std::string& name : exercise.only) {
        if (std::ranges::find(names, name) != names.end()) { continue; }
        const std::string meant = did_you_mean(name, names);
        return "there is no mistake '" + name + "'; " +
               (meant.empty() ? "expected one of " + comma_list(names) : meant);
    }
    return {};
}

/// Makes the choices or items that a student sees in addition to the question.
void show(Task& task) {
    Random random(task.variant.seed ^ 0x5DEECE66DULL);
    const Exercise& exercise = task.exercise();
    if (exercise.kind == ExerciseKind::order) { return show_items(task, random); }
    if (exercise.kind != ExerciseKind::choose) { return; }
    if (!exercise.choices.empty()) { return show_choices(task, random); }
    if (exercise.formula.empty()) { return show_components(task); }
    show_formulas(task, random);
}

}  // namespace

TaskMaker::TaskMaker(const Exercise& exercise) : TaskMaker(exercise, Unlearned()) {
    while (learn()) {}
}

TaskMaker TaskMaker::unlearned(const Exercise& exercise) { return {exercise, Unlearned()}; }

TaskMaker::TaskMaker(const Exercise& exercise, Unlearned) : exercise_(&exercise) {
    problem_ = unknown_mistake(exercise);
    if (!exercise.formula.empty()) { plan_ = std::make_shared<const FormulaPlan>(formula_plan(exercise)); }
    is_learned_ = !problem_.empty() || !is_computed(exercise);
    for (const Exercise& alternative : exercise.alternatives) {
        alternatives_.push_back(unlearned(alternative));
    }
}

bool TaskMaker::learn() {
    if (!is_learned_) {
        is_learned_ = !draw_sample();
        if (is_learned_) { find_groups(); }
        return true;
    }
    const auto more = std::ranges::find_if(alternatives_, [](TaskMaker& maker) { return maker.learn(); });
    if (more != alternatives_.end()) { return true; }
    for (const TaskMaker& alternative : alternatives_) {
        if (problem_.empty()) { problem_ = alternative.problem(); }
    }
    return false;
}

/// Draws one sample. @return true while more samples are needed
bool TaskMaker::draw_sample() {
    const VariantDraw draw =
        drawn_variant(*exercise_, seed_of("sample", std::to_string(samples_drawn_), exercise_->name), plan_);
    ++samples_drawn_;
    problem_ = draw.problem;
    if (draw.variant) {
        Asked asked = asked_in(*draw.variant);
        problem_ = asked.problem;
        if (asked.problem.empty()) { samples_.push_back(std::move(asked)); }
    }
    return samples_drawn_ < kMostSampleDraws && static_cast<int>(samples_.size()) < kSamples;
}

void TaskMaker::find_groups() {
    const std::vector<Asked> samples = std::move(samples_);
    if (samples.empty()) { return; }
    problem_.clear();
    const std::size_t count = samples.front().mistakes.size();
    const auto always_same = [&](auto a, auto b) {
        return std::ranges::all_of(samples, [&](const Asked& s) { return are_same(a(s), b(s), s); });
    };
    leader_.assign(count, -1);
    for (std::size_t k = 0; k < count; ++k) {
        const auto answer = [](std::size_t at) {
            return [at](const Asked& s) -> const MatrixX& { return s.mistakes[at].answer; };
        };
        const bool comparable = std::ranges::all_of(samples, [&](const Asked& s) {
            return std::isfinite(difference_from(s.right, s.mistakes[k].answer, s));
        });
        if (!comparable || always_same([](const Asked& s) -> const MatrixX& { return s.right; }, answer(k))) {
            continue;
        }
        leader_[k] = static_cast<int>(k);
        for (std::size_t before = 0; before < k; ++before) {
            if (leader_[before] == static_cast<int>(before) && always_same(answer(before), answer(k))) {
                leader_[k] = static_cast<int>(before);
                break;
            }
        }
    }
}

bool TaskMaker::accept(Task& task, std::string& why) const {
    Asked& asked = task.asked;
    if (!asked.problem.empty()) {
        why = asked.problem;
        return false;
    }
    if (asked.condition > exercise_->condition_below) {
        why = "the condition is " + std::to_string(asked.condition) + ", more than 'condition_below'";
        return false;
    }
    std::vector<KnownMistake> apart;
    std::vector<std::size_t> position(asked.mistakes.size(), 0);
    for (std::size_t k = 0; k < asked.mistakes.size(); ++k) {
        if (leader_[k] == static_cast<int>(k)) {
            if (!asked.mistakes[k].answer.allFinite()) {
                why = "the mistake '" + asked.mistakes[k].name + "' has no finite answer";
                return false;
            }
            position[k] = apart.size();
            apart.push_back(asked.mistakes[k]);
        } else if (leader_[k] >= 0) {
            std::vector<Message>& titles = apart[position[static_cast<std::size_t>(leader_[k])]].titles;
            const Message& other = asked.mistakes[k].titles.front();
            if (std::ranges::find(titles, other) == titles.end()) { titles.push_back(other); }
        }
    }
    // for programs, all cases together tell mistakes apart (judge_output.cpp)
    const bool by_cases = exercise_->kind == ExerciseKind::code;
    const double least =
        by_cases ? -1.0 : std::max(kTolerancesApart * asked.tolerance, smallest_difference(asked));
    for (std::size_t a = 0; a < apart.size(); ++a) {
        if (difference_from(asked.right, apart[a].answer, asked) <= least) {
            why = "the mistake '" + apart[a].name + "' gives nearly the right answer: " + tr(apart[a].says);
            return false;
        }
        for (std::size_t b = 0; b < a; ++b) {
            if (difference_from(apart[b].answer, apart[a].answer, asked) > least) { continue; }
            why = "the mistakes '" + apart[b].name + "' and '" + apart[a].name +
                  "' give nearly the same answer";
            return false;
        }
    }
    asked.mistakes = std::move(apart);
    return true;
}

/// The maker of the exercise or of one of its alternatives.
const TaskMaker& TaskMaker::chosen_by(std::uint64_t seed) const {
    // not with the seed itself, from which the numbers are drawn
    const int chosen = Random(seed ^ 0x2545F4914F6CDD1DULL).below(static_cast<int>(alternatives_.size()) + 1);
    return chosen > 0 ? alternatives_[static_cast<std::size_t>(chosen) - 1] : *this;
}

Task TaskMaker::make(std::uint64_t seed) const {
    TaskDraft draft(*this, seed);
    while (draft.draw()) {}
    return draft.task();
}

TaskDraft::TaskDraft(const TaskMaker& maker, std::uint64_t seed)
    : maker_(maker.problem_.empty() ? &maker.chosen_by(seed) : &maker), seed_(seed), random_(seed) {
    task_.variant.exercise = maker_->exercise_;
    task_.problem = maker_->problem_;
    task_.draws = 0;
}

bool TaskDraft::draw() {
    const Exercise& exercise = *maker_->exercise_;
    if (!task_.problem.empty()) { return false; }
    VariantDraw draw = drawn_variant(exercise, std::exchange(seed_, random_.next()), maker_->plan_);
    if (!draw.variant) {
        task_.problem = draw.problem;
        return false;
    }
    task_.variant = std::move(*draw.variant);
    ++task_.draws;
    if (is_computed(exercise)) {
        task_.asked = asked_in(task_.variant);
        if (!maker_->accept(task_, why_)) {
            if (!exercise.vary.empty() && task_.draws < kMostDraws) { return true; }
            task_.problem = "no variant can be accepted after " + std::to_string(task_.draws) +
                            " draws; of the last one: " + why_;
            return false;
        }
    }
    show(task_);
    return false;
}

}  // namespace jw
