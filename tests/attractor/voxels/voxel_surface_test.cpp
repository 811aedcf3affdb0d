// SPDX-License-Identifier: MIT
#include "attractor/voxels/voxel_surface.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>
#include <random>

using attractor::SurfaceFlaw;
using attractor::SurfaceMesh;
using attractor::VoxelGrid;

// Voxels, and the surface around them.
class VoxelSurfaceTest : public QObject {
    Q_OBJECT

private slots:
    void aVoxelIsACube();
    void everyContactIsASurface();
    void randomVoxelsAreASurface();
    void flawsAreFound();
    void islandsAndCavities();
    void cavitiesAreFilled();
    void dilationIsThatOfAllNeighbours();
};

namespace {

constexpr double voxelVolume =
    double(attractor::latticePerVoxel) * attractor::latticePerVoxel * attractor::latticePerVoxel;

double volumeOf(const SurfaceMesh& mesh) { // in voxels
    return enclosedVolume(mesh) / voxelVolume;
}

VoxelGrid randomGrid(std::mt19937& random, int side, double density) {
    VoxelGrid grid({side, side, side});
    std::bernoulli_distribution isFilled(density);
    for (int z = 1; z + 1 < side; ++z)
        for (int y = 1; y + 1 < side; ++y)
            for (int x = 1; x + 1 < side; ++x)
                if (isFilled(random)) grid.fill({x, y, z});
    return grid;
}

// A hollow cube of side 5 around (3, 3, 3).
VoxelGrid shell() {
    VoxelGrid grid({7, 7, 7});
    for (int z = 1; z < 6; ++z)
        for (int y = 1; y < 6; ++y)
            for (int x = 1; x < 6; ++x)
                if (std::max({std::abs(x - 3), std::abs(y - 3), std::abs(z - 3)}) == 2) grid.fill({x, y, z});
    return grid;
}

} // namespace

void VoxelSurfaceTest::aVoxelIsACube() {
    VoxelGrid grid({3, 3, 3});
    grid.fill({1, 1, 1});
    const auto mesh = attractor::voxelSurface(grid);
    QVERIFY(mesh.has_value());
    QCOMPARE(mesh->points.size(), std::size_t(8));
    QCOMPARE(mesh->triangles.size(), std::size_t(12));
    QCOMPARE(volumeOf(*mesh), 1.0);
    QVERIFY(flawOf(*mesh) == SurfaceFlaw::None);
}

// All ways in which eight voxels around a corner can be filled.
void VoxelSurfaceTest::everyContactIsASurface() {
    double most = 0;
    for (unsigned octants = 1; octants < 256; ++octants) {
        VoxelGrid grid({4, 4, 4});
        for (unsigned k = 0; k < 8; ++k)
            if ((octants >> k & 1) != 0) grid.fill({1 + int(k & 1), 1 + int(k >> 1 & 1), 1 + int(k >> 2)});
        const auto mesh = attractor::voxelSurface(grid);
        QVERIFY2(mesh && flawOf(*mesh) == SurfaceFlaw::None, qPrintable(QString::number(octants)));
        const double filled = double(grid.countFilled());
        QVERIFY2(volumeOf(*mesh) >= filled - 1e-9, qPrintable(QString::number(octants)));
        most = std::max(most, volumeOf(*mesh) - filled);
    }
    // The bars that keep voxels apart or join them, at the worst where every second octant is filled.
    QVERIFY2(most < 0.22, qPrintable(QString::number(most)));
}

void VoxelSurfaceTest::randomVoxelsAreASurface() {
    std::mt19937 random(7);
    for (int i = 1; i <= 40; ++i) {
        const VoxelGrid grid = randomGrid(random, 10, i / 41.0);
        const auto mesh = attractor::voxelSurface(grid);
        QVERIFY(mesh && flawOf(*mesh) == SurfaceFlaw::None);
    }
}

