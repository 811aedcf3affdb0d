// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"

#include "attractor/render/renderer.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/copies/copy_hierarchy.h"
#include "ifs/extent/polygon.h"
#include "io/fractint/fractint_reader.h"
#include "io/picture/vector/svg_system.h"
#include "io/picture/vector/svg_writer.h"
#include "support/fractals.h"
#include "support/named_test.h"
#include "support/processor_timer.h"

#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QSvgRenderer>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

using namespace io;

namespace {

document::Fractal written(const canonical::Maps2& maps, const QString& name = QStringLiteral("test")) {
    document::System2 system;
    const std::vector<double> weights = ifs::determinantWeights<2>(maps);
    for (std::size_t i = 0; i < maps.size(); ++i)
        ifs::append(system, maps[i], weights[i]);
    return support::fractalOf(system, name);
}

attractor::Camera cameraFor(const document::Fractal& fractal, int width = 300, int height = 240) {
    attractor::Camera camera;
    camera.width = width;
    camera.height = height;
    const auto box = document::displayedBox(fractal);
    return fitted(camera, box->min, box->max);
}

struct Copy {
    QString of;
    ifs::AffineMap<2> map;
    QString fill;
};

// The file as a reader of SVG sees it: groups of copies by id, polygons by id.
struct Parsed {
    std::map<QString, std::vector<Copy>> groups;
    std::map<QString, ifs::AffineMap<2>> transforms;
    std::map<QString, std::vector<ifs::Vector<2>>> polygons;
    std::set<QString> paths; // levels that are one path
    bool wellFormed = false;
};

ifs::AffineMap<2> matrixOf(const QString& text) {
    const QStringList n = text.mid(7, text.size() - 8).split(u' ');
    if (!text.startsWith(QStringLiteral("matrix(")) || n.size() != 6) return {};
    const auto number = [&](int i) { return n[i].toDouble(); };
    return ifs::affineMap(number(0), number(2), number(1), number(3), number(4), number(5));
}

std::vector<ifs::Vector<2>> pointsOf(const QString& text) {
    std::vector<ifs::Vector<2>> points;
    for (const QString& pair : text.split(u' '))
        points.emplace_back(pair.section(u',', 0, 0).toDouble(), pair.section(u',', 1, 1).toDouble());
    return points;
}

Parsed parsed(const QByteArray& bytes) {
    Parsed file;
    QXmlStreamReader xml(bytes);
    QString group;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto attributes = xml.attributes();
        const auto value = [&](const char* name) { return attributes.value(QLatin1String(name)).toString(); };
        if (xml.name() == u"g") {
            group = value("id");
            file.transforms[group] = matrixOf(value("transform"));
        } else if (xml.name() == u"polygon") {
            file.polygons[value("id")] = pointsOf(value("points"));
        } else if (xml.name() == u"path") {
            file.paths.insert(value("id"));
        } else if (xml.name() == u"use") {
            const QString of =
                attributes.value(QStringLiteral("http://www.w3.org/1999/xlink"), QStringLiteral("href"))
                    .toString();
            const QString transform = value("transform");
            file.groups[group].push_back(
                {of.mid(1), transform.isEmpty() ? ifs::AffineMap<2>() : matrixOf(transform), value("fill")});
        }
    }
    file.wellFormed = !xml.hasError();
    return file;
}

// Calls `leaf` for every copy of level 0 and of a projection with its matrix; returns the number of <use>
// followed.
std::uint64_t expand(const Parsed& file, const QString& group, const ifs::AffineMap<2>& map,
                     const std::function<void(const ifs::AffineMap<2>&)>& leaf) {
    std::uint64_t references = 0;
    for (const Copy& copy : file.groups.at(group)) {
        const ifs::AffineMap<2> inside = map * copy.map;
        references += 1;
        if (copy.of == u"level-0" || copy.of.startsWith(u"projection-"))
            leaf(inside);
        else if (!file.paths.contains(copy.of))
            references += expand(file, copy.of, inside, leaf);
    }
    return references;
}

double distance(const ifs::AffineMap<2>& a, const ifs::AffineMap<2>& b) {
    return (a.linear - b.linear).norm() + (a.translation - b.translation).norm();
}

