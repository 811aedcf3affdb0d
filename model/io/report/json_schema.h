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
    QString name{};        // of a definition that is referred to; empty: described where it occurs
    QString description{}; // of all values of this type
    QString remark{};      // on the value in this place
    const char* type = nullptr;
    QString pattern{};
    std::optional<double> minimum{}, maximum{};
    std::optional<int> minItems{}, maxItems{};
    QList<QByteArray> choices{};       // as they are written; nothing else is allowed
    std::vector<JsonSchema> items{};   // one, of an array
    std::vector<JsonSchema> members{}; // of an object, which has no others
    std::vector<JsonSchema> alternatives{};
    bool isNullable = false;
    QString key{};          // of a member
    bool isRequired = true; // as a member

    static JsonSchema oneOf(const QStringList& words);
};

// The schema of what fits one of the two. A member that only one of them has is not required.
JsonSchema either(JsonSchema first, const JsonSchema& second);

// The document: a reference to the named schema `root`, and the definitions of all that have names.
QByteArray schemaText(const JsonSchema& root, const QString& title, const QString& description);

} // namespace io
