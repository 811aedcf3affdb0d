// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"

#include "document/edits/cage/space_cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "io/collection_reader.h"
#include "support/named_test.h"

#include <QTest>

#include <optional>

// The cages of barycage-cli render for entries in space are those that the window fits.
class CliSpaceCageTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void cagesAgreeWithThoseOfTheWindow_data();
    void cagesAgreeWithThoseOfTheWindow();

private:
    using Corners = std::vector<ifs::Vector<3>>;

    QByteArray picture(const QByteArray& restCage, const Corners& moved) const;
};

namespace {

// Turns and shears, so that no extent is a short number.
const QByteArray swirl = "swirl (3D) {\n"
                         ".4 .3 0 -.3 .4 .1 0 -.1 .5 0 0 0 1\n"
                         ".5 0 .2 0 .5 0 -.2 .1 .4 1 .3 0 1\n"
                         ".3 -.2 .1 .2 .4 0 0 .1 .45 .2 1 .7 1\n}\n";

QByteArray quoted(const std::vector<ifs::Vector<3>>& corners) {
    QByteArray text;
    for (const ifs::Vector<3>& corner : corners) {
        text += text.isEmpty() ? "\"" : " ";
        for (int axis = 0; axis < 3; ++axis)
            text += (axis == 0 ? "" : ",") + QByteArray::number(corner[axis], 'g', 17);
    }
    return text + '"';
}

} // namespace

QByteArray CliSpaceCageTest::picture(const QByteArray& restCage, const Corners& moved) const {
    const Result result = run("render swirl.ifs -o swirl.png --look depth --size 80x60 --view 0.5,0.5,0.5,4 "
                              "--rest-cage " +
                              restCage + " --cage " + quoted(moved));
    if (result.status != 0) qWarning("%s", result.err.constData());
    return result.status == 0 ? read("swirl.png") : QByteArray();
}

void CliSpaceCageTest::cagesAgreeWithThoseOfTheWindow_data() {
    using document::SpacePolyhedron;
    QTest::addColumn<SpacePolyhedron>("choice");
    QTest::addColumn<int>("corners");

    QTest::newRow("canonical") << SpacePolyhedron::Simplex << 4;
    QTest::newRow("box") << SpacePolyhedron::Box << 8;
    QTest::newRow("octahedron") << SpacePolyhedron::Octahedron << 6;
    QTest::newRow("hull") << SpacePolyhedron::Hull << 16;
    QTest::newRow("hull:12") << SpacePolyhedron::Hull << 12;
}

// A picture of a moved cage around named corners is, byte for byte, that around the window's corners.
void CliSpaceCageTest::cagesAgreeWithThoseOfTheWindow() {
    QFETCH(document::SpacePolyhedron, choice);
    QFETCH(int, corners);

    write("swirl.ifs", swirl);
    const auto entries = io::readCollection(swirl).file.entries;
    QCOMPARE(entries.size(), 1);
    const document::Fractal& fractal = *entries.front().fractal;
    const auto fitted = document::withPolyhedronFitted(fractal, choice, corners);
    QVERIFY(fitted);
    const Corners rest = document::spaceCage(*fitted)->rest;
    if (choice == document::SpacePolyhedron::Simplex) QVERIFY(rest == document::spaceCage(fractal)->rest);
    Corners moved = rest;
    moved.back() += ifs::Vector<3>(0.3, 0.2, 0.4);

    const QByteArray named = picture(QTest::currentDataTag(), moved);
    QVERIFY(!named.isEmpty());
    QCOMPARE(named, picture(quoted(rest), moved));
    Corners other = rest; // what differs in the sixth digit has other bytes
    for (ifs::Vector<3>& corner : other)
        corner *= 1 + 1e-5;
    QVERIFY(named != picture(quoted(other), moved));
}

BARYCAGE_TEST(CliSpaceCageTest, QGuiApplication);
#include "cli_space_cage_test.moc"
