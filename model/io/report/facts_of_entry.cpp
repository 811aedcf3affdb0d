// SPDX-License-Identifier: MIT
#include "io/report/facts_of_entry.h"

#include "document/text/text.h"
#include "ifs/dimension/dimension.h"
#include "ifs/names.h"
#include "ifs/system/links.h"
#include "io/report/figure_error.h"
#include "io/report/verdicts.h"
#include "io/text/symmetry_text.h"

#include <algorithm>
#include <array>
#include <limits>

template <>
inline constexpr auto ifs::names<ifs::Verdict> = std::to_array<ifs::Named<ifs::Verdict>>({
    {ifs::Verdict::Hyperbolic, "hyperbolic"},
    {ifs::Verdict::EventuallyContractive, "eventually_contractive"},
    {ifs::Verdict::None, "none"},
    {ifs::Verdict::Empty, "none"},
    {ifs::Verdict::Undecided, "undecided"},
});

template <>
inline constexpr auto ifs::names<ifs::NormKind> = std::to_array<ifs::Named<ifs::NormKind>>({
    {ifs::NormKind::Euclidean, "euclidean"},
    {ifs::NormKind::Words, "words"},
    {ifs::NormKind::Ellipsoidal, "ellipsoidal"},
    {ifs::NormKind::Polytope, "polytope"},
});

template <>
inline constexpr auto ifs::names<ifs::LinkState> = std::to_array<ifs::Named<ifs::LinkState>>({
    {ifs::LinkState::TakesPart, "takes_part"},
    {ifs::LinkState::Off, "off"},
    {ifs::LinkState::Ends, "ends"},
    {ifs::LinkState::Unreached, "unreached"},
    {ifs::LinkState::Left, "left"},
});

