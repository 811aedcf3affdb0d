// SPDX-License-Identifier: MIT
#include "io/solid/printable_solid.h"

#include "attractor/voxels/voxel_cover.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/text/text.h"
#include "ifs/extent/extent.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace io {

namespace {

using attractor::VoxelCover;

// √3 (g + the fineness of the cover + the bars) ≤ √3 h.
constexpr double gridShare = 1 / (1 + VoxelCover::fineness + 1.0 / attractor::latticePerVoxel);

struct Box {
    ifs::Vector<3> min;
    ifs::Vector<3> max;
};

Box boxOf(const ifs::SupportFunction<3>& support, const ifs::AffineMap<3>& placement,
          const std::vector<ifs::AffineMap<3>>& pieces) {
    constexpr double fine = 1e-7; // relative to the size
    const auto reach = [&](const ifs::Vector<3>& u) {
        double farthest = -HUGE_VAL;
        for (const ifs::AffineMap<3>& piece : pieces) {
            const ifs::AffineMap<3> placed = placement * piece;
            const ifs::Vector<3> inner = placed.linear.transpose() * u;
            const auto value = support(inner, fine * support.radius() * inner.norm());
            farthest = std::max(farthest, value.value + value.error + u.dot(placed.translation));
        }
        return farthest;
    };
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.max[k] = reach(ifs::Vector<3>::Unit(k));
        box.min[k] = -reach(-ifs::Vector<3>::Unit(k));
    }
    return box;
}

// Returns true if neighbouring points of the lattice stay apart in the numbers of the file.
bool keepsPointsApart(const PrintableSolid& solid) {
    for (const auto& point : solid.mesh.points)
        for (int k = 0; k < 3; ++k) {
            const double at = solid.origin[k] + solid.unit * point[std::size_t(k)];
            if (!(float(at + solid.unit) > float(at)) || !std::isfinite(float(at + solid.unit))) return false;
        }
    return true;
}

QString number(double value) {
    return QLocale::c().toString(value, 'g', 6);
}

class Maker {
public:
    Maker(const document::Fractal& fractal, const SolidOptions& options)
        : m_fractal(fractal), m_options(options) {}

    Failure prepare() {
        if (Failure obstacle = place()) return obstacle;
        const double voxel = m_options.voxel > 0 ? m_options.voxel : voxelAt(m_options.resolution);
        if (!fits(voxel)) return excess();
        m_solid.facts.voxel = voxel;
        m_solid.facts.dilation = std::numbers::sqrt3 * m_side * m_dilation;
        m_solid.facts.bound = std::numbers::sqrt3 * voxel + m_solid.facts.dilation;
        return std::nullopt;
    }

    PrintableSolid make(const Progress& progress, const std::stop_token& stop) {
        m_solid.failure = prepare();
        if (m_solid.failure) return std::move(m_solid);
        VoxelCover cover = attractor::voxelCover(request(), progress, stop);
        m_solid.stopped = cover.outcome == VoxelCover::Outcome::Stopped;
        if (m_solid.stopped) return std::move(m_solid);
        if (cover.outcome != VoxelCover::Outcome::Done) {
            m_solid.failure =
                isAtLowest()
                    ? Text::tr("The pieces of “%1” overlap or touch too much to find its voxels in "
                               "reasonable time, even at the lowest resolution.")
                          .arg(m_fractal.name)
                    : Text::tr(
                          "The pieces of “%1” overlap or touch too much to find its voxels in reasonable "
                          "time. Choose a lower resolution, which makes larger voxels.")
                          .arg(m_fractal.name);
            return std::move(m_solid);
        }
        build(cover);
        if (progress) progress(1);
        return std::move(m_solid);
    }

private:
    attractor::VoxelRequest request() const {
        return {m_system, m_placement, m_box.min, m_box.max, m_side, m_dilation};
    }

