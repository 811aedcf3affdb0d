// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/names.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/branch.h"
#include "io/report/json_schema.h"
#include "io/report/json_writer.h"

#include <QString>
#include <QStringList>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

// JSON whose members are listed once: the same list writes the values and describes them in a schema.
namespace io {

class JsonMembers;

// Writer and schema of the values of a type. A type for which there is a function `void members(JsonMembers&,
// const T&)` is an object; a default value of it is listed for the schema.
template <class T> struct JsonOf;

// Lists the members of one object.
class JsonMembers {
public:
    enum class Values { Given, AllNull };
    explicit JsonMembers(JsonWriter& json, Values values = Values::Given)
        : m_json(&json), m_isNull(values == Values::AllNull) {}
    explicit JsonMembers(JsonSchema& schema) : m_schema(&schema) {}

    // Makes a definition of the object, which other parts of the schema refer to.
    void define(const char* name, const char* description = "") {
        if (!m_schema) return;
        m_schema->name = QString::fromUtf8(name);
        m_schema->description = QString::fromUtf8(description);
    }

    template <class T> void operator()(const char* key, const T& value, const char* remark = "") {
        if (m_schema) return describe(key, JsonOf<T>::schema(value), remark);
        m_json->key(key);
        m_isNull ? m_json->null() : JsonOf<T>::write(*m_json, value);
    }

    // A member that is there only where it is true.
    void mark(const char* key, bool isTrue, const char* remark) {
        if (m_schema) {
            describe(key, {.choices = {"true"}}, remark);
            m_schema->members.back().isRequired = false;
        } else if (isTrue && !m_isNull)
            m_json->member(key, true);
    }

private:
    void describe(const char* key, JsonSchema schema, const char* remark) {
        if (*remark) schema.remark = QString::fromUtf8(remark);
        schema.key = QString::fromUtf8(key);
        m_schema->members.push_back(std::move(schema));
    }