namespace io {

namespace {

template <int Dim> struct ReportedMap {
    ifs::WeightedMap<Dim> map;
    double probability = 0;
};

template <int Dim> void members(JsonMembers& out, const ReportedMap<Dim>& listed) {
    const auto& [linear, translation] = listed.map.map;
    const auto enclosed = ifs::enclosedFixedPoint(listed.map.map);
    out.define("map");
    out("linear", linear);
    out("translation", translation);
    out("weight", Described<double, within<0, 1>>{listed.probability},
        "The probability used; 0 for a map that is switched off.");
    out("weight_in_file", listed.map.weight);
    out("norm", NonNegative{ifs::spectralNorm<Dim>(linear)},
        "The largest factor by which the map stretches.");
    out("determinant", ifs::determinant<Dim>(linear));
    out("fixed_point", enclosed ? std::optional(enclosed->point) : ifs::fixedPoint(listed.map.map));
    out("fixed_point_error", enclosed ? std::optional(NonNegative{enclosed->error}) : std::nullopt,
        "The fixed point is at most that far from the one given; null where I - A is not proved to be "
        "regular.");
}

template <int Dim> std::vector<ReportedMap<Dim>> listedMaps(const document::Shape<Dim>& shape) {
    const std::vector<double> probabilities = ifs::probabilities(shape.system);
    std::vector<ReportedMap<Dim>> maps;
    for (std::size_t i = 0; i < shape.system.maps.size(); ++i)
        maps.push_back({shape.system.maps[i], probabilities[i]});
    return maps;
}

template <int Dim> QString mapLine(const ReportedMap<Dim>& listed, double size) {
    const Figures& number = reportFigures();
    const auto& [linear, translation] = listed.map.map;
    QStringList row;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            row << number(linear(i, j));
    for (int i = 0; i < Dim; ++i)
        row << number(translation[i], 0, size);
    row << number(listed.probability);
    for (QString& cell : row)
        cell = cell.rightJustified(11);
    return row.join(u' ') +
           Text::tr("   norm %1, determinant %2")
               .arg(number(ifs::spectralNorm<Dim>(linear)), number(ifs::determinant<Dim>(linear)));
}

struct ReportedExistence {
    ifs::Existence existence;
    std::vector<std::size_t> rows; // rows of the active maps
};

// The contraction factor is known only where one was proved, or disproved by a witness.
void members(JsonMembers& out, const ReportedExistence& reported) {
    const ifs::Existence& existence = reported.existence;
    const bool isNone = existence.verdict == ifs::Verdict::None;
    const auto length = isNone ? existence.witness.size() : std::size_t(existence.wordLength);
    out.define("existence");
    out("verdict", existence.verdict);
    out("contractivity",
        existence.hasFactor() || isNone ? std::optional(existence.contractivity) : std::nullopt);
    out("word_length", existence.exists() || isNone ? std::optional(Whole<>{int(length)}) : std::nullopt,
        "Of the words that contract, or of the one that does not.");
    out("norm", existence.exists() ? std::optional(existence.norm) : std::nullopt,
        "In which the maps, or words of that length, contract.");
    out("witness", isNone ? std::optional(numbered(existence.witness, reported.rows)) : std::nullopt,
        "A word that contracts in no norm: its spectral radius is proved to be at least 1.");
}

constexpr std::size_t maxListed = 24; // maps mentioned in an abridged line

template <class Item> QString list(std::size_t count, const Figures& number, Item textOf) {
    const std::size_t listed = number.isAbridged ? std::min(count, maxListed) : count;
    QStringList texts;
    for (std::size_t i = 0; i < listed; ++i)
        texts << textOf(i);
    if (listed < count) texts << Panel::tr("… and %n more", nullptr, static_cast<int>(count - listed));
    return texts.join(QStringLiteral("  "));
}

template <int Dim> struct FixedPoint {
    ifs::Vector<Dim> point;
    double error; // large for maps that nearly keep a direction
};

template <int Dim> double errorOf(const ifs::Vector<Dim>& fixedPoint, const ifs::AffineMap<Dim>& map) {
    const auto enclosed = ifs::enclosedFixedPoint(map);
    return enclosed ? enclosed->error + (enclosed->point - fixedPoint).stableNorm()
                    : std::numeric_limits<double>::infinity();
}

// Copies of a map under a symmetry have the same; under a flat cage there are no maps, and no errors.
double errorOf(const document::Analysis& analysis, std::size_t k) {
    const auto& [maps, probabilities, index, links] = analysis.facts.active;
    if (maps.empty()) return 0;
    double error = std::numeric_limits<double>::infinity();
    const auto [first, last] = std::equal_range(index.begin(), index.end(), analysis.fixedBy[k]);
    for (auto copy = first; copy != last; ++copy)
        error = std::min(error, errorOf<2>(analysis.fixedPoints[k], maps[std::size_t(copy - index.begin())]));
    return error;
}

// The first of them with their errors.
std::vector<FixedPoint<2>> fixedPoints(const FactSource<2>& source, std::size_t most) {
    std::vector<FixedPoint<2>> points;
    for (std::size_t k = 0; k < source.analysis->fixedPoints.size(); ++k)
        points.push_back({source.analysis->fixedPoints[k], k < most ? errorOf(*source.analysis, k) : 0});
    return points;
}

// Fixed points of the active maps that have one.
std::vector<FixedPoint<3>> fixedPoints(const FactSource<3>& source, std::size_t most) {
    std::vector<FixedPoint<3>> points;
    for (const auto& map : source.facts.active.maps)
        if (const auto point = ifs::fixedPoint(map))
            points.push_back({*point, points.size() < most ? errorOf<3>(*point, map) : 0});
    return points;
}

template <int Dim>
std::optional<QString> fixedPointsText(const FactSource<Dim>& source, const Figures& number) {
    const auto points =
        fixedPoints(source, number.isAbridged ? maxListed : std::numeric_limits<std::size_t>::max());
    if (points.empty()) return std::nullopt;
    return list(points.size(), number, [&](std::size_t i) {
        const auto& [point, error] = points[i];
        const double size = source.facts.box ? sizeOf(source.facts) : point.stableNorm();
        return tupleWithError<Dim>(point, error, size, number);
    });
}

template <int Dim> void addMapLines(const FactSource<Dim>& source, FactLines& lines) {
    std::size_t number = 0;
    for (const auto& map : listedMaps(*source.shape))
        lines.add(Text::tr("map %1").arg(++number),
                  mapLine(map, source.facts.box ? sizeOf(source.facts) : 0));
    if (source.shape->system.symmetry.group != ifs::SymmetryGroup::None)
        lines.add(Text::tr("symmetry"), symmetrySentence(source.shape->system.symmetry));
}

template <int Dim>
std::optional<QString> existenceText(const FactSource<Dim>& source, const Figures& /*number*/) {
    return verdictText(source.facts.existence, source.facts.active.index);
}

template <int Dim> std::optional<ReportedExistence> existenceOf(const ifs::Facts<Dim>& facts) {
    if (facts.isLate(ifs::LongFact::Existence)) return std::nullopt;
    return ReportedExistence{facts.existence, facts.active.index};
}

template <int Dim>
std::optional<QString> contractionsText(const FactSource<Dim>& source, const Figures& number) {
    const auto& maps = source.facts.active.maps;
    return list(maps.size(), number,
                [&](std::size_t i) { return number(ifs::spectralNorm<Dim>(maps[i].linear)); });
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

template <int Dim>
std::vector<std::vector<NonNegative>> linkRows(const ifs::IteratedFunctionSystem<Dim>& system) {
    const std::vector<double> matrix = ifs::linkMatrix(system);
    std::vector<std::vector<NonNegative>> rows(system.maps.size());
    for (std::size_t k = 0; k < matrix.size(); ++k)
        rows[k / system.maps.size()].push_back({matrix[k]});
    return rows;
}

// The share of each map of the chaos game.
template <int Dim> std::vector<NonNegative> visits(const ifs::IteratedFunctionSystem<Dim>& system) {
    const auto active = ifs::activeMaps(system);
    const std::vector<double> stationary = ifs::transitions(active).stationary;
    std::vector<NonNegative> visits(system.maps.size());
    for (std::size_t k = 0; k < active.index.size(); ++k)
        visits[active.index[k]] = {stationary[k]};
    return visits;
}

template <int Dim> void addLinkLines(const FactSource<Dim>& source, FactLines& lines) {
    const auto& system = source.shape->system;
    if (system.links.empty()) return;
    const std::vector<ifs::LinkState> states = ifs::linkStates(system);
    std::size_t map = 0;
    for (const auto& links : linkRows(system)) {
        QStringList row;
        for (const NonNegative& link : links)
            row << reportFigures()(link.value);
        if (const QString state = stateText(states[map]); !state.isEmpty())
            row << QStringLiteral("(%1)").arg(state);
        lines.add(Text::tr("links from map %1").arg(++map), row.join(u' '));
    }
    if (ifs::activeMaps(system).isLinked())
        lines.add(Text::tr("linked maps"), Text::tr("separation, connectedness, joint spectral radius and "
                                                    "periodic addresses are not computed for linked maps"));
}

template <int Dim> QString deformationName(const ifs::ControlCage<Dim>& cage) {
    if (cage.rest.size() == Dim + 1) return QStringLiteral("affine");
    return cage.deformation == ifs::Deformation::Bend ? QStringLiteral("bend") : QStringLiteral("affine_fit");
}

template <int Dim> void addCageLines(const FactSource<Dim>& source, FactLines& lines) {
    const auto& cage = source.shape->cage;
    if (!cage) return;
    const auto list = [](const auto& points) {
        QStringList texts;
        for (const auto& point : points)
            texts << tuple<Dim>(point, 0, 0, reportFigures());
        return texts.join(u' ');
    };
    lines.add(Text::tr("cage at rest"), list(cage->rest));
    lines.add(Text::tr("cage now"), list(cage->current));
    if (cage->rest.size() > Dim + 1)
        lines.add(Text::tr("deformation"),
                  cage->deformation == ifs::Deformation::Bend ? Text::tr("bend") : Text::tr("affine fit"));
}

void describeGroup(JsonSchema& schema) {
    schema.pattern =
        QStringLiteral("^(mirror|[cd]([2-9]|1[0-9]|2[0-4])|tetrahedral|octahedral|icosahedral)$");
}

void describeDeformation(JsonSchema& schema) {
    schema =
        JsonSchema::oneOf({QStringLiteral("affine"), QStringLiteral("bend"), QStringLiteral("affine_fit")});
}

} // namespace

template <int Dim> void addMapFacts(FactRows& rows, const FactSource<Dim>& source) {
    add(rows).inLines(source, addMapLines<Dim>).member("maps", [&source] {
        return OnLines<ReportedMap<Dim>>{listedMaps(*source.shape)};
    });
    add(rows, Text::tr("attractor"))
        .written(source, existenceText<Dim>)
        .member("attractor", [&source] { return existenceOf(source.facts); })
        .isLateWith(ifs::LongFact::Existence, Late::Said)
        .inPanel(FactGroup::Maps, Panel::tr("Attractor"),
                 Panel::tr("A compact set to which the iterates of every compact set converge. A system has "
                           "one if and only if its maps contract in some norm."));
    add(rows)
        .shownAs(source, contractionsText<Dim>)
        .inPanel(FactGroup::Maps, Panel::tr("Contraction"),
                 Panel::tr("‖A‖ of each active map: the largest factor by which it stretches distances."));
    add(rows)
        .shownAs(source, fixedPointsText<Dim>)
        .inPanel(FactGroup::Maps, Panel::tr("Fixed points"),
                 Panel::tr("The point that each map leaves unchanged; it belongs to the attractor."));
}

template void addMapFacts<2>(FactRows&, const FactSource<2>&);
template void addMapFacts<3>(FactRows&, const FactSource<3>&);

template <int Dim> static void members(JsonMembers& out, const ifs::Symmetry<Dim>& symmetry) {
    out("group", Described<QString, describeGroup>{symmetryName(symmetry.group, symmetry.order)},
        "mirror, c2 to c24 (rotation), d2 to d24 (dihedral), tetrahedral, octahedral or icosahedral.");
    out("elements", Whole<2, 60>{int(ifs::groupOrder(symmetry.group, symmetry.order))});
    out("angle", symmetry.angle, "Of a mirror, in degrees.");
    out("centre", symmetry.centre);
    out("frame", symmetry.frame, "The matrix of the frame in which the group has its standard position.");
}

template <int Dim> static void members(JsonMembers& out, const ifs::ControlCage<Dim>& cage) {
    out("rest", AtLeast3<ifs::Vector<Dim>>{cage.rest});
    out("current", AtLeast3<ifs::Vector<Dim>>{cage.current});
    out("deformation", Described<QString, describeDeformation>{deformationName(cage)});
}

template <int Dim> void addEntryFacts(FactRows& rows, const FactSource<Dim>& source) {
    if (!source.shape) return;
    const ifs::IteratedFunctionSystem<Dim>& system = source.shape->system;
    const bool isSymmetric = system.symmetry.group != ifs::SymmetryGroup::None;
    add(rows).member("symmetry", isSymmetric ? std::optional(system.symmetry) : std::nullopt,
                     "The group under which the attractor is symmetric; null without one. The maps are those "
                     "listed in the file; all other facts are those of the system with |elements| maps for "
                     "each of them, and words number the maps as convert --expand lists them.");
    const bool isLinked = !system.links.empty(); // false: any map may follow any other
    add(rows)
        .inLines(source, addLinkLines<Dim>)
        .member(
            "links", isLinked ? std::optional(linkRows(system)) : std::nullopt,
            "By rows: how likely each map is just after this one, as a factor of its weight. Null: all 1.")
        .member("link_states", isLinked ? std::optional(ifs::linkStates(system)) : std::nullopt,
                "For each map, whether it takes part, or why not.")
        .member("visits", isLinked ? std::optional(visits(system)) : std::nullopt,
                "For each map, its share of the chaos game of linked maps.");
    add(rows).inLines(source, addCageLines<Dim>).member("cage", source.shape->cage);
}

template void addEntryFacts<2>(FactRows&, const FactSource<2>&);
template void addEntryFacts<3>(FactRows&, const FactSource<3>&);

} // namespace io
