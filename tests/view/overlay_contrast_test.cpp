// SPDX-License-Identifier: MIT
#include "attractor/renderer.h"
#include "canvas/attractor_item.h"
#include "canvas/canvas_scene.h"
#include "canvas/overlay_style.h"
#include "support/contrast.h"

#include <QPainter>
#include <QTest>

#include <functional>
#include <memory>

using view::CanvasPart;
using view::CanvasScene;
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

// A picture without anything else in it, or one that holds every shade beside every other.
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

} // namespace

// Whatever the picture, every handle and every piece of an outline stands out from it by 4.5 to 1, as
// measured in the pixels.
class OverlayContrastTest : public QObject {
    Q_OBJECT

private slots:
    void onEveryPicture_data();
    void onEveryPicture();
    void sentencesAreReadable();
};

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
    scene.setGridVisible(false);
    scene.setAxesVisible(false);
    scene.setView(camera(), 1);
    scene.setHovered({Kind(part), part == int(Kind::Edge) ? 1 : 0});
    scene.setFocused(scene.hovered());

    std::vector<std::shared_ptr<attractor::Frame>> pictures;
    for (int grey = 0;
         grey<256; grey += grey> 90 && grey < 150 ? 3 : 15) // the darkest to the lightest, the worst closely
        pictures.push_back(pictureOf([grey](int, int) { return qRgb(grey, grey, grey); }));
    for (const QRgb colour : {qRgb(255, 0, 0), qRgb(0, 200, 0), qRgb(0, 0, 255), qRgb(255, 190, 70),
                              qRgb(214, 96, 0), qRgb(90, 120, 160)})
        pictures.push_back(pictureOf([colour](int, int) { return colour; }));
    pictures.push_back(
        pictureOf([](int x, int y) { return qRgb(x * 37 % 256, y * 53 % 256, (x + y) * 11 % 256); }));

    std::vector<QPointF> places;
    const QPolygonF cage = scene.cagePolygon();
    for (int i = 0; i < cage.size(); ++i) {
        const QLineF edge(cage[i], cage[(i + 1) % cage.size()]);
        for (double t = 0.15; t < 0.86; t += 0.05)
            places.push_back(edge.pointAt(t));
    }
    const std::size_t onEdges = places.size();
    for (const Kind handle : {Kind::Vertex, Kind::Pivot, Kind::Rotate, Kind::Scale})
        for (int i = 0; i < (handle == Kind::Vertex ? cage.size() : 1); ++i)
            places.push_back(scene.positionOf({handle, i}));

    for (const auto& picture : pictures) {
        scene.setFrame(picture);
        const QImage under = view::imageOf(*picture);
        const QImage over = painted(scene);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double contrast = contrastAt(over, under, places[i], i < onEdges ? 6 : 12);
            QVERIFY2(contrast >= enough, qPrintable(QStringLiteral("%1 at %2, %3 on %4")
                                                        .arg(contrast)
                                                        .arg(places[i].x())
                                                        .arg(places[i].y())
                                                        .arg(under.pixelColor(places[i].toPoint()).name())));
        }
    }
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

QTEST_MAIN(OverlayContrastTest)
#include "overlay_contrast_test.moc"
