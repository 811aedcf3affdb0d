// SPDX-License-Identifier: MIT
#include "io/report/facts_of_pieces.h"

#include "document/text/text.h"
#include "ifs/dimension/dimension.h"
#include "ifs/names.h"
#include "io/report/figure_error.h"
#include "io/report/verdicts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

// Names in the JSON, where unknown values are null.
template <>
inline constexpr auto ifs::names<ifs::Separation> = std::to_array<ifs::Named<ifs::Separation>>({
    {ifs::Separation::Strong, "strong"},
    {ifs::Separation::Overlapping, "overlapping"},
});

template <>
inline constexpr auto ifs::names<ifs::Connectedness> = std::to_array<ifs::Named<ifs::Connectedness>>({
    {ifs::Connectedness::Connected, "connected"},
    {ifs::Connectedness::ConnectedToRounding, "connected_to_rounding"},
    {ifs::Connectedness::Disconnected, "disconnected"},
});

template <>
inline constexpr auto
    ifs::names<ifs::HausdorffDimension::Proof> = std::to_array<ifs::Named<ifs::HausdorffDimension::Proof>>({
        {ifs::HausdorffDimension::Proof::OpenSetCondition, "open set condition"},
        {ifs::HausdorffDimension::Proof::FiniteType, "finite type"},
        {ifs::HausdorffDimension::Proof::Convex, "convex hull"},
    });