void VoxelSurfaceTest::flawsAreFound() {
    VoxelGrid grid({3, 3, 3});
    grid.fill({1, 1, 1});
    const SurfaceMesh cube = *attractor::voxelSurface(grid);
    SurfaceMesh open = cube;
    open.triangles.pop_back();
    QVERIFY(flawOf(open) == SurfaceFlaw::Open);
    SurfaceMesh turned = cube;
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    QVERIFY(flawOf(turned) != SurfaceFlaw::None);
    SurfaceMesh twice = cube; // two cubes that share a point
    const auto shift = std::uint32_t(cube.points.size());
    for (const auto& point : cube.points)
        twice.points.push_back({-point[0], -point[1], -point[2]});
    for (const auto& triangle : cube.triangles)
        twice.triangles.push_back({triangle[0] + shift, triangle[2] + shift, triangle[1] + shift});
    QVERIFY(flawOf(twice) == SurfaceFlaw::None);
    for (auto& triangle : twice.triangles)
        for (auto& point : triangle)
            if (point == shift) point = 0;
    QVERIFY(flawOf(twice) == SurfaceFlaw::NotManifold);
}

void VoxelSurfaceTest::islandsAndCavities() {
    VoxelGrid grid = shell();
    QCOMPARE(countIslands(grid), std::uint64_t(1));
    QCOMPARE(cavitiesOf(grid).count, std::uint64_t(1));
    QCOMPARE(cavitiesOf(grid).voxels, std::uint64_t(27));
    grid.fill({3, 3, 3});
    QCOMPARE(countIslands(grid), std::uint64_t(2));
    QCOMPARE(cavitiesOf(grid).voxels, std::uint64_t(26));
    // Touching in a corner is one island; cavities that touch in a corner are two.
    VoxelGrid pair({4, 4, 4});
    pair.fill({1, 1, 1});
    pair.fill({2, 2, 2});
    QCOMPARE(countIslands(pair), std::uint64_t(1));
    VoxelGrid block({6, 6, 6});
    for (int z = 1; z < 5; ++z)
        for (int y = 1; y < 5; ++y)
            for (int x = 1; x < 5; ++x)
                if (!(x == y && y == z && (x == 2 || x == 3))) block.fill({x, y, z});
    QCOMPARE(cavitiesOf(block).count, std::uint64_t(2));
    QCOMPARE(cavitiesOf(block).voxels, std::uint64_t(2));
}

void VoxelSurfaceTest::cavitiesAreFilled() {
    VoxelGrid grid = shell();
    QCOMPARE(fillCavities(grid).voxels, std::uint64_t(27));
    QCOMPARE(grid.countFilled(), std::uint64_t(125));
    QCOMPARE(cavitiesOf(grid).count, std::uint64_t(0));
    QCOMPARE(volumeOf(*attractor::voxelSurface(grid)), 125.0);
}

void VoxelSurfaceTest::dilationIsThatOfAllNeighbours() {
    constexpr int sizeX = 70; // more than a word
    constexpr int side = 8;
    std::mt19937 random(3);
    for (const int radius : {1, 2, 3}) {
        VoxelGrid grid({sizeX, side, side});
        for (int i = 0; i < 12; ++i)
            grid.fill({int(random() % sizeX), int(random() % side), int(random() % side)});
        VoxelGrid wide = grid;
        wide.dilate(radius);
        for (int z = 0; z < side; ++z)
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < sizeX; ++x) {
                    bool isNear = false;
                    for (int k = -radius; k <= radius; ++k)
                        for (int j = -radius; j <= radius; ++j)
                            for (int i = -radius; i <= radius; ++i)
                                isNear = isNear || grid.isFilled({x + i, y + j, z + k});
                    QCOMPARE(wide.isFilled({x, y, z}), isNear);
                }
    }
}

BARYCAGE_TEST(VoxelSurfaceTest, QCoreApplication);
#include "voxel_surface_test.moc"
