// SPDX-License-Identifier: MIT
#include "canvas/items/grid_item.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/attractor_item.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <memory>
#include <utility>
#include <vector>

namespace {

constexpr int width = 300;
constexpr int height = 200;

QImage painted(view::GridItem& grid, double ratio) {
    QImage image(qRound(width * ratio), qRound(height * ratio), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::black);
    QPainter painter(&image);
    grid.paint(&painter, nullptr, nullptr);
    return image;
}

// Pixels of a row or column that nothing crosses: those that differ from the background.
std::vector<int> marked(const QImage& image, bool alongRow, int at) {
    std::vector<int> result;
    for (int i = 0; i < (alongRow ? image.width() : image.height()); ++i)
        if ((alongRow ? image.pixel(i, at) : image.pixel(at, i)) != qRgb(0, 0, 0)) result.push_back(i);
    return result;
}

class GridItemTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        view::OverlayStyle style;
        style.gridMinor = QColor(0, 0, 255);
        style.gridMajor = QColor(255, 0, 0);
        style.axis = Qt::white;
        m_grid.setStyle(style);
        // Lines every 0.2, the stronger ones every 1: 20.6 and 103 pixels. The origin is at (147.3, 101.63).
        m_grid.setView({{2.7 / 103, 1.63 / 103}, 103, width, height, attractor::YAxis::Up});
        m_grid.setAxesVisible(false);
        m_grid.setGridVisible(true);
    }

    void linesAreOneDevicePixelWide_data() {
        QTest::addColumn<double>("ratio");
        for (const double ratio : {1.0, 1.25, 1.5, 2.0})
            QTest::addRow("%g", ratio) << ratio;
    }
    void linesAreOneDevicePixelWide() {
        QFETCH(double, ratio);
        const QImage image = painted(m_grid, ratio);
        std::vector<int> upright;
        for (int k = -7; k <= 7; ++k)
            upright.push_back(int(std::floor((147.3 + 20.6 * k) * ratio)));
        std::vector<int> level;
        for (int k = -4; k <= 4; ++k)
            level.push_back(int(std::floor((101.63 + 20.6 * k) * ratio)));
        QCOMPARE(marked(image, true, 0), upright);
        QCOMPARE(marked(image, true, image.height() - 1), upright); // to the far edge
        QCOMPARE(marked(image, false, 0), level);
        QCOMPARE(marked(image, false, image.width() - 1), level);
        QCOMPARE(image.pixel(upright[2], 0), qRgb(255, 0, 0)); // at −1
        QCOMPARE(image.pixel(upright[3], 0), qRgb(0, 0, 255));
        QCOMPARE(image.pixel(0, level[4]), qRgb(255, 0, 0)); // at 0
        QCOMPARE(image.pixel(0, level[5]), qRgb(0, 0, 255));
    }

    void axesAreOnePixelWide_data() { linesAreOneDevicePixelWide_data(); }
    void axesAreOnePixelWide() {
        QFETCH(double, ratio);
        m_grid.setGridVisible(false);
        m_grid.setAxesVisible(true);
        const QImage image = painted(m_grid, ratio);
        const std::vector<int> upright = marked(image, true, 0);
        const std::vector<int> level = marked(image, false, image.width() - 1);
        QCOMPARE(int(upright.size()), qRound(ratio));
        QCOMPARE(int(level.size()), qRound(ratio));
        QVERIFY(std::abs(upright.front() + upright.size() / 2.0 - 147.3 * ratio) <= 1);
        QVERIFY(std::abs(level.front() + level.size() / 2.0 - 101.63 * ratio) <= 1);
    }

    void theGridTurnsWithTheView() {
        attractor::Camera camera{{2.7 / 103, 1.63 / 103},  103, width, height, attractor::YAxis::Up,
                                 attractor::rotationOf(30)};
        m_grid.setView(camera);
        m_grid.setGridVisible(false);
        m_grid.setAxesVisible(true);
        const QImage axes = painted(m_grid, 1);
        const auto isLit = [&](const QImage& image, const ifs::Vector<2>& world) {
            const ifs::Vector<2> pixel = toPixel(camera, world);
            return image.pixel(int(pixel.x()), int(pixel.y())) != qRgb(0, 0, 0);
        };
        for (const double way : {-0.7, -0.35, 0.35, 0.7}) {
            QVERIFY(isLit(axes, {way, 0}));
            QVERIFY(isLit(axes, {0, way}));
            QVERIFY(!isLit(axes, {way, 0.5}));
        }
        m_grid.setGridVisible(true);
        const QImage grid = painted(m_grid, 1);
        QVERIFY(isLit(grid, {0.4, 0.37}));
        QVERIFY(isLit(grid, {0.5, -0.2}));
        QVERIFY(!isLit(grid, {0.5, -0.3}));
    }

    // A picture that fills the view takes the upright lines along, with the same pixels.
    void linesOverAPicture_data() { linesAreOneDevicePixelWide_data(); }
    void linesOverAPicture() {
        QFETCH(double, ratio);
        const attractor::Camera camera{{2.7 / 103, 1.63 / 103}, 103, width, height, attractor::YAxis::Up};
        auto frame = std::make_shared<attractor::Frame>();
        frame->camera = view::deviceCamera(camera, ratio);
        frame->opaque = true;
        for (int k = 0; k < frame->camera.width * frame->camera.height; ++k)
            frame->pixels.push_back(0xff000000U | 2654435761U * unsigned(k) >> 8);
        view::AttractorItem picture;
        picture.setFrame(frame);
        picture.setView(camera, ratio);
        view::OverlayStyle style;
        style.gridMinor = QColor(0, 0, 255, 70);
        style.gridMajor = QColor(255, 0, 0, 90);
        style.axis = QColor(255, 255, 255, 120);
        m_grid.setStyle(style);
        m_grid.setAxesVisible(true);
        const auto paintedTogether = [&](bool withGrid) {
            picture.setGrid(withGrid ? &m_grid : nullptr);
            QImage image(frame->camera.width, frame->camera.height, QImage::Format_RGB32);
            image.setDevicePixelRatio(ratio);
            image.fill(Qt::black);
            QPainter painter(&image);
            picture.paint(&painter, nullptr, nullptr);
            const QImage between = image.copy();
            m_grid.paint(&painter, nullptr, nullptr);
            return std::pair(between, image);
        };
        const auto [picturesAlone, expected] = paintedTogether(false);
        const auto [withLines, found] = paintedTogether(true);
        QCOMPARE(found, expected);
        QVERIFY(picturesAlone != withLines);
        QVERIFY(!marked(painted(m_grid, ratio), true, 0).empty()); // left out only once
        m_grid.setVisible(false);
        QCOMPARE(paintedTogether(true).first, picturesAlone);
        m_grid.setVisible(true);
    }

    // Far from the origin doubles have no room for lines between their neighbours.
    void nothingIsDrawnWhereNumbersAreTooCoarse() {
        m_grid.setView({{1e17, 0}, 103, width, height, attractor::YAxis::Up});
        const QImage image = painted(m_grid, 1);
        QVERIFY(marked(image, true, 0).empty());
        QCOMPARE(int(marked(image, false, 0).size()), 9);
    }

private:
    view::GridItem m_grid;
};

} // namespace

QTEST_MAIN(GridItemTest)
#include "grid_item_test.moc"
