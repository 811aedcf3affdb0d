// SPDX-License-Identifier: MIT
#include "document/analysis/analysis.h"
#include "document/fractal/fractal_geometry.h"

#include "ifs/dimension/dimension.h"
#include "ifs/linear/symmetric_matrices.h"
#include "ifs/shown_facts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace document {

namespace {

using ifs::Polygon;

constexpr std::size_t maxCylinders = 4096;

// The ellipse on which an even mass has the same mean and covariance: {x : (x − m)ᵀ C⁻¹ (x − m) ≤ 4}.
Polygon ellipse(const ifs::Moments<2>& moments) {
    constexpr int corners = 120;
    const auto [values, axes] = ifs::symmetricEigenvalues<2>(moments.covariance);
    const ifs::Matrix<2> shape = 2 * axes * values.cwiseMax(0).cwiseSqrt().asDiagonal();
    Polygon result;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        result.push_back(moments.mean + shape * ifs::Vector<2>(std::cos(angle), std::sin(angle)));
    }
    return result;
}

// Returns true if the chaos game may apply a map after another, or after itself.
bool mayFollow(const ifs::ActiveMaps<2>& active, std::size_t before, std::size_t after) {
    return !active.isLinked() || active.links[before * active.maps.size() + after] > 0;
}

bool mayRepeat(const ifs::ActiveMaps<2>& active, std::size_t map) {
    return mayFollow(active, map, map);
}

// The change, in coordinates of the picture, that the pieces apply to points whose addresses begin with
// `word`; the identity if only some of these points have moved.
ifs::AffineMap<2> changeOf(const ifs::Word& word, std::span<const ifs::MovedBranch<2>> pieces,
                           const ifs::AffineMap<2>& display) {
    for (const auto& [beginning, change] : pieces)
        if (beginning.size() <= word.size() && std::equal(beginning.begin(), beginning.end(), word.begin()))
            return ifs::conjugate(display, change).value_or(ifs::AffineMap<2>{});
    return {};
}

// The images of the hull under all words of one length, at most so long that there are few enough to see, and
// as outer ones those under the beginnings of these words.
void addCylinders(Analysis& analysis, const ifs::Facts<2>& facts, int depth,
                  const std::vector<attractor::Rgba>& colours) {
    const auto& maps = facts.active.maps;
    if (!facts.hull || maps.empty()) return;
    const Polygon hull = ifs::convexHull(facts.hull->vertices, 1e-3 * std::sqrt(facts.hull->area));
    std::vector<OutlineShape> shapes{{Outline::Cylinders, hull, {}}};
    std::size_t first = 0;
    for (int k = 0; k < depth && (shapes.size() - first) * maps.size() <= maxCylinders; ++k) {
        const std::size_t end = shapes.size();
        for (std::size_t i = 0; i < maps.size(); ++i)
            for (std::size_t shorter = first; shorter < end; ++shorter) {
                if (k > 0 && !mayFollow(facts.active, std::size_t(shapes[shorter].word.front()), i)) continue;
                const std::size_t index = facts.active.index[i];
                OutlineShape shape{Outline::Cylinders, {}, colours[index], {int(i)}, {int(index)}};
                shape.word.insert(shape.word.end(), shapes[shorter].word.begin(), shapes[shorter].word.end());
                shape.listed.insert(shape.listed.end(), shapes[shorter].listed.begin(),
                                    shapes[shorter].listed.end());
                for (const auto& corner : shapes[shorter].points)
                    shape.points.push_back(maps[i](corner));
                shapes.push_back(std::move(shape));
            }
        first = end;
    }
    const auto shown = shapes.begin() + std::ptrdiff_t(first);
    analysis.outerCylinders.assign(shapes.begin(), shown);
    analysis.shapes.insert(analysis.shapes.end(), shown, shapes.end());
}

