// SPDX-License-Identifier: MIT
#include "io/report/info_text.h"

#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "document/moments/animated_fractal.h"
#include "document/text/text.h"
#include "ifs/dimension/dimension.h"
#include "ifs/facts.h"
#include "ifs/system/links.h"
#include "io/report/figure_error.h"
#include "io/report/verdicts.h"
#include "io/text/symmetry_text.h"

#include <algorithm>
#include <cmath>

namespace io {

namespace {

constexpr int shownDigits = 6;

QString digits(double number, double error = 0, double size = 0) {
    return figure(number, error, size, shownDigits);
}

QString digits(const std::optional<double>& number) {
    return number ? digits(*number) : Text::tr("unknown");
}

template <typename Vector> QString tuple(const Vector& v, double error = 0, double size = 0) {
    QStringList parts;
    for (Eigen::Index i = 0; i < v.size(); ++i)
        parts << digits(double(v[i]), error, size);
    return QStringLiteral("(%1)").arg(parts.join(QStringLiteral(", ")));
}

template <typename Matrix> QString rows(const Matrix& m, double error) {
    QStringList parts;
    for (Eigen::Index i = 0; i < m.rows(); ++i)
        parts << tuple(m.row(i), error);
    return parts.join(QStringLiteral(" "));
}

template <typename Points> QString list(const Points& points, double error = 0, double size = 0) {
    QStringList parts;
    for (const auto& point : points)
        parts << tuple(point, error, size);
    return parts.join(QStringLiteral(" "));
}

template <class Matrix> QString errorNote(const Matrix& values, double error, double size) {
    QString note;
    for (const double value : values.reshaped())
        if (note.isEmpty() && value != 0) note = io::errorNote({value}, error, size, shownDigits);
    if (note.isEmpty() && values.isZero(0)) note = io::errorNote({0}, error, size, shownDigits);
    return note;
}

// The ends of an interval are rounded outwards.
QString lowerDigits(double number) {
    const QString text = digits(number);
    return text.toDouble() > number ? digits(number - 1e-6 * std::abs(number)) : text;
}

QString upperDigits(double number) {
    const QString text = digits(number);
    return text.toDouble() < number ? digits(number + 1e-6 * std::abs(number)) : text;
}

class Lines {
public:
    void add(const QString& name, const QString& value) {
        m_text += QStringLiteral("  %1  %2\n").arg(name, -22).arg(value);
    }
    void title(const QString& text) { m_text += text + u'\n'; }
    const QString& text() const { return m_text; }

private:
    QString m_text;
};

QString notComputed() {
    return Text::tr("not computed within the budget");
}

template <int Dim> QString mapLine(const ifs::WeightedMap<Dim>& map, double probability, double size) {
    QStringList row;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            row << digits(map.map.linear(i, j)).rightJustified(11);
    for (int i = 0; i < Dim; ++i)
        row << digits(map.map.translation[i], 0, size).rightJustified(11);
    row << digits(probability).rightJustified(11);
    return row.join(u' ') + Text::tr("   norm %1, determinant %2")
                                .arg(digits(ifs::spectralNorm<Dim>(map.map.linear)),
                                     digits(ifs::determinant<Dim>(map.map.linear)));
}

template <int Dim> void addMoments(Lines& lines, const ifs::Facts<Dim>& facts) {
    const auto spread = facts.moments ? facts.moments->covariance.trace() : 0;
    const double size =
        facts.box ? (facts.box->max - facts.box->min).stableNorm() : std::sqrt(std::max(spread, 0.0));
    if (facts.mean) {
        const auto [point, error] = *facts.mean;
        const auto known = withoutNoise(point, error);
        lines.add(Text::tr("mean"), isWorthless(error, std::max(size, point.stableNorm()))
                                        ? Text::tr("unknown")
                                        : tuple(known, error, size) + errorNote(known, error, size));
    }
    if (facts.moments) {
        const double error = facts.moments->covarianceError;
        const auto known = withoutNoise(facts.moments->covariance, error);
        lines.add(Text::tr("covariance"), isWorthless(error, std::max(spread, size * size))
                                              ? Text::tr("unknown")
                                              : rows(known, error) + errorNote(known, error, size * size));
    }
}

template <int Dim> QString boxText(const ifs::BoundingBox<Dim>& box) {
    const auto& [min, max, error] = box;
    const double size = (max - min).stableNorm();
    if (isWorthless(error, std::max(size, 1e-9 * max.stableNorm()))) return Text::tr("unknown");
    Eigen::Matrix<double, Dim, 2> corners;
    corners << withoutNoise(min, error), withoutNoise(max, error);
    return tuple(corners.col(0), error, size) + u' ' + tuple(corners.col(1), error, size) +
           errorNote(corners, error, size);
}

template <int Dim> void addBoxAndSimplex(Lines& lines, const ifs::Facts<Dim>& facts) {
    if (facts.isLate(ifs::LongFact::Extents)) {
        lines.add(Text::tr("bounding box"), notComputed());
        lines.add(Text::tr("canonical simplex"), notComputed());
    }
    if (facts.box) lines.add(Text::tr("bounding box"), boxText(*facts.box));
    if (facts.simplex) {
        std::vector<ifs::Vector<Dim>> corners;
        QString note;
        const double error = facts.simplex->error, leg = facts.simplex->leg;
        for (const auto& vertex : facts.simplex->vertices) {
            corners.push_back(withoutNoise(vertex, error));
            if (note.isEmpty()) note = errorNote(corners.back(), error, leg);
        }
        lines.add(Text::tr("canonical simplex"),
                  isWorthless(error, leg) ? Text::tr("unknown") : list(corners, error, leg) + note);
    }
}

void addParts(Lines& lines, const std::vector<std::optional<ifs::BoundingBox<2>>>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (const auto& box = parts[i]) lines.add(Text::tr("part of map %1").arg(i + 1), boxText(*box));
}

// The size of the attractor, as far as it is known: that of the hull, if no box is.
template <int Dim> double sizeOf(const ifs::Facts<Dim>& facts) {
    if (facts.box) return (facts.box->max - facts.box->min).stableNorm();
    ifs::Vector<Dim> low = facts.hull->vertices.front(), high = low;
    for (const auto& vertex : facts.hull->vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    return (high - low).stableNorm();
}

// Of an area or a volume.
template <int Dim> QString contentText(double content, double error, const ifs::Facts<Dim>& facts) {
    const double size =
        std::pow(std::max(sizeOf(facts), 1e-9 * facts.hull->vertices.front().stableNorm()), Dim);
    if (isWorthless(error, std::max(content, 1e-3 * size))) return Text::tr("unknown");
    return digits(content, error, size) + io::errorNote({content}, error, size, shownDigits);
}

QString vertexCount(std::size_t vertices) {
    return vertices == 1 ? Text::tr("1 vertex") : Text::tr("%1 vertices").arg(vertices);
}

void addHull(Lines& lines, const ifs::Facts<2>& facts) {
    if (facts.isLate(ifs::LongFact::Hull)) lines.add(Text::tr("convex hull"), notComputed());
    if (!facts.hull) return;
    const QString area = contentText(facts.hull->area, ifs::areaError(*facts.hull), facts);
    if (facts.isLate(ifs::LongFact::ExtremePoints))
        return lines.add(
            Text::tr("convex hull"),
            Text::tr("%1, area %2; error at most %3; periodic addresses not computed within the "
                     "budget")
                .arg(vertexCount(facts.hull->vertices.size()), area, upperDigits(facts.hull->error)));
    if (facts.isHullExact)
        return lines.add(Text::tr("convex hull"),
                         facts.hull->vertices.size() == 1
                             ? Text::tr("a point; exact")
                             : Text::tr("%1, all of them with periodic addresses, area %2; exact")
                                   .arg(vertexCount(facts.hull->vertices.size()), area));
    lines.add(Text::tr("convex hull"),
              Text::tr("%1, %2 of them with periodic addresses, area %3; error at most %4")
                  .arg(vertexCount(facts.hull->vertices.size()))
                  .arg(std::ranges::count_if(facts.extremePoints,
                                             [](const auto& point) { return point.has_value(); }))
                  .arg(area, upperDigits(facts.hull->error)));
}

void addHull(Lines& lines, const ifs::Facts<3>& facts) {
    if (facts.isLate(ifs::LongFact::Hull)) lines.add(Text::tr("convex hull"), notComputed());
    if (!facts.hull) return;
    lines.add(Text::tr("convex hull"),
              Text::tr("%1, %2, volume %3; error at most %4")
                  .arg(vertexCount(facts.hull->vertices.size()))
                  .arg(facts.hull->facets.size() == 1 ? Text::tr("1 facet")
                                                      : Text::tr("%1 facets").arg(facts.hull->facets.size()))
                  .arg(contentText(facts.hull->volume, ifs::volumeError(*facts.hull), facts),
                       upperDigits(facts.hull->error)));
}

void addOpenSet(Lines& lines, const ifs::Invariants& invariants) {
    if (!invariants.openSet) return;
    lines.add(Text::tr("open set condition"), openSetText(*invariants.openSet));
    if (const auto& neighbours = invariants.openSet->neighbours)
        lines.add(Text::tr("neighbours"), QString::number(*neighbours));
    if (const auto& dimension = invariants.openSet->dimension) {
        const bool isByType = dimension->proof == ifs::HausdorffDimension::Proof::FiniteType;
        const bool isExact = dimension->certainty == ifs::Certainty::Exact;
        lines.add(Text::tr("Hausdorff dimension"),
                  digits(dimension->value) +
                      io::errorNote({dimension->value}, dimension->error, 1, shownDigits) +
                      (isByType ? u' ' + Text::tr("(finite type)") : QString()) + roundingNote(isExact));
    }
    if (const auto& spectrum = invariants.spectrum)
        lines.add(Text::tr("spectrum"), QStringLiteral("D0 %1, D1 %2, D2 %3, D∞ %4")
                                            .arg(digits(spectrum->capacity), digits(spectrum->information),
                                                 digits(spectrum->correlation), digits(spectrum->least)));
}

// One number where that is all that the digits show of the interval.
QString radiusText(const ifs::JointSpectralRadius& radius) {
    constexpr double rounding = 1e-15;                       // of exact radii
    const bool isOne = radius.least < 1 && radius.most >= 1; // one side or the other matters
    if (!isOne && radius.most - radius.least <= rounding * radius.most &&
        digits(radius.least) == digits(radius.most))
        return digits(radius.most);
    return Text::tr("between %1 and %2").arg(lowerDigits(radius.least), upperDigits(radius.most));
}

void addTile(Lines& lines, const std::optional<ifs::Tile>& tile) {
    if (!tile) return;
    const QString note = roundingNote(tile->isExact);
    if (tile->area) lines.add(Text::tr("area of the tile"), digits(*tile->area) + note);
    if (tile->boundaryDimension)
        lines.add(
            Text::tr("dimension of boundary"),
            digits(*tile->boundaryDimension) +
                io::errorNote({*tile->boundaryDimension}, tile->boundaryDimensionError, 1, shownDigits) +
                note);
}

template <int Dim> void addInvariants(Lines& lines, const ifs::Facts<Dim>& facts) {
    const ifs::Invariants& invariants = facts.invariants;
    const auto& index = facts.active.index;
    if (facts.isLate(ifs::LongFact::Contacts)) {
        lines.add(Text::tr("separation"), notComputed());
        lines.add(Text::tr("connectedness"), notComputed());
    }
    if (const auto& contacts = invariants.contacts) {
        lines.add(Text::tr("separation"), separationText(contacts->separation));
        lines.add(Text::tr("connectedness"), connectednessText(contacts->connectedness));
        for (const auto& overlap : contacts->overlaps)
            lines.add(Text::tr("overlap"),
                      (overlap.isExact
                           ? Text::tr("the words %1 and %2 are the same map")
                           : Text::tr("the words %1 and %2 are the same map within rounding error"))
                          .arg(wordText(overlap.first, index), wordText(overlap.second, index)));
    }
    addOpenSet(lines, invariants);
    addTile(lines, invariants.tile);
    if (facts.isLate(ifs::LongFact::JointSpectralRadius))
        lines.add(Text::tr("joint spectral radius"), notComputed());
    if (const auto& radius = invariants.jointSpectralRadius; radius && std::isfinite(radius->most))
        lines.add(Text::tr("joint spectral radius"), radiusText(*radius));
    if (invariants.entropy) lines.add(Text::tr("entropy"), digits(*invariants.entropy));
    if (invariants.lyapunovExponent)
        lines.add(Text::tr("Lyapunov exponent"), digits(*invariants.lyapunovExponent));
    if (invariants.measureDimension)
        lines.add(Text::tr("dimension of measure"),
                  (invariants.isMeasureDimensionCapped
                       ? Text::tr("at most %1").arg(digits(*invariants.measureDimension))
                       : digits(*invariants.measureDimension)) +
                      openSetNote(facts));
}

template <int Dim>
void addSystem(Lines& lines, const ifs::IteratedFunctionSystem<Dim>& system, const document::Entry& entry,
               const InfoSubject& subject) {
    const std::vector<double> probabilities = ifs::probabilities(system);
    const ifs::Facts<Dim> facts = factsFor(ifs::expanded(system), entry, subject);
    const double size = facts.box ? sizeOf(facts) : 0;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        lines.add(Text::tr("map %1").arg(i + 1), mapLine(system.maps[i], probabilities[i], size));
    if (system.symmetry.group != ifs::SymmetryGroup::None)
        lines.add(Text::tr("symmetry"), symmetrySentence(system.symmetry));
    const bool isExistenceLate = facts.isLate(ifs::LongFact::Existence);
    lines.add(Text::tr("attractor"),
              isExistenceLate ? notComputed() : verdictText(facts.existence, facts.active.index));
    addMoments<Dim>(lines, facts);
    addBoxAndSimplex<Dim>(lines, facts);
    if constexpr (Dim == 2) addParts(lines, partsOf(system, facts));
    addHull(lines, facts);
    lines.add(Text::tr("similarity dimension"),
              isExistenceLate ? notComputed()
                              : digits(facts.similarityDimension) +
                                    (facts.similarityDimension ? openSetNote(facts) : QString()));
    if (facts.isLate(ifs::LongFact::AffinityDimension))
        lines.add(Text::tr("affinity dimension"), notComputed());
    else if (facts.isAffinityDimensionCapped)
        lines.add(Text::tr("affinity dimension"),
                  Text::tr("at least %1").arg(digits(facts.affinityDimension)));
    else if (subject.limits.withAffinityDimension)
        lines.add(Text::tr("affinity dimension"),
                  digits(facts.affinityDimension) +
                      (facts.affinityDimension ? io::errorNote({*facts.affinityDimension},
                                                               facts.affinityDimensionError, 1, shownDigits)
                                               : QString()));
    addInvariants(lines, facts);
}

QString mapCount(std::size_t maps) {
    return maps == 1 ? Text::tr("1 map") : Text::tr("%1 maps").arg(maps);
}

// "maple — in the plane, 4 maps"
QString titleOf(const document::Fractal& fractal) {
    const auto* space = document::system3(fractal);
    return space ? Text::tr("%1 — in space, %2").arg(fractal.name, mapCount(space->maps.size()))
                 : Text::tr("%1 — in the plane, %2")
                       .arg(fractal.name, mapCount(document::system2(fractal)->maps.size()));
}

// Empty for a map that takes part, and for one that its weight switches off.
QString stateText(ifs::LinkState state) {
    switch (state) {
    case ifs::LinkState::Ends:
        return Text::tr("takes no part: after it, the chaos game ends");
    case ifs::LinkState::Unreached:
        return Text::tr("takes no part: no map leads to it");
    case ifs::LinkState::Left:
        return Text::tr("takes no part: the chaos game leaves it and never returns");
    case ifs::LinkState::TakesPart:
    case ifs::LinkState::Off:
        break;
    }
    return {};
}

template <int Dim> void addLinks(Lines& lines, const ifs::IteratedFunctionSystem<Dim>& system) {
    if (system.links.empty()) return;
    const std::size_t n = system.maps.size();
    const std::vector<double> matrix = ifs::linkMatrix(system);
    const std::vector<ifs::LinkState> states = ifs::linkStates(system);
    for (std::size_t i = 0; i < n; ++i) {
        QStringList row;
        for (std::size_t j = 0; j < n; ++j)
            row << digits(matrix[i * n + j]);
        const QString state = stateText(states[i]);
        lines.add(Text::tr("links from map %1").arg(i + 1),
                  row.join(u' ') + (state.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(state)));
    }
    if (ifs::activeMaps(system).isLinked())
        lines.add(Text::tr("linked maps"), Text::tr("separation, connectedness, joint spectral radius and "
                                                    "periodic addresses are not computed for linked maps"));
}

template <int Dim>
void addShape(Lines& lines, const document::Shape<Dim>& shape, const document::Entry& entry,
              const InfoSubject& subject) {
    addSystem(lines, shape.system, entry, subject);
    addLinks(lines, shape.system);
    if (shape.cage) {
        lines.add(Text::tr("cage at rest"), list(shape.cage->rest));
        lines.add(Text::tr("cage now"), list(shape.cage->current));
        if (shape.cage->rest.size() > Dim + 1)
            lines.add(Text::tr("deformation"), shape.cage->deformation == ifs::Deformation::Bend
                                                   ? Text::tr("bend")
                                                   : Text::tr("affine fit"));
    }
    for (const auto& [branch, recurs] : document::storedBranches(shape)) {
        const QString address = document::addressText(branch.word, branch.word.size());
        lines.add(Text::tr("moved branch"),
                  recurs ? Text::tr("%1, and inside itself").arg(address) : address);
    }
    if (!shape.moved.empty())
        lines.add(Text::tr("moved branches"),
                  Text::tr("all figures are those of the code, where no branch is moved"));
}

QString loopText(animation::Loop loop) {
    switch (loop) {
    case animation::Loop::Cycle:
        return Text::tr("in a cycle");
    case animation::Loop::ThereAndBack:
        return Text::tr("there and back");
    case animation::Loop::Off:
        break;
    }
    return Text::tr("once");
}

// "; tracks: 2, motions: 1", without what there is none of.
QString movingText(const document::AnimationFacts& facts) {
    QStringList parts;
    if (facts.tracks > 0) parts << Text::tr("tracks: %1").arg(facts.tracks);
    if (facts.motions > 0) parts << Text::tr("motions: %1").arg(facts.motions);
    return parts.isEmpty() ? QString() : QStringLiteral("; ") + parts.join(QStringLiteral(", "));
}

void addAnimation(Lines& lines, const document::Fractal& fractal) {
    const auto facts = document::animationFacts(fractal);
    if (!facts) return;
    lines.add(Text::tr("animation"),
              Text::tr("frames: %1, %2 per second, %3")
                      .arg(animation::frameCount(facts->loop, facts->length))
                      .arg(digits(double(facts->rate.frames) / facts->rate.seconds), loopText(facts->loop)) +
                  movingText(*facts));
}

void addEntry(Lines& lines, const document::Entry& entry, const InfoSubject& subject) {
    const document::Fractal fractal =
        subject.moment ? document::frameAt(*entry.fractal, *subject.moment).fractal : *entry.fractal;
    if (const auto* plane = document::plane(fractal)) {
        lines.title(titleOf(fractal));
        addShape(lines, *plane, entry, subject);
        addAnimation(lines, *entry.fractal);
    } else if (const auto* space = document::space(fractal)) {
        lines.title(titleOf(fractal));
        addShape(lines, *space, entry, subject);
        addAnimation(lines, *entry.fractal);
    } else {
        lines.title(Text::tr("%1 — could not be read").arg(fractal.name));
        for (const auto& problem : entry.problems)
            if (problem.severity == document::Problem::Severity::Error)
                lines.add(Text::tr("reason"), problem.message);
    }
}

} // namespace

QString listText(const QList<document::Entry>& entries, const QList<qsizetype>& numbers) {
    QString text;
    for (qsizetype i = 0; i < entries.size(); ++i) {
        const document::Fractal& fractal = *entries[i].fractal;
        const int dimension = document::dimension(fractal);
        const auto* space = document::system3(fractal);
        const QString size =
            dimension == 0 ? Text::tr("could not be read")
            : space        ? Text::tr("in space, %1").arg(mapCount(space->maps.size()))
                    : Text::tr("in the plane, %1").arg(mapCount(document::system2(fractal)->maps.size()));
        text += QStringLiteral("%1  %2  %3\n")
                    .arg(numbers[i], 5)
                    .arg(size, -24)
                    .arg(QString(fractal.name).replace(u'\n', u' '));
    }
    return text;
}

QString infoText(const InfoSubject& subject) {
    Lines lines;
    for (qsizetype i = 0; i < subject.entries.size(); ++i) {
        const document::Entry& entry = subject.entries[i];
        if (subject.begun) subject.begun(i);
        if (!lines.text().isEmpty()) lines.title({});
        addEntry(lines, entry, subject);
    }
    return lines.text();
}

} // namespace io
