// SPDX-License-Identifier: MIT
#include "support/choose.h"
#include "support/named_test.h"
#include "view/panels/collage_panel_fixture.h"

#include <QComboBox>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

constexpr QSize side{24, 24}; // of a square that is looked at

bool isGrey(QRgb pixel) {
    return qRed(pixel) == qGreen(pixel) && qGreen(pixel) == qBlue(pixel);
}

// Whether all pixels of the square keep their colour one step up and to the right, or down and to the right.
bool isAlong(const QImage& image, const QRect& square, int down) {
    for (int y = square.top(); y <= square.bottom(); ++y)
        for (int x = square.left(); x <= square.right(); ++x)
            if (image.pixel(x, y) != image.pixel(x + 1, y + down)) return false;
    return true;
}

std::set<int> opacitiesOf(const QImage& image, const QRect& square) {
    std::set<int> found;
    for (int y = square.top(); y <= square.bottom(); ++y)
        for (int x = square.left(); x <= square.right(); ++x)
            found.insert(qAlpha(image.pixel(x, y)));
    return found;
}

} // namespace

// What lies over the canvas of a target and of what is compared with it.
class CollageLayerTest : public CollagePanelFixture {
    Q_OBJECT

    void take(const std::vector<ifs::AffineMap<2>>& maps) {
        document::Fractal fractal = m_document->fractal();
        document::Shape<2> shape;
        for (const auto& map : maps)
            ifs::append<2>(shape.system, placed(map), 0.3);
        fractal.shape = std::move(shape);
        m_document->edit(QStringLiteral("Prepare"), std::move(fractal));
        m_canvas->selectMaps({});
        settle();
    }
    void setBackground(const attractor::Rgba& colour) {
        document::Fractal fractal = m_document->fractal();
        fractal.appearance.background = colour;
        m_document->edit(QStringLiteral("Background"), std::move(fractal));
    }
    void showAgreement(bool shown) {
        using Agreement = view::CollagePanel::Agreement;
        support::choose(named<QComboBox>(QStringLiteral("Agreement")),
                        shown ? Agreement::OfCollage : Agreement::Hidden);
        settle();
    }
    void setOpacity(int percent) {
        named<QSlider>(QStringLiteral("Opacity of the target"))->setValue(percent);
    }
    // The layer alone, on nothing.
    QImage painted() const {
        QImage image(m_canvas->viewport()->size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        layer()->paint(&painter, nullptr, nullptr);
        return image;
    }
    QColor paintedAt(const Vector<2>& place) const { return paintedIn(placed(place)); }
    QColor paintedIn(const Vector<2>& point) const {
        return painted().pixelColor(view::pixelOf(m_canvas->camera(), point).toPoint());
    }
    document::MeasuredFractal measured() const {
        return *document::measured(m_document->fractal(), *m_panel->target()->traced(),
                                   document::Compared::Collage);
    }
    // Of the picture of the agreement, around a place of the plane.
    QRect squareAt(const document::MeasuredFractal& measured, const Vector<2>& inPicture) const {
        const QRectF& area = measured.area;
        const Vector<2> place = placed(inPicture);
        QRect square({0, 0}, side);
        square.moveCenter({int((place.x() - area.x()) / area.width() * measured.picture.width()),
                           int((area.y() - place.y()) / area.height() * measured.picture.height())});
        return square;
    }

private slots:
    void init() {
        openPanel();
        traceLeaf();
        attractor::Camera camera = m_canvas->camera();
        camera.centre = placed(Vector<2>(0, 0));
        camera.pixelsPerUnit = 400 / m_panel->target()->traced()->place.height;
        m_canvas->navigation().moveTo(camera);
    }
    void cleanup() {
        m_panel.reset();
        close();
    }

    // Half of the leaf in its middle, and a small one on its right.
    void agreementIsToldByColourAndHatching() {
        take({ifs::affineMap(0.5, 0, 0, 0.5, 0, 0), ifs::affineMap(0.25, 0, 0, 0.25, 0.36, 0)});
        const document::MeasuredFractal result = measured();
        const QImage& image = result.picture;
        const QRect both = squareAt(result, {0, 0});
        for (int y = both.top(); y <= both.bottom(); ++y)
            for (int x = both.left(); x <= both.right(); ++x)
                QVERIFY(isGrey(image.pixel(x, y)) && qAlpha(image.pixel(x, y)) > 0);
        QCOMPARE(opacitiesOf(image, both).size(), std::size_t{1}); // no hatching
        const QRect missing = squareAt(result, {0, 0.3}), excess = squareAt(result, {0.36, 0});
        for (const QRect& square : {missing, excess}) {
            QVERIFY(image.rect().contains(square));
            for (int y = square.top(); y <= square.bottom(); ++y)
                for (int x = square.left(); x <= square.right(); ++x) {
                    const QRgb pixel = image.pixel(x, y);
                    QVERIFY(square == missing ? qBlue(pixel) > qRed(pixel) : qRed(pixel) > qBlue(pixel));
                }
            QCOMPARE(opacitiesOf(image, square).size(), std::size_t{2}); // strokes, and what is between
        }
        QVERIFY(isAlong(image, missing, 1) && !isAlong(image, missing, -1)); // like a backslash
        QVERIFY(isAlong(image, excess, -1) && !isAlong(image, excess, 1));   // like a slash
        QCOMPARE(qAlpha(image.pixel(squareAt(result, {0.3, 0.3}).center())), 0);
        QVERIFY(result.used.contains(missing) && result.used.contains(excess));
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                QVERIFY(qAlpha(image.pixel(x, y)) == 0 || result.used.contains(x, y));
    }

    void agreementLiesInItsPlace() {
        take({ifs::affineMap(0.5, 0, 0, 0.5, 0, 0), ifs::affineMap(0.25, 0, 0, 0.25, 0.36, 0)});
        setOpacity(0);
        QTRY_VERIFY_WITH_TIMEOUT(paintedAt({0, 0}).alpha() > 0, 60'000);
        const QColor both = paintedAt({0, 0}), missing = paintedAt({0, 0.3}), excess = paintedAt({0.36, 0});
        QVERIFY(std::abs(both.red() - both.blue()) < 10);
        QVERIFY(missing.alpha() > 0 && missing.blue() > missing.red() + 50);
        QVERIFY(excess.alpha() > 0 && excess.red() > excess.blue() + 50);
        QCOMPARE(paintedAt({0.3, 0.3}).alpha(), 0);
        showAgreement(false);
        QCOMPARE(paintedAt({0, 0.3}).alpha(), 0);
    }

    void targetIsAsOpaqueAsTheSliderSays() {
        showAgreement(false);
        setBackground({255, 255, 255, 255});
        setOpacity(0);
        QCOMPARE(paintedAt({0, 0.1}).alpha(), 0);
        setOpacity(40);
        const QColor usual = paintedAt({0, 0.1});
        setOpacity(80);
        const QColor strong = paintedAt({0, 0.1});
        QVERIFY(usual.alpha() > 60 && std::abs(strong.alpha() - 2 * usual.alpha()) <= 4);
        QVERIFY(strong.lightness() < 80); // dark on light
        QVERIFY(paintedAt({0.3, 0.3}).alpha() < 10);
        setBackground({0, 0, 0, 255});
        QVERIFY(paintedAt({0, 0.1}).lightness() > 180); // light on dark
    }

    // w_i(L) in the colour of map i, and nowhere else; so it is while a corner is held, too.
    void mapsCarryTheTargetInTheirColours() {
        take({ifs::affineMap(0.25, 0, 0, 0.25, 0, -0.3), ifs::affineMap(0.25, 0, 0, 0.25, 0, 0),
              ifs::affineMap(0.25, 0, 0, 0.25, 0, 0.3)});
        showAgreement(false);
        setOpacity(0);
        m_canvas->setTool(CanvasView::Tool::Cage);
        QCOMPARE(paintedAt({0, 0}).alpha(), 0);
        m_canvas->setTool(CanvasView::Tool::Maps);
        const auto verifyColours = [&] {
            std::set<QRgb> colours;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& map = system().maps[i];
                const attractor::Rgba expected =
                    attractor::mapColour(m_document->fractal().appearance, map.id, i);
                const QColor found = paintedIn(map.map(placed(Vector<2>(0, 0.05))));
                QVERIFY2(found.alpha() > 40 && found.alpha() < 120,
                         qPrintable(QString::number(found.alpha())));
                QVERIFY(std::abs(found.red() - expected.red) < 8);
                QVERIFY(std::abs(found.green() - expected.green) < 8);
                QVERIFY(std::abs(found.blue() - expected.blue) < 8);
                colours.insert(qRgb(expected.red, expected.green, expected.blue));
            }
            QCOMPARE(colours.size(), std::size_t{3});
        };
        verifyColours();
        QCOMPARE(paintedAt({0, 0.15}).alpha(), 0); // between two of them
        QCOMPARE(paintedAt({0.2, 0}).alpha(), 0);
        const document::System2 before = system();
        const QPointF corner = at({Kind::Vertex, 1, 0});
        press(corner);
        move(corner + QPointF(-6, 4));
        move(corner + QPointF(-12, 8));
        QVERIFY(!(system() == before));
        verifyColours();
        key(Qt::Key_Escape);
        release(corner);
        QVERIFY(system() == before);
        verifyColours();
    }
};

BARYCAGE_TEST(CollageLayerTest, QApplication);
#include "collage_layer_test.moc"