QImage maskOf(const QImage& picture, QRgb background) {
    QImage mask(picture.size(), QImage::Format_Grayscale8);
    mask.fill(0);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb colour = picture.pixel(x, y);
            const int difference = std::abs(qRed(colour) - qRed(background)) +
                                   std::abs(qGreen(colour) - qGreen(background)) +
                                   std::abs(qBlue(colour) - qBlue(background));
            if (difference > 90) mask.setPixel(x, y, 255);
        }
    return mask;
}

// By librsvg, which has nothing to do with this project; null when it is not installed.
QImage drawnByOthers(const QByteArray& svg) {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("rsvg-convert"));
    if (program.isEmpty()) return {};
    QProcess process;
    process.start(program, {});
    process.write(svg);
    process.closeWriteChannel();
    process.waitForFinished(120'000);
    return QImage::fromData(process.readAllStandardOutput(), "PNG");
}

// The share of lit pixels of `a` that have a lit pixel of `b` within `reach`.
double covered(const QImage& a, const QImage& b, int reach) {
    int lit = 0;
    int found = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            if (qGray(a.pixel(x, y)) == 0) continue;
            ++lit;
            bool near = false;
            for (int v = std::max(0, y - reach); v <= std::min(b.height() - 1, y + reach) && !near; ++v)
                for (int u = std::max(0, x - reach); u <= std::min(b.width() - 1, x + reach) && !near; ++u)
                    near = qGray(b.pixel(u, v)) != 0;
            found += near;
        }
    return lit == 0 ? 0 : double(found) / lit;
}

} // namespace

class SvgWriterTest : public QObject {
    Q_OBJECT

private slots:
    void reopensAsTheSameFractal();
    void copiesComposeLikeTheMaps_data() { systems(); }
    void copiesComposeLikeTheMaps();
    void referencesAreCountedAndBounded_data() { systems(); }
    void referencesAreCountedAndBounded();
    void outlinesAreNoLargerThanProgramsRead();
    void unitsDoNotMatter();
    void errorHoldsBothWays();
    void noMatrixIsSingular_data();
    void noMatrixIsSingular();
    void singularMapsCostNothingBelowThem();
    void placementIsOneTransform();
    void mapsGiveColoursToTheTopLevel();
    void triangleIsDrawnWhenAsked();
    void looksLikeTheRendering_data() { systems(); }
    void looksLikeTheRendering();
    void thinPicturesLookLikeTheRendering_data();
    void thinPicturesLookLikeTheRendering();
    void movedBranchesLookLikeTheRendering();
    void systemsWithoutAttractorAreRefused();
    void bentPicturesAreWrittenAsTheirAffineFit();
    void hostileFilesAreRefused();
    void awkwardTextSurvives();

private:
    void compareWithTheRendering(document::Fractal fractal);
    void systems() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < 4; ++i)
            QTest::addRow("%s", names[i]) << i;
    }
    static canonical::Maps2 mapsOf(int index) {
        switch (index) {
        case 0:
            return canonical::maple();
        case 1:
            return canonical::flower();
        case 2:
            return canonical::fern();
        default:
            return canonical::sierpinskiRight();
        }
    }
    static constexpr const char* names[] = {"maple", "flower", "fern", "sierpinski"};
};

void SvgWriterTest::reopensAsTheSameFractal() {
    document::Fractal fractal = written(canonical::maple());
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    document::plane(fractal)->cage->current[1] = {1.25, -0.1};
    fractal.appearance.gamma = 1.75;
    const SvgPicture picture = svgPicture(fractal, cameraFor(fractal), {2, CageVisibility::Hidden});
    QVERIFY(!picture.plan.failure);
    const EmbeddedSystem system = readSvgSystem(picture.bytes);
    QVERIFY(!system.failure);
    QVERIFY(looksLikeSvg(picture.bytes));
    const document::FractalFile file = readFractint(system.text);
    QCOMPARE(file.entries.size(), 1);
    const document::Fractal& back = *file.entries.first().fractal;
    QCOMPARE(back.name, fractal.name);
    QVERIFY(*document::system2(back) == *document::system2(fractal));
    QVERIFY(document::plane(back)->cage == document::plane(fractal)->cage);
    QVERIFY(back.appearance == fractal.appearance);
}

