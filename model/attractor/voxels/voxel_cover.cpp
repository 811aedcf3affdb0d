// SPDX-License-Identifier: MIT
#include "attractor/voxels/voxel_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace attractor {

namespace {

using Index = VoxelGrid::Index;

// The grid around the box, the box in its middle: no side of it lies on a side of voxels unless the box has
// none to spare.
bool placeGrid(const VoxelRequest& request, VoxelCover& cover) {
    Index size{};
    double voxels = 1;
    for (int k = 0; k < 3; ++k) {
        const double length = (request.max[k] - request.min[k]) / request.side;
        const double count = std::floor(length) + 1 + 2.0 * (request.margin + 1);
        voxels *= std::ceil(count / (k == 0 ? 64 : 1)) * (k == 0 ? 64 : 1); // as they are stored
        if (!(voxels <= double(VoxelGrid::maxVoxels))) return false;
        size[std::size_t(k)] = int(count);
        cover.origin[k] = (request.min[k] + request.max[k] - request.side * count) / 2;
    }
    cover.grid = VoxelGrid(size);
    return true;
}

class Walk {
public:
    Walk(const VoxelRequest& request, VoxelCover& cover) : m_cover(cover) {
        for (const ifs::AffineMap<3>& map : request.system.maps)
            m_maps.push_back(request.system.inBox(map));
        ifs::AffineMap<3> toGrid;
        toGrid.linear /= request.side;
        toGrid.translation = -cover.origin / request.side;
        findPoints();
        const ifs::AffineMap<3> box = toGrid * request.placement * request.system.fromBox();
        for (const PreparedSpace::Piece& piece : request.system.pieces())
            m_pieces.push_back(box * piece.map);
    }

    // First down to the size of voxels: most that a word only touches are then marked by its neighbours.
    VoxelCover::Outcome run(const std::function<void(double)>& progress, const std::stop_token& stop) {
        m_postponed = 1.5;
        const auto first = [&](double share) { progress(0.8 * share); };
        const auto outcome = walk(progress ? std::function<void(double)>(first) : nullptr, stop);
        if (outcome != VoxelCover::Outcome::Done) return outcome;
        m_postponed = 0;
        const auto second = [&](double share) { progress(0.8 + 0.2 * share); };
        return walk(progress ? std::function<void(double)>(second) : nullptr, stop);
    }

private:
    VoxelCover::Outcome walk(const std::function<void(double)>& progress, const std::stop_token& stop) {
        constexpr std::uint64_t between = 1U << 20; // words between two looks at the clock
        std::size_t begun = 0;
        while (!m_open.empty() || begun < m_pieces.size()) {
            if (m_open.empty()) {
                const ifs::AffineMap<3>& piece = m_pieces[begun++];
                if (!isDone(piece)) m_open.push_back({piece, 0});
                continue;
            }
            Open& open = m_open.back();
            if (open.next == m_maps.size()) {
                m_open.pop_back();
                continue;
            }
            const ifs::AffineMap<3> word = open.word * m_maps[open.next++];
            if (++m_cover.words > VoxelCover::maxWords) return VoxelCover::Outcome::TooManyWords;
            if (m_cover.words % between == 0) {
                if (stop.stop_requested()) return VoxelCover::Outcome::Stopped;
                if (progress) progress((double(begun) - 1 + share()) / double(m_pieces.size()));
            }
            if (!isDone(word)) m_open.push_back({word, 0});
        }
        return VoxelCover::Outcome::Done;
    }

    struct Open {
        ifs::AffineMap<3> word;
        std::size_t next; // of its children
    };

