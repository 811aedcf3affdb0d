// SPDX-License-Identifier: MIT
#include "io/report/info_json.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "document/moments/animated_fractal.h"
#include "io/collection_reader.h"
#include "io/report/facts.h"
#include "io/report/json_members.h"

#include <functional>
#include <numeric>

namespace io {

namespace {

template <int Dim> struct ReportedBranch {
    NumberedWord address;
    document::StoredBranch<Dim> stored;
};

template <int Dim> void members(JsonMembers& out, const ReportedBranch<Dim>& reported) {
    out.define("", "An affine change of the part of the attractor at this address.");
    out("address", reported.address);
    out("recurs", reported.stored.recurs,
        "Whether the same branch is changed again inside this one, and so on.");
    out("linear", reported.stored.branch.change.linear);
    out("translation", reported.stored.branch.change.translation);
}

template <int Dim> OnLines<ReportedBranch<Dim>> reportedBranches(const document::Shape<Dim>& shape) {
    std::vector<std::size_t> rows(shape.system.maps.size());
    std::iota(rows.begin(), rows.end(), std::size_t(0));
    OnLines<ReportedBranch<Dim>> reported;
    for (const auto& stored : document::storedBranches(shape))
        reported.items.push_back({numbered(stored.branch.word, rows), stored});
    return reported;
}

void describeDimension(JsonSchema& schema) {
    schema = {.choices = {"2", "3"}};
}
using Dimension = Described<int, describeDimension>;

std::optional<Dimension> dimensionOf(const document::Fractal& fractal) {
    const int dimension = document::dimension(fractal);
    return dimension == 0 ? std::nullopt : std::optional(Dimension{dimension});
}

void listHead(JsonMembers& out, const document::Fractal& fractal) {
    out("name", fractal.name);
    out("dimension", dimensionOf(fractal), "null for an entry that could not be read");
    out("loaded", dimensionOf(fractal).has_value());
}

struct ListedEntry {
    int number = 0;
    document::Fractal fractal{};
};

void members(JsonMembers& out, const ListedEntry& entry) {
    out.define("listed", "All there is of an entry with --list.");
    out("number", Whole<1>{entry.number}, "Of the entry in the file, counted from 1.");
    listHead(out, entry.fractal);
    std::optional<Whole<>> count;
    if (const auto* plane = document::system2(entry.fractal)) count = {int(plane->maps.size())};
    if (const auto* space = document::system3(entry.fractal)) count = {int(space->maps.size())};
    out("map_count", count);
}

template <int Dim> void listFacts(JsonMembers& out, const FactSource<Dim>& source) {
    for (const Fact& row : facts(source))
        for (const auto& list : row.members)
            list(out);
}

template <int Dim>
void listShape(JsonMembers& out, const document::Shape<Dim>& shape, const document::Entry& entry,
               const InfoSubject& subject) {
    const ifs::Facts<Dim> facts = factsFor(ifs::expanded(shape.system), entry, subject);
    listFacts<Dim>(out, {.facts = facts, .shape = &shape});
    out("moved_branches", reportedBranches(shape));
}

// Lists all facts as null, and no moved branches.
void listUnread(JsonWriter& json, JsonMembers& out) {
    JsonMembers nulls(json, JsonMembers::Values::AllNull);
    const document::Shape<2> empty;
    const ifs::Facts<2> none;
    listFacts<2>(nulls, {.facts = none, .shape = &empty});
    out("moved_branches", reportedBranches(empty));
}

// Writes the facts of the moment asked for; the animation is that of the entry.
void writeEntry(JsonWriter& json, const document::Entry& entry, const InfoSubject& subject) {
    const document::Fractal fractal = momentOf(entry, subject);
    json.beginObject();
    JsonMembers out(json);
    listHead(out, fractal);
    if (!dimensionOf(fractal)) listUnread(json, out);
    if (const auto* plane = document::plane(fractal)) listShape(out, *plane, entry, subject);
    if (const auto* space = document::space(fractal)) listShape(out, *space, entry, subject);
    out("animation", document::animationFacts(*entry.fractal), "Of the entry, also with --frame.");
    json.endObject();
}

template <int Dim> JsonSchema entrySchema() {
    JsonSchema schema{.type = "object"};
    JsonMembers out(schema);
    out.define("entry");
    listHead(out, {});
    const std::size_t head = schema.members.size();
    const document::Shape<Dim> empty;
    const ifs::Facts<Dim> none;
    listFacts<Dim>(out, {.facts = none, .shape = &empty});
    for (std::size_t k = head; k < schema.members.size(); ++k) // of an entry that could not be read
        schema.members[k].isNullable |= schema.members[k].isRequired;
    out("moved_branches", reportedBranches(empty));
    out("animation", document::animationFacts({}), "Of the entry, also with --frame.");
    return schema;
}

// `write` writes the entry of an index.
struct Entries {
    qsizetype count = 0;
    std::function<void(JsonWriter&, qsizetype)> write{};
};

void describeFormat(JsonSchema& schema) {
    schema = JsonSchema::oneOf(collectionFormats());
}

void listReport(JsonMembers& out, const InfoSubject& subject, const Entries& entries) {
    out.define("report");
    out("file", subject.fileName,
        "As given; a byte of the name that is not UTF-8 is a lone surrogate U+DC80 to U+DCFF.");
    out("format", Described<QString, describeFormat>{subject.format}, "What the file was read as.");
    out("entries", entries);
    out("problems", OnLines<document::Problem>{{subject.problems.begin(), subject.problems.end()}});
}

QByteArray report(const InfoSubject& subject, const Entries& entries) {
    JsonWriter json;
    json.beginObject();
    JsonMembers out(json);
    listReport(out, subject, entries);
    json.endObject();
    return json.text();
}

void describeRate(JsonSchema& schema) {
    schema.pattern = QStringLiteral("^[0-9]+/[0-9]+$");
}

void describeSeverity(JsonSchema& schema) {
    schema = JsonSchema::oneOf({QStringLiteral("error"), QStringLiteral("warning")});
}

} // namespace

static void members(JsonMembers& out, const document::AnimationFacts& facts) {
    out("fps",
        Described<QString, describeRate>{
            QStringLiteral("%1/%2").arg(facts.rate.frames).arg(facts.rate.seconds)},
        "Frames per seconds.");
    out("frames", Whole<1>{facts.length}, "L: keys are at frames 0 to L.");
    out("loop", facts.loop);
    out("tracks", Whole<>{facts.tracks});
}

static void members(JsonMembers& out, const document::Problem& problem) {
    const bool isError = problem.severity == document::Problem::Severity::Error;
    const auto place = [](int number) { return number > 0 ? std::optional(Whole<1>{number}) : std::nullopt; };
    out.define("problem");
    out("entry", problem.entry.isEmpty() ? std::nullopt : std::optional(problem.entry));
    out("line", place(problem.line));
    out("column", place(problem.column));
    out("severity",
        Described<QString, describeSeverity>{isError ? QStringLiteral("error") : QStringLiteral("warning")});
    out("message", problem.message);
}

template <> struct JsonOf<Entries> {
    static void write(JsonWriter& json, const Entries& entries) {
        json.beginArray();
        for (qsizetype i = 0; i < entries.count; ++i)
            entries.write(json, i);
        json.endArray();
    }
    static JsonSchema schema(const Entries&) {
        return {.type = "array",
                .items = {{.alternatives = {either(entrySchema<2>(), entrySchema<3>()),
                                            JsonOf<ListedEntry>::schema({})}}}};
    }
};

QByteArray infoJson(const InfoSubject& given) {
    InfoSubject subject = given;
    subject.remark = [&](const document::Problem& problem) {
        subject.problems << problem;
        if (given.remark) given.remark(problem);
    };
    return report(subject, {subject.entries.size(), [&](JsonWriter& json, qsizetype i) {
                                if (subject.begun) subject.begun(i);
                                writeEntry(json, subject.entries[i], subject);
                            }});
}

QByteArray listJson(const InfoSubject& subject, const QList<qsizetype>& numbers) {
    return report(subject,
                  {subject.entries.size(), [&](JsonWriter& json, qsizetype i) {
                       JsonOf<ListedEntry>::write(json, {int(numbers[i]), *subject.entries[i].fractal});
                   }});
}

QByteArray infoSchema() {
    JsonSchema schema{.type = "object"};
    JsonMembers out(schema);
    listReport(out, {}, {});
    return schemaText(
        schema, QStringLiteral("Output of barycage-cli info --json"),
        QStringLiteral("A fact that could not be established is null, never a guess. Numbers have as "
                       "many digits as it takes to read back the same double. Maps and addresses "
                       "count from 1, in the order of the file."));
}

} // namespace io
