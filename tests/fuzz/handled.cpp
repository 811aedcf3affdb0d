// SPDX-License-Identifier: MIT
#include "fuzz/handled.h"

#include "ifs/facts.h"
#include "ifs/system/links.h"
#include "io/collection_reader.h"
#include "io/exchange/text_formats.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/vector/svg_writer.h"
#include "io/report/info_json.h"
#include "io/report/info_text.h"

#include <QJsonDocument>
#include <QRegularExpression>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace fuzz {

void promise(bool kept, const char* what) {
    if (kept) return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

namespace {

using io::TextFormat;

constexpr std::size_t maxMaps = 16; // of what is analysed; more take their time in every reader

template <int Dim> std::size_t expandedCount(const ifs::IteratedFunctionSystem<Dim>& system) {
    return system.maps.size() * ifs::groupOrder(system.symmetry.group, system.symmetry.order);
}

// The maps that take part, with those that a symmetry stands for.
template <int Dim>
std::vector<ifs::AffineMap<Dim>> takingPart(const ifs::IteratedFunctionSystem<Dim>& system) {
    return ifs::activeMaps(ifs::expanded(system)).maps;
}

template <int Dim>
void checkWritten(const std::shared_ptr<const document::Fractal>& fractal,
                  const ifs::IteratedFunctionSystem<Dim>& system, TextFormat format) {
    const QByteArray text = io::textOf({fractal}, format);
    promise(!text.isEmpty(), "what a format holds is written");
    if (format == TextFormat::Latex) return; // which nobody reads
    const io::Collection back = io::readCollection(text, QStringLiteral("some.") + io::suffixOf(format));
    promise(back.file.entries.size() == 1, "a system that is written is one system");
    const auto* shape = std::get_if<document::Shape<Dim>>(&back.file.entries.first().fractal->shape);
    promise(shape != nullptr, "a system that is written reads back in its dimension");
    if (!system.links.empty()) return; // of which a format may write the plain maps
    promise(takingPart(shape->system) == takingPart(system), "a system that is written keeps its maps");
}

template <int Dim>
void checkWritten(const std::shared_ptr<const document::Fractal>& fractal,
                  const ifs::IteratedFunctionSystem<Dim>& system) {
    for (const TextFormat format : {TextFormat::Fractint, TextFormat::Flame, TextFormat::Aifs,
                                    TextFormat::Latex, TextFormat::Csv, TextFormat::Tsv})
        if (io::holds(format, *fractal)) checkWritten(fractal, system, format);
}

void checkDrawn(const document::Fractal& fractal) {
    attractor::Camera camera;
    camera.width = camera.height = 64;
    static const QRegularExpression noNumber(
        QStringLiteral("\\s(?:transform|d|points|viewBox)=\"[^\"]*(?:nan|inf)"));
    const QString drawing = QString::fromUtf8(io::structuredSvg(fractal, camera));
    promise(!drawing.contains(noNumber), "every number of a drawing is a number");
}

template <int Dim> void checkFacts(const ifs::Facts<Dim>& facts) {
    const double sum = std::accumulate(facts.probabilities.begin(), facts.probabilities.end(), 0.0);
    promise(facts.active.maps.empty() || std::abs(sum - 1) < 1e-9, "probabilities sum to 1");
    if (facts.mean) promise(facts.mean->point.allFinite() && facts.mean->error >= 0, "a mean is a point");
    const auto verdict = facts.existence.verdict;
    const bool exists = verdict == ifs::Verdict::Hyperbolic || verdict == ifs::Verdict::EventuallyContractive;
    promise(exists || !facts.box || facts.active.isLinked(), "only an attractor has a box");
    if (!facts.box) return;
    const auto& [min, max, error] = *facts.box;
    promise(error >= 0 && (min.array() <= max.array() + error).all(), "a box is a box");
    if (facts.active.isLinked()) return;
    for (const auto& map : facts.active.maps)
        if (const auto fixed = ifs::enclosedFixedPoint(map)) {
            const double off = (error + fixed->error) * (1 + 1e-9);
            promise((fixed->point.array() >= min.array() - off).all() &&
                        (fixed->point.array() <= max.array() + off).all(),
                    "a box holds the fixed points");
        }
    if (facts.hull)
        for (const auto& vertex : facts.hull->vertices) {
            const double off = error + facts.hull->error + 1e-12 * (max.norm() + min.norm());
            promise((vertex.array() >= min.array() - off).all() &&
                        (vertex.array() <= max.array() + off).all(),
                    "a box holds the hull");
        }
}

void checkText(const io::InfoSubject& subject) {
    promise(!io::infoText(subject).isEmpty(), "a report says something");
}

void checkJson(const io::InfoSubject& subject) {
    QJsonParseError error;
    QJsonDocument::fromJson(io::infoJson(subject), &error);
    promise(error.error == QJsonParseError::NoError, "a report is JSON");
}

template <int Dim>
void checkSystem(const document::Entry& entry, const ifs::IteratedFunctionSystem<Dim>& system) {
    using namespace std::chrono_literals;
    if (expandedCount(system) > maxMaps || takingPart(system).empty()) return;
    checkWritten(entry.fractal, system);
    io::InfoSubject subject;
    subject.entries << entry;
    subject.limits = {.perFact = 1ms, .together = 4ms};
    // A few inputs get one of these each, for they take much longer than reading does.
    constexpr int kinds = 16;
    switch (qChecksum(io::writeEntry(*entry.fractal)) % kinds) {
    case 0:
        return checkFacts(ifs::factsOf(ifs::expanded(system), {}, subject.limits));
    case 1:
        return checkText(subject);
    case 2:
        return checkJson(subject);
    case 3:
        if (Dim == 2) checkDrawn(*entry.fractal);
    }
}

} // namespace

void checkHandled(const document::FractalFile& file) {
    constexpr int few = 2;
    int left = few;
    for (const document::Entry& entry : file.entries) {
        const document::Fractal& fractal = *entry.fractal;
        if (document::dimension(fractal) == 0) continue;
        if (const auto* plane = document::system2(fractal)) checkSystem(entry, *plane);
        if (const auto* space = document::system3(fractal)) checkSystem(entry, *space);
        if (--left == 0) return;
    }
}

} // namespace fuzz
