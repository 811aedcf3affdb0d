// SPDX-License-Identifier: MIT
#include "attractor/voxels/voxel_grid.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace attractor {

VoxelGrid::VoxelGrid(const Index& size)
    : m_size(size),
      m_rowWords((std::size_t(size[0]) + 63) / 64),
      m_bits(m_rowWords * std::size_t(size[1]) * std::size_t(size[2]), 0) {}

std::uint64_t VoxelGrid::countFilled() const {
    std::uint64_t count = 0;
    for (const std::uint64_t bits : m_bits)
        count += std::uint64_t(std::popcount(bits));
    return count;
}

void VoxelGrid::dilate(int radius) {
    if (radius <= 0 || m_bits.empty()) return;
    dilateRows(radius);
    const auto sizeY = std::size_t(m_size[1]);
    dilateAcross(m_rowWords, m_size[1], radius);
    dilateAcross(m_rowWords * sizeY, m_size[2], radius);
}

void VoxelGrid::dilateRows(int radius) {
    const unsigned last = unsigned(m_size[0]) % 64;
    const std::uint64_t lastMask = last == 0 ? ~std::uint64_t{0} : (std::uint64_t{1} << last) - 1;
    std::vector<std::uint64_t> wider(m_rowWords);
    for (std::size_t begin = 0; begin < m_bits.size(); begin += m_rowWords) {
        std::uint64_t* bits = m_bits.data() + begin;
        for (int step = 0; step < radius; ++step) {
            for (std::size_t i = 0; i < m_rowWords; ++i) {
                const std::uint64_t before = i > 0 ? bits[i - 1] >> 63 : 0;
                const std::uint64_t after = i + 1 < m_rowWords ? bits[i + 1] << 63 : 0;
                wider[i] = bits[i] | bits[i] << 1 | bits[i] >> 1 | before | after;
            }
            wider.back() &= lastMask;
            std::ranges::copy(wider, bits);
        }
    }
}

// Along the axis on which neighbours are `stride` words apart.
void VoxelGrid::dilateAcross(std::size_t stride, int count, int radius) {
    const std::size_t slab = stride * std::size_t(count);
    std::vector<std::uint64_t> line(static_cast<std::size_t>(count));
    for (std::size_t begin = 0; begin < m_bits.size(); begin += slab)
        for (std::size_t offset = 0; offset < stride; ++offset) {
            std::uint64_t* first = m_bits.data() + begin + offset;
            bool isEmpty = true;
            for (std::size_t i = 0; i < line.size(); ++i) {
                line[i] = first[i * stride];
                isEmpty = isEmpty && line[i] == 0;
            }
            if (isEmpty) continue;
            for (std::size_t i = 0; i < line.size(); ++i) {
                const std::size_t from = i > std::size_t(radius) ? i - std::size_t(radius) : 0;
                const std::size_t to = std::min(line.size() - 1, i + std::size_t(radius));
                std::uint64_t any = 0;
                for (std::size_t k = from; k <= to; ++k)
                    any |= line[k];
                first[i * stride] = any;
            }
        }
}

// The voxels of one kind as runs along x, and which of them are connected.
class VoxelRuns {
public:
    enum class Kind { Filled, Empty };
    enum class Contact { Faces, Corners };

    VoxelRuns(const VoxelGrid& grid, Kind kind, Contact contact) : m_size(grid.m_size) {
        for (int z = 0; z < m_size[2]; ++z)
            for (int y = 0; y < m_size[1]; ++y) {
                m_rows.push_back(std::uint32_t(m_runs.size()));
                addRow(grid, kind, y, z);
            }
        m_rows.push_back(std::uint32_t(m_runs.size()));
        m_parents.resize(m_runs.size());
        std::iota(m_parents.begin(), m_parents.end(), std::uint32_t{0});
        connect(contact);
    }