namespace io {

namespace {

using Value = std::optional<QString>;

template <int Dim> QString caveat(const FactSource<Dim>& source) {
    return source.isComplete() || source.facts.invariants.contacts ? openSetNote(source.facts) : QString();
}

QString notSimilarities() {
    return Panel::tr(
        "There is no value, because these maps are not all similarities in the same coordinates.");
}

template <class Verdict> std::optional<Verdict> unlessUnknown(Verdict verdict) {
    return verdict == Verdict::Unknown ? std::nullopt : std::optional(verdict);
}

// Σ sᵢᴰ = 1 with numbers, equal ratios together, and solved where there is one ratio.
QString moranEquation(std::vector<double> ratios, const Figures& number) {
    constexpr double apart = 1e-9;
    std::ranges::sort(ratios, std::greater());
    QStringList terms;
    std::size_t count = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        ++count;
        if (i + 1 < ratios.size() && ratios[i + 1] > ratios[i] * (1 - apart)) continue;
        const QString power = number(ratios[i]) + u'ᴰ';
        terms << (count == 1 ? power : QStringLiteral("%1 · %2").arg(count).arg(power));
        count = 0;
    }
    QString text = terms.join(QStringLiteral(" + ")) + QStringLiteral(" = 1");
    if (terms.size() == 1 && ratios.size() > 1)
        text += QStringLiteral(" ⇒ D = ln %1 / ln %2").arg(ratios.size()).arg(number(1 / ratios.front()));
    return text;
}

template <int Dim> bool isMoranSum(const ifs::Facts<Dim>& facts) {
    return facts.similarityDimension && !facts.active.isLinked();
}

template <int Dim> Value moranText(const FactSource<Dim>& source, const Figures& number) {
    constexpr std::size_t maxRatios = 1000;
    const auto& maps = source.facts.active.maps;
    const auto ratios = isMoranSum(source.facts) && maps.size() <= maxRatios
                            ? ifs::similarityRatios<Dim>(maps)
                            : std::nullopt;
    return ratios ? Value(moranEquation(*ratios, number)) : std::nullopt;
}

template <int Dim> Value affinityText(const FactSource<Dim>& source, const Figures& number) {
    const auto& dimension = source.facts.affinityDimension;
    if (source.facts.isAffinityDimensionCapped)
        return Text::tr("at least %1").arg(number(dimension.value_or(Dim)));
    if (!source.withAffinityDimension) return std::nullopt;
    if (!dimension) return QString();
    return number(*dimension) + number.note({*dimension}, source.facts.affinityDimensionError, 1);
}

template <int Dim> const ifs::PieceContacts* contactsOf(const FactSource<Dim>& source) {
    const auto& contacts = source.facts.invariants.contacts;
    return contacts ? &*contacts : nullptr;
}

struct ReportedOverlap {
    NumberedWord first, second;
    bool isExact = false;
};

void members(JsonMembers& out, const ReportedOverlap& overlap) {
    out("first", overlap.first);
    out("second", overlap.second);
    out("exact", overlap.isExact);
}

template <int Dim> std::optional<std::vector<ReportedOverlap>> overlapsOf(const FactSource<Dim>& source) {
    if (source.facts.isLate(ifs::LongFact::Contacts)) return std::nullopt;
    std::vector<ReportedOverlap> reported;
    const auto& rows = source.facts.active.index;
    if (const auto* contacts = contactsOf(source))
        for (const auto& [first, second, isExact] : contacts->overlaps)
            reported.push_back({numbered(first, rows), numbered(second, rows), isExact});
    return reported;
}

template <int Dim> void addOverlapLines(const FactSource<Dim>& source, FactLines& lines) {
    const auto& rows = source.facts.active.index;
    if (const auto* contacts = contactsOf(source))
        for (const auto& [first, second, isExact] : contacts->overlaps)
            lines.add(Text::tr("overlap"),
                      (isExact ? Text::tr("the words %1 and %2 are the same map")
                               : Text::tr("the words %1 and %2 are the same map within rounding error"))
                          .arg(wordText(first, rows), wordText(second, rows)));
}

// Overlaps as equations.
template <int Dim> Value overlapsText(const FactSource<Dim>& source, const Figures&) {
    const auto& rows = source.facts.active.index;
    QStringList texts;
    if (const auto* contacts = contactsOf(source))
        for (const auto& [first, second, isExact] : contacts->overlaps)
            texts << (isExact ? QStringLiteral("%1 = %2") : QStringLiteral("%1 ≈ %2"))
                         .arg(wordText(first, rows), wordText(second, rows));
    return texts.join(QStringLiteral("  "));
}

template <int Dim> Value hausdorffText(const FactSource<Dim>& source, const Figures& number) {
    const auto& openSet = source.facts.invariants.openSet;
    if (!openSet || !openSet->dimension) return std::nullopt;
    const auto& [value, error, proof, certainty] = *openSet->dimension;
    const bool isByType = proof == ifs::HausdorffDimension::Proof::FiniteType;
    return number(value) + number.note({value}, error, 1) +
           (isByType ? u' ' + Text::tr("(finite type)") : QString()) +
           roundingNote(certainty == ifs::Certainty::Exact);
}

template <int Dim> Value tileText(const FactSource<Dim>& source, const Figures& number) {
    const auto& tile = source.facts.invariants.tile;
    if (!tile || !tile->area) return std::nullopt;
    return number(*tile->area) + roundingNote(tile->isExact);
}

template <int Dim> Value boundaryText(const FactSource<Dim>& source, const Figures& number) {
    const auto& tile = source.facts.invariants.tile;
    if (!tile || !tile->boundaryDimension) return std::nullopt;
    return number(*tile->boundaryDimension) +
           number.note({*tile->boundaryDimension}, tile->boundaryDimensionError, 1) +
           roundingNote(tile->isExact);
}

template <int Dim> Value similarityText(const FactSource<Dim>& source, const Figures& number) {
    const auto& dimension = source.facts.similarityDimension;
    return dimension ? number(*dimension) + caveat(source) : QString();
}

template <int Dim> Value boxCountingText(const FactSource<Dim>& source, const Figures& number) {
    const auto& counting = source.analysis->boxCounting;
    if (!counting) return std::nullopt;
    return QStringLiteral("%1 ± %2").arg(number(counting->fit.slope), boundText(counting->uncertainty));
}

template <int Dim> Value separationOf(const FactSource<Dim>& source, const Figures& /*number*/) {
    const auto* contacts = contactsOf(source);
    return contacts ? Value(separationText(contacts->separation)) : std::nullopt;
}

template <int Dim> Value connectednessOf(const FactSource<Dim>& source, const Figures& /*number*/) {
    const auto* contacts = contactsOf(source);
    return contacts ? Value(connectednessText(contacts->connectedness)) : std::nullopt;
}

template <int Dim> Value conditionText(const FactSource<Dim>& source, const Figures& /*number*/) {
    const auto& openSet = source.facts.invariants.openSet;
    return openSet ? Value(openSetText(*openSet)) : std::nullopt;
}

template <int Dim> Value neighboursText(const FactSource<Dim>& source, const Figures& number) {
    const auto& openSet = source.facts.invariants.openSet;
    return openSet && openSet->neighbours ? Value(number.count(*openSet->neighbours)) : std::nullopt;
}

template <int Dim> Value spectrumText(const FactSource<Dim>& source, const Figures& number) {
    const auto& spectrum = source.facts.invariants.spectrum;
    const auto& openSet = source.facts.invariants.openSet;
    if (!spectrum || !openSet) return std::nullopt;
    return QStringLiteral("D0 %1, D1 %2, D2 %3, D∞ %4")
               .arg(number(spectrum->capacity), number(spectrum->information), number(spectrum->correlation),
                    number(spectrum->least)) +
           roundingNote(openSet->certainty == ifs::Certainty::Exact);
}

template <int Dim> std::optional<ifs::JointSpectralRadius> radiusOf(const FactSource<Dim>& source) {
    const auto& radius = source.facts.invariants.jointSpectralRadius;
    return radius && std::isfinite(radius->most) ? radius : std::nullopt;
}

// The ends of an interval are rounded outwards.
QString lowerDigits(double number) {
    const QString text = reportFigures()(number);
    return text.toDouble() > number ? reportFigures()(number - 1e-6 * std::abs(number)) : text;
}

// The interval of the radius, or a single number if the digits show no more.
template <int Dim> std::optional<QString> radiusText(const FactSource<Dim>& source, const Figures& number) {
    const auto radius = radiusOf(source);
    if (!radius) return std::nullopt;
    const auto [least, most] = *radius;
    constexpr double rounding = 1e-15;         // relative error of exact radii
    const bool isOne = least < 1 && most >= 1; // shown as 1 only if that does not change its meaning
    if (!isOne && most - least <= rounding * most && number(least) == number(most)) return number(most);
    return Text::tr("between %1 and %2").arg(lowerDigits(least), upperDigits(most));
}

template <int Dim>
std::optional<QString> shortRadiusText(const FactSource<Dim>& source, const Figures& number) {
    const auto radius = radiusOf(source);
    if (!radius) return std::nullopt;
    const auto [least, most] = *radius;
    constexpr double tight = 1e-8; // limit below which short numbers coincide
    if (most - least < (number.isAbridged ? tight : std::numeric_limits<double>::min())) return number(most);
    if (!number.isAbridged) return Text::tr("between %1 and %2").arg(number(least), number(most));
    return Text::tr("between %1 and %2")
        .arg(QString::number(std::floor(least * 1e4) / 1e4), QString::number(std::ceil(most * 1e4) / 1e4));
}

template <int Dim> std::optional<QString> measureText(const FactSource<Dim>& source, const Figures& number) {
    const ifs::Invariants& found = source.facts.invariants;
    const auto value = number.known(found.measureDimension);
    if (!value) return std::nullopt;
    return (found.isMeasureDimensionCapped ? Text::tr("at most %1").arg(*value) : *value) + caveat(source);
}

} // namespace

