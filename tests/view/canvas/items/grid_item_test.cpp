// SPDX-License-Identifier: MIT
#include "canvas/items/grid_item.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/attractor_item.h"
#include "support/named_test.h"

#include <QImage>
#include <QPaintEngine>
#include <QPainter>
#include <QTest>

#include <memory>
#include <utility>
#include <vector>

namespace {

constexpr int viewWidth = 300;
constexpr int viewHeight = 200;

QImage painted(view::GridItem& grid, double ratio) {
    QImage image(qRound(viewWidth * ratio), qRound(viewHeight * ratio), QImage::Format_RGB32);
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

// Keeps where which text is drawn.
class TextRecorder : public QPaintDevice {
public:
    struct Text {
        QString text;
        QRectF box;
    };
    const std::vector<Text>& texts() const { return m_engine.texts; }

    QPaintEngine* paintEngine() const override { return &m_engine; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth:
            return viewWidth;
        case PdmHeight:
            return viewHeight;
        case PdmDepth:
            return 32;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    struct Engine : QPaintEngine {
        Engine() : QPaintEngine(QPaintEngine::AllFeatures) {}
        bool begin(QPaintDevice*) override { return true; }
        bool end() override { return true; }
        void updateState(const QPaintEngineState&) override {}
        void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
        void drawPath(const QPainterPath&) override {}
        void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
        void drawTextItem(const QPointF& at, const QTextItem& item) override {
            texts.push_back({item.text(), QRectF(at.x(), at.y() - item.ascent(), item.width(),
                                                 item.ascent() + item.descent())});
        }
        Type type() const override { return QPaintEngine::User; }

        std::vector<Text> texts;
    };
    mutable Engine m_engine;
};

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
        m_grid.setView({{2.7 / 103, 1.63 / 103}, 103, viewWidth, viewHeight, attractor::YAxis::Up});
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
        attractor::Camera camera{{2.7 / 103, 1.63 / 103},  103, viewWidth, viewHeight, attractor::YAxis::Up,
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
        const attractor::Camera camera{
            {2.7 / 103, 1.63 / 103}, 103, viewWidth, viewHeight, attractor::YAxis::Up};
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

    // Far from both axes lines of x and of y end at the same edges, and the numbers stand at their ends.
    void turnedNumbersDoNotLieOnEachOther_data() {
        QTest::addColumn<double>("pixelsPerUnit");
        for (const double pixelsPerUnit : {1e2, 1e5, 1e9, 1e12})
            QTest::addRow("%g", pixelsPerUnit) << pixelsPerUnit;
    }
    void turnedNumbersDoNotLieOnEachOther() {
        QFETCH(double, pixelsPerUnit);
        m_grid.setAxesVisible(true);
        for (int degrees = 3; degrees < 360; degrees += 7) {
            m_grid.setView({{0.7438, 7.1318},
                            pixelsPerUnit,
                            viewWidth,
                            viewHeight,
                            attractor::YAxis::Up,
                            attractor::rotationOf(degrees)});
            TextRecorder recorder;
            QPainter painter(&recorder);
            m_grid.paint(&painter, nullptr, nullptr);
            painter.end();
            const auto& texts = recorder.texts();
            QVERIFY2(texts.size() >= 2, qPrintable(QString::number(degrees)));
            for (std::size_t i = 0; i < texts.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    QVERIFY2(!texts[i].box.adjusted(1, 1, -1, -1).intersects(texts[k].box),
                             qPrintable(QStringLiteral("%1 degrees: “%2” on “%3”")
                                            .arg(degrees)
                                            .arg(texts[i].text, texts[k].text)));
        }
    }

    // Far from the origin doubles have no room for lines between their neighbours.
    void nothingIsDrawnWhereNumbersAreTooCoarse() {
        m_grid.setView({{1e17, 0}, 103, viewWidth, viewHeight, attractor::YAxis::Up});
        const QImage image = painted(m_grid, 1);
        QVERIFY(marked(image, true, 0).empty());
        QCOMPARE(int(marked(image, false, 0).size()), 9);
    }

private:
    view::GridItem m_grid;
};

} // namespace

BARYCAGE_TEST(GridItemTest, QApplication);
#include "grid_item_test.moc"