    struct Run {
        int begin = 0;
        int end = 0; // exclusive
    };
    std::size_t size() const { return m_runs.size(); }
    const Run& operator[](std::size_t i) const { return m_runs[i]; }
    std::uint32_t group(std::uint32_t run) { // first run of its group
        while (m_parents[run] != run)
            run = m_parents[run] = m_parents[m_parents[run]];
        return run;
    }
    // Calls act(run, y, z) for every run.
    template <class Act> void each(const Act& act) const {
        std::size_t row = 0;
        for (int z = 0; z < m_size[2]; ++z)
            for (int y = 0; y < m_size[1]; ++y, ++row)
                for (std::uint32_t i = m_rows[row]; i < m_rows[row + 1]; ++i)
                    act(i, y, z);
    }

private:
    void addRow(const VoxelGrid& grid, Kind kind, int y, int z) {
        const std::uint64_t* bits = grid.m_bits.data() + grid.row(y, z);
        const std::uint64_t turned = kind == Kind::Filled ? 0 : ~std::uint64_t{0};
        int x = 0;
        const auto next = [&](std::uint64_t flip) { // first set voxel from x on
            while (x < m_size[0]) {
                const std::uint64_t rest = (bits[x / 64] ^ turned ^ flip) >> (x % 64);
                if (rest != 0) {
                    x = std::min(x + std::countr_zero(rest), m_size[0]);
                    return;
                }
                x = (x / 64 + 1) * 64;
            }
            x = m_size[0];
        };
        while (true) {
            next(0);
            if (x >= m_size[0]) return;
            const int begin = x;
            next(~std::uint64_t{0});
            m_runs.push_back({begin, x});
        }
    }

    void connect(Contact contact) {
        const int reach = contact == Contact::Corners ? 1 : 0;
        std::size_t row = 0;
        for (int z = 0; z < m_size[2]; ++z)
            for (int y = 0; y < m_size[1]; ++y, ++row) {
                if (y > 0) connectRows(row, row - 1, reach);
                if (z == 0) continue;
                const std::size_t below = row - std::size_t(m_size[1]);
                connectRows(row, below, reach);
                if (reach == 0) continue;
                if (y > 0) connectRows(row, below - 1, reach);
                if (y + 1 < m_size[1]) connectRows(row, below + 1, reach);
            }
    }

    void connectRows(std::size_t a, std::size_t b, int reach) {
        std::uint32_t i = m_rows[a];
        std::uint32_t k = m_rows[b];
        while (i < m_rows[a + 1] && k < m_rows[b + 1]) {
            const Run& p = m_runs[i];
            const Run& q = m_runs[k];
            if (p.begin < q.end + reach && q.begin < p.end + reach) unite(i, k);
            ++(p.end < q.end ? i : k);
        }
    }

    void unite(std::uint32_t a, std::uint32_t b) {
        a = group(a);
        b = group(b);
        m_parents[std::max(a, b)] = std::min(a, b);
    }

    VoxelGrid::Index m_size;
    std::vector<Run> m_runs;
    std::vector<std::uint32_t> m_rows; // first run of each row, y fastest
    std::vector<std::uint32_t> m_parents;
};

std::uint64_t countIslands(const VoxelGrid& grid) {
    VoxelRuns runs(grid, VoxelRuns::Kind::Filled, VoxelRuns::Contact::Corners);
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < runs.size(); ++i)
        count += runs.group(i) == i ? 1 : 0;
    return count;
}

namespace {

// Calls act(run, y, z) for every run of a cavity.
template <class Act> Cavities eachOfCavities(const VoxelGrid& grid, const Act& act) {
    VoxelRuns runs(grid, VoxelRuns::Kind::Empty, VoxelRuns::Contact::Faces);
    std::vector<bool> isOutside(runs.size(), false);
    const VoxelGrid::Index& size = grid.size();
    runs.each([&](std::uint32_t i, int y, int z) {
        const VoxelRuns::Run& run = runs[i];
        if (run.begin == 0 || run.end == size[0] || y == 0 || y + 1 == size[1] || z == 0 || z + 1 == size[2])
            isOutside[runs.group(i)] = true;
    });
    Cavities cavities;
    runs.each([&](std::uint32_t i, int y, int z) {
        const std::uint32_t group = runs.group(i);
        if (isOutside[group]) return;
        if (group == i) ++cavities.count;
        cavities.voxels += std::uint64_t(runs[i].end - runs[i].begin);
        act(runs[i], y, z);
    });
    return cavities;
}

} // namespace

Cavities cavitiesOf(const VoxelGrid& grid) {
    return eachOfCavities(grid, [](const VoxelRuns::Run&, int, int) {});
}

Cavities fillCavities(VoxelGrid& grid) {
    return eachOfCavities(grid, [&grid](const VoxelRuns::Run& run, int y, int z) {
        for (int x = run.begin; x < run.end; ++x)
            grid.fill({x, y, z});
    });
}

} // namespace attractor