static void members(JsonMembers& out, const ifs::HausdorffDimension& dimension) {
    out("value", dimension.value);
    out("error", NonNegative{dimension.error}, "How far the value is off, at most.");
    out("by", dimension.proof);
    out("to_rounding", dimension.certainty == ifs::Certainty::ToRounding,
        "Proved for the maps that the coefficients are the rounding of.");
}

static void members(JsonMembers& out, const ifs::DimensionSpectrum& spectrum) {
    out("D0", spectrum.capacity);
    out("D1", spectrum.information);
    out("D2", spectrum.correlation);
    out("Dinf", spectrum.least);
}

static void members(JsonMembers& out, const ifs::Tile& tile) {
    out("area", tile.area,
        "Where copies of the attractor, moved by a lattice and turned by finitely many turns, cover the "
        "plane equally often.");
    out("boundary_dimension", tile.boundaryDimension, "Where all maps are similarities of one ratio.");
    out("boundary_dimension_error",
        tile.boundaryDimension ? std::optional(NonNegative{tile.boundaryDimensionError}) : std::nullopt,
        "How far the boundary dimension is off, at most.");
    out("exact", tile.isExact,
        "Proved of the coefficients as they are; else as far as their rounding tells.");
}

template <int Dim> void addDimensions(FactRows& rows, const FactSource<Dim>& source) {
    const ifs::Facts<Dim>& facts = source.facts;
    add(rows, Text::tr("similarity dimension"))
        .written(source, similarityText<Dim>)
        .member("similarity_dimension", facts.similarityDimension)
        .isLateWith(ifs::LongFact::Existence, Late::Said)
        .inPanel(FactGroup::Dimensions, Panel::tr("Similarity dimension"),
                 Panel::tr("The number D with Σ sᵢᴰ = 1, where sᵢ are the ratios of the maps, if all maps "
                           "are similarities in some coordinates. It is the dimension of the attractor under "
                           "the open set condition, and an upper bound for it otherwise."),
                 notSimilarities());
    const QString noEquation =
        isMoranSum(facts) ? QString()
        : facts.active.isLinked()
            ? Panel::tr("There is no value, because the maps are linked: the equation is another.")
            : notSimilarities();
    add(rows)
        .shownAs(source, moranText<Dim>)
        .inPanel(FactGroup::Dimensions, Panel::tr("Moran equation"),
                 Panel::tr("Σ sᵢᴰ = 1 with the ratios of these maps, equal ratios combined. Its solution is "
                           "the similarity dimension."),
                 noEquation);
    const auto& affinity = facts.affinityDimension;
    Fact& row = add(rows, Text::tr("affinity dimension"))
                    .written(source, affinityText<Dim>)
                    .member("affinity_dimension", affinity)
                    .member("affinity_dimension_error",
                            affinity ? std::optional(facts.affinityDimensionError) : std::nullopt,
                            "How far the affinity dimension is off, at most.")
                    .mark("capped", facts.isAffinityDimensionCapped,
                          "Only where it is true: the affinity dimension is larger than that of space, which "
                          "stands for it.")
                    .isLateWith(ifs::LongFact::AffinityDimension, Late::Said);
    if (Dim == 3) return; // plane only from here on
    row.inPanel(FactGroup::Dimensions, Panel::tr("Affinity dimension"),
                Panel::tr("Falconer’s dimension, at most 2: the exponent at which the sum of the singular "
                          "value functions of all words of one length neither grows nor shrinks as the words "
                          "get longer. It is an upper bound for the box-counting dimension, and equal to it "
                          "for almost all translations if the maps contract enough."))
        .takesLong = true;
    add(rows)
        .shownAs(source, boxCountingText<Dim>)
        .inPanel(FactGroup::Dimensions, Panel::tr("Box-counting dimension"),
                 Panel::tr("Slope of the least-squares line of ln N against ln 1/ε, where N is the number of "
                           "boxes of side ε that meet the attractor, over the sizes where it is most stable. "
                           "This is an estimate: the uncertainty is the difference between parts of that "
                           "range, not a proven bound."))
        .takesLong = true;
}

