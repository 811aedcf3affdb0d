// SPDX-License-Identifier: MIT
#include "attractor/colour/palette.h"
#include "attractor/render/renderer.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/attractor_item.h"
#include "canvas/items/overlay_style.h"
#include "canvas/scene/canvas_scene.h"
#include "support/contrast.h"
#include "support/named_test.h"

#include <QPainter>
#include <QTest>

#include <array>
#include <cmath>
#include <functional>
#include <memory>

using view::CanvasPart;
using view::CanvasScene;
using view::HandleTarget;
using Kind = view::CanvasPart::Kind;

namespace {

constexpr int width = 480;
constexpr int height = 360;
constexpr double enough = 4.5;

attractor::Camera camera() {
    attractor::Camera camera;
    camera.width = width;
    camera.height = height;
    camera.centre = {0.55, 0.6};
    camera.pixelsPerUnit = 130.3;
    return camera;
}

// An empty picture, or one that has every shade next to every other.
std::shared_ptr<attractor::Frame> pictureOf(const std::function<QRgb(int x, int y)>& colour) {
    auto frame = std::make_shared<attractor::Frame>();
    frame->camera = camera();
    frame->opaque = true;
    frame->pixels.reserve(std::size_t(width * height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            frame->pixels.push_back(colour(x, y) | 0xff000000);
    return frame;
}

QImage painted(CanvasScene& scene) {
    QImage image(width, height, QImage::Format_RGB32);
    QPainter painter(&image);
    scene.render(&painter, QRectF(0, 0, width, height), QRectF(0, 0, width, height));
    return image;
}

// The most that a pixel of the overlay, within so many pixels of here, stands out from what it lies on.
double contrastAt(const QImage& over, const QImage& under, const QPointF& at, int reach) {
    double best = 1;
    for (int y = int(at.y()) - reach; y <= int(at.y()) + reach; ++y)
        for (int x = int(at.x()) - reach; x <= int(at.x()) + reach; ++x)
            if (over.valid(x, y))
                best = std::max(best, support::contrast(over.pixel(x, y), under.pixel(x, y)));
    return best;
}

std::vector<QPointF> placesOn(const QPolygonF& outline) {
    std::vector<QPointF> places;
    for (int i = 0; i < outline.size(); ++i) {
        const QLineF edge(outline[i], outline[(i + 1) % outline.size()]);
        for (double t = 0.15; t < 0.86; t += 0.05)
            places.push_back(edge.pointAt(t));
    }
    return places;
}

// On the darkest to the lightest, the worst closely, on colours, and on all of them side by side.
std::vector<std::shared_ptr<attractor::Frame>> pictures() {
    std::vector<std::shared_ptr<attractor::Frame>> pictures;
    for (int grey = 0; grey < 256; grey += (grey > 90 && grey < 150 ? 3 : 15))
        pictures.push_back(pictureOf([grey](int, int) { return qRgb(grey, grey, grey); }));
    for (const QRgb colour : {qRgb(255, 0, 0), qRgb(0, 200, 0), qRgb(0, 0, 255), qRgb(255, 190, 70),
                              qRgb(214, 96, 0), qRgb(90, 120, 160)})
        pictures.push_back(pictureOf([colour](int, int) { return colour; }));
    pictures.push_back(
        pictureOf([](int x, int y) { return qRgb(x * 37 % 256, y * 53 % 256, (x + y) * 11 % 256); }));
    return pictures;
}

void standsOut(CanvasScene& scene, const std::vector<QPointF>& edges, const std::vector<QPointF>& handles) {
    std::vector<QPointF> places = edges;
    places.insert(places.end(), handles.begin(), handles.end());
    for (const auto& picture : pictures()) {
        scene.setFrame(picture);
        const QImage under = view::imageOf(*picture);
        const QImage over = painted(scene);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double contrast = contrastAt(over, under, places[i], i < edges.size() ? 6 : 12);
            QVERIFY2(contrast >= enough, qPrintable(QStringLiteral("%1 at %2, %3 on %4")
                                                        .arg(contrast)
                                                        .arg(places[i].x())
                                                        .arg(places[i].y())
                                                        .arg(under.pixelColor(places[i].toPoint()).name())));
        }
    }
}

} // namespace

// Whatever the picture, every handle and every piece of an outline stands out from it by 4.5 to 1, as
// measured in the pixels.
class OverlayContrastTest : public QObject {
    Q_OBJECT

private slots:
    void onEveryPicture_data();
    void onEveryPicture();
    void mapsOnEveryPicture_data();
    void mapsOnEveryPicture();
    void sentencesAreReadable();
    void hoverAndSelectionHaveNoMapsColour();
};

// A difference of 40 in CIELAB is seen at a glance, of thin lines too.
void OverlayContrastTest::hoverAndSelectionHaveNoMapsColour() {
    const auto lab = [](const QColor& colour) {
        const auto linear = [](double v) {
            return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        };
        const double r = linear(colour.redF()), g = linear(colour.greenF()), b = linear(colour.blueF());
        const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
        const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
        const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
        const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
        return std::array{116 * y - 16, 500 * (x - y), 200 * (y - z)};
    };
    for (const attractor::Rgba background :
         {attractor::Rgba{0, 0, 0, 255}, attractor::Rgba{255, 255, 255, 255}}) {
        const view::OverlayStyle style = view::overlayStyle(background, QPalette());
        const auto accent = lab(style.accent);
        for (std::size_t map = 0; map < 12; ++map) {
            const attractor::Rgba colour = attractor::categoricalColour(map);
            const auto other = lab(QColor(colour.red, colour.green, colour.blue));
            const double distance =
                std::hypot(accent[0] - other[0], accent[1] - other[1], accent[2] - other[2]);
            QVERIFY2(distance > 40, qPrintable(QStringLiteral("map %1: %2").arg(map + 1).arg(distance)));
        }
        QVERIFY(support::contrast(style.accent.rgb(), style.onAccent.rgb()) >= enough);
    }
}

void OverlayContrastTest::onEveryPicture_data() {
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("part");
    for (const bool dark : {true, false})
        for (const Kind part :
             {Kind::None, Kind::Vertex, Kind::Edge, Kind::Inside, Kind::Pivot, Kind::Rotate, Kind::Scale})
            QTest::addRow("%s background, part %d pointed at", dark ? "dark" : "light", int(part))
                << dark << int(part);
}

void OverlayContrastTest::onEveryPicture() {
    QFETCH(bool, dark);
    QFETCH(int, part);
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.appearance.background =
        dark ? attractor::Rgba{13, 17, 23, 255} : attractor::Rgba{250, 250, 248, 255};
    document::Document document;
    document.setFile(document::fileOf(fractal));
    CanvasScene scene(&document);
    scene.setDesktop(QPalette(), QFont());
    scene.grid().setGridVisible(false);
    scene.grid().setAxesVisible(false);
    scene.setView(camera(), 1);
    scene.selection().setHovered({Kind(part), part == int(Kind::Edge) ? 1 : 0});
    scene.selection().setFocused(scene.selection().hovered());

    const std::vector<QPointF> edges = placesOn(scene.cagePolygon());
    std::vector<QPointF> handles;
    for (const Kind handle : {Kind::Vertex, Kind::Pivot, Kind::Rotate, Kind::Scale})
        for (int i = 0; i < (handle == Kind::Vertex ? scene.cagePolygon().size() : 1); ++i)
            handles.push_back(scene.positionOf({handle, i}));
    standsOut(scene, edges, handles);
}

void OverlayContrastTest::mapsOnEveryPicture_data() {
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("taken");
    QTest::addColumn<bool>("takesPart");
    for (const bool dark : {true, false})
        for (const bool takesPart : {true, false})
            for (const auto taken : {HandleTarget::Cage, HandleTarget::Maps, HandleTarget::Branch})
                QTest::addRow("%s background, tool %d, map %s", dark ? "dark" : "light", int(taken),
                              takesPart ? "on" : "off")
                    << dark << int(taken) << takesPart;
}

// The first map is selected, the second is not; the third may be switched off.
void OverlayContrastTest::mapsOnEveryPicture() {
    QFETCH(bool, dark);
    QFETCH(int, taken);
    QFETCH(bool, takesPart);
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.appearance.background =
        dark ? attractor::Rgba{13, 17, 23, 255} : attractor::Rgba{250, 250, 248, 255};
    auto& maps = document::system2(fractal)->maps;
    maps[0].map.translation = {0.1, 0.15}; // away from the edges of the cage
    maps[0].enabled = taken != int(HandleTarget::Cage) || takesPart;
    maps[2].enabled = takesPart;
    document::Document document;
    document.setFile(document::fileOf(fractal));
    CanvasScene scene(&document);
    scene.setDesktop(QPalette(), QFont());
    scene.grid().setGridVisible(false);
    scene.grid().setAxesVisible(false);
    scene.setView(camera(), 1);
    scene.handles().setTarget(HandleTarget(taken));
    scene.selection().setMapIndices({0});
    scene.selection().setPointed(maps[0].id);
    if (taken == int(HandleTarget::Branch)) scene.handles().setBranch({0});

    std::vector<QPointF> edges;
    std::vector<QPointF> handles;
    for (std::size_t place = 0; place < (taken == int(HandleTarget::Maps) ? maps.size() : 1); ++place) {
        QPolygonF frame;
        for (const QPointF& corner : scene.cagePolygon())
            frame << view::pixelOf(camera(), maps[place].map(view::worldAt(camera(), corner)));
        QVERIFY(frame.size() == 3);
        const std::vector<QPointF> onFrame = placesOn(frame);
        edges.insert(edges.end(), onFrame.begin(), onFrame.end());
        if (taken != int(HandleTarget::Cage)) handles.insert(handles.end(), frame.begin(), frame.end());
    }
    standsOut(scene, edges, handles);
}

// The ground of the sentences on the canvas lets a little of the picture through, and stays readable.
void OverlayContrastTest::sentencesAreReadable() {
    for (const attractor::Rgba background :
         {attractor::Rgba{13, 17, 23, 255}, attractor::Rgba{250, 250, 248, 255}})
        for (const int grey : {0, 128, 255}) {
            const view::OverlayStyle style = view::overlayStyle(background, QPalette());
            QImage pixel(1, 1, QImage::Format_RGB32);
            pixel.fill(QColor(grey, grey, grey));
            QPainter(&pixel).fillRect(pixel.rect(), style.noteBackground);
            QVERIFY(support::contrast(pixel.pixel(0, 0), style.noteText.rgb()) >= enough);
        }
}

BARYCAGE_TEST(OverlayContrastTest, QApplication);
#include "overlay_contrast_test.moc"