// Adds all shapes but the cylinders.
void addShapes(Analysis& analysis, const AnalysisRequest& request,
               const std::vector<attractor::Rgba>& colours) {
    const ifs::Facts<2>& facts = analysis.facts;
    const auto wants = [&](Outline kind) { return request.outlines.contains(kind); };
    std::vector<OutlineShape>& shapes = analysis.shapes;
    if (wants(Outline::Box) && facts.box) {
        const auto &low = facts.box->min, &high = facts.box->max;
        shapes.push_back({Outline::Box, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}});
    }
    if (wants(Outline::Simplex) && facts.simplex)
        shapes.push_back(
            {Outline::Simplex, {facts.simplex->vertices.begin(), facts.simplex->vertices.end()}, {}});
    if (wants(Outline::Hull) && facts.hull) shapes.push_back({Outline::Hull, facts.hull->vertices, {}});
    if (wants(Outline::Ellipse) && facts.moments) {
        shapes.push_back({Outline::Ellipse, ellipse(*facts.moments), {}});
        shapes.push_back({Outline::Ellipse, {facts.moments->mean}, {}});
    }
    if (wants(Outline::FixedPoints))
        for (std::size_t k = 0; k < analysis.fixedPoints.size(); ++k)
            shapes.push_back({Outline::FixedPoints, {analysis.fixedPoints[k]}, colours[analysis.fixedBy[k]]});
}

std::vector<attractor::Rgba> mapColours(const Fractal& fractal) {
    std::vector<attractor::Rgba> colours;
    const System2& system = *system2(fractal);
    for (std::size_t k = 0; k < system.maps.size(); ++k)
        colours.push_back(attractor::mapColour(fractal.appearance, system.maps[k].id, k));
    return colours;
}

// The polygon with points along its edges, so that it can follow a bend.
Polygon bent(const Polygon& polygon, const ifs::Placement& placement) {
    constexpr int pieces = 24;
    const int along = std::max(1, pieces * 4 / int(std::max<std::size_t>(polygon.size(), 4)));
    Polygon result;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        for (int n = 0; n < (polygon.size() == 1 ? 1 : along); ++n)
            result.push_back(placement(polygon[k] + (polygon[(k + 1) % polygon.size()] - polygon[k]) *
                                                        (double(n) / along)));
    return result;
}

} // namespace

Analysis Analyser::begunInSpace(const AnalysisRequest& request) {
    const Shape<3>& shape = *space(*request.fractal);
    if (!m_solidCode || m_solidSystem != shape.system) {
        m_solidCode = ifs::geometricFacts(shape.system);
        m_solidSystem = shape.system;
        m_hasSolidInvariants = false;
    }
    Analysis analysis;
    analysis.isComplete = m_hasSolidInvariants;
    analysis.revision = request.revision;
    analysis.isOfCode = shape.cage && ifs::bends(*shape.cage);
    const bool isMoved = shape.cage && !analysis.isOfCode && shape.cage->rest != shape.cage->current;
    const ifs::AffineMap<3> placed = isMoved ? ifs::displayMap(*shape.cage) : ifs::AffineMap<3>();
    analysis.solid = isMoved ? ifs::moved(placed, *m_solidCode) : *m_solidCode;
    if (m_hasSolidInvariants && !analysis.solid->active.maps.empty())
        analysis.solid->invariants = m_solidCode->invariants;
    std::set<Outline> outlines = request.outlines;
    if (const auto pieces = shownBranches(shape, m_solidCode->active); !pieces.empty()) {
        analysis.hasMovedBranches = true;
        analysis.solid = ifs::shown<3>(*std::move(analysis.solid), *m_solidCode, placed, pieces);
        outlines.erase(Outline::Hull); // hull of the code, not of the picture
    }
    if (!outlines.empty())
        analysis.shapesInSpace = spaceOutlines({*m_solidCode, *analysis.solid, placed}, *request.fractal,
                                               outlines, request.cylinderDepth);
    return analysis;
}