template <int Dim> void addContacts(FactRows& rows, const FactSource<Dim>& source) {
    const ifs::PieceContacts contacts = source.facts.invariants.contacts.value_or(ifs::PieceContacts());
    add(rows, Text::tr("separation"))
        .written(source, separationOf<Dim>)
        .member("separation", unlessUnknown(contacts.separation),
                "strong: the pieces are disjoint; overlapping: two words are the same map.")
        .isLateWith(ifs::LongFact::Contacts, Late::Said)
        .inPanel(FactGroup::Pieces, Panel::tr("Separation"),
                 Panel::tr("Whether the pieces that the maps make of the attractor are disjoint (strong "
                           "separation, proved by disjoint covers), or words of maps coincide, so that the "
                           "open set condition fails."));
    add(rows, Text::tr("connectedness"))
        .written(source, connectednessOf<Dim>)
        .member("connectedness", unlessUnknown(contacts.connectedness))
        .isLateWith(ifs::LongFact::Contacts, Late::Said)
        .inPanel(FactGroup::Pieces, Panel::tr("Connectedness"),
                 Panel::tr("An attractor is connected if and only if its pieces are joined by common points "
                           "(Hata). Common points are looked for among fixed points of short words, and "
                           "their absence is proved by disjoint covers."));
    add(rows)
        .inLines(source, addOverlapLines<Dim>)
        .shownAs(source, overlapsText<Dim>)
        .member(
            "overlaps", [&source] { return overlapsOf(source); },
            "Pairs of words that are the same map, exactly or within rounding error.")
        .isLateWith(ifs::LongFact::Contacts, Late::Silent)
        .inPanel(FactGroup::Pieces, Panel::tr("Overlaps"),
                 Panel::tr("Different words that compose to the same map, neither a prefix of the other: "
                           "their pieces coincide."),
                 Panel::tr("No overlaps were found."));
}

