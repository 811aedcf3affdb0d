// SPDX-License-Identifier: MIT
#include "attractor/voxels/voxel_cover.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace attractor {

namespace {

// The size of the grid around the box; nullopt when there would be too many voxels.
std::optional<VoxelGrid::Index> gridSize(const VoxelRequest& request) {
    VoxelGrid::Index size{};
    double voxels = 1;
    for (int k = 0; k < 3; ++k) {
        const double length = (request.max[k] - request.min[k]) / request.side;
        const double count = std::floor(length) + 1 + 2.0 * (request.margin + 1);
        voxels *= std::ceil(count / (k == 0 ? 64 : 1)) * (k == 0 ? 64 : 1); // whole 64-bit words, as stored
        if (!(voxels <= double(VoxelGrid::maxVoxels))) return {};
        size[std::size_t(k)] = int(count);
    }
    return size;
}

// The box in the middle of the grid: no side of it lies on a side of voxels unless the box has none to spare.
bool placeGrid(const VoxelRequest& request, VoxelCover& cover) {
    const auto size = gridSize(request);
    if (!size) return false;
    for (int k = 0; k < 3; ++k)
        cover.origin[k] = (request.min[k] + request.max[k] - request.side * (*size)[std::size_t(k)]) / 2;
    cover.grid = VoxelGrid(*size);
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
        const ifs::AffineMap<3> box = toGrid * request.placement * request.system.fromBox();
        for (const PreparedSpace::Piece& piece : request.system.pieces())
            m_pieces.push_back(box * piece.map);
    }

    VoxelCover::Outcome run(const std::function<void(double)>& progress, const std::stop_token& stop) {
        if (!fillKnownPoints(stop)) return VoxelCover::Outcome::Stopped;
        m_open.clear();
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
            if (m_open.size() > maxDepth) return VoxelCover::Outcome::TooManyWords;
        }
        return VoxelCover::Outcome::Done;
    }

private:
    static constexpr std::uint64_t between = 1U << 20; // words between two checks of the time
    static constexpr std::size_t maxDepth = 1'000'000; // words, about 100 MB

    struct Open {
        ifs::AffineMap<3> word;
        std::size_t next; // index of the next child
    };

    // Marks images of a fixed point at distances of a voxel. These voxels are met however words are divided,
    // and a word on the border of marked voxels need not be divided.
    bool fillKnownPoints(const std::stop_token& stop) {
        constexpr double fewVoxels = 2; // voxels wide
        const auto fixed = fixedPoint();
        if (!fixed) return true;
        std::vector<ifs::Vector<3>> points;
        for (const ifs::AffineMap<3>& map : m_maps)
            points.push_back(map(*fixed));
        std::uint64_t words = 0;
        std::uint64_t looked = 0; // images at the last check of the time
        for (const ifs::AffineMap<3>& piece : m_pieces)
            for (m_open = {{piece, 0}}; !m_open.empty();) {
                Open& open = m_open.back();
                const ifs::Matrix<3>& linear = open.word.linear;
                if (2 * linear.cwiseAbs().rowwise().sum().maxCoeff() <= fewVoxels) {
                    for (const ifs::Vector<3>& point : points)
                        fill(open.word(point));
                    words += points.size() / 4; // cost in words
                    open.next = m_maps.size();
                }
                if (open.next == m_maps.size()) {
                    m_open.pop_back();
                    continue;
                }
                const ifs::AffineMap<3> word = open.word * m_maps[open.next++];
                m_open.push_back({word, 0});
                if (++words > VoxelCover::maxWords / 8 || m_open.size() > maxDepth) return true;
                if (words - looked > between) {
                    if (stop.stop_requested()) return false;
                    looked = words;
                }
            }
        return true;
    }

    // Fixed point of a map in box coordinates, for a map that shrinks so much that the point is exact up to
    // rounding.
    std::optional<ifs::Vector<3>> fixedPoint() const {
        for (const ifs::AffineMap<3>& map : m_maps) {
            const ifs::Matrix<3> difference = ifs::Matrix<3>::Identity() - map.linear;
            const ifs::Vector<3> point = difference.partialPivLu().solve(map.translation);
            if (map.linear.norm() <= 0.9 && point.cwiseAbs().maxCoeff() <= 1 + 1e-12) return point;
        }
        return {};
    }

    void fill(const ifs::Vector<3>& point) {
        const VoxelGrid::Index voxel{int(std::floor(point[0])), int(std::floor(point[1])),
                                     int(std::floor(point[2]))};
        if (m_cover.grid.contains(voxel)) m_cover.grid.fill(voxel);
    }

    double share() const { // share of the piece
        double part = 1;
        double result = 0;
        for (std::size_t k = 0; k < std::min<std::size_t>(m_open.size(), 8); ++k) {
            part /= double(m_maps.size());
            result += part * double(m_open[k].next - 1);
        }
        return result;
    }

    // Returns true if dividing the word gains nothing; marks the voxels that it certainly meets.
    bool isDone(const ifs::AffineMap<3>& word) {
        constexpr double rounding = 1e-9;        // voxels; the grid has at most 2²⁸
        constexpr std::int64_t maxLookedAt = 64; // voxels examined for a word
        VoxelGrid::Index low{};
        VoxelGrid::Index high{};
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
        bool isKnown = true;
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x) {
                    const VoxelGrid::Index voxel{x, y, z};
                    if (m_cover.grid.isFilled(voxel)) continue;
                    if (!isSmall) return false;
                    isKnown = false;
                    if (m_cover.grid.contains(voxel)) m_cover.grid.fill(voxel);
                }
        return isKnown || isSmall;
    }

    VoxelCover& m_cover;
    std::vector<ifs::AffineMap<3>> m_maps;   // maps in box coordinates
    std::vector<ifs::AffineMap<3>> m_pieces; // displayed pieces, box → voxels
    std::vector<Open> m_open;
};

} // namespace

bool fitsGrid(const VoxelRequest& request) {
    return gridSize(request).has_value();
}

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