    JsonWriter* m_json = nullptr;
    JsonSchema* m_schema = nullptr;
    bool m_isNull = false;
};

template <class T> struct JsonOf {
    static void write(JsonWriter& json, const T& value) {
        if constexpr (std::is_enum_v<T>) {
            json.value(QString::fromLatin1(ifs::nameOf(value)));
        } else {
            json.beginObject(JsonWriter::Layout::Inline);
            JsonMembers out(json);
            members(out, value);
            json.endObject();
        }
    }
    static JsonSchema schema(const T& value) {
        if constexpr (std::is_enum_v<T>) {
            QStringList words;
            for (const auto& each : ifs::names<T>)
                words << QString::fromLatin1(each.id);
            return JsonSchema::oneOf(words);
        } else {
            JsonSchema object{.type = "object"};
            JsonMembers out(object);
            members(out, value);
            return object;
        }
    }
};

// A number, text or truth value as the writer knows it.
template <class T> struct PlainJson {
    static void write(JsonWriter& json, const T& value) { json.value(value); }
};
template <> struct JsonOf<double> : PlainJson<double> {
    static JsonSchema schema(double) { return {.type = "number"}; }
};
template <> struct JsonOf<int> : PlainJson<int> {
    static JsonSchema schema(int) { return {.type = "integer"}; }
};
template <> struct JsonOf<bool> : PlainJson<bool> {
    static JsonSchema schema(bool) { return {.type = "boolean"}; }
};
template <> struct JsonOf<QString> : PlainJson<QString> {
    static JsonSchema schema(const QString&) { return {.type = "string"}; }
};

template <class T> struct JsonOf<std::optional<T>> {
    static void write(JsonWriter& json, const std::optional<T>& value) {
        value ? JsonOf<T>::write(json, *value) : json.null();
    }
    static JsonSchema schema(const std::optional<T>& value) {
        JsonSchema schema = JsonOf<T>::schema(value ? *value : T());
        schema.isNullable = true;
        return schema;
    }
};

template <class T> struct JsonOf<std::vector<T>> {
    static void write(JsonWriter& json, const std::vector<T>& values,
                      JsonWriter::Layout layout = JsonWriter::Layout::Inline) {
        json.beginArray(layout);
        for (const T& value : values)
            JsonOf<T>::write(json, value);
        json.endArray();
    }
    static JsonSchema schema(const std::vector<T>&) {
        return {.type = "array", .items = {JsonOf<T>::schema(T())}};
    }
};

// An array with a line for each item.
template <class T> struct OnLines { std::vector<T> items; };
template <class T> struct JsonOf<OnLines<T>> {
    static void write(JsonWriter& json, const OnLines<T>& value) {
        JsonOf<std::vector<T>>::write(json, value.items, JsonWriter::Layout::Lines);
    }
    static JsonSchema schema(const OnLines<T>& value) { return JsonOf<std::vector<T>>::schema(value.items); }
};

// A value of which the schema says more than its type does.
template <class T, void (*Adapt)(JsonSchema&)> struct Described { T value{}; };
template <class T, void (*Adapt)(JsonSchema&)> struct JsonOf<Described<T, Adapt>> {
    static void write(JsonWriter& json, const Described<T, Adapt>& given) {
        JsonOf<T>::write(json, given.value);
    }
    static JsonSchema schema(const Described<T, Adapt>& given) {
        JsonSchema schema = JsonOf<T>::schema(given.value);
        Adapt(schema);
        return schema;
    }
};

constexpr int noBound = std::numeric_limits<int>::max();
template <int Min, int Max> void within(JsonSchema& schema) {
    schema.minimum = Min;
    if (Max != noBound) schema.maximum = Max;
}
template <int Min = 0, int Max = noBound> using Whole = Described<int, within<Min, Max>>;
using NonNegative = Described<double, within<0, noBound>>;
inline std::optional<NonNegative> nonNegative(const std::optional<double>& value) {
    return value ? std::optional(NonNegative{*value}) : std::nullopt;
}

template <int Most> void atLeast3(JsonSchema& schema) {
    schema.minItems = 3;
    if (Most != noBound) schema.maxItems = Most;
}
template <class T, int Most = noBound> using AtLeast3 = Described<std::vector<T>, atLeast3<Most>>;

// A word of maps by their numbers in the file, counted from 1: the k-th symbol is the map in rows[k].
inline void describeWord(JsonSchema& schema) {
    schema.name = QStringLiteral("word");
    schema.description = QStringLiteral("Numbers of maps, the map applied last first.");
}
using NumberedWord = Described<std::vector<Whole<1>>, describeWord>;
inline NumberedWord numbered(const ifs::Word& word, const std::vector<std::size_t>& rows) {
    NumberedWord result;
    for (const int symbol : word)
        result.value.push_back({int(rows[std::size_t(symbol)]) + 1});
    return result;
}

template <int Rows, int Columns> struct JsonOf<Eigen::Matrix<double, Rows, Columns>> {
    using Matrix = Eigen::Matrix<double, Rows, Columns>;
    static void write(JsonWriter& json, const Matrix& matrix) {
        json.beginArray(JsonWriter::Layout::Inline);
        for (int row = 0; row < Rows; ++row)
            if constexpr (Columns == 1)
                json.value(matrix[row]);
            else
                JsonOf<ifs::Vector<Columns>>::write(json, matrix.row(row).transpose());
        json.endArray();
    }
    static JsonSchema schema(const Matrix&) {
        JsonSchema schema{.type = "array", .minItems = 2, .maxItems = 3};
        schema.name = Columns == 1 ? QStringLiteral("vector") : QStringLiteral("matrix");
        schema.description = Columns == 1 ? QStringLiteral("Two numbers in the plane, three in space.")
                                          : QStringLiteral("Rows.");
        if constexpr (Columns == 1)
            schema.items.push_back({.type = "number"});
        else
            schema.items.push_back(JsonOf<ifs::Vector<Columns>>::schema({}));
        return schema;
    }
};

} // namespace io
