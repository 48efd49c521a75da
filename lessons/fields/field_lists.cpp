#include "lessons/fields/fields.hpp"

#include "lessons/diagnostics/text_place.hpp"

/// Access to keys that hold lists: numbers, vectors, matrices, names.
namespace jw {

namespace {

std::string in_words(std::size_t count) {
    switch (count) {
        case 2: return "two";
        case 3: return "three";
        case 4: return "four";
        default: return std::to_string(count);
    }
}

}  // namespace

IfGiven<std::vector<double>> Fields::list_in(
    const toml::node& node, const std::string& what, std::size_t count, std::size_t most,
    std::string_view said) {
    const std::string expected = !said.empty() ? std::string(said)
                                 : count != 0  ? in_words(count) + " numbers"
                                               : "a list of 1 to " + std::to_string(most) + " numbers";
    const toml::array* list = node.as_array();
    if (list == nullptr) {
        report(
            Code::wrong_type, span_of(node.source()),
            what + " is " + kind_of(node) + "; expected " + expected);
        return std::nullopt;
    }
    const bool wrong_count = count != 0 ? list->size() != count : list->empty() || list->size() > most;
    if (wrong_count) {
        report(
            Code::wrong_count, span_of(node.source()),
            what + " has " + std::to_string(list->size()) + (list->size() == 1 ? " entry" : " entries") +
                "; expected " + expected);
        return std::nullopt;
    }
    Located<std::vector<double>> out{{}, span_of(node.source())};
    for (const toml::node& entry : *list) {
        const std::string which = "entry " + std::to_string(out.value.size() + 1) + " of " + what;
        if (!entry.is_number()) {
            report(
                Code::wrong_type, span_of(entry.source()),
                which + " is " + kind_of(entry) + "; expected a number");
            return std::nullopt;
        }
        const auto value = number_in(entry, which);
        if (!value) { return std::nullopt; }
        out.value.push_back(*value);
    }
    return out;
}

IfGiven<std::vector<double>> Fields::numbers(
    std::string_view key, std::size_t count, std::size_t most, std::string_view expected) {
    check_described(key, {KeyKind::numbers, KeyKind::tensor});
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    return list_in(*node, in_quotes(key), count, most, expected);
}

bool Fields::is_nested(std::string_view key) {
    const toml::node* node = find(key);
    const toml::array* list = node != nullptr ? node->as_array() : nullptr;
    return list != nullptr && !list->empty() && (*list)[0].is_array();
}

IfGiven<std::vector<Vec3>> Fields::vectors_in(
    std::string_view key, int least, int most, const EntryWords& words, const std::string& expected) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    const toml::array* list = node->as_array();
    const int count = list != nullptr ? static_cast<int>(list->size()) : 0;
    if (list == nullptr || count < least || count > most) {
        const std::string is =
            list == nullptr ? kind_of(*node) : words.before + std::to_string(count) + words.after;
        report(
            list == nullptr ? Code::wrong_type : Code::wrong_count, span_of(node->source()),
            in_quotes(key) + " is " + is + "; expected " + expected);
        return std::nullopt;
    }
    Located<std::vector<Vec3>> out{{}, span_of(node->source())};
    for (const toml::node& each : *list) {
        const std::string number = std::to_string(out.value.size() + 1);
        const auto row = list_in(each, words.one + ' ' + number + " of " + in_quotes(key), 3);
        if (!row) { return std::nullopt; }
        out.value.push_back(Eigen::Map<const Vec3>(row->value.data()));
    }
    return out;
}

IfGiven<Mat3> Fields::matrix(std::string_view key) {
    check_described(key, {KeyKind::tensor});
    const auto rows = vectors_in(key, 3, 3, {"row", "", " rows"}, "three rows of three numbers");
    if (!rows) { return std::nullopt; }
    Located<Mat3> out{Mat3::Zero(), rows->span};
    for (int k = 0; k < 3; ++k) { out.value.row(k) = rows->value[at(k)].transpose(); }
    return out;
}

IfGiven<std::vector<Vec3>> Fields::vectors(std::string_view key) {
    const Key* described = check_described(key, {KeyKind::vectors});
    const int least = described != nullptr ? described->least : 0;
    const int most = described != nullptr ? described->most : static_cast<int>(kLongestList);
    return vectors_in(
        key, least, most, {"entry", "a list of ", ""},
        std::to_string(least) + " to " + std::to_string(most) + " vectors of three numbers");
}

IfGiven<Vec3> Fields::vector(std::string_view key) {
    check_described(key, {KeyKind::vector, KeyKind::direction});
    const toml::node* node = find(key);
    const auto list = node != nullptr ? list_in(*node, in_quotes(key), 3) : std::nullopt;
    if (!list) { return std::nullopt; }
    return Located<Vec3>{Eigen::Map<const Vec3>(list->value.data()), list->span};
}

IfGiven<Vec3> Fields::direction(std::string_view key) {
    check_described(key, {KeyKind::direction});
    const auto v = vector(key);
    // squares of very small numbers are 0, so the norm must not square them
    if (v && v->value.stableNorm() < kShortestDirection) {
        const bool zero = v->value.isZero(0.0);
        report(
            Code::zero_direction, v->span,
            in_quotes(key) +
                (zero ? " has length 0; expected a direction, three numbers not all zero"
                      : " is too short to be a direction, " + short_number(v->value.stableNorm()) +
                            "; expected a length of at least " + short_number(kShortestDirection)));
        return std::nullopt;
    }
    return v;
}

std::vector<TypedText> Fields::typed_numbers(std::string_view key) const {
    std::vector<TypedText> out;
    const auto add = [&](const toml::node& node) {
        if (const auto value = node.value<double>()) {
            const SourceSpan span = span_of(node.source());
            out.push_back({*value, number_at(problems_->source(), span), span});
        }
    };
    const toml::node* node = table_->get(key);
    if (node == nullptr) { return out; }
    if (const toml::array* list = node->as_array()) {
        for (const toml::node& entry : *list) { add(entry); }
    } else {
        add(*node);
    }
    return out;
}

IfGiven<std::vector<Located<std::string>>> Fields::texts(std::string_view key) {
    check_described(key, {KeyKind::texts});
    const toml::node* node = find(key);
    return node != nullptr ? texts_in(*node, std::string(key), "a list of names") : std::nullopt;
}

IfGiven<std::vector<Located<std::string>>> Fields::texts_in(
    const toml::node& node, const std::string& what, std::string_view expected) {
    const toml::array* list = node.as_array();
    if (list == nullptr) {
        wrong_type(what, node, expected);
        return std::nullopt;
    }
    Located<std::vector<Located<std::string>>> out{{}, span_of(node.source())};
    for (const toml::node& entry : *list) {
        if (!entry.is_string()) {
            report(
                Code::wrong_type, span_of(entry.source()),
                "entry " + std::to_string(out.value.size() + 1) + " of " + in_quotes(what) + " is " +
                    kind_of(entry) + "; expected a name in quotes");
            return std::nullopt;
        }
        out.value.push_back({entry.as_string()->get(), span_of(entry.source())});
    }
    return out;
}

}  // namespace jw