// Following the copies from the outside in must give camera · w_σ1 ∘ w_σ2 ∘ …: the order oracle of the
// addresses.
void SvgWriterTest::copiesComposeLikeTheMaps() {
    QFETCH(int, index);
    const document::Fractal fractal = written(mapsOf(index));
    const attractor::Camera camera = cameraFor(fractal);
    const Parsed file = parsed(svgPicture(fractal, camera, {5, CageVisibility::Hidden}).bytes);
    QVERIFY(file.wellFormed);
    const auto levels = ifs::CopyHierarchy::of(*document::system2(fractal), worldToPixel(camera));
    std::mt19937 random(11);
    for (int trial = 0; trial < 200; ++trial) {
        ifs::AffineMap<2> drawn = file.transforms.at(QStringLiteral("attractor"));
        ifs::AffineMap<2> expected = worldToPixel(camera);
        QString group = QStringLiteral("attractor");
        while (group != u"level-0" && !group.startsWith(u"projection-")) {
            const auto& copies = file.groups.at(group);
            QCOMPARE(copies.size(), levels->index().size());
            const std::size_t i = random() % copies.size();
            const int level = group == u"attractor" ? 5 : group.mid(6).toInt();
            drawn = drawn * copies[i].map;
            expected = expected * levels->copy(i, level, 5).map;
            group = copies[i].of;
        }
        QVERIFY(distance(drawn, expected) < 1e-9 * (1 + expected.translation.norm()));
    }
}

// Their bars are all that is drawn at every depth: two copies, whose error stays.
void SvgWriterTest::singularMapsCostNothingBelowThem() {
    const document::Fractal fractal = written(
        {ifs::affineMap(-.169, .104, 0, 0, 1.35, -.963), ifs::affineMap(-.401, .217, 0, 0, 1.44, -1.07)});
    const attractor::Camera camera = cameraFor(fractal);
    const support::ProcessorTimer clock;
    const SvgPicture picture = svgPicture(fractal, camera, {150, CageVisibility::Hidden});
    QCOMPARE(picture.plan.depth, 150);
    QCOMPARE(picture.plan.references, 2u);
    const double error = picture.plan.errorInPixels;
    QVERIFY2(error > 0.5 && error < 3, qPrintable(QString::number(error)));
    QVERIFY2(clock.elapsed() < 5000, qPrintable(QString::number(clock.elapsed())));
}

