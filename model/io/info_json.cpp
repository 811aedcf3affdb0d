// SPDX-License-Identifier: MIT
#include "ifs/facts.h"
#include "io/info_report.h"
#include "io/json_writer.h"

namespace io {

namespace {

using Layout = JsonWriter::Layout;

template <int Dim> void writeVector(JsonWriter& json, const ifs::Vector<Dim>& v) {
    json.beginArray(Layout::Inline);
    for (int i = 0; i < Dim; ++i)
        json.value(double(v[i]));
    json.endArray();
}

template <int Dim> void writeMatrix(JsonWriter& json, const ifs::Matrix<Dim>& m) {
    json.beginArray(Layout::Inline);
    for (int row = 0; row < Dim; ++row)
        writeVector<Dim>(json, m.row(row).transpose());
    json.endArray();
}

template <int Dim, typename Points> void writePoints(JsonWriter& json, const Points& points) {
    json.beginArray(Layout::Inline);
    for (const ifs::Vector<Dim>& point : points)
        writeVector<Dim>(json, point);
    json.endArray();
}

void writeNull(JsonWriter& json, const char* key) {
    json.key(key);
    json.null();
}

template <int Dim> void writeMap(JsonWriter& json, const ifs::WeightedMap<Dim>& map, double probability) {
    json.beginObject(Layout::Inline);
    json.key("linear");
    writeMatrix<Dim>(json, map.map.linear);
    json.key("translation");
    writeVector<Dim>(json, map.map.translation);
    json.member("weight", probability);
    json.member("weight_in_file", map.weight);
    json.member("norm", ifs::spectralNorm<Dim>(map.map.linear));
    json.member("determinant", ifs::determinant<Dim>(map.map.linear));
    json.key("fixed_point");
    if (const auto fixed = ifs::fixedPoint(map.map))
        writeVector<Dim>(json, *fixed);
    else
        json.null();
    json.endObject();
}

QString verdictName(ifs::Verdict verdict) {
    switch (verdict) {
    case ifs::Verdict::Hyperbolic:
        return QStringLiteral("hyperbolic");
    case ifs::Verdict::EventuallyContractive:
        return QStringLiteral("eventually_contractive");
    case ifs::Verdict::Undecided:
        return QStringLiteral("undecided");
    case ifs::Verdict::None:
    case ifs::Verdict::Empty:
        break;
    }
    return QStringLiteral("none");
}

// The contraction factor is known only where one was proved, or disproved by a witness.
void writeExistence(JsonWriter& json, const ifs::Existence& existence) {
    const bool settled =
        existence.verdict != ifs::Verdict::Undecided && existence.verdict != ifs::Verdict::Empty;
    json.key("attractor");
    json.beginObject(Layout::Inline);
    json.member("verdict", verdictName(existence.verdict));
    json.member("contractivity", settled ? std::optional(existence.contractivity) : std::nullopt);
    json.key("word_length");
    if (settled)
        json.value(existence.verdict == ifs::Verdict::None ? int(existence.witness.size())
                                                           : existence.wordLength);
    else
        json.null();
    json.endObject();
}

template <int Dim> void writeMoments(JsonWriter& json, const ifs::Facts<Dim>& facts) {
    if (!facts.mean)
        writeNull(json, "mean");
    else {
        json.key("mean");
        writeVector<Dim>(json, *facts.mean);
    }
    if (!facts.moments) return writeNull(json, "covariance");
    json.key("covariance");
    writeMatrix<Dim>(json, facts.moments->covariance);
}

template <int Dim> void writeBox(JsonWriter& json, const std::optional<ifs::BoundingBox<Dim>>& box) {
    if (!box) return writeNull(json, "bounding_box");
    json.key("bounding_box");
    json.beginObject(Layout::Inline);
    json.key("min");
    writeVector<Dim>(json, box->min);
    json.key("max");
    writeVector<Dim>(json, box->max);
    json.member("error", box->error);
    json.endObject();
}

template <int Dim>
void writeSimplex(JsonWriter& json, const std::optional<ifs::CanonicalSimplex<Dim>>& simplex) {
    if (!simplex) return writeNull(json, "canonical_simplex");
    QString orientation;
    for (const int sign : simplex->orientation)
        orientation += sign > 0 ? u'+' : u'-';
    json.key("canonical_simplex");
    json.beginObject(Layout::Inline);
    json.member("orientation", orientation);
    json.member("leg", simplex->leg);
    json.key("vertices");
    writePoints<Dim>(json, simplex->vertices);
    json.member("error", simplex->error);
    json.endObject();
}

// Maps counted from 1, in the order of the file.
void writeWord(JsonWriter& json, const char* key, const ifs::Word& word,
               const std::vector<std::size_t>& places) {
    json.key(key);
    json.beginArray(Layout::Inline);
    for (const int symbol : word)
        json.value(int(places[std::size_t(symbol)]) + 1);
    json.endArray();
}

// One address for each vertex, null where none is known.
void writeAddresses(JsonWriter& json, const ifs::Facts<2>& facts) {
    json.key("addresses");
    json.beginArray(Layout::Inline);
    for (const auto& point : facts.extremePoints) {
        if (!point) {
            json.null();
            continue;
        }
        json.beginObject(Layout::Inline);
        writeWord(json, "prefix", point->prefix, facts.active.index);
        writeWord(json, "period", point->period, facts.active.index);
        json.endObject();
    }
    json.endArray();
}

template <int Dim> void writeHull(JsonWriter& json, const ifs::Facts<Dim>& facts) {
    const auto& hull = facts.hull;
    if (!hull) return writeNull(json, "hull");
    json.key("hull");
    json.beginObject(Layout::Inline);
    json.key("vertices");
    writePoints<Dim>(json, hull->vertices);
    if constexpr (Dim == 2) {
        json.member("area", hull->area);
        writeAddresses(json, facts);
    } else {
        json.member("volume", hull->volume);
        json.key("facets");
        json.beginArray(Layout::Inline);
        for (const auto& facet : hull->facets) {
            json.beginArray(Layout::Inline);
            for (const int corner : facet)
                json.value(corner);
            json.endArray();
        }
        json.endArray();
    }
    json.member("error", hull->error);
    json.endObject();
}

void writeCage(JsonWriter& json, const std::optional<ifs::ControlCage<2>>& cage) {
    if (!cage) return writeNull(json, "cage");
    json.key("cage");
    json.beginObject(Layout::Inline);
    json.key("rest");
    writePoints<2>(json, cage->rest);
    json.key("current");
    writePoints<2>(json, cage->current);
    const bool isSimplex = cage->rest.size() == 3;
    const bool bends = cage->deformation == ifs::Deformation::Bend;
    json.member("deformation", isSimplex ? QStringLiteral("affine")
                               : bends   ? QStringLiteral("bend")
                                         : QStringLiteral("affine_fit"));
    json.endObject();
}

template <int Dim>
void writeSystem(JsonWriter& json, const ifs::IteratedFunctionSystem<Dim>& system,
                 const InfoSubject& subject) {
    const ifs::Facts<Dim> facts = ifs::factsOf(system, subject.hullTolerance);
    json.key("maps");
    json.beginArray();
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        writeMap(json, system.maps[i], facts.probabilities[i]);
    json.endArray();
    writeExistence(json, facts.existence);
    writeMoments<Dim>(json, facts);
    writeBox<Dim>(json, facts.box);
    writeSimplex<Dim>(json, facts.simplex);
    writeHull<Dim>(json, facts);
    json.member("similarity_dimension", facts.similarityDimension);
    json.member("affinity_dimension", facts.affinityDimension);
}

void writeEntry(JsonWriter& json, const document::Fractal& fractal, const InfoSubject& subject) {
    const int dimension = document::dimension(fractal);
    json.beginObject();
    json.member("name", fractal.name);
    json.key("dimension");
    dimension == 0 ? json.null() : json.value(dimension);
    json.member("loaded", dimension != 0);
    if (const auto* plane = std::get_if<document::System2>(&fractal.system))
        writeSystem(json, *plane, subject);
    else if (const auto* space = std::get_if<document::System3>(&fractal.system))
        writeSystem(json, *space, subject);
    else
        for (const char* key : {"maps", "attractor", "mean", "covariance", "bounding_box",
                                "canonical_simplex", "hull", "similarity_dimension", "affinity_dimension"})
            writeNull(json, key);
    writeCage(json, fractal.cage);
    json.key("moved_branches");
    json.beginArray();
    for (const auto& [word, change] : document::movedBranches(fractal)) {
        json.beginObject(Layout::Inline);
        std::vector<std::size_t> places(document::system2(fractal)->maps.size());
        std::iota(places.begin(), places.end(), std::size_t(0));
        writeWord(json, "address", word, places);
        json.key("linear");
        writeMatrix<2>(json, change.linear);
        json.key("translation");
        writeVector<2>(json, change.translation);
        json.endObject();
    }
    json.endArray();
    json.endObject();
}

void writeProblem(JsonWriter& json, const document::Problem& problem) {
    json.beginObject(Layout::Inline);
    json.key("entry");
    problem.entry.isEmpty() ? json.null() : json.value(problem.entry);
    json.key("line");
    problem.line > 0 ? json.value(problem.line) : json.null();
    json.key("column");
    problem.column > 0 ? json.value(problem.column) : json.null();
    const bool error = problem.severity == document::Problem::Severity::Error;
    json.member("severity", error ? QStringLiteral("error") : QStringLiteral("warning"));
    json.member("message", problem.message);
    json.endObject();
}

} // namespace

QByteArray infoJson(const InfoSubject& subject) {
    JsonWriter json;
    json.beginObject();
    json.member("file", subject.fileName);
    json.member("format", subject.format);
    json.key("problems");
    json.beginArray();
    for (const auto& problem : subject.problems)
        writeProblem(json, problem);
    json.endArray();
    json.key("entries");
    json.beginArray();
    for (const auto& entry : subject.entries)
        writeEntry(json, *entry.fractal, subject);
    json.endArray();
    json.endObject();
    return json.text();
}

} // namespace io
