// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "ifs/extent/polygon.h"
#include "io/fractint/fractint_reader.h"
#include "io/picture/vector/svg_shapes.h"
#include "io/picture/vector/svg_writer.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/thorough.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace io;
using ifs::AffineMap;
using ifs::Vector;

namespace {

constexpr int svgWidth = 480;
constexpr int svgHeight = 360;
constexpr int cellsPerPixel = 4;
constexpr int border = 12; // pixels around the picture
// A point and the middle of its cell, and once more for the other set.
const double resolution = std::sqrt(2.0) / cellsPerPixel;

// Which cells of a fine grid over the picture a set touches.
class Cells {
public:
    static constexpr int columns = (svgWidth + 2 * border) * cellsPerPixel;
    static constexpr int rows = (svgHeight + 2 * border) * cellsPerPixel;

    static int column(double x) { return index(x, columns); }
    static int row(double y) { return index(y, rows); }
    static Vector<2> middle(int column, int row) {
        return Vector<2>(column + 0.5, row + 0.5) / cellsPerPixel - Vector<2>(border, border);
    }

    // False when it was there.
    bool add(int column, int row) {
        char& cell = m_cells[std::size_t(row) * columns + std::size_t(column)];
        return !std::exchange(cell, true);
    }
    bool add(const Vector<2>& point) { return add(column(point.x()), row(point.y())); }
    bool has(int column, int row) const { return m_cells[std::size_t(row) * columns + std::size_t(column)]; }

private:
    static int index(double pixel, int count) {
        return int(std::clamp(std::floor((pixel + border) * cellsPerPixel), 0.0, count - 1.0));
    }

    std::vector<char> m_cells = std::vector<char>(std::size_t(columns) * rows);
};

// The squared distances along a line to the lower envelope of parabolas (Felzenszwalb and Huttenlocher 2012).
void transform(std::vector<double>& f) {
    const int n = int(f.size());
    static thread_local std::vector<int> v;
    static thread_local std::vector<double> z, d;
    v.assign(f.size(), 0);
    z.assign(f.size() + 1, 0);
    d.assign(f.size(), 0);
    int k = -1;
    for (int q = 0; q < n; ++q) {
        if (!std::isfinite(f[std::size_t(q)])) continue;
        double s = -HUGE_VAL;
        while (k >= 0) {
            const int p = v[std::size_t(k)];
            s = (f[std::size_t(q)] + double(q) * q - f[std::size_t(p)] - double(p) * p) / (2.0 * (q - p));
            if (s > z[std::size_t(k)]) break;
            --k;
        }
        ++k;
        v[std::size_t(k)] = q;
        z[std::size_t(k)] = k == 0 ? -HUGE_VAL : s;
        z[std::size_t(k) + 1] = HUGE_VAL;
    }
    if (k < 0) return;
    int i = 0;
    for (int q = 0; q < n; ++q) {
        while (z[std::size_t(i) + 1] < q)
            ++i;
        const int p = v[std::size_t(i)];
        d[std::size_t(q)] = double(q - p) * (q - p) + f[std::size_t(p)];
    }
    f = d;
}

// The largest distance of a cell of `from` to the next of `to`, in pixels.
double farthest(const Cells& from, const Cells& to) {
    std::vector<std::vector<double>> squares(Cells::rows, std::vector<double>(Cells::columns));
    for (int y = 0; y < Cells::rows; ++y) {
        for (int x = 0; x < Cells::columns; ++x)
            squares[std::size_t(y)][std::size_t(x)] = to.has(x, y) ? 0 : HUGE_VAL;
        transform(squares[std::size_t(y)]);
    }
    double result = 0;
    std::vector<double> line(Cells::rows);
    for (int x = 0; x < Cells::columns; ++x) {
        for (int y = 0; y < Cells::rows; ++y)
            line[std::size_t(y)] = squares[std::size_t(y)][std::size_t(x)];
        transform(line);
        for (int y = 0; y < Cells::rows; ++y)
            if (from.has(x, y)) result = std::max(result, line[std::size_t(y)]);
    }
    return std::sqrt(result) / cellsPerPixel;
}

// Every cell whose middle a convex polygon covers, and those along its edges.
void fill(Cells& cells, const ifs::Polygon& polygon) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector<2>& corner = polygon[i];
        const Vector<2> edge = polygon[(i + 1) % polygon.size()] - corner;
        const int steps = int(std::min(edge.norm() * cellsPerPixel * 2, 1e4)) + 1;
        for (int k = 0; k < steps; ++k)
            cells.add(corner + edge * (double(k) / steps));
        low = std::min(low, corner.y());
        high = std::max(high, corner.y());
    }
    for (int row = Cells::row(low); row <= Cells::row(high); ++row) {
        const double y = Cells::middle(0, row).y();
        double left = HUGE_VAL, right = -HUGE_VAL;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector<2>& a = polygon[i];
            const Vector<2>& b = polygon[(i + 1) % polygon.size()];
            if ((a.y() <= y) == (b.y() <= y)) continue;
            const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
            left = std::min(left, x);
            right = std::max(right, x);
        }
        if (left > right) continue;
        for (int column = Cells::column(left); column <= Cells::column(right); ++column) {
            const double x = Cells::middle(column, row).x();
            if (x >= left && x <= right) cells.add(column, row);
        }
    }
}

