// SPDX-License-Identifier: MIT
#include "attractor/samples/space_orbit.h"
#include "attractor/space_systems.h"
#include "attractor/voxels/voxel_cover.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>

using attractor::VoxelCover;

// Voxels that cover an attractor: none is missing, and none is far from it.
class VoxelCoverTest : public QObject {
    Q_OBJECT

private slots:
    void everyPointIsCovered_data();
    void everyPointIsCovered();
    void everyVoxelIsNear_data() { everyPointIsCovered_data(); }
    void everyVoxelIsNear();
    void aCubeIsFull();
    void fewWordsAreTakenApartWherePiecesTouch();
    void limitsAreKept();
    void stops();
};

namespace {

VoxelCover coverOf(const attractor::PreparedSpace& system, const ifs::AffineMap<3>& placement, double share) {
    const ifs::Vector<3> middle = placement(system.centre);
    const ifs::Vector<3> half = placement.linear.cwiseAbs() * system.halfExtent;
    return attractor::voxelCover(
        {system, placement, middle - half, middle + half, 2 * half.maxCoeff() * share, 0});
}

ifs::AffineMap<3> turned() {
    ifs::AffineMap<3> map;
    map.linear << 0.6, -0.8, 0.1, 0.8, 0.6, 0.3, 0, 0.2, 1.5;
    map.translation = {3, -1, 2};
    return map;
}

attractor::VoxelGrid::Index indexOf(const VoxelCover& cover, const ifs::Vector<3>& x) {
    attractor::VoxelGrid::Index result{};
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = int(std::floor((x - cover.origin)[Eigen::Index(k)] / cover.side));
    return result;
}

systems::System3 flat() { // a triangle of Sierpiński in a plane that is askew
    return canonical::system(canonical::Maps3{systems::scaled(0.5, 0, 0, 0), systems::scaled(0.5, 1, 0, 1),
                                              systems::scaled(0.5, 0, 1, 1)});
}

} // namespace

void VoxelCoverTest::everyPointIsCovered_data() {
    QTest::addColumn<systems::System3>("system");
    QTest::newRow("menger") << systems::menger();
    QTest::newRow("tetrahedron") << systems::tetrahedron();
    QTest::newRow("fern") << systems::fern3();
    QTest::newRow("flat") << flat();
}

void VoxelCoverTest::everyPointIsCovered() {
    QFETCH(systems::System3, system);
    const attractor::PreparedSpace prepared = attractor::preparedSpace(system);
    const VoxelCover cover = coverOf(prepared, turned(), 1 / 50.0);
    QVERIFY(cover.outcome == VoxelCover::Outcome::Done);
    attractor::SpaceOrbit orbit(prepared, 1);
    for (int i = 0; i < 30; ++i)
        orbit.next(); // the first points of an orbit are only near
    for (int i = 0; i < 200'000; ++i)
        QVERIFY(cover.grid.isFilled(indexOf(cover, turned()(orbit.next().x))));
}

// Against points of the attractor, which lie somewhere in all voxels around.
void VoxelCoverTest::everyVoxelIsNear() {
    QFETCH(systems::System3, system);
    const attractor::PreparedSpace prepared = attractor::preparedSpace(system);
    const VoxelCover cover = coverOf(prepared, turned(), 1 / 25.0);
    attractor::VoxelGrid met(cover.grid.size());
    attractor::SpaceOrbit orbit(prepared, 1);
    for (int i = 0; i < 3'000'000; ++i) {
        const auto voxel = indexOf(cover, turned()(orbit.next().x));
        if (met.contains(voxel)) met.fill(voxel);
    }
    met.dilate(1);
    const auto [sizeX, sizeY, sizeZ] = cover.grid.size();
    for (int z = 0; z < sizeZ; ++z)
        for (int y = 0; y < sizeY; ++y)
            for (int x = 0; x < sizeX; ++x)
                QVERIFY(!cover.grid.isFilled({x, y, z}) || met.isFilled({x, y, z}));
}

void VoxelCoverTest::aCubeIsFull() {
    const attractor::PreparedSpace cube = attractor::preparedSpace(canonical::system(canonical::cube()));
    const VoxelCover cover =
        attractor::voxelCover({cube, {}, ifs::Vector<3>::Zero(), ifs::Vector<3>::Ones(), 1 / 9.5, 0});
    QCOMPARE(cover.grid.countFilled(), std::uint64_t(1000));
    QCOMPARE(cover.grid.size(), (attractor::VoxelGrid::Index{12, 12, 12}));
}

void VoxelCoverTest::fewWordsAreTakenApartWherePiecesTouch() {
    const VoxelCover cover = coverOf(attractor::preparedSpace(systems::menger()), {}, 0.01);
    QVERIFY(cover.outcome == VoxelCover::Outcome::Done);
    const double wordsPerVoxel = double(cover.words) / double(cover.grid.countFilled());
    QVERIFY2(wordsPerVoxel < 30, qPrintable(QString::number(wordsPerVoxel)));
}

void VoxelCoverTest::limitsAreKept() {
    const attractor::PreparedSpace menger = attractor::preparedSpace(systems::menger());
    QVERIFY(coverOf(menger, {}, 1e-5).outcome == VoxelCover::Outcome::TooManyVoxels);
    QVERIFY(coverOf(menger, {}, 1e-300).outcome == VoxelCover::Outcome::TooManyVoxels);
    // Words that hardly shrink would be taken apart until they fill the memory.
    const auto slow = attractor::preparedSpace(canonical::system(
        canonical::Maps3{systems::scaled(1 - 1e-8, 0, 0, 0), systems::scaled(0.5, 1, 1, 1)}));
    const VoxelCover cover = coverOf(slow, {}, 0.01);
    QVERIFY(cover.outcome == VoxelCover::Outcome::TooManyWords && cover.words < 2'000'000);
}

void VoxelCoverTest::stops() {
    std::stop_source source;
    source.request_stop();
    const attractor::PreparedSpace menger = attractor::preparedSpace(systems::menger());
    const auto cover = attractor::voxelCover(
        {menger, {}, ifs::Vector<3>::Zero(), ifs::Vector<3>::Ones(), 0.004, 0}, {}, source.get_token());
    QVERIFY(cover.outcome == VoxelCover::Outcome::Stopped);
}

BARYCAGE_TEST(VoxelCoverTest, QCoreApplication);
#include "voxel_cover_test.moc"