template <int Dim> void addOpenSet(FactRows& rows, const FactSource<Dim>& source) {
    const ifs::OpenSetFacts known = source.facts.invariants.openSet.value_or(ifs::OpenSetFacts());
    const auto condition = unlessUnknown(known.condition);
    add(rows, Text::tr("open set condition"))
        .written(source, conditionText<Dim>)
        .member("open_set_condition",
                condition ? std::optional(*condition == ifs::OpenSetCondition::Holds) : std::nullopt,
                "Whether there is an open set U with disjoint images w_i(U) in U.")
        .mark("open_set_condition_to_rounding", condition && known.certainty == ifs::Certainty::ToRounding,
              "Only where it is true: the condition is decided for the maps that the coefficients are the "
              "rounding of.")
        .isLateWith(ifs::LongFact::Contacts, Late::Silent)
        .inPanel(FactGroup::Pieces, Panel::tr("Open set condition"),
                 Panel::tr(
                     "Whether there is an open set with disjoint images in it. It is proved where the pieces "
                     "are disjoint, where an area of the attractor is, and where the neighbours of pieces of "
                     "one size are finitely many, and none of them coincides with its neighbour."));
    add(rows, Text::tr("neighbours"))
        .written(source, neighboursText<Dim>)
        .member("neighbours",
                known.neighbours ? std::optional(Whole<>{int(*known.neighbours)}) : std::nullopt,
                "How many maps w_σ⁻¹w_τ, but for the identity, there are between pieces of one size that "
                "meet; null unless all maps are similarities of one ratio and these are finitely many.")
        .isLateWith(ifs::LongFact::Contacts, Late::Silent);
    add(rows, Text::tr("Hausdorff dimension"))
        .written(source, hausdorffText<Dim>)
        .member("hausdorff_dimension", known.dimension)
        .isLateWith(ifs::LongFact::Contacts, Late::Silent)
        .inPanel(FactGroup::Pieces, Panel::tr("Hausdorff dimension"),
                 Panel::tr("Dimension of the attractor, where it is proved: the similarity dimension under "
                           "the open set condition; or, where pieces coincide and there are finitely many "
                           "neighbours, by the growth of the number of different maps."),
                 Panel::tr("There is no value: it is not known how much the pieces overlap, or the maps are "
                           "no similarities."));
    add(rows, Text::tr("spectrum"))
        .written(source, spectrumText<Dim>)
        .member("spectrum", source.facts.invariants.spectrum,
                "Dimensions of the measure of similarities under the open set condition: of the attractor, "
                "of information, of correlation, and where the measure is densest.")
        .isLateWith(ifs::LongFact::Contacts, Late::Silent);
}

