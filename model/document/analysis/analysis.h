// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis/space_outlines.h"
#include "document/fractal/fractal.h"
#include "ifs/dimension/box_counting.h"
#include "ifs/extent/polygon.h"
#include "ifs/facts.h"
#include "ifs/system/branch.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <vector>

namespace document {

struct AnalysisRequest {
    std::shared_ptr<const Fractal> fractal;
    std::set<Outline> outlines;
    int cylinderDepth = 1; // address length of the outlined cylinders
    std::uint64_t revision = 0;
};

// A shape to draw, in displayed coordinates; more than one point are a closed polygon.
struct OutlineShape {
    Outline kind;
    ifs::Polygon points;
    // Colour of the map of a fixed point, or of the first map of a cylinder.
    std::optional<attractor::Rgba> colour;
    ifs::Word word{};   // address of a cylinder, over the maps that the chaos game applies
    ifs::Word listed{}; // address by indices in the system, where a symmetry makes several maps of one
};

// Analysis of a picture: of the code's attractor where its cage puts it. Only a cage that bends leaves no
// system to analyse; then the facts are those of the code, and the shapes are bent with it. If branches are
// moved, extents, mean and covariance are those of what is shown, everything else that of the code. For a
// system in space only `solid` and its shapes are set.
struct Analysis {
    std::uint64_t revision = 0; // revision of the request
    bool isOfCode = false;
    bool hasMovedBranches = false;
    ifs::Facts<2> facts;
    std::optional<ifs::Facts<3>> solid;
    std::vector<ifs::Vector<2>> fixedPoints; // fixed points of the active maps, if they have one
    std::vector<std::size_t> fixedBy;        // maps of the fixed points: indices in the system
    std::optional<ifs::BoxCounting> boxCounting;
    std::vector<OutlineShape> shapes;
    std::vector<OutlineShape> outerCylinders; // cylinders that contain those of `shapes`; not drawn
    std::vector<SpaceOutline> shapesInSpace;
    bool isComplete = false; // false: the affinity dimension and the box counting are still being computed
};

// Analyses one fractal after the other. Facts of the code are computed once for as long as only the cage
// moves, and nothing is when only other outlines are requested.
class Analyser {
public:
    // The part that takes a few milliseconds, in space perhaps a second; complete where the rest is known
    // already. The fractal must be a system.
    Analysis begun(const AnalysisRequest& request);
    // The rest of it; nullopt when stopped.
    std::optional<Analysis> completed(Analysis analysis, const std::stop_token& stop);

private:
    void addInvariants(Analysis& analysis) const; // invariants of the code
    Analysis begunInSpace(const AnalysisRequest& request);
    std::optional<Analysis> completedInSpace(Analysis analysis, const std::stop_token& stop);

    System2 m_system;
    // Facts of m_system, with the affinity dimension once it has been requested.
    std::optional<ifs::Facts<2>> m_code;
    bool m_hasDimension = false;
    ifs::AffineMap<2> m_display;                   // display of the latest request
    std::optional<ifs::BoxCounting> m_boxCounting; // box counting of the code displayed by m_counted
    std::optional<ifs::AffineMap<2>> m_counted;
    System3 m_solidSystem;
    std::optional<ifs::Facts<3>> m_solidCode; // facts of m_solidSystem
    bool m_hasSolidInvariants = false;
};

} // namespace document
