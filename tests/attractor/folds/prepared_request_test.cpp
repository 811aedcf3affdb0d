// SPDX-License-Identifier: MIT
#include "attractor/folds/prepared_request.h"

#include "attractor/colour/srgb_transfer.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <limits>

using namespace attractor;

namespace {

PreparedRequest preparedOf(const RenderRequest& request) {
    PreparedRequest prepared;
    prepared.set(request);
    return prepared;
}

} // namespace

class TestPreparedRequest : public QObject {
    Q_OBJECT

private slots:
    void rangesAreKept() {
        RenderRequest request = systems::request(systems::fern(), 100);
        request.threads = 0;
        request.appearance.supersample = 9;
        QCOMPARE(preparedOf(request).request().threads, 1);
        QCOMPARE(preparedOf(request).cellsPerPixel(), 4);
        request.threads = 1000;
        request.appearance.supersample = -1;
        QCOMPARE(preparedOf(request).request().threads, 256);
        QCOMPARE(preparedOf(request).cellsPerPixel(), 1);
        QCOMPARE(preparedOf(request).request().samples, std::uint64_t{100});
    }

    void whatCanBeDrawn() {
        const RenderRequest good = systems::request(systems::fern(), 100);
        QVERIFY(preparedOf(good).isDrawable());
        QVERIFY(!PreparedRequest().isDrawable());
        const auto isDrawable = [&](const auto& spoil) {
            RenderRequest request = good;
            spoil(request);
            return preparedOf(request).isDrawable();
        };
        QVERIFY(!isDrawable([](RenderRequest& request) { request.system.maps.clear(); }));
        QVERIFY(!isDrawable([](RenderRequest& request) { request.camera.width = 0; }));
        QVERIFY(!isDrawable([](RenderRequest& request) { request.camera.height = -1; }));
        for (const double scale :
             {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
            QVERIFY(!isDrawable([scale](RenderRequest& request) { request.camera.pixelsPerUnit = scale; }));
        QVERIFY(!isDrawable([](RenderRequest& request) {
            request.camera.centre.y() = std::numeric_limits<double>::quiet_NaN();
        }));
    }

    void notesAboutTheView() {
        RenderRequest request = systems::request(systems::sierpinski(), 100);
        QVERIFY(preparedOf(request).viewNote() == RenderNote::None);
        request.cage = systems::squeezed(0.5);
        QVERIFY(preparedOf(request).viewNote() == RenderNote::None);
        request.cage = systems::squeezed(0);
        QVERIFY(preparedOf(request).viewNote() == RenderNote::Degenerate);
        request.cage.reset();
        request.camera.pixelsPerUnit = 1e18;
        QVERIFY(preparedOf(request).viewNote() == RenderNote::TooDeep);
    }

    // A cage that holds no coordinates moves nothing.
    void invalidCagesAreLeftOut() {
        RenderRequest request = systems::request(systems::sierpinski(), 100);
        request.cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {5, 0}, {0, 5}}};
        const PreparedRequest prepared = preparedOf(request);
        QVERIFY(prepared.projection().cage.affine() == ifs::AffineMap<2>{});
        QVERIFY(prepared.projection().cage.bend() == nullptr);
    }

    void theSystemIsPreparedOnce() {
        RenderRequest request = systems::request(systems::fern(), 100);
        PreparedRequest prepared = preparedOf(request);
        const auto* maps = prepared.system().maps.data();
        request.camera.pixelsPerUnit *= 2;
        request.cage = systems::squeezed(2);
        prepared.set(request);
        QCOMPARE(prepared.system().maps.data(), maps);
        QCOMPARE(prepared.request().camera.pixelsPerUnit, request.camera.pixelsPerUnit);
        request.system.maps.pop_back();
        prepared.set(request);
        QCOMPARE(prepared.system().maps.size(), std::size_t{3});
        request.moved = {{{0}, ifs::affineMap(1, 0, 0, 1, 5, 0)}};
        prepared.set(request);
        QCOMPARE(prepared.system().moved.size(), std::size_t{1});
    }

    // Maps that are off have no colour among those that take part.
    void coloursOfMaps() {
        RenderRequest request = systems::request(systems::fern(), 100);
        QVERIFY(!preparedOf(request).coloured());
        request.appearance.colourBy = ColourBy::Map;
        request.appearance.mapColours[request.system.maps[2].id] = {255, 128, 0, 255};
        request.system.maps[0].enabled = false;
        const PreparedRequest prepared = preparedOf(request);
        QVERIFY(prepared.coloured());
        const ColourCell& cell = prepared.colourOf(1, 0.9);
        QCOMPARE(cell.samples, 1U);
        QCOMPARE(cell.red, 4095U);
        QCOMPARE(cell.green, std::uint32_t(linearLight(128) * 4095 + 0.5));
        QCOMPARE(cell.blue, 0U);
    }

    void coloursOfAddresses() {
        RenderRequest request = systems::request(systems::fern(), 100);
        request.appearance.colourBy = ColourBy::Address;
        request.appearance.palette = {"ramp", {{0, {0, 0, 0, 255}}, {1, {255, 255, 255, 255}}}};
        const PreparedRequest prepared = preparedOf(request);
        QVERIFY(prepared.coloured());
        std::uint32_t last = 0;
        for (int i = 0; i <= 10; ++i) {
            const ColourCell& cell = prepared.colourOf(3, i / 10.0);
            QVERIFY(cell.red >= last && cell.red == cell.green && cell.red == cell.blue);
            last = cell.red;
        }
        QVERIFY(prepared.colourOf(0, 0).red < 20 && last > 4000);
    }
};

BARYCAGE_TEST(TestPreparedRequest);
#include "prepared_request_test.moc"