    Failure place() {
        if (Failure obstacle = obstacleToSolid(m_fractal)) return obstacle;
        const document::Shape<3>* shape = document::space(m_fractal);
        m_system = attractor::preparedSpace(shape->system, document::movedBranches(*shape));
        const auto support = m_system.isCertified ? ifs::SupportFunction<3>::of(m_system.maps) : std::nullopt;
        if (!support)
            return Text::tr("“%1” has no certified attractor, so it has no solid.").arg(m_fractal.name);
        if (shape->cage) m_placement = ifs::displayMap(*shape->cage);
        m_box = boxOf(*support, m_placement, document::shownPieces(*shape));
        const double longest = (m_box.max - m_box.min).maxCoeff();
        if (!(longest < HUGE_VAL)) return Text::tr("“%1” is too large for a solid.").arg(m_fractal.name);
        // True up to rounding, which grows with the distance from the origin: a common fixed point of all
        // maps.
        const double farthest = m_box.max.cwiseAbs().cwiseMax(m_box.min.cwiseAbs()).maxCoeff();
        if (!(longest > 1e-13 * farthest) && (m_options.voxel == 0 || m_options.longest > 0))
            return Text::tr("“%1” is a single point: only the size of its voxel can be chosen.")
                .arg(m_fractal.name);
        const double scale = m_options.longest > 0 ? m_options.longest / longest : 1;
        m_placement = {scale * m_placement.linear, scale * m_placement.translation};
        m_box = {scale * m_box.min, scale * m_box.max};
        m_longest = scale * longest;
        return std::nullopt;
    }

    bool isAtLowest() const {
        return m_options.voxel == 0 && m_options.resolution <= SolidOptions::leastOffered;
    }

    double voxelAt(int resolution) const { return m_longest / std::max(1, resolution); }

    bool fits(double voxel) {
        m_side = gridShare * voxel;
        const double thicker = std::ceil((m_options.wall * mostGrowth() / m_side - 1) / 2);
        if (!(thicker < double(SolidOptions::maxResolution))) return false;
        m_dilation = std::max(0, int(thicker));
        return attractor::fitsGrid(request());
    }

    // Bound of the longest side of the mesh relative to that of the attractor, which takes the wall's room
    // and that of the voxels at both ends. The mesh shrinks by so much at most, and its walls with it.
    double mostGrowth() const {
        if (!(m_options.longest > 0)) return 1;
        const double room = 1 - m_options.wall / m_longest;
        return room > 0 ? (1 + 4 * m_side / m_longest) / room : HUGE_VAL;
    }

    // The longest side is what was asked, though the mesh is larger than the attractor.
    void shrink() {
        SolidFacts& facts = m_solid.facts;
        const double longest = facts.size.maxCoeff();
        if (!(m_options.longest > 0) || !(longest > 0)) return;
        const double factor = m_options.longest / longest;
        m_solid.origin *= factor;
        m_solid.unit *= factor;
        facts.size *= factor;
        for (double* length : {&facts.voxel, &facts.dilation, &facts.bound})
            *length *= factor;
        for (double* volume : {&facts.volume, &facts.cavityVolume})
            *volume *= factor * factor * factor;
    }

    QString excess() {
        const QString millions = QString::number(attractor::VoxelGrid::maxVoxels / 1'000'000);
        if (m_options.voxel > 0)
            return Text::tr("The solid of “%1” would need more than %2 million voxels. Choose larger voxels.")
                .arg(m_fractal.name, millions);
        int most = 0; // largest that fits; 0: none
        for (int excessive = std::max(1, m_options.resolution); excessive - most > 1;) {
            const int middle = std::midpoint(most, excessive);
            if (fits(voxelAt(middle)))
                most = middle;
            else
                excessive = middle;
        }
        if (most == 0)
            return Text::tr("The wall is too thick for a solid of this size. Choose a thinner wall.");
        return Text::tr(
                   "The solid of “%1” would need more than %2 million voxels. Choose a lower resolution: "
                   "at most %3.")
            .arg(m_fractal.name, millions, QString::number(most));
    }

