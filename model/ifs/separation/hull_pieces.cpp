// SPDX-License-Identifier: MIT
#include "ifs/separation/hull_pieces.h"

#include "ifs/separation/affine_hull.h"
#include "ifs/separation/exact_map.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace ifs {

namespace {

constexpr std::size_t maxImages = 64;

bool isLess(const Dyadic& a, const Dyadic& b) {
    return (a - b).sign() < 0;
}

// Maps t ↦ (slope·t + shift)/unit of a line, unit > 0, all |slope| < unit.
struct LineMaps {
    struct Map {
        Dyadic slope, shift;
    };
    std::vector<Map> maps;
    Dyadic unit;
};

struct Interval {
    Dyadic low, high;
};

// The hull of a set on a line and its images, in one and the same unit.
struct LineImages {
    Interval hull;
    std::vector<Interval> images;
    Dyadic unit; // 1 in this unit
};

// Ends of the hull of which one is an end's image by the map `top`, the other by `bottom`, over `scale`.
struct Ends {
    Dyadic high, low, scale;
};

// unit·high = slope·(high or low) + shift of the top, and likewise of the bottom: Cramer's rule.
Ends endsOf(const LineMaps& line, const LineMaps::Map& top, const LineMaps::Map& bottom) {
    const Dyadic zero;
    const bool isTopTurned = top.slope.sign() < 0, isBottomTurned = bottom.slope.sign() < 0;
    const Dyadic e = isTopTurned ? line.unit : line.unit - top.slope;
    const Dyadic f = isTopTurned ? top.slope : zero;
    const Dyadic g = isBottomTurned ? bottom.slope : zero;
    const Dyadic h = isBottomTurned ? line.unit : line.unit - bottom.slope;
    return {top.shift * h + f * bottom.shift, e * bottom.shift + g * top.shift, e * h - f * g};
}

// Each step takes the maps that lead farthest out from the ends so far; where none leads farther, these are
// the ends of the attractor.
std::optional<LineImages> imagesOf(const LineMaps& line) {
    constexpr int maxSteps = 64;
    std::size_t top = 0, bottom = 0;
    for (int step = 0; step < maxSteps; ++step) {
        const Ends ends = endsOf(line, line.maps[top], line.maps[bottom]);
        if (ends.scale.sign() <= 0) return std::nullopt;
        LineImages result{{line.unit * ends.low, line.unit * ends.high}, {}, line.unit * ends.scale};
        for (const auto& [slope, shift] : line.maps) {
            Interval image{slope * ends.low + shift * ends.scale, slope * ends.high + shift * ends.scale};
            if (slope.sign() < 0) std::swap(image.low, image.high);
            result.images.push_back(std::move(image));
        }
        std::size_t farTop = top, farBottom = bottom;
        for (std::size_t i = 0; i < result.images.size(); ++i) {
            if (isLess(result.images[farTop].high, result.images[i].high)) farTop = i;
            if (isLess(result.images[i].low, result.images[farBottom].low)) farBottom = i;
        }
        if (farTop == top && farBottom == bottom) return result;
        top = farTop;
        bottom = farBottom;
    }
    return std::nullopt;
}

// The maps of the line p + t·v/d, where p is the fixed point of the first map and d its denominator.
template <int Dim> LineMaps alongLine(std::span<const AffineMap<Dim>> maps, const HullBasis<Dim>& basis) {
    const auto& [direction, pivot] = basis.directions.front();
    const bool isNegative = direction[pivot].sign() < 0, isBelow = basis.point.denominator.sign() < 0;
    LineMaps result;
    result.unit = isNegative ? -direction[pivot] : direction[pivot];
    for (int i = 0; i < int(maps.size()); ++i) {
        const auto map = exactWord<Dim>(maps, {i});
        const auto moved = image(map, basis.point);
        Dyadic slope, shift = moved.numerator[pivot] - basis.point.numerator[pivot];
        for (std::size_t k = 0; k < Dim; ++k)
            slope = slope + map.linear[pivot][k] * direction[k];
        result.maps.push_back({isNegative ? -slope : slope, isBelow == isNegative ? shift : -shift});
    }
    return result;
}

// The maps of each axis along which the attractor extends; none where some map is not along the axes.
template <int Dim> std::vector<LineMaps> alongAxes(std::span<const AffineMap<Dim>> maps) {
    std::vector<LineMaps> result;
    for (const auto& map : maps)
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j)
                if (i != j && map.linear(i, j) != 0) return {};
    for (int axis = 0; axis < Dim; ++axis) {
        LineMaps line{{}, Dyadic(1)};
        for (const auto& map : maps)
            line.maps.push_back({Dyadic(map.linear(axis, axis)), Dyadic(map.translation[axis])});
        result.push_back(std::move(line));
    }
    return result;
}

