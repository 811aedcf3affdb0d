// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/json_writer.h"

#include <QList>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace io {

// The part of JSON Schema (draft 2020-12) that describes what JsonMembers writes.
struct JsonSchema {
    struct Member;

    QString name{};        // name of a definition; empty: described in place
    QString description{}; // description of all values of this type
    QString remark{};      // remark on the value in this place
    const char* type = nullptr;
    QString pattern{};
    std::optional<double> minimum{}, maximum{};
    std::optional<int> minItems{}, maxItems{};
    QList<QByteArray> choices{};     // complete list of allowed JSON texts
    std::vector<JsonSchema> items{}; // type of the elements of an array; at most one
    std::vector<Member> members{};   // complete list of an object's members
    std::vector<JsonSchema> alternatives{};
    bool isNullable = false;

    static JsonSchema oneOf(const QStringList& words);
};

struct JsonSchema::Member {
    QString key;
    JsonSchema schema;
    bool isRequired = true;
};

// The schema of what fits one of the two. A member that only one of them has is not required.
JsonSchema either(JsonSchema first, const JsonSchema& second);

// The document: a reference to the named schema `root`, and the definitions of all that have names.
QByteArray schemaText(const JsonSchema& root, const QString& title, const QString& description);

} // namespace io
