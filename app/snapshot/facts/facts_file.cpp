#include "app/snapshot/facts/facts_file.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw::snapshot {

namespace {

constexpr const char* kFormat = "jointwise snapshot";
constexpr int kVersion = 1;
constexpr double kMostCounted = 1e9;

constexpr std::array kWeights{
    EnumWord<Weight>{Weight::failure, "failure"}, EnumWord<Weight>{Weight::rank, "rank"},
    EnumWord<Weight>{Weight::count, "count"},     EnumWord<Weight>{Weight::pose, "pose"},
    EnumWord<Weight>{Weight::text, "text"},       EnumWord<Weight>{Weight::quantity, "quantity"},
    EnumWord<Weight>{Weight::detail, "detail"}};

/// ["rank", "rank", 5], ["pose", "crank · r · x", 0.25, "m", 1e-06], ["text", "title", "Joint A"]
Json json_of(const Fact& fact) {
    Json json = Json::array({word_of(kWeights, fact.weight), fact.name});
    if (!fact.value) {
        json.push_back(fact.text);
    } else if (fact.tolerance <= 0.0) {
        json.push_back(std::lround(*fact.value));
    } else {
        json.push_back(std::strtod(short_decimal(fact).c_str(), nullptr));
        json.push_back(fact.unit);
        json.push_back(fact.tolerance);
    }
    return json;
}

[[noreturn]] void fail(const std::string& file, const std::string& why) {
    throw std::runtime_error(
        "'" + file + "' is not a snapshot of this program: " + why +
        "; expected a file that 'jointwise snapshot record' has written");
}

std::string text_in(const Json& json, const std::string& file) {
    if (!json.is_string()) { fail(file, "a text is " + std::string(json.type_name())); }
    return json.get<std::string>();
}

double number_in(const Json& json, const std::string& file) {
    if (!json.is_number()) { fail(file, "a number is " + std::string(json.type_name())); }
    return json.get<double>();
}

Fact fact_of(const Json& json, const std::string& file) {
    if (!json.is_array() || (json.size() != 3 && json.size() != 5)) {
        fail(file, "a fact is not a list of three or five entries");
    }
    Fact fact;
    const std::string weight = text_in(json[0], file);
    const auto known = value_of(kWeights, weight);
    if (!known) { fail(file, "a fact has the weight " + in_quotes(weight)); }
    fact.weight = *known;
    fact.name = text_in(json[1], file);
    if (json.size() == 3 && json[2].is_string()) {
        fact.text = json[2].get<std::string>();
    } else {
        fact.value = number_in(json[2], file);
    }
    if (json.size() == 3 && fact.value &&
        (!json[2].is_number_integer() || std::abs(*fact.value) > kMostCounted)) {
        fail(file, in_quotes(fact.name) + " is not a count");
    }
    if (json.size() == 5) {
        fact.unit = text_in(json[3], file);
        fact.tolerance = number_in(json[4], file);
        if (!(fact.tolerance > 0.0)) { fail(file, "a tolerance is not above zero"); }
    }
    return fact;
}

/// The value of a key that must be there.
const Json& at(const Json& json, const char* key, const std::string& file) {
    const auto found = json.find(key);
    if (found == json.end()) { fail(file, "it has no \"" + std::string(key) + "\""); }
    return *found;
}

std::map<std::string, std::string> words_in(const Json& json, const std::string& file) {
    if (!json.is_object()) { fail(file, "a table of words is " + std::string(json.type_name())); }
    std::map<std::string, std::string> words;
    for (const auto& [key, value] : json.items()) { words[key] = text_in(value, file); }
    return words;
}

}  // namespace

std::string text_of(const Record& record) {
    const Json head{{"format", kFormat},      {"version", kVersion},       {"name", record.name},
                    {"title", record.title},  {"blessed", record.blessed}, {"drawn_with", record.drawn_with},
                    {"things", record.things}};
    std::string text = json_document(head);
    // the head without its closing brace, then the facts, one per line
    text.erase(text.find_last_of('}'));
    text.erase(text.find_last_not_of('\n') + 1);
    text += ",\n \"facts\": [";
    const char* separator = "\n  ";
    for (const Fact& fact : record.facts) {
        std::string line = json_document(json_of(fact), -1);
        line.erase(line.find_last_not_of('\n') + 1);
        text += separator + line;
        separator = ",\n  ";
    }
    return text + "\n ]\n}\n";
}

Record record_of(const std::string& text, const std::string& file) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded() || !json.is_object()) { fail(file, "it is not JSON, or cut off"); }
    if (at(json, "format", file) != kFormat) { fail(file, "its \"format\" is another one"); }
    const double version = number_in(at(json, "version", file), file);
    if (version != kVersion) {
        fail(
            file,
            "its version is " + short_number(version) + ", this program reads " + std::to_string(kVersion));
    }
    Record record;
    record.name = text_in(at(json, "name", file), file);
    record.title = text_in(at(json, "title", file), file);
    record.drawn_with = words_in(at(json, "drawn_with", file), file);
    record.things = words_in(at(json, "things", file), file);
    const Json& blessed = at(json, "blessed", file);
    const Json& facts = at(json, "facts", file);
    if (!blessed.is_array() || !facts.is_array()) { fail(file, "a list is none"); }
    for (const Json& reason : blessed) { record.blessed.push_back(text_in(reason, file)); }
    std::set<std::string> names;
    for (const Json& json_fact : facts) {
        record.facts.push_back(fact_of(json_fact, file));
        const std::string& fact = record.facts.back().name;
        if (!names.insert(fact).second) { fail(file, in_quotes(fact) + " is in it twice"); }
    }
    return record;
}

}  // namespace jw::snapshot