Analysis Analyser::begun(const AnalysisRequest& request) {
    if (space(*request.fractal)) return begunInSpace(request);
    const Fractal& fractal = *request.fractal;
    const System2& system = *system2(fractal);
    if (!m_code || m_system != system) {
        m_code = ifs::geometricFacts(system);
        m_system = system;
        m_hasDimension = false;
        m_counted.reset();
    }
    Analysis analysis;
    analysis.revision = request.revision;
    const ifs::Placement placed = placement(fractal);
    analysis.isOfCode = placed.bend() != nullptr;
    m_display = analysis.isOfCode ? ifs::AffineMap<2>{} : placed.affine();
    const ifs::Facts<2> placedCode = ifs::moved(m_display, *m_code);
    const auto pieces = shownBranches(*plane(fractal), m_code->active);
    analysis.hasMovedBranches = !pieces.empty();
    analysis.facts = pieces.empty() ? placedCode : ifs::shown<2>(placedCode, *m_code, m_display, pieces);
    std::size_t longest = 1;
    for (const auto& piece : pieces)
        longest = std::max(longest, piece.word.size());
    for (std::size_t k = 0; k < m_code->active.maps.size(); ++k)
        if (const auto fixed = ifs::fixedPoint(m_code->active.maps[k]);
            fixed && mayRepeat(m_code->active, k)) {
            const ifs::AffineMap<2> change = changeOf(ifs::Word(longest, int(k)), pieces, m_display);
            analysis.fixedPoints.push_back(change(m_display(*fixed)));
            analysis.fixedBy.push_back(m_code->active.index[k]);
        }
    if (m_counted && *m_counted == m_display) {
        addInvariants(analysis);
        analysis.boxCounting = m_boxCounting;
        analysis.isComplete = true;
    }
    const std::vector<attractor::Rgba> colours = mapColours(fractal);
    if (request.outlines.contains(Outline::Cylinders)) {
        addCylinders(analysis, placedCode, request.cylinderDepth, colours);
        for (auto* shapes : {&analysis.shapes, &analysis.outerCylinders})
            for (OutlineShape& shape : *shapes)
                for (const ifs::AffineMap<2> change = changeOf(shape.word, pieces, m_display);
                     ifs::Vector<2> & point : shape.points)
                    point = change(point);
    }
    addShapes(analysis, request, colours);
    if (analysis.isOfCode)
        for (auto* shapes : {&analysis.shapes, &analysis.outerCylinders})
            for (OutlineShape& shape : *shapes)
                shape.points = bent(shape.points, placed);
    return analysis;
}

std::optional<Analysis> Analyser::completedInSpace(Analysis analysis, const std::stop_token& stop) {
    if (!m_hasSolidInvariants) m_solidCode->invariants = ifs::invariantsOf(*m_solidCode);
    m_hasSolidInvariants = true;
    if (stop.stop_requested()) return std::nullopt;
    if (!analysis.solid->active.maps.empty()) analysis.solid->invariants = m_solidCode->invariants;
    analysis.isComplete = true;
    return analysis;
}

void Analyser::addInvariants(Analysis& analysis) const {
    if (analysis.facts.active.maps.empty()) return; // flat picture
    analysis.facts.affinityDimension = m_code->affinityDimension;
    analysis.facts.affinityDimensionError = m_code->affinityDimensionError;
    analysis.facts.isAffinityDimensionCapped = m_code->isAffinityDimensionCapped;
    analysis.facts.invariants =
        ifs::scaled(m_code->invariants, std::abs(ifs::determinant<2>(m_display.linear)));
}

std::optional<Analysis> Analyser::completed(Analysis analysis, const std::stop_token& stop) {
    if (analysis.isComplete) return analysis;
    if (analysis.solid) return completedInSpace(std::move(analysis), stop);
    if (!m_hasDimension) {
        if (!m_code->active.isLinked())
            m_code->affinityDimension = ifs::affinityDimension(m_code->active.maps, stop);
        const auto& moran = m_code->similarityDimension;
        m_code->affinityDimensionError = moran ? ifs::similarityDimensionError<2>(m_code->active.maps, *moran)
                                               : ifs::affinityDimensionError;
        if (stop.stop_requested()) return std::nullopt;
        ifs::capAffinityDimension(*m_code);
        m_code->invariants = ifs::invariantsOf(*m_code);
        if (stop.stop_requested()) return std::nullopt;
        m_hasDimension = true;
    }
    addInvariants(analysis);
    if (!analysis.facts.active.maps.empty() && m_code->support)
        analysis.boxCounting = ifs::boxCounting(*m_code->support, m_display, stop);
    if (stop.stop_requested()) return std::nullopt;
    m_boxCounting = analysis.boxCounting;
    m_counted = m_display;
    analysis.isComplete = true;
    return analysis;
}

} // namespace document
