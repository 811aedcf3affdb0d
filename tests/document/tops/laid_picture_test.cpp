// SPDX-License-Identifier: MIT
#include "document/tops/laid_picture.h"

#include "attractor/colour/srgb_transfer.h"
#include "attractor/tops/picture_patterns.h"
#include "ifs/tops/families.h"
#include "ifs/tops/top_systems.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <set>

using document::LaidPicture;
using document::TheftMode;

namespace {

constexpr double p = 0.35, q = 0.6; // where the pieces of G meet

document::Fractal squareOf(double x, double y) {
    document::System2 system;
    for (const ifs::AffineMap<2>& map : ifs::squareFamily({x, y}))
        ifs::append(system, map);
    return support::fractalOf(std::move(system));
}

std::optional<LaidPicture> laidOn(const std::shared_ptr<const attractor::MipPicture>& picture,
                                  TheftMode mode) {
    const auto outcome = document::coupled(squareOf(.5, .5), squareOf(p, q), {});
    if (!outcome.entries) return std::nullopt;
    attractor::DeferredTheft there(2);
    return document::laid(*outcome.entries, picture, mode, std::nullopt, there, {});
}

// Redder from left to right, greener downwards.
std::shared_ptr<const attractor::MipPicture> slopes() {
    std::vector<attractor::Rgba> pixels;
    for (int k = 0; k < 64 * 64; ++k)
        pixels.push_back({std::uint8_t(k % 64 * 4), std::uint8_t(k / 64 * 4), 0, 255});
    return std::make_shared<const attractor::MipPicture>(64, 64, pixels);
}

// Where T_GF takes a coordinate of G: the inverse of h_α, which increases.
double inverse(double alpha, double image) {
    double low = 0, high = 1;
    for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        (tops::hFunction(alpha, middle) < image ? low : high) = middle;
    }
    return low;
}

// Whether a pixel of so many shows what lies between the images of its edges, to a few shades.
bool isBetween(int shade, double alpha, int pixel, int count) {
    constexpr int tolerance = 16; // of 255
    return shade >= 255 * inverse(alpha, double(pixel) / count) - tolerance &&
           shade <= 255 * inverse(alpha, double(pixel + 1) / count) + tolerance;
}

} // namespace

// The picture that each mode lays on the partner.
class LaidPictureTest : public QObject {
    Q_OBJECT

private slots:
    // The picture lies on F, and 48 pixels on G show it through T_GF; T_FG then takes them back to F.
    void reducesThroughTheInverse() {
        constexpr int side = 48;
        const auto laid = laidOn(slopes(), TheftMode::Reduce);
        QVERIFY(laid);
        QCOMPARE(laid->picture->width(), side);
        QCOMPARE(laid->picture->height(), side);
        const ifs::Vector<2> corner = laid->toPicture(ifs::Vector<2>(0, 1));
        QVERIFY(corner.norm() < 0.01);
        int elsewhere = 0;
        for (int row = 1; row < side - 1; ++row)
            for (int column = 1; column < side - 1; ++column) {
                const auto colour = laid->picture->at(column + .5, row + .5, 0);
                QVERIFY(colour.alpha > 0.99);
                const int red = attractor::encoded(colour.red), green = attractor::encoded(colour.green);
                QVERIFY(isBetween(red, p, column, side));
                QVERIFY(isBetween(255 - green, q, side - 1 - row, side));
                elsewhere += isBetween(red, .5, column, side) ? 0 : 1; // than where it lies on F
            }
        QVERIFY(elsewhere > side * side / 10);
    }

    void posterisesToFourShades() {
        const auto wheel =
            std::make_shared<const attractor::MipPicture>(attractor::picture(attractor::Pattern::Wheel, 256));
        const auto laid = laidOn(wheel, TheftMode::Posterise);
        QVERIFY(laid);
        QCOMPARE(laid->picture->width(), 768);
        std::set<int> shades;
        for (int row = 5; row < laid->picture->height(); row += 11)
            for (int column = 5; column < 768; column += 11) {
                const auto colour = laid->picture->at(column + .5, row + .5, 0);
                if (colour.alpha < 1) continue;
                for (const double channel : {colour.red, colour.green, colour.blue})
                    shades.insert(attractor::encoded(channel));
            }
        for (const int shade : shades)
            QVERIFY2(shade % 85 == 0, qPrintable(QString::number(shade)));
        QVERIFY(shades.size() >= 3);
    }

    // Whatever picture was chosen, the grid covers the box of G.
    void theGridCoversThePartner() {
        const auto laid = laidOn(slopes(), TheftMode::DeformationGrid);
        QVERIFY(laid);
        const attractor::MipPicture grid = attractor::picture(attractor::Pattern::Grid);
        QCOMPARE(laid->picture->width(), grid.width());
        QVERIFY(laid->toPicture(ifs::Vector<2>(0, 1)).norm() < 1e-6 * grid.width());
        const ifs::Vector<2> end(grid.width(), grid.height());
        QVERIFY((laid->toPicture(ifs::Vector<2>(1, 0)) - end).norm() < 1e-6 * grid.width());
        for (int k = 0; k < 100; ++k) {
            const double x = (k * 37 % 100 + .5) / 100 * grid.width();
            const double y = (k + .5) / 100 * grid.height();
            QCOMPARE(laid->picture->at(x, y, 1).red, grid.at(x, y, 1).red);
        }
    }

    // While F is dragged, nothing about G is worked out again; another G, or another order, is.
    void anEntryThatStaysIsKnown() {
        const auto before = document::coupled(squareOf(.5, .5), squareOf(p, q), {}).entries;
        const auto mapsOf = [](const document::Fractal& fractal) {
            return ifs::mapsOf(*document::system2(fractal));
        };
        const auto dragged = document::coupled(squareOf(.4, .5), squareOf(p, q), {}, before).entries;
        QVERIFY(dragged->toAttractor.outline() == before->toAttractor.outline());
        QVERIFY(dragged->fromAttractor.maps() == mapsOf(squareOf(.4, .5)));
        QVERIFY(dragged->from == document::coupled(squareOf(.4, .5), squareOf(p, q), {}).entries->from);
        const auto other = document::coupled(squareOf(.5, .5), squareOf(.2, q), {}, before).entries;
        QVERIFY(other->toAttractor.maps() == mapsOf(squareOf(.2, q)));
        QVERIFY(other->to == document::coupled(squareOf(.5, .5), squareOf(.2, q), {}).entries->to);
        const std::vector<std::size_t> order{1, 0, 2, 3};
        const auto reordered = document::coupled(squareOf(.5, .5), squareOf(p, q), order, before).entries;
        std::vector<ifs::AffineMap<2>> maps = mapsOf(squareOf(p, q));
        std::swap(maps[0], maps[1]);
        QVERIFY(reordered->toAttractor.maps() == maps);
    }

    void filtersStop() {
        const auto outcome = document::coupled(squareOf(.5, .5), squareOf(p, q), {});
        std::stop_source stop;
        stop.request_stop();
        attractor::DeferredTheft there(1);
        for (const TheftMode mode : {TheftMode::Reduce, TheftMode::Posterise})
            QVERIFY(!document::laid(*outcome.entries, slopes(), mode, std::nullopt, there, stop.get_token()));
    }
};

BARYCAGE_TEST(LaidPictureTest);
#include "laid_picture_test.moc"