// All that a reader of the file draws.
class Drawn {
public:
    Drawn(const ifs::CopyHierarchy& levels, int depth) : m_levels(levels), m_depth(depth) {
        m_outline = levels.outline(depth);
        for (int level = 0; level <= depth; ++level)
            m_copies.push_back(level == 0 ? std::vector<ifs::Copy>() : levels.copies(level, depth));
        for (const ifs::Copy& copy : levels.picture(depth))
            draw(levels.display(), copy);
    }

    const Cells& cells() const { return m_cells; }

private:
    void draw(const AffineMap<2>& outer, const ifs::Copy& copy) {
        const AffineMap<2> map = outer * copy.map;
        if (copy.projection) {
            for (const ifs::Polygon& bar : m_levels.projection(*copy.projection)->bars)
                add(bar, map);
        } else if (copy.level == 0) {
            add(m_outline, map);
        } else {
            for (const ifs::Copy& inner : m_copies[std::size_t(copy.level)])
                draw(map, inner);
        }
    }

    void add(ifs::Polygon polygon, const AffineMap<2>& map) {
        for (auto& corner : polygon)
            corner = map(corner);
        fill(m_cells, polygon);
    }

    const ifs::CopyHierarchy& m_levels;
    int m_depth;
    ifs::Polygon m_outline;
    std::vector<std::vector<ifs::Copy>> m_copies;
    Cells m_cells;
};

// The attractor from its own points: the images of each under all maps, as long as they touch new cells.
Cells attractorOf(const document::Fractal& fractal, const attractor::Camera& camera) {
    const auto active = ifs::activeMaps(*document::system2(fractal));
    const ifs::ControlCage<2>* cage = document::cage2(fractal);
    const AffineMap<2> display = cage ? worldToPixel(camera) * ifs::displayMap(*cage) : worldToPixel(camera);
    Cells whole;
    std::vector<Vector<2>> points{*ifs::addressPoint<2>(active.maps, {}, {0})};
    whole.add(display(points.front()));
    for (std::size_t n = 0; n < points.size(); ++n)
        for (const auto& map : active.maps)
            if (const Vector<2> image = map(points[n]); whole.add(display(image))) points.push_back(image);
    const auto moved = ifs::overMaps<2>(document::movedBranches(fractal), active.index);
    if (moved.empty()) return whole;
    Cells shown;
    const auto pieces = ifs::pieces<2>(moved, active.maps.size());
    for (const auto& piece : ifs::pieceMaps<2>(pieces, active.maps))
        for (const auto& point : points)
            shown.add(display(piece(point)));
    return shown;
}

} // namespace

// What the dialog says about the accuracy of a picture of shapes, against what a fine grid measures, for
// the systems of the collection.
class SvgAccuracyTest : public QObject {
    Q_OBJECT

private slots:
    void statedAccuracy_data();
    void statedAccuracy();
    void cleanupTestCase();

private:
    int m_measured = 0;
    QStringList m_refused;
};

void SvgAccuracyTest::statedAccuracy_data() {
    QTest::addColumn<document::Fractal>("fractal");
    // A sixteenth of them, or all.
    int systems = 0;
    QDir folder(support::sourcePath(QStringLiteral("ifs_library")));
    for (const QString& name : folder.entryList({QStringLiteral("*.ifs")})) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        for (const auto& entry : readFractint(file.readAll()).entries) {
            if (!entry.fractal || !document::system2(*entry.fractal)) continue;
            if (++systems % 16 != 0 && !support::isThorough()) continue;
            QTest::newRow(qPrintable(name + u' ' + entry.fractal->name)) << *entry.fractal;
        }
    }
    QVERIFY(systems > 100);
}

void SvgAccuracyTest::statedAccuracy() {
    QFETCH(document::Fractal, fractal);
    attractor::Camera camera;
    camera.width = svgWidth;
    camera.height = svgHeight;
    const auto box = document::displayedBox(fractal);
    if (box) camera = fitted(camera, box->min, box->max);
    const ShapeLevels shapes = shapeLevels(fractal, camera);
    const SvgPlan plan = svgPlan(fractal, camera, {});
    QCOMPARE(plan.failure.has_value(), shapes.failure.has_value());
    if (shapes.failure) {
        QVERIFY2(ifs::activeMaps(*document::system2(fractal)).isLinked(), qPrintable(*shapes.failure));
        m_refused << QString::fromUtf8(QTest::currentDataTag());
        return;
    }
    ++m_measured;
    const Cells exact = attractorOf(fractal, camera);
    const Drawn drawn(*shapes.levels, plan.depth);
    const double measured = std::max(farthest(drawn.cells(), exact), farthest(exact, drawn.cells()));
    const double stated = plan.errorInPixels;
    const QString both = QStringLiteral("%1 px are stated, %2 measured").arg(stated).arg(measured);
    // Maps that shrink slowly leave some cells of the attractor without a point: once more as much is in
    // doubt.
    QVERIFY2(stated >= measured - 2 * resolution, qPrintable(both));
    QVERIFY2(stated <= 1 || stated <= 2 * (measured + resolution), qPrintable(both));
    // Where it is worse than a pixel, the dialog says why: more copies than programs draw without a wait.
    if (plan.isCutShort)
        QVERIFY(stated > 1 && shapes.levels->error(plan.depth + 1) < stated &&
                shapes.levels->references(plan.depth + 1) > ifs::CopyHierarchy::comfortableReferences);
}

void SvgAccuracyTest::cleanupTestCase() {
    qInfo("%d systems were measured; linked ones, which cannot be written as copies: %s", m_measured,
          qPrintable(m_refused.join(QStringLiteral(", "))));
}

BARYCAGE_TEST(SvgAccuracyTest, QCoreApplication);
#include "svg_accuracy_test.moc"