    void build(VoxelCover& cover) {
        SolidFacts& facts = m_solid.facts;
        cover.grid.dilate(m_dilation);
        const attractor::Cavities cavities =
            m_options.fillsCavities ? fillCavities(cover.grid) : cavitiesOf(cover.grid);
        facts.cavities = cavities.count;
        facts.cavityVolume = double(cavities.voxels) * m_side * m_side * m_side;
        facts.islands = countIslands(cover.grid);
        auto mesh = attractor::voxelSurface(cover.grid);
        if (!mesh) {
            m_solid.failure =
                Text::tr("The surface of “%1” would have more than %2 million triangles. Choose a "
                         "lower resolution, which makes larger voxels.")
                    .arg(m_fractal.name, QString::number(attractor::SurfaceMesh::maxTriangles / 1'000'000));
            return;
        }
        m_solid.mesh = *std::move(mesh);
        m_solid.origin = cover.origin;
        m_solid.unit = m_side / attractor::latticePerVoxel;
        facts.triangles = m_solid.mesh.triangles.size();
        facts.volume = enclosedVolume(m_solid.mesh) * std::pow(m_solid.unit, 3);
        facts.size = sizeOf();
        shrink();
        if (m_solid.mesh.triangles.empty() || flawOf(m_solid.mesh) != attractor::SurfaceFlaw::None)
            m_solid.failure =
                Text::tr("The surface of “%1” is not closed, so it was not written.").arg(m_fractal.name);
        else if (!keepsPointsApart(m_solid))
            m_solid.failure =
                Text::tr("“%1” is too small for its distance from the origin: the numbers in "
                         "the file cannot distinguish its points. Move it to the origin, or make "
                         "it larger.")
                    .arg(m_fractal.name);
    }

    ifs::Vector<3> sizeOf() const {
        ifs::Vector<3> low = ifs::Vector<3>::Constant(HUGE_VAL);
        ifs::Vector<3> high = -low;
        for (const auto& point : m_solid.mesh.points) {
            const ifs::Vector<3> p(point[0], point[1], point[2]);
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        return m_solid.unit * (high - low);
    }

    const document::Fractal& m_fractal;
    const SolidOptions& m_options;
    PrintableSolid m_solid;
    attractor::PreparedSpace m_system;
    ifs::AffineMap<3> m_placement; // coordinates of the code → mm
    Box m_box;
    double m_longest = 0; // mm; longest side of the box
    double m_side = 1;    // mm; side of a voxel
    int m_dilation = 0;   // voxels
};

} // namespace

QString summaryOf(const SolidFacts& facts, const SolidOptions& options) {
    QStringList lines;
    lines << Text::tr("Size: %1 × %2 × %3 mm; volume: %4 mm³; triangles: %5.")
                 .arg(number(facts.size.x()), number(facts.size.y()), number(facts.size.z()),
                      number(facts.volume))
                 .arg(facts.triangles);
    lines << Text::tr("Distance from the attractor: at most %1 mm = √3 · %2 mm + %3 mm for the wall.")
                 .arg(number(facts.bound), number(facts.voxel), number(facts.dilation));
    if (facts.cavities > 0)
        lines << (options.fillsCavities ? Text::tr("Cavities filled: %1, with %2 mm³.")
                                        : Text::tr("Closed cavities: %1, with %2 mm³."))
                     .arg(facts.cavities)
                     .arg(number(facts.cavityVolume));
    if (facts.islands > 1) lines << Text::tr("Separate bodies: %1.").arg(facts.islands);
    return lines.join(u'\n') + u'\n';
}

Failure obstacleToSolid(const document::Fractal& fractal) {
    const document::Shape<3>* shape = document::space(fractal);
    if (!shape) return Text::tr("“%1” is not a system in space, so it has no solid.").arg(fractal.name);
    if (shape->cage && ifs::bends(*shape->cage))
        return Text::tr("The cage of “%1” bends the picture, so its solid cannot be written.")
            .arg(fractal.name);
    return std::nullopt;
}

Failure obstacleToSolid(const document::Fractal& fractal, const SolidOptions& options) {
    return Maker(fractal, options).prepare();
}

PrintableSolid printableSolid(const document::Fractal& fractal, const SolidOptions& options,
                              const Progress& progress, const std::stop_token& stop) {
    return Maker(fractal, options).make(progress, stop);
}

} // namespace io
