// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor {

// A box of cubes of equal size, each filled or empty. Everything outside the box is empty.
class VoxelGrid {
public:
    using Index = std::array<int, 3>;

    static constexpr std::uint64_t maxVoxels = std::uint64_t{1} << 28; // 32 MB of bits

    VoxelGrid() = default;
    explicit VoxelGrid(const Index& size); // starts empty; at most maxVoxels

    const Index& size() const { return m_size; }
    bool contains(const Index& voxel) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (voxel[k] < 0 || voxel[k] >= m_size[k]) return false;
        return true;
    }
    bool isFilled(const Index& voxel) const {
        return contains(voxel) && (m_bits[word(voxel)] >> (unsigned(voxel[0]) % 64) & 1) != 0;
    }
    void fill(const Index& voxel) { // `voxel` must lie in the box
        m_bits[word(voxel)] |= std::uint64_t{1} << (unsigned(voxel[0]) % 64);
    }
    std::uint64_t countFilled() const;

    // Fills every voxel of the box whose coordinates differ by at most `radius` from those of a filled one.
    void dilate(int radius);

private:
    friend class VoxelRuns;
    std::size_t row(int y, int z) const {
        return (std::size_t(z) * std::size_t(m_size[1]) + std::size_t(y)) * m_rowWords;
    }
    std::size_t word(const Index& voxel) const {
        return row(voxel[1], voxel[2]) + std::size_t(voxel[0]) / 64;
    }
    void dilateRows(int radius);
    void dilateAcross(std::size_t stride, int count, int radius);

    Index m_size{};
    std::size_t m_rowWords = 0;
    std::vector<std::uint64_t> m_bits; // rows along x, padded with zeros to whole words
};

// Groups of filled voxels that share at least a corner with one another.
std::uint64_t countIslands(const VoxelGrid& grid);

// Groups of empty voxels, connected through faces, from which no way leads out of the box.
struct Cavities {
    std::uint64_t count = 0;
    std::uint64_t voxels = 0;
};
Cavities cavitiesOf(const VoxelGrid& grid);
Cavities fillCavities(VoxelGrid& grid); // returns the cavities that were filled

} // namespace attractor