template <int Dim> void addTile(FactRows& rows, const FactSource<Dim>& source) {
    Fact& area = add(rows, Text::tr("area of the tile"))
                     .written(source, tileText<Dim>)
                     .member("tile", source.facts.invariants.tile,
                             "An attractor with inner points that copies of it fill the plane with; null "
                             "where that is not proved.")
                     .isLateWith(ifs::LongFact::Contacts, Late::Silent);
    if (Dim == 3) return;
    area.inPanel(
        FactGroup::Pieces, Panel::tr("Tile area"),
        Panel::tr("Area of the attractor, if its copies, moved by a lattice and turned by a few turns, cover "
                  "the plane equally often; proved by the contacts of the copies, or by counting those that "
                  "hold a point."),
        Panel::tr(
            "There is no value: it is not proved that copies of the attractor cover the plane in this way."));
    add(rows, Text::tr("dimension of boundary"))
        .written(source, boundaryText<Dim>)
        .inPanel(FactGroup::Pieces, Panel::tr("Boundary dimension"),
                 Panel::tr(
                     "Dimension of the boundary, if all maps are similarities of one ratio whose pieces fill "
                     "an area and meet in finitely many ways: from the growth of the number of contacts."),
                 Panel::tr("There is no value, because these maps are not of this kind."));
}

template <int Dim> void addPieces(FactRows& rows, const FactSource<Dim>& source) {
    addContacts(rows, source);
    addOpenSet(rows, source);
    addTile(rows, source);
}

static void members(JsonMembers& out, const ifs::JointSpectralRadius& radius) {
    out("least", NonNegative{radius.least});
    out("most", NonNegative{radius.most});
}

template <int Dim> void addMeasure(FactRows& rows, const FactSource<Dim>& source) {
    const ifs::Invariants& known = source.facts.invariants;
    add(rows, Text::tr("joint spectral radius"))
        .written(source, radiusText<Dim>)
        .shownAs(source, shortRadiusText<Dim>)
        .member("joint_spectral_radius", radiusOf(source), "Both ends are proved.")
        .isLateWith(ifs::LongFact::JointSpectralRadius, Late::Said)
        .inPanel(
            FactGroup::Pieces, Panel::tr("Joint spectral radius"),
            Panel::tr("The largest factor per map by which long words stretch. Both ends of the interval are "
                      "proved; a system contracts in some norm if and only if it is less than 1."));
    add(rows, Text::tr("entropy"))
        .written("entropy", known.entropy, "Of the weights, in nats.")
        .inPanel(FactGroup::Pieces, Panel::tr("Entropy"),
                 Panel::tr("−Σ pᵢ ln pᵢ: the uncertainty of one step of the chaos game, in nats."));
    add(rows, Text::tr("Lyapunov exponent"))
        .written("lyapunov_exponent", known.lyapunovExponent, "Of similarities.")
        .inPanel(FactGroup::Pieces, Panel::tr("Lyapunov exponent"),
                 Panel::tr("Σ pᵢ ln sᵢ: how the logarithm of a distance changes per step of the chaos game, "
                           "if all maps are similarities in some coordinates."),
                 notSimilarities());
    add(rows, Text::tr("dimension of measure"))
        .written(source, measureText<Dim>)
        .member("measure_dimension", known.measureDimension,
                "Of similarities; an upper bound where pieces overlap.")
        .mark("measure_dimension_capped", known.isMeasureDimensionCapped,
              "Only where it is true: the dimension of the line, plane or space that holds the attractor "
              "stands for a larger number.")
        .isLateWith(ifs::LongFact::Existence, Late::Silent)
        .inPanel(
            FactGroup::Pieces, Panel::tr("Dimension of the measure"),
            Dim == 2
                ? Panel::tr(
                      "Entropy divided by minus the Lyapunov exponent, at most 2: the dimension of the "
                      "invariant measure under the open set condition, and an upper bound for it otherwise.")
                : Panel::tr(
                      "Entropy divided by minus the Lyapunov exponent, at most 3: the dimension of the "
                      "invariant measure under the open set condition, and an upper bound for it otherwise."),
            notSimilarities());
}

template void addDimensions<2>(FactRows&, const FactSource<2>&);
template void addDimensions<3>(FactRows&, const FactSource<3>&);
template void addPieces<2>(FactRows&, const FactSource<2>&);
template void addPieces<3>(FactRows&, const FactSource<3>&);
template void addMeasure<2>(FactRows&, const FactSource<2>&);
template void addMeasure<3>(FactRows&, const FactSource<3>&);

} // namespace io
