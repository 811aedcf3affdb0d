// SPDX-License-Identifier: MIT
#include "io/report/json_members.h"
#include "support/named_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <optional>
#include <vector>

namespace {

enum class Colour { Red, Blue };

struct Inner {
    double width = 0;
    bool isRound = false;
};

void members(io::JsonMembers& out, const Inner& inner) {
    out.define("inner", "What is inside.");
    out("width", io::NonNegative{inner.width}, "Never negative.");
    out.mark("round", inner.isRound, "Only where it is true.");
}

struct Outer {
    std::optional<Inner> inner;
    std::vector<io::Whole<1>> numbers;
    Colour colour = Colour::Blue;
};

void members(io::JsonMembers& out, const Outer& outer) {
    out("inner", outer.inner);
    out("numbers", outer.numbers);
    out("colour", outer.colour);
}

} // namespace

template <>
inline constexpr auto ifs::names<Colour> = std::to_array<ifs::Named<Colour>>({
    {Colour::Red, "red"},
    {Colour::Blue, "blue"},
});

class JsonMembersTest : public QObject {
    Q_OBJECT

private:
    static QByteArray text(const Outer& outer) {
        io::JsonWriter json;
        io::JsonOf<Outer>::write(json, outer);
        return json.text();
    }

    static QJsonObject schema(io::JsonSchema schema) {
        schema.name = QStringLiteral("root");
        return QJsonDocument::fromJson(io::schemaText(schema, QStringLiteral("t"), QStringLiteral("d")))
            .object()[QStringLiteral("$defs")]
            .toObject();
    }

private slots:
    void valuesAreWrittenInTheirOrder() {
        QCOMPARE(text({Inner{2.5, true}, {{1}, {7}}, Colour::Red}),
                 QByteArray(R"({"inner": {"width": 2.5, "round": true}, "numbers": [1, 7], "colour": "red"})"
                            "\n"));
        QCOMPARE(text({}), QByteArray(R"({"inner": null, "numbers": [], "colour": "blue"})"
                                      "\n"));
    }

    void theSameListIsTheSchema() {
        const QJsonObject all = schema(io::JsonOf<Outer>::schema({}));
        const QJsonObject root = all[QStringLiteral("root")].toObject();
        QCOMPARE(root[QStringLiteral("required")].toArray(),
                 QJsonArray::fromStringList(
                     {QStringLiteral("inner"), QStringLiteral("numbers"), QStringLiteral("colour")}));
        const QJsonObject members = root[QStringLiteral("properties")].toObject();
        QCOMPARE(members[QStringLiteral("colour")][QStringLiteral("enum")].toArray(),
                 QJsonArray::fromStringList({QStringLiteral("red"), QStringLiteral("blue")}));
        QCOMPARE(members[QStringLiteral("numbers")][QStringLiteral("items")][QStringLiteral("minimum")], 1);
        QCOMPARE(members[QStringLiteral("inner")][QStringLiteral("anyOf")][0][QStringLiteral("$ref")],
                 QStringLiteral("#/$defs/inner"));
        const QJsonObject inner = all[QStringLiteral("inner")].toObject();
        QCOMPARE(inner[QStringLiteral("description")], QStringLiteral("What is inside."));
        QCOMPARE(inner[QStringLiteral("required")].toArray(),
                 QJsonArray::fromStringList({QStringLiteral("width")}));
        QCOMPARE(inner[QStringLiteral("properties")][QStringLiteral("width")][QStringLiteral("description")],
                 QStringLiteral("Never negative."));
    }

    void whatIsAbsentIsNull() {
        io::JsonWriter json;
        json.beginObject(io::JsonWriter::Layout::Inline);
        io::JsonMembers out(json, io::JsonMembers::Values::AllNull);
        members(out, Outer{Inner{1, true}, {{1}}, Colour::Red});
        json.endObject();
        QCOMPARE(json.text(), QByteArray("{\"inner\": null, \"numbers\": null, \"colour\": null}\n"));
    }

    // As of the plane and of space: more vertices, and members that only one of them has.
    void schemasOfTwoKindsFitBoth() {
        const auto polygon = io::JsonOf<io::AtLeast3<io::Whole<>, 3>>::schema({});
        const auto polyhedron = io::JsonOf<io::AtLeast3<io::Whole<>, 4>>::schema({});
        io::JsonSchema flat{.type = "object"}, solid{.type = "object"};
        const auto member = [](const char* key, io::JsonSchema schema) {
            schema.key = QString::fromLatin1(key);
            return schema;
        };
        flat.members = {member("corners", polygon), member("area", {.type = "number"})};
        solid.members = {member("corners", polyhedron), member("volume", {.type = "number"})};
        const QJsonObject root = schema(io::either(flat, solid))[QStringLiteral("root")].toObject();
        QCOMPARE(root[QStringLiteral("required")].toArray(),
                 QJsonArray::fromStringList({QStringLiteral("corners")}));
        const QJsonObject members = root[QStringLiteral("properties")].toObject();
        QCOMPARE(members.keys(),
                 QStringList({QStringLiteral("area"), QStringLiteral("corners"), QStringLiteral("volume")}));
        QCOMPARE(members[QStringLiteral("corners")][QStringLiteral("maxItems")], 4);
        QCOMPARE(members[QStringLiteral("corners")][QStringLiteral("minItems")], 3);
    }
};

BARYCAGE_TEST(JsonMembersTest);
#include "json_members_test.moc"