void SvgWriterTest::referencesAreCountedAndBounded() {
    QFETCH(int, index);
    const document::Fractal fractal = written(mapsOf(index));
    const SvgPicture picture = svgPicture(fractal, cameraFor(fractal), {1000, CageVisibility::Hidden});
    QCOMPARE(picture.plan.depth, picture.plan.deepest);
    QVERIFY(picture.plan.references < 400'000);
    const auto counted =
        expand(parsed(picture.bytes), QStringLiteral("attractor"), {}, [](const ifs::AffineMap<2>&) {});
    QVERIFY(counted > 0 && counted <= picture.plan.references); // fewer where low levels are paths
    const SvgPicture shallow = svgPicture(fractal, cameraFor(fractal), {4, CageVisibility::Hidden});
    QCOMPARE(expand(parsed(shallow.bytes), QStringLiteral("attractor"), {}, [](const ifs::AffineMap<2>&) {}),
             shallow.plan.references);
}

// A million times as large and seen from as far, everything is the same.
void SvgWriterTest::unitsDoNotMatter() {
    std::vector<ifs::AffineMap<2>> maps = canonical::fern();
    const auto planOf = [](const std::vector<ifs::AffineMap<2>>& of) {
        const document::Fractal fractal = written(of);
        return svgPlan(fractal, cameraFor(fractal), {1000, CageVisibility::Hidden});
    };
    const SvgPlan near = planOf(maps);
    for (auto& map : maps)
        map.translation *= 1e6;
    const SvgPlan far = planOf(maps);
    QCOMPARE(far.depth, near.depth);
    QCOMPARE(far.references, near.references);
}

// Dust of a few ten thousand pieces, each with the many corners of a hull that turns.
void SvgWriterTest::outlinesAreNoLargerThanProgramsRead() {
    const double c = 0.4 * std::cos(0.35);
    const double s = 0.4 * std::sin(0.35);
    const document::Fractal fractal =
        written({ifs::affineMap(c, -s, s, c, 0, 0), ifs::affineMap(c, -s, s, c, 1, 0),
                 ifs::affineMap(c, -s, s, c, 0.4, 1)});
    const attractor::Camera camera = cameraFor(fractal, 8000, 8000);
    SvgFormat format;
    format.style = ShapeStyle::Outline;
    const int usual = svgPlan(fractal, camera, format).depth;
    const SvgPicture picture = svgPicture(fractal, camera, format);
    QVERIFY(!picture.plan.failure);
    QVERIFY(picture.plan.depth < usual);
    QVERIFY(picture.bytes.size() > 1'000'000 && picture.bytes.size() < 10'000'000);
    format.depth = picture.plan.depth + 1;
    const SvgPicture refused = svgPicture(fractal, camera, format);
    QVERIFY(refused.plan.failure && refused.bytes.isEmpty());
}

void SvgWriterTest::errorHoldsBothWays() {
    const document::Fractal fractal = written(canonical::sierpinskiRight());
    const attractor::Camera camera = cameraFor(fractal);
    const SvgPicture picture = svgPicture(fractal, camera, {4, CageVisibility::Hidden});
    const Parsed file = parsed(picture.bytes);
    std::vector<ifs::Polygon> drawn;
    expand(file, QStringLiteral("attractor"), file.transforms.at(QStringLiteral("attractor")),
           [&](const ifs::AffineMap<2>& map) {
               ifs::Polygon& copy = drawn.emplace_back();
               for (const auto& vertex : file.polygons.at(QStringLiteral("level-0")))
                   copy.push_back(map(vertex));
               std::ranges::reverse(copy); // y grows downwards
           });
    QVERIFY(!drawn.empty() && ifs::area(drawn.front()) > 0);
    std::vector<ifs::Vector<2>> points{{0, 0}, {1, 0}, {0, 1}}; // of the attractor, a 128th apart
    for (int level = 0; level < 7; ++level) {
        std::vector<ifs::Vector<2>> images;
        for (const auto& map : canonical::sierpinskiRight())
            for (const auto& point : points)
                images.push_back(map(point));
        points = std::move(images);
    }
    for (auto& point : points)
        point = toPixel(camera, point);
    const double gap = camera.pixelsPerUnit / 128;
    double beyond = 0, missing = 0;
    for (const ifs::Polygon& copy : drawn)
        for (const auto& vertex : copy) {
            double nearest = 1e9;
            for (const auto& point : points)
                nearest = std::min(nearest, (vertex - point).norm());
            beyond = std::max(beyond, nearest);
        }
    for (const auto& point : points) {
        double nearest = 1e9;
        for (const ifs::Polygon& copy : drawn)
            nearest = std::min(nearest, ifs::distanceToConvex(copy, point));
        missing = std::max(missing, nearest);
    }
    const double stated = picture.plan.errorInPixels;
    QVERIFY2(beyond <= stated + gap, qPrintable(QString::number(beyond)));
    QVERIFY2(missing <= 1e-6, qPrintable(QString::number(missing)));
    // The copies fill the hole in their middle: at depth 4 a right triangle with legs of a 32nd of the whole,
    // whose points are as far from the attractor as its incircle is wide.
    const double hole = camera.pixelsPerUnit / 32 * (1 - 1 / std::sqrt(2.0));
    QVERIFY2(stated >= hole && stated < hole + 1, qPrintable(QString::number(stated)));
}

void SvgWriterTest::noMatrixIsSingular_data() {
    QTest::addColumn<QVector<double>>("rows");
    QTest::newRow("fern") << QVector<double>{0,   0,     0,    .16, 0, 0,   .85,  .04, -.04, .85, 0, 1.6,
                                             0.2, -0.26, 0.23, .22, 0, 1.6, -.15, .28, .26,  .24, 0, .44};
    QTest::newRow("constant map") << QVector<double>{0, 0, 0, 0, 1, 1, .5, 0, 0, .5, 0, 0};
    QTest::newRow("on a line") << QVector<double>{.33, 0, 0, 0, 0, 0, .33, 0, 0, 0, .67, 0};
    QTest::newRow("one point") << QVector<double>{.5, 0, 0, .5, 1, 1};
}

void SvgWriterTest::noMatrixIsSingular() {
    QFETCH(QVector<double>, rows);
    canonical::Maps2 maps;
    for (int i = 0; i + 5 < rows.size(); i += 6)
        maps.push_back(
            ifs::affineMap(rows[i], rows[i + 1], rows[i + 2], rows[i + 3], rows[i + 4], rows[i + 5]));
    const document::Fractal fractal = written(maps);
    const SvgPicture picture = svgPicture(fractal, cameraFor(fractal), {});
    QVERIFY(!picture.plan.failure);
    const Parsed file = parsed(picture.bytes);
    int leaves = 0;
    bool singular = false;
    expand(file, QStringLiteral("attractor"), file.transforms.at(QStringLiteral("attractor")),
           [&](const ifs::AffineMap<2>& map) {
               ++leaves;
               singular = singular || !std::isnormal(ifs::determinant<2>(map.linear));
           });
    QVERIFY(leaves > 0);
    QVERIFY(!singular);
    QSvgRenderer renderer(picture.bytes);
    QVERIFY(renderer.isValid());
}

void SvgWriterTest::placementIsOneTransform() {
    document::Fractal fractal = written(canonical::maple());
    const attractor::Camera camera = cameraFor(fractal);
    const SvgPicture before = svgPicture(fractal, camera, {3, CageVisibility::Hidden});
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    for (auto& vertex : document::plane(fractal)->cage->current)
        vertex = {vertex.x() + 0.2 * vertex.y(), -0.5 * vertex.y()};
    const Parsed file = parsed(svgPicture(fractal, camera, {3, CageVisibility::Hidden}).bytes);
    const auto expected = worldToPixel(camera) * ifs::affineMap(1, 0.2, 0, -0.5, 0, 0);
    QVERIFY(distance(file.transforms.at(QStringLiteral("attractor")), expected) < 1e-9);
    const Parsed original = parsed(before.bytes);
    const QString level = QStringLiteral("level-2");
    for (std::size_t i = 0; i < original.groups.at(level).size(); ++i)
        QVERIFY(file.groups.at(level)[i].map == original.groups.at(level)[i].map);
}

void SvgWriterTest::mapsGiveColoursToTheTopLevel() {
    document::Fractal fractal = written(canonical::sierpinskiRight());
    fractal.appearance.colourBy = attractor::ColourBy::Map;
    const auto& maps = document::system2(fractal)->maps;
    fractal.appearance.mapColours[maps[1].id] = {1, 2, 3, 255};
    const Parsed file = parsed(svgPicture(fractal, cameraFor(fractal), {3, CageVisibility::Hidden}).bytes);
    const auto& top = file.groups.at(QStringLiteral("attractor"));
    QCOMPARE(top[1].fill, QStringLiteral("#010203"));
    QVERIFY(top[0].fill != top[2].fill);
    for (const Copy& copy : file.groups.at(QStringLiteral("level-1")))
        QVERIFY(copy.fill.isEmpty());
}

void SvgWriterTest::triangleIsDrawnWhenAsked() {
    document::Fractal fractal = written(canonical::maple());
    const attractor::Camera camera = cameraFor(fractal);
    QVERIFY(!parsed(svgPicture(fractal, camera, {1, CageVisibility::Hidden}).bytes)
                 .polygons.count(QStringLiteral("current")));
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    document::plane(fractal)->cage->current[0] = {0, 0};
    const Parsed file = parsed(svgPicture(fractal, camera, {1, CageVisibility::Shown}).bytes);
    const auto& current = file.polygons.at(QStringLiteral("current"));
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY((current[i] - toPixel(camera, document::plane(fractal)->cage->current[i])).norm() < 1e-9);
    QVERIFY(!file.polygons.count(QStringLiteral("rest"))); // as on the canvas
}

void SvgWriterTest::looksLikeTheRendering() {
    QFETCH(int, index);
    compareWithTheRendering(written(mapsOf(index)));
}

// Points, copies that are thin in both directions, and curves over an axis, whose copies are thin in one.
void SvgWriterTest::thinPicturesLookLikeTheRendering_data() {
    QTest::addColumn<int>("index");
    for (int i = 0; i < 10; ++i)
        QTest::addRow("%d", i) << i;
}

void SvgWriterTest::thinPicturesLookLikeTheRendering() {
    QFETCH(int, index);
    const auto dot = [](double s, double x, double y) { return ifs::affineMap(s, 0, 0, s, x, y); };
    const canonical::Maps2 systems[] = {
        {dot(0, 1, 2), dot(0, -1, .5), dot(0, 3, -1)},
        {dot(1e-9, 1, 2), dot(1e-9, -1, .5), dot(1e-9, 3, -1)},
        {dot(1e-4, 1, 2), dot(.5, 3, 0)},
        {ifs::affineMap(0, 1e-5, 1e-5, 0, 1, 2), dot(.5, 3, 0)},
        {dot(0, 1.5, .7)},
        // The parabola y = x(1 − x), and Takagi's function.
        {ifs::affineMap(.5, 0, .25, .25, 0, 0), ifs::affineMap(.5, 0, -.25, .25, .5, .25)},
        {ifs::affineMap(.5, 0, .5, .5, 0, 0), ifs::affineMap(.5, 0, -.5, .5, .5, .5)},
        // Copies that become thin in directions of their own long before they are small.
        {ifs::affineMap(-.169, .104, 0, 0, 1.35, -.963), ifs::affineMap(-.401, .217, 0, 0, 1.44, -1.07)},
        {ifs::affineMap(-.29162, .202607, -.407927, .241756, 1.195094, .507223),
         ifs::affineMap(.287476, -.190696, 0, 0, .402597, 1.694427)},
        {ifs::affineMap(.5, -.0489, -.275, -.493, -1.24, 1.23),
         ifs::affineMap(.116, -.0787, .0184, .455, .537, -.838),
         ifs::affineMap(-.604, -.0867, -.3, -.0294, 1.33, .491)},
    };
    document::Fractal fractal = written(systems[index]);
    // So that every part has points that are seen.
    document::System2 system;
    for (const auto& map : systems[index])
        ifs::append(system, map, 1.0);
    if (index >= 7) fractal.shape = document::Shape<2>{system};
    if (index >= 7) fractal.appearance.brightness = 1000;
    compareWithTheRendering(fractal);
}

// Also a branch that ends with a singular map, and one that goes on after it.
void SvgWriterTest::movedBranchesLookLikeTheRendering() {
    document::Fractal fractal = written(canonical::fern());
    const auto& maps = document::system2(fractal)->maps;
    const auto shift = [](double x, double y) { return ifs::affineMap(1, 0, 0, 1, x, y); };
    document::plane(fractal)->moved = {
        {{maps[2].id}, shift(-4, 1)},
        {{maps[1].id, maps[0].id}, shift(4, 0)},
        {{maps[0].id, maps[3].id}, ifs::affineMap(0, 3, 1, 0, 4, 4)},
        {{maps[3].id, maps[1].id, maps[3].id}, ifs::affineMap(0, -2, 2, 0, 5, 5)}};
    compareWithTheRendering(fractal);
}

void SvgWriterTest::compareWithTheRendering(document::Fractal fractal) {
    fractal.appearance.colourBy = attractor::ColourBy::Plain;
    const attractor::Camera camera = cameraFor(fractal);
    const QRgb background = qRgb(13, 16, 23);
    attractor::RenderRequest request = document::renderRequest(fractal, camera);
    request.samples = 4'000'000;
    const attractor::Frame frame = attractor::render(request);
    const QImage rendered(reinterpret_cast<const uchar*>(frame.pixels.data()), camera.width, camera.height,
                          QImage::Format_ARGB32_Premultiplied);
    const QImage drawn = drawnByOthers(svgPicture(fractal, camera, {}).bytes);
    if (drawn.isNull()) QSKIP("rsvg-convert is not installed: no independent program to draw the SVG");
    QCOMPARE(drawn.size(), rendered.size());
    const QImage points = maskOf(rendered, background);
    const QImage copies = maskOf(drawn, background);
    QVERIFY2(covered(points, copies, 2) > 0.99, qPrintable(QString::number(covered(points, copies, 2))));
    QVERIFY2(covered(copies, points, 2) > 0.99, qPrintable(QString::number(covered(copies, points, 2))));
}

void SvgWriterTest::systemsWithoutAttractorAreRefused() {
    const document::Fractal rotation = written({ifs::affineMap(0, -1, 1, 0, 0, 0)});
    attractor::Camera camera;
    camera.width = camera.height = 100;
    QVERIFY(svgPicture(rotation, camera, {}).plan.failure);
    QVERIFY(svgPicture(rotation, camera, {}).bytes.isEmpty());
    document::Fractal unread;
    QVERIFY(svgPlan(unread, camera, {}).failure);
}

void SvgWriterTest::bentPicturesAreWrittenAsTheirAffineFit() {
    document::Fractal bent = written(canonical::maple());
    document::plane(bent)->cage =
        ifs::ControlCage<2>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 0}, {1, 0}, {2, 2}, {0, 1}}};
    const attractor::Camera camera = cameraFor(written(canonical::maple()));
    const SvgPicture picture = svgPicture(bent, camera, {2, CageVisibility::Hidden});
    QVERIFY(!picture.plan.failure && picture.plan.unbent);
    document::Fractal fitted = bent;
    document::plane(fitted)->cage->deformation = ifs::Deformation::AffineFit;
    QVERIFY(!svgPlan(fitted, camera, {}).unbent);
    const auto drawn = [](const QByteArray& bytes) { return bytes.mid(bytes.indexOf("</metadata>")); };
    QCOMPARE(drawn(picture.bytes), drawn(svgPicture(fitted, camera, {2, CageVisibility::Hidden}).bytes));
    // The bend itself is in the system that travels with the picture.
    const auto back = readFractint(readSvgSystem(picture.bytes).text);
    QVERIFY(document::plane(*back.entries.first().fractal)->cage == document::plane(bent)->cage);
}

