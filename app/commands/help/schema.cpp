#include "app/commands/program/add_command.hpp"
#include "app/session/output/json.hpp"
#include "lessons/format/key.hpp"
#include "lessons/typed/typed.hpp"

namespace jw {

namespace {

// editors for TOML know draft 7
constexpr const char* kDraft = "http://json-schema.org/draft-07/schema#";

// BCP 47, as accepted by lessons/text/text.hpp
constexpr const char* kLanguageTag =
    "[a-z]{2,3}(-[A-Z][a-z]{3})?(-([A-Z]{2}|[0-9]{3}))?(-([a-z0-9]{5,8}|[0-9][a-z0-9]{3}))*$";

Json definition(std::string_view name) { return {{"$ref", "#/definitions/" + std::string(name)}}; }

Json list_of(const Json& entry, int least, int most) {
    Json list{{"type", "array"}, {"items", entry}};
    if (least > 0) { list["minItems"] = least; }
    if (most > 0) { list["maxItems"] = most; }
    return list;
}

Json number_between(const char* least_key, double least) {
    return {{"type", "number"}, {least_key, least}, {"maximum", kLargestNumber}};
}

Json text_of(const Key& key) {
    Json any{{"type", "string"}};
    if (key.words == nullptr) { return any; }
    any["pattern"] = key.pattern;
    return {{"anyOf", Json::array({Json{{"enum", key.words()}}, any})}};
}

/// J' as three or six numbers or as three rows of three.
Json tensor() {
    const Json number = definition("number");
    return {
        {"anyOf",
         Json::array({list_of(number, 3, 3), list_of(number, 6, 6), list_of(list_of(number, 3, 3), 3, 3)})}};
}

Json value_of(const Key& key) {
    switch (key.kind) {
        case KeyKind::text: return text_of(key);
        case KeyKind::words:
        case KeyKind::plain_words:
        case KeyKind::formula: return {{"type", "string"}};
        case KeyKind::word: return {{"enum", key.words()}};
        case KeyKind::number: return definition("number");
        case KeyKind::positive: return number_between("exclusiveMinimum", 0.0);
        case KeyKind::not_negative: return number_between("minimum", 0.0);
        case KeyKind::whole_number:
            return {{"type", "integer"}, {"minimum", key.least}, {"maximum", key.most}};
        case KeyKind::flag: return {{"type", "boolean"}};
        case KeyKind::vector:
        case KeyKind::direction: return definition("vector");
        case KeyKind::numbers: return list_of(definition("number"), key.least, key.most);
        case KeyKind::vectors: return list_of(definition("vector"), key.least, key.most);
        case KeyKind::tensor: return tensor();
        case KeyKind::texts:
        case KeyKind::list_of_words: return list_of({{"type", "string"}}, key.least, key.most);
        case KeyKind::table: return definition(key.table);
        case KeyKind::tables: {
            const Json entry = definition(key.table);
            return {{"anyOf", Json::array({list_of(entry, 0, 0), entry})}};
        }
        case KeyKind::any: break;
    }
    return Json::object();
}

Json property(const SpelledKey& key) {
    const Json value = value_of(*key.key);
    Json described{{"description", key.about}};
    // draft 7 ignores everything beside a reference
    if (value.contains("$ref")) {
        described["allOf"] = Json::array({value});
    } else {
        described.update(value);
    }
    return described;
}

/// Texts of a table in another language, under its tag; a key of the table itself is not a language.
void add_languages(const KeyTable& table, Json& out) {
    Json texts = Json::object();
    std::string keys;
    for (const SpelledKey& key : spelled_keys(table)) {
        if (is_translated(key.key->kind)) { texts[key.name] = property(key); }
        keys += (keys.empty() ? "" : "|") + key.name;
    }
    if (texts.empty()) { return; }
    out["patternProperties"]["^(?!(" + keys + ")$)" + kLanguageTag] = {
        {"description", "the same texts in another language"},
        {"type", "object"},
        {"properties", texts},
        {"additionalProperties", false}};
}

Json table_of(const KeyTable& table) {
    Json properties = Json::object();
    Json required = Json::array();
    for (const SpelledKey& key : spelled_keys(table)) {
        properties[key.name] = property(key);
        if (key.key->required) { required.push_back(key.name); }
    }
    Json out{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    add_languages(table, out);
    if (!required.empty()) { out["required"] = required; }
    if (table.exactly_one) { out["minProperties"] = out["maxProperties"] = 1; }
    return out;
}

struct SchemaOptions {};

/// JSON Schema of lesson files, for editors: docs/lesson.schema.json.
Exit write_schema(const SchemaOptions& /*options*/, const Streams& streams) {
    const std::span<const KeyTable> tables = key_tables();
    Json schema{
        {"$schema", kDraft},
        {"title", "Jointwise lesson"},
        {"description", "Written by 'jointwise schema' from lessons/format; do not edit."}};
    schema.update(table_of(tables.front()));
    Json& definitions = schema["definitions"];
    definitions["number"] = {{"type", "number"}, {"minimum", -kLargestNumber}, {"maximum", kLargestNumber}};
    definitions["vector"] = list_of(definition("number"), 3, 3);
    for (const KeyTable& table : tables.subspan(1)) { definitions[table.name] = table_of(table); }
    streams.out << json_document(schema);
    return Exit::done;
}

}  // namespace

void add_schema(const CommandLine& line) {
    add_command<SchemaOptions>(
        line, "schema", "write the JSON Schema of lesson files, for editors", write_schema,
        "Example: jointwise schema > lesson.schema.json");
}

}  // namespace jw
