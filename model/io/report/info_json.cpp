// SPDX-License-Identifier: MIT
#include "io/report/info_json.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "document/moments/animated_fractal.h"
#include "ifs/dimension/moments.h"
#include "ifs/extent/extent.h"
#include "ifs/facts.h"
#include "ifs/system/links.h"
#include "io/fractint/animation_lines.h"
#include "io/report/invariants_json.h"
#include "io/report/json_writer.h"
#include "io/text/symmetry_text.h"

#include <cmath>
#include <numeric>
#include <span>

namespace io {

namespace {

using Layout = JsonWriter::Layout;

void writeValues(JsonWriter& json, const auto& values) {
    json.beginArray(Layout::Inline);
    for (const auto value : values)
        json.value(value);
    json.endArray();
}

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
    const auto enclosed = ifs::enclosedFixedPoint(map.map);
    json.key("fixed_point");
    if (const auto fixed = enclosed ? enclosed->point : ifs::fixedPoint(map.map))
        writeVector<Dim>(json, *fixed);
    else
        json.null();
    json.member("fixed_point_error", enclosed ? std::optional(enclosed->error) : std::nullopt);
    json.endObject();
}

QString normName(ifs::NormKind norm) {
    switch (norm) {
    case ifs::NormKind::Words:
        return QStringLiteral("words");
    case ifs::NormKind::Ellipsoidal:
        return QStringLiteral("ellipsoidal");
    case ifs::NormKind::Polytope:
        return QStringLiteral("polytope");
    case ifs::NormKind::Euclidean:
        break;
    }
    return QStringLiteral("euclidean");
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
void writeExistence(JsonWriter& json, const ifs::Existence& existence,
                    const std::vector<std::size_t>& indices) {
    const bool settled =
        existence.verdict != ifs::Verdict::Undecided && existence.verdict != ifs::Verdict::Empty;
    json.key("attractor");
    json.beginObject(Layout::Inline);
    json.member("verdict", verdictName(existence.verdict));
    const bool hasNumber = existence.hasFactor() || existence.verdict == ifs::Verdict::None;
    json.member("contractivity", hasNumber ? std::optional(existence.contractivity) : std::nullopt);
    json.key("word_length");
    if (settled)
        json.value(existence.verdict == ifs::Verdict::None ? int(existence.witness.size())
                                                           : existence.wordLength);
    else
        json.null();
    json.key("norm");
    if (settled && existence.verdict != ifs::Verdict::None)
        json.value(normName(existence.norm));
    else
        json.null();
    if (existence.verdict == ifs::Verdict::None)
        writeWord(json, "witness", existence.witness, indices);
    else
        writeNull(json, "witness");
    json.endObject();
}

template <int Dim> void writeMoments(JsonWriter& json, const ifs::Facts<Dim>& facts) {
    if (!facts.mean)
        writeNull(json, "mean");
    else {
        json.key("mean");
        writeVector<Dim>(json, facts.mean->point);
    }
    json.member("mean_error", facts.mean ? std::optional(facts.mean->error) : std::nullopt);
    json.key("covariance");
    if (facts.moments)
        writeMatrix<Dim>(json, facts.moments->covariance);
    else
        json.null();
    json.member("covariance_error",
                facts.moments ? std::optional(facts.moments->covarianceError) : std::nullopt);
}

template <int Dim> void writeBox(JsonWriter& json, const std::optional<ifs::BoundingBox<Dim>>& box) {
    if (!box) return json.null();
    json.beginObject(Layout::Inline);
    json.key("min");
    writeVector<Dim>(json, box->min);
    json.key("max");
    writeVector<Dim>(json, box->max);
    json.member("error", box->error);
    json.endObject();
}

// By the maps that make them, null for one that takes no part; all is null for maps that are not linked.
void writeParts(JsonWriter& json, const std::vector<std::optional<ifs::BoundingBox<2>>>& parts) {
    if (parts.empty()) return writeNull(json, "parts");
    json.key("parts");
    json.beginArray();
    for (const auto& box : parts)
        writeBox<2>(json, box);
    json.endArray();
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
        json.member("area_error", ifs::areaError(*hull));
        writeAddresses(json, facts);
        json.member("exact", facts.isHullExact);
    } else {
        json.member("volume", hull->volume);
        json.member("volume_error", ifs::volumeError(*hull));
        json.key("facets");
        json.beginArray(Layout::Inline);
        for (const auto& facet : hull->facets)
            writeValues(json, facet);
        json.endArray();
    }
    json.member("error", hull->error);
    json.endObject();
}

template <int Dim> void writeCage(JsonWriter& json, const std::optional<ifs::ControlCage<Dim>>& cage) {
    if (!cage) return writeNull(json, "cage");
    json.key("cage");
    json.beginObject(Layout::Inline);
    json.key("rest");
    writePoints<Dim>(json, cage->rest);
    json.key("current");
    writePoints<Dim>(json, cage->current);
    const bool isSimplex = cage->rest.size() == Dim + 1;
    const bool bends = cage->deformation == ifs::Deformation::Bend;
    json.member("deformation", isSimplex ? QStringLiteral("affine")
                               : bends   ? QStringLiteral("bend")
                                         : QStringLiteral("affine_fit"));
    json.endObject();
}

// Those that are null without the fact.
std::vector<const char*> keysOf(ifs::LongFact fact) {
    switch (fact) {
    case ifs::LongFact::Existence:
        return {"attractor", "similarity_dimension", "measure_dimension"};
    case ifs::LongFact::Extents:
        return {"bounding_box", "canonical_simplex"};
    case ifs::LongFact::JointSpectralRadius:
        return {"joint_spectral_radius"};
    case ifs::LongFact::Contacts:
        return {"separation", "connectedness",       "overlaps", "open_set_condition",
                "neighbours", "hausdorff_dimension", "spectrum", "tile"};
    case ifs::LongFact::Hull:
        return {"hull"};
    case ifs::LongFact::AffinityDimension:
        return {"affinity_dimension", "affinity_dimension_error"};
    case ifs::LongFact::ExtremePoints:
        break;
    }
    return {"addresses"};
}

template <int Dim>
void writeSystem(JsonWriter& json, const ifs::IteratedFunctionSystem<Dim>& system,
                 const document::Entry& entry, const InfoSubject& subject) {
    // Addresses number the maps as the expanded system lists them.
    const std::vector<double> probabilities = ifs::probabilities(system);
    const ifs::Facts<Dim> facts = factsFor(ifs::expanded(system), entry, subject);
    json.key("maps");
    json.beginArray();
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        writeMap(json, system.maps[i], probabilities[i]);
    json.endArray();
    if (facts.isLate(ifs::LongFact::Existence))
        writeNull(json, "attractor");
    else
        writeExistence(json, facts.existence, facts.active.index);
    writeMoments<Dim>(json, facts);
    json.key("bounding_box");
    writeBox<Dim>(json, facts.box);
    if constexpr (Dim == 2)
        writeParts(json, partsOf(system, facts));
    else
        writeNull(json, "parts");
    writeSimplex<Dim>(json, facts.simplex);
    writeHull<Dim>(json, facts);
    json.member("similarity_dimension", facts.similarityDimension);
    json.member("affinity_dimension", facts.affinityDimension);
    json.member("affinity_dimension_error",
                facts.affinityDimension ? std::optional(facts.affinityDimensionError) : std::nullopt);
    if (facts.isAffinityDimensionCapped) json.member("capped", true);
    json.key("out_of_time");
    json.beginArray(Layout::Inline);
    for (const ifs::LongFact fact : facts.late)
        for (const char* key : keysOf(fact))
            json.value(QString::fromLatin1(key));
    json.endArray();
    writeInvariants(json, facts);
}

template <int Dim> void writeSymmetry(JsonWriter& json, const ifs::Symmetry<Dim>& symmetry) {
    if (symmetry.group == ifs::SymmetryGroup::None) return writeNull(json, "symmetry");
    json.key("symmetry");
    json.beginObject(Layout::Inline);
    json.member("group", symmetryName(symmetry.group, symmetry.order));
    json.key("elements");
    json.value(int(ifs::groupOrder(symmetry.group, symmetry.order)));
    json.member("angle", symmetry.angle);
    json.key("centre");
    writeVector<Dim>(json, symmetry.centre);
    json.key("frame");
    writeMatrix<Dim>(json, symmetry.frame);
    json.endObject();
}

template <int Dim> void writeMovedBranches(JsonWriter& json, const document::Shape<Dim>& shape) {
    std::vector<std::size_t> indices(shape.system.maps.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    json.key("moved_branches");
    json.beginArray();
    for (const auto& [branch, recurs] : document::storedBranches(shape)) {
        json.beginObject(Layout::Inline);
        writeWord(json, "address", branch.word, indices);
        json.member("recurs", recurs);
        json.key("linear");
        writeMatrix<Dim>(json, branch.change.linear);
        json.key("translation");
        writeVector<Dim>(json, branch.change.translation);
        json.endObject();
    }
    json.endArray();
}

QString stateName(ifs::LinkState state) {
    switch (state) {
    case ifs::LinkState::Off:
        return QStringLiteral("off");
    case ifs::LinkState::Ends:
        return QStringLiteral("ends");
    case ifs::LinkState::Unreached:
        return QStringLiteral("unreached");
    case ifs::LinkState::Left:
        return QStringLiteral("left");
    case ifs::LinkState::TakesPart:
        break;
    }
    return QStringLiteral("takes_part");
}

// Null where any map may follow any other as its weight says.
template <int Dim> void writeLinks(JsonWriter& json, const ifs::IteratedFunctionSystem<Dim>& system) {
    if (system.links.empty()) {
        for (const char* key : {"links", "link_states", "visits"})
            writeNull(json, key);
        return;
    }
    const std::size_t n = system.maps.size();
    const std::vector<double> matrix = ifs::linkMatrix(system);
    json.key("links");
    json.beginArray(Layout::Inline);
    for (std::size_t i = 0; i < n; ++i)
        writeValues(json, std::span(matrix).subspan(i * n, n));
    json.endArray();
    json.key("link_states");
    json.beginArray(Layout::Inline);
    for (const ifs::LinkState state : ifs::linkStates(system))
        json.value(stateName(state));
    json.endArray();
    const auto active = ifs::activeMaps(system);
    std::vector<double> visits(n, 0);
    const std::vector<double> stationary = ifs::transitions(active).stationary;
    for (std::size_t k = 0; k < active.index.size(); ++k)
        visits[active.index[k]] = stationary[k];
    json.key("visits");
    writeValues(json, visits);
}

template <int Dim>
void writeShape(JsonWriter& json, const document::Shape<Dim>& shape, const document::Entry& entry,
                const InfoSubject& subject) {
    writeSystem(json, shape.system, entry, subject);
    writeSymmetry(json, shape.system.symmetry);
    writeLinks(json, shape.system);
    writeCage(json, shape.cage);
    writeMovedBranches(json, shape);
}

void writeAnimation(JsonWriter& json, const document::Fractal& fractal) {
    const auto facts = document::animationFacts(fractal);
    if (!facts) return writeNull(json, "animation");
    json.key("animation");
    json.beginObject(Layout::Inline);
    json.member("fps", QStringLiteral("%1/%2").arg(facts->rate.frames).arg(facts->rate.seconds));
    json.key("frames");
    json.value(facts->length);
    json.member("loop", QString::fromLatin1(ifs::nameOf(facts->loop)));
    json.key("tracks");
    json.value(facts->tracks);
    json.endObject();
}

// All facts are those of the moment asked for; the animation is that of the entry.
void writeEntry(JsonWriter& json, const document::Entry& entry, const InfoSubject& subject) {
    const document::Fractal fractal =
        subject.moment ? document::frameAt(*entry.fractal, *subject.moment).fractal : *entry.fractal;
    const int dimension = document::dimension(fractal);
    json.beginObject();
    json.member("name", fractal.name);
    json.key("dimension");
    dimension == 0 ? json.null() : json.value(dimension);
    json.member("loaded", dimension != 0);
    if (const auto* plane = document::plane(fractal)) {
        writeShape(json, *plane, entry, subject);
    } else if (const auto* space = document::space(fractal)) {
        writeShape(json, *space, entry, subject);
    } else {
        for (const char* key : {"maps",
                                "attractor",
                                "mean",
                                "mean_error",
                                "covariance",
                                "covariance_error",
                                "bounding_box",
                                "parts",
                                "canonical_simplex",
                                "hull",
                                "similarity_dimension",
                                "affinity_dimension",
                                "affinity_dimension_error",
                                "out_of_time",
                                "separation",
                                "connectedness",
                                "overlaps",
                                "open_set_condition",
                                "neighbours",
                                "hausdorff_dimension",
                                "spectrum",
                                "tile",
                                "joint_spectral_radius",
                                "entropy",
                                "lyapunov_exponent",
                                "measure_dimension",
                                "symmetry",
                                "links",
                                "link_states",
                                "visits",
                                "cage"})
            writeNull(json, key);
        json.key("moved_branches");
        json.beginArray();
        json.endArray();
    }
    writeAnimation(json, *entry.fractal);
    json.endObject();
}

void writeListed(JsonWriter& json, const document::Fractal& fractal, qsizetype number) {
    const int dimension = document::dimension(fractal);
    json.beginObject(Layout::Inline);
    json.member("number", int(number));
    json.member("name", fractal.name);
    json.key("dimension");
    dimension == 0 ? json.null() : json.value(dimension);
    json.member("loaded", dimension != 0);
    json.key("map_count");
    if (const auto* plane = document::system2(fractal))
        json.value(int(plane->maps.size()));
    else if (const auto* space = document::system3(fractal))
        json.value(int(space->maps.size()));
    else
        json.null();
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

// `write` writes the entry of an index.
template <class Write> QByteArray report(const InfoSubject& subject, Write write) {
    JsonWriter json;
    json.beginObject();
    json.member("file", subject.fileName);
    json.member("format", subject.format);
    json.key("entries");
    json.beginArray();
    for (qsizetype i = 0; i < subject.entries.size(); ++i)
        write(json, i);
    json.endArray();
    json.key("problems"); // perhaps found meanwhile
    json.beginArray();
    for (const auto& problem : subject.problems)
        writeProblem(json, problem);
    json.endArray();
    json.endObject();
    return json.text();
}

} // namespace

QByteArray infoJson(const InfoSubject& given) {
    InfoSubject subject = given;
    subject.remark = [&](const document::Problem& problem) {
        subject.problems << problem;
        if (given.remark) given.remark(problem);
    };
    return report(subject, [&](JsonWriter& json, qsizetype i) {
        if (subject.begun) subject.begun(i);
        writeEntry(json, subject.entries[i], subject);
    });
}

QByteArray listJson(const InfoSubject& subject, const QList<qsizetype>& numbers) {
    return report(subject, [&](JsonWriter& json, qsizetype i) {
        writeListed(json, *subject.entries[i].fractal, numbers[i]);
    });
}

} // namespace io