void SvgWriterTest::hostileFilesAreRefused() {
    const QByteArray body =
        "<svg xmlns='http://www.w3.org/2000/svg'><b:system xmlns:b='urn:barycage:system:1'>";
    const QByteArray end = "</b:system></svg>";
    QCOMPARE(readSvgSystem(body + "a { }" + end).text, QByteArray("a { }"));
    QVERIFY(
        readSvgSystem("<!DOCTYPE svg [<!ENTITY a 'x'><!ENTITY b '&a;&a;'>]>" + body + "&b;" + end).failure);
    QVERIFY(readSvgSystem(body + "&undefined;" + end).failure);
    QVERIFY(readSvgSystem(body + "a { }").failure);
    QVERIFY(readSvgSystem(body + QByteArray(9 * 1024 * 1024, ' ') + end).failure);
    QVERIFY(readSvgSystem("<svg xmlns='http://www.w3.org/2000/svg'/>").failure);
    QVERIFY(readSvgSystem({}).failure);
    const document::Fractal fractal = written(canonical::flower());
    const QByteArray whole = svgPicture(fractal, cameraFor(fractal), {2, CageVisibility::Hidden}).bytes;
    const QByteArray text = readSvgSystem(whole).text;
    for (qsizetype size = 0; size < whole.indexOf("</metadata>"); size += 7) {
        const EmbeddedSystem system = readSvgSystem(whole.left(size));
        QVERIFY(system.failure || system.text == text);
    }
}

void SvgWriterTest::awkwardTextSurvives() {
    document::Fractal fractal = written(canonical::flower());
    fractal.comments = {QStringLiteral("ends ]]> and <begins> & so on"), QStringLiteral("bell\x07 rings")};
    const SvgPicture picture = svgPicture(fractal, cameraFor(fractal), {1, CageVisibility::Hidden});
    QVERIFY(parsed(picture.bytes).wellFormed);
    const document::FractalFile file = readFractint(readSvgSystem(picture.bytes).text);
    const QStringList comments = file.entries.first().fractal->comments;
    QCOMPARE(comments.size(), 2);
    QCOMPARE(comments[0], fractal.comments[0]);
    QVERIFY(comments[1].startsWith(QStringLiteral("bell")) && comments[1].endsWith(QStringLiteral("rings")));
    QVERIFY(!comments[1].contains(u'\a'));
}

BARYCAGE_TEST(SvgWriterTest, QGuiApplication);
#include "svg_writer_test.moc"