// Returns true if any two images are apart along some axis.
template <class Apart> bool areAllApart(const std::vector<LineImages>& axes, Apart areApart) {
    const std::size_t count = axes.front().images.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (std::ranges::none_of(
                    axes, [&](const LineImages& axis) { return areApart(axis.images[i], axis.images[j]); }))
                return false;
    return true;
}

bool haveDisjointInsides(const std::vector<LineImages>& axes) {
    const auto isFlat = [](const Interval& image) { return !isLess(image.low, image.high); };
    return std::ranges::none_of(
               axes, [&](const LineImages& axis) { return std::ranges::any_of(axis.images, isFlat); }) &&
           areAllApart(axes, [](const Interval& a, const Interval& b) {
               return !isLess(a.low, b.high) || !isLess(b.low, a.high);
           });
}

bool areDisjoint(const std::vector<LineImages>& axes) {
    return areAllApart(axes, [](const Interval& a, const Interval& b) {
        return isLess(a.high, b.low) || isLess(b.high, a.low);
    });
}

// The cells between neighbouring ends of the images along one axis, and which of them each image holds.
struct Cells {
    std::size_t count = 0;
    std::vector<std::pair<std::size_t, std::size_t>> ofImages; // first, and one after the last
};

Cells cellsOf(const LineImages& axis) {
    std::vector<Dyadic> ends{axis.hull.low, axis.hull.high};
    for (const auto& [low, high] : axis.images) {
        ends.push_back(low);
        ends.push_back(high);
    }
    std::ranges::sort(ends, isLess);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto place = [&ends](const Dyadic& end) {
        return std::size_t(std::ranges::lower_bound(ends, end, isLess) - ends.begin());
    };
    Cells result{ends.size() - 1, {}};
    for (const auto& [low, high] : axis.images)
        result.ofImages.emplace_back(place(low), place(high));
    return result;
}

// Every cell of the box lies in an image.
bool coverHull(const std::vector<LineImages>& axes) {
    constexpr std::size_t maxWork = 4'000'000;
    std::vector<Cells> cells;
    std::size_t count = 1;
    for (const LineImages& axis : axes) {
        cells.push_back(cellsOf(axis));
        count *= cells.back().count;
    }
    const std::size_t images = axes.front().images.size();
    if (count * images > maxWork) return false;
    const auto holds = [&cells](std::size_t image, std::size_t cell) {
        return std::ranges::all_of(cells, [&](const Cells& axis) {
            const std::size_t at = cell % axis.count;
            cell /= axis.count;
            return axis.ofImages[image].first <= at && at < axis.ofImages[image].second;
        });
    };
    for (std::size_t cell = 0; cell < count; ++cell) {
        bool isHeld = false;
        for (std::size_t image = 0; image < images && !isHeld; ++image)
            isHeld = holds(image, cell);
        if (!isHeld) return false;
    }
    return true;
}

} // namespace

template <int Dim> std::optional<HullPieces> piecesOfHull(std::span<const AffineMap<Dim>> maps) {
    if (maps.size() < 2 || maps.size() > maxImages) return std::nullopt;
    const auto basis = hullBasis<Dim>(maps);
    if (!basis || basis->directions.empty()) return std::nullopt;
    const bool isLine = basis->directions.size() == 1;
    std::vector<LineMaps> lines;
    if (isLine)
        lines.push_back(alongLine<Dim>(maps, *basis));
    else
        lines = alongAxes<Dim>(maps);
    std::vector<LineImages> axes;
    for (const LineMaps& line : lines) {
        auto images = imagesOf(line);
        if (!images) return std::nullopt;
        if (isLess(images->hull.low, images->hull.high)) axes.push_back(std::move(*images));
    }
    // Without turns, an attractor in a leaning plane or on a leaning line fills no box.
    if (axes.size() != basis->directions.size()) return std::nullopt;
    HullPieces result{int(axes.size()), haveDisjointInsides(axes), areDisjoint(axes), coverHull(axes)};
    if (Dim == 2 && axes.size() == 2) {
        result.area = 1;
        for (const auto& [hull, images, unit] : axes)
            *result.area *= roundedQuotient(hull.high - hull.low, unit);
    }
    return result;
}

template std::optional<HullPieces> piecesOfHull<2>(std::span<const AffineMap<2>>);
template std::optional<HullPieces> piecesOfHull<3>(std::span<const AffineMap<3>>);

} // namespace ifs
