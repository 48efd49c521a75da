#include "app/session/answers/judged_answer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/numerics/decimal.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

std::string without_blanks(const std::string& text) {
    std::string kept;
    std::ranges::copy_if(text, std::back_inserter(kept), [](char c) { return c != ' '; });
    return kept;
}

/// A number or a fraction of two numbers, with or without the unit after it.
std::optional<double> typed_number(std::string text, const std::string& unit) {
    text = without_blanks(text);
    const std::string plain_unit = without_blanks(unit);
    if (!plain_unit.empty() && text.size() > plain_unit.size() && text.ends_with(plain_unit)) {
        text.resize(text.size() - plain_unit.size());
    }
    const auto parse = [](std::string_view part) -> std::optional<double> {
        double value = 0.0;
        const auto [end, error] = read_decimal(part.data(), part.data() + part.size(), value);
        const bool whole = error == std::errc() && end == part.data() + part.size();
        return whole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
    };
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) { return parse(text); }
    const auto above = parse(std::string_view(text).substr(0, slash));
    const auto below = parse(std::string_view(text).substr(slash + 1));
    if (!above || !below || *below == 0.0) { return std::nullopt; }
    return *above / *below;
}

int chosen(const QuestionView& view, const std::string& given) {
    const std::optional<double> number = typed_number(given, "");
    const auto count = static_cast<double>(view.choices.size());
    if (number && *number >= 1.0 && *number <= count && *number == std::floor(*number)) {
        return static_cast<int>(*number) - 1;
    }
    for (std::size_t k = 0; k < view.choices.size(); ++k) {
        if (!given.empty() && math::plain_words(view.choices[k]).starts_with(given)) {
            return static_cast<int>(k);
        }
    }
    return -1;
}

GivenAnswer judge_choice(const QuestionView& view, const RightAnswer& right, const std::string& given) {
    GivenAnswer judged;
    const int choice = chosen(view, given);
    if (choice < 0) {
        judged.note = tr("expected the number of a choice, 1 to {0}", view.choices.size());
        return judged;
    }
    judged.understood = true;
    judged.right = right.known && choice == right.choice;
    judged.note = tr("You said: {0}", view.choices[static_cast<std::size_t>(choice)]);
    return judged;
}

GivenAnswer judge_number(const QuestionView& view, const RightAnswer& right, const std::string& given) {
    GivenAnswer judged;
    const std::optional<double> number = typed_number(given, view.unit);
    if (!number) {
        judged.note = view.unit.empty() ? tr("expected a number") : tr("expected a number in {0}", view.unit);
        return judged;
    }
    const double apart = *number - right.number;
    const double off = right.turn > 0.0 ? std::remainder(apart, right.turn) : apart;
    judged.understood = true;
    judged.right = right.known && std::abs(off) <= right.tolerance;
    judged.note = tr("You said {0}.", number_text(*number, 6) + (view.unit.empty() ? "" : " " + view.unit));
    if (right.known && !judged.right && right.tolerance > 0.0) {
        judged.note = followed(judged.note, tr("Off by {0}.", number_text(off, 3)));
    }
    return judged;
}

GivenAnswer judge_thing(
    const QuestionView& view, const RightAnswer& right, const Mechanism& mechanism,
    const std::string& given) {
    GivenAnswer judged;
    const std::optional<Thing> thing = thing_named(mechanism, view.thing, given);
    const bool possible =
        thing && std::ranges::find(view.names, name_of(*thing, mechanism)) != view.names.end();
    if (!possible) {
        judged.note = view.names.empty() ? tr("nothing of that kind is here")
                                         : tr("expected a name such as {0}", view.names.front());
        return judged;
    }
    judged.understood = true;
    judged.right = right.known && std::ranges::find(right.things, *thing) != right.things.end();
    judged.note = tr("You said: {0}", name_of(*thing, mechanism));
    return judged;
}

/// Seven numbers, separated by blanks, commas or semicolons.
std::optional<BodyPose> typed_pose(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == ',' || c == ';'; }, ' ');
    std::istringstream words(text);
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        const std::optional<double> number = typed_number(word, "");
        if (!number) { return std::nullopt; }
        numbers.push_back(*number);
    }
    if (numbers.size() != 7) { return std::nullopt; }
    BodyPose pose{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5], numbers[6]}};
    const double length = pose.p.norm();
    // a p that was typed with a few digits has length 1 only to a few per cent
    if (!(length > 0.5) || !(length < 2.0)) { return std::nullopt; }
    pose.p /= length;
    return pose;
}

GivenAnswer judge_pose(const RightAnswer& right, const std::string& given) {
    GivenAnswer judged;
    const std::optional<BodyPose> pose = typed_pose(given);
    if (!pose) {
        judged.note = tr("expected x, y, z [m] and e0, e1, e2, e3; or drag the body");
        return judged;
    }
    judged.understood = true;
    judged.note = tr("You said: {0}", tr("r = {0} m", vector_text(pose->r)));
    if (!right.known || !right.pose) { return judged; }
    const double off = (pose->r - right.pose->r).norm();
    const double turn = pose->turn_from(*right.pose);
    judged.right = off <= right.tolerance && turn <= right.tolerance_rad;
    if (!judged.right) {
        judged.note = followed(
            judged.note + ".",
            tr("Off by {0} m and {1}°.", number_text(off, 3), number_text(turn * kDegreesPerRadian, 3)));
    }
    return judged;
}

}  // namespace

GivenAnswer judge_answer(
    const QuestionView& view, const RightAnswer& right, const Mechanism& mechanism,
    const std::string& given) {
    switch (view.kind) {
        case QuestionView::Kind::choice: return judge_choice(view, right, given);
        case QuestionView::Kind::thing: return judge_thing(view, right, mechanism, given);
        case QuestionView::Kind::pose: return judge_pose(right, given);
        case QuestionView::Kind::number: break;
    }
    return judge_number(view, right, given);
}

std::string pose_text(const BodyPose& pose) {
    std::string text;
    for (const double x : pose.r) { text += number_text(x, 17) + " "; }
    for (const double e : pose.p) { text += number_text(e, 17) + " "; }
    text.pop_back();
    return text;
}

}  // namespace jw
