// SPDX-License-Identifier: MIT
#include "io/report/invariants_json.h"

#include <QString>

#include <cmath>
#include <optional>

namespace io {

void writeNull(JsonWriter& json, const char* key) {
    json.key(key);
    json.null();
}

void writeWord(JsonWriter& json, const char* key, const ifs::Word& word,
               const std::vector<std::size_t>& indices) {
    json.key(key);
    json.beginArray(JsonWriter::Layout::Inline);
    for (const int symbol : word)
        json.value(int(indices[std::size_t(symbol)]) + 1);
    json.endArray();
}

namespace {

using Layout = JsonWriter::Layout;

void writeContacts(JsonWriter& json, const std::optional<ifs::PieceContacts>& contacts,
                   const std::vector<std::size_t>& indices, bool isLate) {
    using ifs::Connectedness, ifs::Separation;
    const auto separation = contacts ? contacts->separation : Separation::Unknown;
    const auto connectedness = contacts ? contacts->connectedness : Connectedness::Unknown;
    if (separation == Separation::Unknown)
        writeNull(json, "separation");
    else
        json.member("separation", separation == Separation::Strong ? QStringLiteral("strong")
                                                                   : QStringLiteral("overlapping"));
    if (connectedness == Connectedness::Unknown)
        writeNull(json, "connectedness");
    else
        json.member("connectedness",
                    connectedness == Connectedness::Disconnected ? QStringLiteral("disconnected")
                    : connectedness == Connectedness::Connected  ? QStringLiteral("connected")
                                                                 : QStringLiteral("connected_to_rounding"));
    if (isLate) return writeNull(json, "overlaps");
    json.key("overlaps");
    json.beginArray(Layout::Inline);
    for (const auto& overlap : contacts ? contacts->overlaps : std::vector<ifs::Overlap>()) {
        json.beginObject(Layout::Inline);
        writeWord(json, "first", overlap.first, indices);
        writeWord(json, "second", overlap.second, indices);
        json.member("exact", overlap.isExact);
        json.endObject();
    }
    json.endArray();
}

void writeTile(JsonWriter& json, const std::optional<ifs::Tile>& tile) {
    if (!tile) return writeNull(json, "tile");
    json.key("tile");
    json.beginObject(Layout::Inline);
    json.member("area", tile->area);
    json.member("boundary_dimension", tile->boundaryDimension);
    json.member("boundary_dimension_error",
                tile->boundaryDimension ? std::optional(tile->boundaryDimensionError) : std::nullopt);
    json.member("exact", tile->isExact);
    json.endObject();
}

QString proofName(ifs::HausdorffDimension::Proof proof) {
    return proof == ifs::HausdorffDimension::Proof::FiniteType ? QStringLiteral("finite type")
                                                               : QStringLiteral("open set condition");
}

void writeOpenSet(JsonWriter& json, const std::optional<ifs::OpenSetFacts>& facts) {
    using ifs::Certainty, ifs::OpenSetCondition;
    const bool isKnown = facts && facts->condition != OpenSetCondition::Unknown;
    json.key("open_set_condition");
    if (isKnown)
        json.value(facts->condition == OpenSetCondition::Holds);
    else
        json.null();
    if (isKnown && facts->certainty == Certainty::ToRounding)
        json.member("open_set_condition_to_rounding", true);
    json.key("neighbours");
    if (facts && facts->neighbours)
        json.value(int(*facts->neighbours));
    else
        json.null();
    if (!facts || !facts->dimension) return writeNull(json, "hausdorff_dimension");
    const auto& [value, error, proof, certainty] = *facts->dimension;
    json.key("hausdorff_dimension");
    json.beginObject(Layout::Inline);
    json.member("value", value);
    json.member("error", error);
    json.member("by", proofName(proof));
    json.member("to_rounding", certainty == Certainty::ToRounding);
    json.endObject();
}

void writeSpectrum(JsonWriter& json, const std::optional<ifs::DimensionSpectrum>& spectrum) {
    if (!spectrum) return writeNull(json, "spectrum");
    json.key("spectrum");
    json.beginObject(Layout::Inline);
    json.member("D0", spectrum->capacity);
    json.member("D1", spectrum->information);
    json.member("D2", spectrum->correlation);
    json.member("Dinf", spectrum->least);
    json.endObject();
}

} // namespace

template <int Dim> void writeInvariants(JsonWriter& json, const ifs::Facts<Dim>& facts) {
    const ifs::Invariants& invariants = facts.invariants;
    writeContacts(json, invariants.contacts, facts.active.index, facts.isLate(ifs::LongFact::Contacts));
    writeOpenSet(json, invariants.openSet);
    writeSpectrum(json, invariants.spectrum);
    writeTile(json, invariants.tile);
    const auto& radius = invariants.jointSpectralRadius;
    if (radius && std::isfinite(radius->most)) {
        json.key("joint_spectral_radius");
        json.beginObject(Layout::Inline);
        json.member("least", radius->least);
        json.member("most", radius->most);
        json.endObject();
    } else
        writeNull(json, "joint_spectral_radius");
    json.member("entropy", invariants.entropy);
    json.member("lyapunov_exponent", invariants.lyapunovExponent);
    json.member("measure_dimension", invariants.measureDimension);
    if (invariants.isMeasureDimensionCapped) json.member("measure_dimension_capped", true);
}

template void writeInvariants<2>(JsonWriter&, const ifs::Facts<2>&);
template void writeInvariants<3>(JsonWriter&, const ifs::Facts<3>&);

} // namespace io
