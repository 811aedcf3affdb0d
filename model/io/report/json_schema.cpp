// SPDX-License-Identifier: MIT
#include "io/report/json_schema.h"

#include <algorithm>

namespace io {

namespace {

void writeSchema(JsonWriter& json, const JsonSchema& schema);

void writeObject(JsonWriter& json, const std::vector<JsonSchema>& members) {
    json.key("properties");
    json.beginObject();
    for (const auto& member : members) {
        json.key(member.key.toUtf8().constData());
        writeSchema(json, member);
    }
    json.endObject();
    json.key("required");
    json.beginArray();
    for (const auto& member : members)
        if (member.isRequired) json.value(member.key);
    json.endArray();
    json.member("additionalProperties", false);
}

// `write` writes one item.
void writeArray(JsonWriter& json, const char* key, const auto& items, auto write) {
    if (items.empty()) return;
    json.key(key);
    json.beginArray();
    for (const auto& item : items)
        write(item);
    json.endArray();
}

void writeBody(JsonWriter& json, const JsonSchema& schema) {
    if (schema.type) json.member("type", QString::fromLatin1(schema.type));
    if (!schema.members.empty()) writeObject(json, schema.members);
    for (const JsonSchema& item : schema.items) {
        json.key("items");
        writeSchema(json, item);
    }
    if (schema.minItems) json.member("minItems", *schema.minItems);
    if (schema.maxItems) json.member("maxItems", *schema.maxItems);
    if (schema.minimum) json.member("minimum", *schema.minimum);
    if (schema.maximum) json.member("maximum", *schema.maximum);
    if (!schema.pattern.isEmpty()) json.member("pattern", schema.pattern);
    writeArray(json, "enum", schema.choices, [&](const QByteArray& choice) { json.token(choice); });
    writeArray(json, "anyOf", schema.alternatives, [&](const JsonSchema& each) { writeSchema(json, each); });
}

void writeUnlessNull(JsonWriter& json, const JsonSchema& schema) {
    json.beginObject();
    const QString& text =
        schema.remark.isEmpty() && schema.name.isEmpty() ? schema.description : schema.remark;
    if (!text.isEmpty()) json.member("description", text);
    if (schema.name.isEmpty())
        writeBody(json, schema);
    else
        json.member("$ref", QStringLiteral("#/$defs/") + schema.name);
    json.endObject();
}

void writeSchema(JsonWriter& json, const JsonSchema& schema) {
    if (!schema.isNullable) return writeUnlessNull(json, schema);
    json.beginObject();
    json.key("anyOf");
    json.beginArray();
    writeUnlessNull(json, schema);
    json.beginObject();
    json.member("type", QStringLiteral("null"));
    json.endObject();
    json.endArray();
    json.endObject();
}

// Collects definitions in the order in which they are referred to.
void collectDefinitions(const JsonSchema& schema, std::vector<const JsonSchema*>& found) {
    if (!schema.name.isEmpty()) {
        if (std::ranges::any_of(found, [&](const auto* other) { return other->name == schema.name; })) return;
        found.push_back(&schema);
    }
    for (const JsonSchema& item : schema.items)
        collectDefinitions(item, found);
    for (const JsonSchema& alternative : schema.alternatives)
        collectDefinitions(alternative, found);
    for (const auto& member : schema.members)
        collectDefinitions(member, found);
}

} // namespace

JsonSchema JsonSchema::oneOf(const QStringList& words) {
    JsonSchema schema;
    for (const QString& word : words)
        if (const QByteArray token = '"' + word.toUtf8() + '"'; !schema.choices.contains(token))
            schema.choices << token;
    return schema;
}

JsonSchema either(JsonSchema first, const JsonSchema& second) {
    if (first.maxItems && second.maxItems) first.maxItems = std::max(*first.maxItems, *second.maxItems);
    for (std::size_t i = 0; i < first.items.size() && i < second.items.size(); ++i)
        first.items[i] = either(first.items[i], second.items[i]);
    for (auto& member : first.members) {
        const auto other = std::ranges::find(second.members, member.key, &JsonSchema::key);
        if (other == second.members.end())
            member.isRequired = false;
        else
            member = either(std::move(member), *other);
    }
    for (JsonSchema member : second.members)
        if (std::ranges::find(first.members, member.key, &JsonSchema::key) == first.members.end()) {
            member.isRequired = false;
            first.members.push_back(std::move(member));
        }
    return first;
}

QByteArray schemaText(const JsonSchema& root, const QString& title, const QString& description) {
    std::vector<const JsonSchema*> definitions;
    collectDefinitions(root, definitions);
    JsonWriter json;
    json.beginObject();
    json.member("$schema", QStringLiteral("https://json-schema.org/draft/2020-12/schema"));
    json.member("title", title);
    json.member("description", description);
    json.member("$ref", QStringLiteral("#/$defs/") + root.name);
    json.key("$defs");
    json.beginObject();
    for (const JsonSchema* definition : definitions) {
        json.key(definition->name.toUtf8().constData());
        JsonSchema described = *definition;
        described.name.clear();
        described.remark.clear();
        described.isNullable = false;
        writeSchema(json, described);
    }
    json.endObject();
    json.endObject();
    return json.text();
}

} // namespace io