    // Fixed points of maps, the outermost in each octant. Each word has them at its corners, where voxels
    // that other words would have to be taken apart for are met.
    void findPoints() {
        std::vector<ifs::Vector<3>> fixed;
        for (const ifs::AffineMap<3>& map : m_maps) {
            const ifs::Matrix<3> difference = ifs::Matrix<3>::Identity() - map.linear;
            const ifs::Vector<3> point = difference.partialPivLu().solve(map.translation);
            const double miss = (map(point) - point).cwiseAbs().maxCoeff();
            if (point.cwiseAbs().maxCoeff() <= 1 + 1e-12 && miss <= 1e-13 * (1 - map.linear.norm() / 2))
                fixed.push_back(point);
        }
        for (int octant = 0; octant < 8 && !fixed.empty(); ++octant) {
            const ifs::Vector<3> way(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
            const auto outermost = std::ranges::max_element(
                fixed, {}, [&](const ifs::Vector<3>& point) { return way.dot(point); });
            if (std::ranges::find(m_corners, *outermost) == m_corners.end()) m_corners.push_back(*outermost);
        }
        constexpr std::size_t enough = 64;
        for (const ifs::AffineMap<3>& map : m_maps)
            for (const ifs::Vector<3>& corner : m_corners) {
                const ifs::Vector<3> point = map(corner);
                const auto isHere = [&](const ifs::Vector<3>& known) { return known.isApprox(point, 1e-9); };
                if (m_inner.size() < enough && std::ranges::none_of(m_corners, isHere) &&
                    std::ranges::none_of(m_inner, isHere))
                    m_inner.push_back(point);
            }
    }

    // The voxels of points of the attractor in the word, which are met whatever it is taken apart into.
    void fill(const std::vector<ifs::Vector<3>>& points, const ifs::AffineMap<3>& word) {
        for (const ifs::Vector<3>& point : points) {
            const ifs::Vector<3> at = word(point);
            const Index voxel{int(std::floor(at[0])), int(std::floor(at[1])), int(std::floor(at[2]))};
            if (m_cover.grid.contains(voxel)) m_cover.grid.fill(voxel);
        }
    }

    double share() const { // of the piece
        double part = 1;
        double result = 0;
        for (std::size_t k = 0; k < std::min<std::size_t>(m_open.size(), 8); ++k) {
            part /= double(m_maps.size());
            result += part * double(m_open[k].next - 1);
        }
        return result;
    }

    // Whether there is nothing to be gained from its children; marks what it is known to meet.
    bool isDone(const ifs::AffineMap<3>& word) {
        constexpr double rounding = 1e-9;        // voxels; the grid has at most 2²⁹
        constexpr std::int64_t maxLookedAt = 64; // voxels
        Index low{};
        Index high{};
        double widest = 0;
        std::int64_t count = 1;
        for (int k = 0; k < 3; ++k) {
            const double half = word.linear.row(k).cwiseAbs().sum() + rounding;
            const double reach = double(m_cover.grid.size()[std::size_t(k)]);
            low[std::size_t(k)] = int(std::floor(std::clamp(word.translation[k] - half, -1.0, reach)));
            high[std::size_t(k)] = int(std::floor(std::clamp(word.translation[k] + half, -1.0, reach)));
            widest = std::max(widest, 2 * half);
            count *= high[std::size_t(k)] - low[std::size_t(k)] + 1;
        }
        const bool isSmall = count == 1 || widest <= VoxelCover::fineness;
        if (!isSmall && count > maxLookedAt) return false;
        if (areFilled(low, high)) return true;
        if (!isSmall) {
            fill(m_corners, word);
            if (areFilled(low, high)) return true;
            fill(m_inner, word);
            return widest <= m_postponed || areFilled(low, high);
        }
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x)
                    if (m_cover.grid.contains({x, y, z})) m_cover.grid.fill({x, y, z});
        return true;
    }

    bool areFilled(const Index& low, const Index& high) const {
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x)
                    if (!m_cover.grid.isFilled({x, y, z})) return false;
        return true;
    }

    VoxelCover& m_cover;
    std::vector<ifs::AffineMap<3>> m_maps;   // in box coordinates
    std::vector<ifs::Vector<3>> m_corners;   // points of the attractor, in box coordinates
    std::vector<ifs::Vector<3>> m_inner;     // their images
    std::vector<ifs::AffineMap<3>> m_pieces; // of what is shown, box → voxels
    double m_postponed = 0;                  // how wide words are, in voxels, that are not taken apart yet
    std::vector<Open> m_open;
};

} // namespace

VoxelCover voxelCover(const VoxelRequest& request, const std::function<void(double)>& progress,
                      const std::stop_token& stop) {
    VoxelCover cover;
    cover.side = request.side;
    if (!placeGrid(request, cover))
        cover.outcome = VoxelCover::Outcome::TooManyVoxels;
    else
        cover.outcome = Walk(request, cover).run(progress, stop);
    return cover;
}

} // namespace attractor
