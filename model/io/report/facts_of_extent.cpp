// SPDX-License-Identifier: MIT
#include "io/report/facts_of_extent.h"

#include "document/edits/cage/cage_edits.h"
#include "document/text/text.h"
#include "ifs/links/linked_extent.h"
#include "io/report/figure_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

namespace io {

namespace {

template <int Dim> std::optional<ifs::Mean<Dim>> meanOf(const ifs::Facts<Dim>& facts) {
    if (facts.moments) return ifs::Mean<Dim>{facts.moments->mean, facts.moments->meanError};
    return facts.mean;
}

template <int Dim> std::optional<QString> meanText(const FactSource<Dim>& source, const Figures& number) {
    const auto mean = meanOf(source.facts);
    if (!mean) return std::nullopt;
    const double size = sizeOf(source.facts);
    if (isWorthless(mean->error, std::max(size, mean->point.stableNorm()))) return unknown();
    return tupleWithError<Dim>(mean->point, mean->error, size, number);
}

// Form of a matrix: by rows in reports, the part above the diagonal in the panel.
enum class MatrixForm { Rows, UpperPart };

template <int Dim, MatrixForm Form>
std::optional<QString> covarianceText(const FactSource<Dim>& source, const Figures& number) {
    if (!source.facts.moments) return std::nullopt;
    const auto& moments = *source.facts.moments;
    const double error = moments.covarianceError, size = std::pow(sizeOf(source.facts), 2);
    if (isWorthless(error, std::max(size, moments.covariance.trace()))) return unknown();
    const ifs::Matrix<Dim> known = withoutNoise(moments.covariance, error);
    std::vector<double> entries;
    QStringList rows, upper;
    for (int row = 0; row < Dim; ++row) {
        rows << tuple<Dim>(known.row(row).transpose(), error, 0, number);
        for (int column = row; column < Dim; ++column) {
            entries.push_back(known(row, column));
            upper << number(entries.back());
        }
    }
    const QString text =
        Form == MatrixForm::Rows ? rows.join(QStringLiteral(" ")) : upper.join(QStringLiteral(", "));
    return text + number.note(entries, error, size);
}

// A box at a point may be off by as much as its coordinates are rounded.
template <int Dim> bool isBoxWorthless(const ifs::BoundingBox<Dim>& box, double size) {
    return isWorthless(box.error, std::max(size, 1e-9 * box.max.stableNorm()));
}

template <int Dim> std::vector<double> endsOf(const ifs::Vector<Dim>& low, const ifs::Vector<Dim>& high) {
    std::vector<double> ends(low.begin(), low.end());
    ends.insert(ends.end(), high.begin(), high.end());
    return ends;
}

// The box by its corners.
template <int Dim> QString boxText(const ifs::BoundingBox<Dim>& box, const Figures& number) {
    const double size = (box.max - box.min).stableNorm();
    if (isBoxWorthless(box, size)) return unknown();
    const ifs::Vector<Dim> low = withoutNoise(box.min, box.error), high = withoutNoise(box.max, box.error);
    return tuple<Dim>(low, box.error, size, number) + u' ' + tuple<Dim>(high, box.error, size, number) +
           number.note(endsOf<Dim>(low, high), box.error, size);
}

// The box by its sides.
template <int Dim> std::optional<QString> sidesText(const FactSource<Dim>& source, const Figures& number) {
    if (!source.facts.box) return std::nullopt;
    const auto& box = *source.facts.box;
    const double size = sizeOf(source.facts);
    if (isBoxWorthless(box, size)) return unknown();
    const ifs::Vector<Dim> low = withoutNoise(box.min, box.error), high = withoutNoise(box.max, box.error);
    QStringList sides;
    for (int axis = 0; axis < Dim; ++axis)
        sides << QStringLiteral("[%1, %2]")
                     .arg(number(low[axis], box.error, size), number(high[axis], box.error, size));
    return sides.join(QStringLiteral(" × ")) + number.note(endsOf<Dim>(low, high), box.error, size);
}

constexpr auto certified = "Certified: the truth is within this distance outside what is given.";

// Boxes of the parts of linked maps, by the maps that make them: none for a map that takes no part, and
// nothing for maps that are not linked.
using Parts = std::vector<std::optional<ifs::BoundingBox<2>>>;

std::optional<Parts> partsOf(const FactSource<2>& source) {
    if (source.facts.isLate(ifs::LongFact::Extents)) return std::nullopt;
    const auto& system = source.shape->system;
    Parts parts = ifs::boxesOfParts(source.facts.active, source.facts.existence, system.maps.size(),
                                    ifs::copiesOfEachMap(system));
    return parts.empty() ? std::nullopt : std::optional(std::move(parts));
}

std::optional<Parts> partsOf(const FactSource<3>&) {
    return std::nullopt;
}

template <int Dim> std::optional<QString> cornersText(const FactSource<Dim>& source, const Figures& number) {
    if (!source.facts.simplex) return std::nullopt;
    const auto& [orientation, leg, vertices, error] = *source.facts.simplex;
    if (isWorthless(error, leg)) return unknown();
    QStringList corners;
    QString note;
    for (const auto& vertex : vertices) {
        const ifs::Vector<Dim> known = withoutNoise(vertex, error);
        corners << tuple<Dim>(known, error, leg, number);
        if (note.isEmpty()) note = number.note({known.begin(), known.end()}, error, leg);
    }
    return corners.join(u' ') + note;
}

template <int Dim> std::optional<QString> legText(const FactSource<Dim>& source, const Figures& number) {
    if (!source.facts.simplex) return std::nullopt;
    const auto& [orientation, leg, vertices, error] = *source.facts.simplex;
    if (isWorthless(error, leg)) return unknown();
    const ifs::Vector<Dim> corner = withoutNoise(vertices[0], error);
    std::vector<double> values(corner.begin(), corner.end());
    values.push_back(leg);
    return Panel::tr("%1, leg %2, corner %3")
               .arg(document::orientationText(orientation), number(leg),
                    tuple<Dim>(corner, error, leg, number)) +
           number.note(values, error, leg);
}

// The size of the hull where no box is known.
template <int Dim> double extentOf(const ifs::Facts<Dim>& facts) {
    if (facts.box) return sizeOf(facts);
    ifs::Vector<Dim> low = facts.hull->vertices.front(), high = low;
    for (const auto& vertex : facts.hull->vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    return (high - low).stableNorm();
}

double contentOf(const ifs::ConvexHull& hull) {
    return hull.area;
}
double contentOf(const ifs::ConvexHull3& hull) {
    return hull.volume;
}
double contentError(const ifs::ConvexHull& hull) {
    return ifs::areaError(hull);
}
double contentError(const ifs::ConvexHull3& hull) {
    return ifs::volumeError(hull);
}

// The text of an area or a volume; of a point, what rounding leaves of it.
template <int Dim> std::optional<QString> contentText(const FactSource<Dim>& source, const Figures& number) {
    if (!source.facts.hull) return std::nullopt;
    const auto& hull = *source.facts.hull;
    const double content = contentOf(hull), error = contentError(hull);
    const double size =
        std::pow(std::max(extentOf(source.facts), 1e-9 * hull.vertices.front().stableNorm()), Dim);
    if (isWorthless(error, std::max(content, 1e-3 * size))) return unknown();
    return number(content, error, size) + number.note({content}, error, size);
}

QString vertexCount(std::size_t vertices) {
    return vertices == 1 ? Text::tr("1 vertex") : Text::tr("%1 vertices").arg(vertices);
}

// The number of vertices, marked if the hull, and with it this number, is not known exactly.
template <int Dim> QString withItsExactness(const QString& count, const ifs::Facts<Dim>& facts) {
    constexpr double roundOff = 1e-9; // of the size
    const bool isExact = facts.isHullExact || facts.hull->error <= roundOff * extentOf<Dim>(facts);
    return isExact ? count : Panel::tr("%1 (approximation)").arg(count);
}

std::optional<QString> hullText(const FactSource<2>& source, const Figures& number) {
    const auto& hull = source.facts.hull;
    if (!hull) return std::nullopt;
    const QString area = *contentText<2>(source, number);
    const QString vertices = withItsExactness<2>(vertexCount(hull->vertices.size()), source.facts);
    if (source.facts.isLate(ifs::LongFact::ExtremePoints))
        return Text::tr("%1, area %2; error at most %3; periodic addresses not computed within the budget")
            .arg(vertices, area, upperDigits(hull->error));
    if (source.facts.isHullExact)
        return hull->vertices.size() == 1
                   ? Text::tr("a point; exact")
                   : Text::tr("%1, all of them with periodic addresses, area %2; exact").arg(vertices, area);
    return Text::tr("%1, %2 of them with periodic addresses, area %3; error at most %4")
        .arg(vertices)
        .arg(std::ranges::count_if(source.facts.extremePoints,
                                   [](const auto& point) { return point.has_value(); }))
        .arg(area, upperDigits(hull->error));
}

std::optional<QString> hullText(const FactSource<3>& source, const Figures& number) {
    const auto& hull = source.facts.hull;
    if (!hull) return std::nullopt;
    return Text::tr("%1, %2, volume %3; error at most %4")
        .arg(withItsExactness<3>(vertexCount(hull->vertices.size()), source.facts))
        .arg(hull->facets.size() == 1 ? Text::tr("1 facet") : Text::tr("%1 facets").arg(hull->facets.size()))
        .arg(*contentText<3>(source, number), upperDigits(hull->error));
}

template <int Dim> std::optional<QString> verticesText(const FactSource<Dim>& source, const Figures& number) {
    const auto& hull = source.facts.hull;
    if (!hull) return std::nullopt;
    return withItsExactness<Dim>(number.count(hull->vertices.size()), source.facts);
}

struct Address {
    NumberedWord prefix, period;
};

void members(JsonMembers& out, const Address& address) {
    out("prefix", address.prefix);
    out("period", address.period);
}

template <int Dim> struct ReportedHull {
    ifs::HullIn<Dim> hull;
    std::vector<std::optional<Address>> addresses{};
    bool isExact = false;
};

template <int Dim> std::optional<ReportedHull<Dim>> hullOf(const ifs::Facts<Dim>& facts) {
    if (!facts.hull) return std::nullopt;
    ReportedHull<Dim> reported{*facts.hull, {}, facts.isHullExact};
    for (const auto& point : facts.extremePoints)
        reported.addresses.push_back(point
                                         ? std::optional(Address{numbered(point->prefix, facts.active.index),
                                                                 numbered(point->period, facts.active.index)})
                                         : std::nullopt);
    return reported;
}

template <int Dim> void members(JsonMembers& out, const ReportedHull<Dim>& reported) {
    const auto& hull = reported.hull;
    out.define("hull", "area and addresses in the plane, volume and facets in space");
    out("vertices", hull.vertices, "Counter-clockwise in the plane.");
    if constexpr (Dim == 2) {
        out("area", hull.area);
        out("area_error", NonNegative{contentError(hull)}, "At most so far from the area of the true hull.");
        out("addresses", reported.addresses, "For each vertex its address, null where none is known.");
        out("exact", reported.isExact,
            "In the plane: proved in rational numbers; the vertices are those of the exact hull, rounded to "
            "doubles.");
    } else {
        out("volume", hull.volume);
        out("volume_error", NonNegative{contentError(hull)},
            "At most so far from the volume of the true hull.");
        std::vector<AtLeast3<Whole<>>> facets;
        for (const auto& [a, b, c] : hull.facets)
            facets.push_back({{{a}, {b}, {c}}});
        out("facets", facets, "In space: indices of vertices.");
    }
    out("error", NonNegative{hull.error}, certified);
}

template <int Dim>
std::optional<QString> boxCornersText(const FactSource<Dim>& source, const Figures& number) {
    return source.facts.box ? std::optional(boxText(*source.facts.box, number)) : std::nullopt;
}

template <int Dim> std::optional<QString> boxErrorText(const FactSource<Dim>& source, const Figures& number) {
    return source.facts.box ? std::optional(number.bound(source.facts.box->error)) : std::nullopt;
}

template <int Dim>
std::optional<QString> hullErrorText(const FactSource<Dim>& source, const Figures& number) {
    return source.facts.hull ? std::optional(number.bound(source.facts.hull->error)) : std::nullopt;
}

template <int Dim> std::optional<OnLines<Parts::value_type>> reportedParts(const FactSource<Dim>& source) {
    const auto parts = partsOf(source);
    return parts ? std::optional(OnLines<Parts::value_type>{*parts}) : std::nullopt;
}

template <int Dim> void addPartLines(const FactSource<Dim>& source, FactLines& lines) {
    int map = 0;
    for (const auto& box : partsOf(source).value_or(Parts()))
        if (++map; box) lines.add(Text::tr("part of map %1").arg(map), boxText(*box, reportFigures()));
}

// The member of a value; nullopt if there is none.
template <class Known, class Member> auto memberOf(const std::optional<Known>& known, Member member) {
    return known ? std::optional(std::invoke(member, *known)) : std::nullopt;
}

void describeSigns(JsonSchema& schema) {
    schema.pattern = QStringLiteral("^[+-]{2,3}$");
}

} // namespace

template <int Dim> static void members(JsonMembers& out, const ifs::CanonicalSimplex<Dim>& simplex) {
    const auto& [orientation, leg, vertices, error] = simplex;
    QString signs;
    for (const int sign : orientation)
        signs += sign > 0 ? u'+' : u'-';
    out("orientation", Described<QString, describeSigns>{signs}, "One sign for each axis.");
    out("leg", leg);
    out("vertices", AtLeast3<ifs::Vector<Dim>, Dim + 1>{{vertices.begin(), vertices.end()}});
    out("error", NonNegative{error}, certified);
}

template <int Dim> static void members(JsonMembers& out, const ifs::BoundingBox<Dim>& box) {
    out("min", box.min);
    out("max", box.max);
    out("error", NonNegative{box.error}, certified);
}

template <int Dim> void addMoments(FactRows& rows, const FactSource<Dim>& source) {
    const auto& [mean, moments] = std::tie(source.facts.mean, source.facts.moments);
    add(rows, Text::tr("mean"))
        .written(source, meanText<Dim>)
        .member("mean", memberOf(mean, &ifs::Mean<Dim>::point), "Of the invariant measure of the weights.")
        .member("mean_error", nonNegative(memberOf(mean, &ifs::Mean<Dim>::error)),
                "The true mean is within this distance.")
        .inPanel(FactGroup::Moments, Panel::tr("Mean"),
                 Panel::tr("Mean of the invariant measure, solved without sampling: the centre of mass of "
                           "the picture."));
    add(rows, Text::tr("covariance"))
        .written(source, covarianceText<Dim, MatrixForm::Rows>)
        .shownAs(source, covarianceText<Dim, MatrixForm::UpperPart>)
        .member("covariance", memberOf(moments, &ifs::Moments<Dim>::covariance))
        .member("covariance_error", nonNegative(memberOf(moments, &ifs::Moments<Dim>::covarianceError)),
                "No element is farther from its true value.")
        .inPanel(
            FactGroup::Moments, Panel::tr("Covariance"),
            Dim == 2
                ? Panel::tr(
                      "Covariance xx, xy, yy of the invariant measure, solved without sampling: how far the "
                      "picture spreads. A uniform mass on the ellipse has the same mean and covariance.")
                : Panel::tr("Covariance xx, xy, xz, yy, yz, zz of the invariant measure, solved without "
                            "sampling: how far the picture spreads."));
}

template <int Dim> void addExtents(FactRows& rows, const FactSource<Dim>& source) {
    add(rows, Text::tr("bounding box"))
        .written(source, boxCornersText<Dim>)
        .shownAs(source, sidesText<Dim>)
        .member("bounding_box", source.facts.box)
        .isLateWith(ifs::LongFact::Extents, Late::Said)
        .inPanel(FactGroup::Extents, Dim == 2 ? Panel::tr("Box") : Panel::tr("Box", "in space"),
                 Dim == 2 ? Panel::tr("The smallest box with sides parallel to the axes that contains the "
                                      "attractor; certified. Each side is off by at most the error.")
                          : Panel::tr("The smallest box with edges parallel to the axes that contains the "
                                      "attractor, to the error bound."));
    if (Dim == 3)
        add(rows)
            .shownAs(source, boxErrorText<Dim>)
            .inPanel(FactGroup::Extents, Panel::tr("Box error bound"),
                     Panel::tr("The attractor extends at most this far beyond the box; certified."));
    add(rows).member(
        "parts", [&source] { return reportedParts(source); },
        "Of linked maps in the plane, at most 64 of them: for each map, the box of the part of the attractor "
        "that it makes. Null for a map that takes no part.");
    add(rows, Text::tr("canonical simplex"))
        .written(source, cornersText<Dim>)
        .shownAs(source, legText<Dim>)
        .member("canonical_simplex", source.facts.simplex,
                "The minimal canonical simplex around the attractor.")
        .isLateWith(ifs::LongFact::Extents, Late::Said)
        .inPanel(FactGroup::Extents, Panel::tr("Canonical simplex"),
                 Dim == 2 ? Panel::tr("The smallest isosceles right triangle with legs parallel to the axes "
                                      "that contains the attractor; certified. The signs give the directions "
                                      "of its legs. For a single point, the leg is 1.")
                          : Panel::tr("The smallest tetrahedron with three equal legs parallel to the axes "
                                      "that contains the attractor; certified. The signs give the directions "
                                      "of its legs. For a single point, the leg is 1."));
    add(rows).inLines(source, addPartLines<Dim>);
}

template <int Dim> void addHull(FactRows& rows, const FactSource<Dim>& source) {
    add(rows, Text::tr("convex hull"))
        .written(source,
                 static_cast<std::optional<QString> (*)(const FactSource<Dim>&, const Figures&)>(hullText))
        .member("hull", [&source] { return hullOf(source.facts); })
        .isLateWith(ifs::LongFact::Hull, Late::Said);
    add(rows)
        .shownAs(source, contentText<Dim>)
        .inPanel(FactGroup::Hull, Dim == 2 ? Panel::tr("Hull area") : Panel::tr("Hull volume"),
                 Dim == 2 ? Panel::tr("Area of the computed hull, whose vertices are points of the "
                                      "attractor. The exact convex hull is larger by at most its perimeter "
                                      "times the error bound e, and πe² for the corners.")
                          : Panel::tr("Volume of the computed hull, whose vertices are points of the "
                                      "attractor. The exact convex hull is larger by at most the error."));
    add(rows)
        .shownAs(source, verticesText<Dim>)
        .inPanel(FactGroup::Hull, Panel::tr("Hull vertices"),
                 Panel::tr("Vertices of the computed hull; each is a point of the attractor. If the exact "
                           "hull has infinitely many, as many are computed as the tolerance requires."));
    add(rows)
        .shownAs(source, hullErrorText<Dim>)
        .inPanel(FactGroup::Hull, Panel::tr("Hull error bound"),
                 Dim == 2
                     ? Panel::tr("The attractor extends at most this far beyond the polygon; certified.")
                     : Panel::tr("The attractor extends at most this far beyond the polyhedron; certified."));
}

template void addMoments<2>(FactRows&, const FactSource<2>&);
template void addMoments<3>(FactRows&, const FactSource<3>&);
template void addExtents<2>(FactRows&, const FactSource<2>&);
template void addExtents<3>(FactRows&, const FactSource<3>&);
template void addHull<2>(FactRows&, const FactSource<2>&);
template void addHull<3>(FactRows&, const FactSource<3>&);

} // namespace io
