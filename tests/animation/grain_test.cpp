// SPDX-License-Identifier: MIT
#include "animation/animation.h"
#include "animation/motions/motion_presets.h"
#include "attractor/render/banded_rendering.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace animation;
using attractor::Exposure, attractor::RenderRequest;

namespace {

constexpr int width = 160, height = 120, length = 1000; // nothing moves far from one frame to the next
const attractor::View wholeView{{0, 2.5}, 11};
constexpr std::uint64_t few = 30'000; // samples: the grain is coarse

using Greys = std::vector<int>;

// What is seen of a system at a moment, in a picture of few samples, with the exposure of frame 0.
class Film {
public:
    Film(ifs::IteratedFunctionSystem<2> system, Animation<2> animation)
        : m_still{std::move(system)}, m_animation(std::move(animation)) {
        m_still.cage = ifs::polygonAtRest<2>({{-4, -3}, {4, -3}, {0, 8}});
        m_exposure = *attractor::BandedRendering(requestAt(0, 1)).measuredExposure();
    }

    Greys at(int frame, std::uint64_t seed = 1) const {
        attractor::BandedRendering rendering(requestAt(frame, seed));
        rendering.useExposure(m_exposure);
        std::vector<std::uint32_t> pixels(std::size_t(width) * height);
        rendering.band(0, height, pixels);
        Greys greys;
        for (const std::uint32_t pixel : pixels)
            greys.push_back(systems::grey(pixel));
        return greys;
    }

private:
    RenderRequest requestAt(int frame, std::uint64_t seed) const {
        const Pose<2> pose = m_animation.at(moment(frame), m_still);
        RenderRequest request = systems::request(pose.system, few, width, height);
        request.camera = attractor::cameraOf(pose.camera.value_or(wholeView), {width, height});
        request.cage = pose.cage;
        request.seed = seed;
        return request;
    }

    Pose<2> m_still;
    Animation<2> m_animation;
    Exposure m_exposure;
};

// The mean difference of two pictures.
double apart(const Greys& a, const Greys& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(a[i] - b[i]);
    return sum / double(a.size());
}

double mean(const Greys& greys) {
    double sum = 0;
    for (const int grey : greys)
        sum += grey;
    return sum / double(greys.size());
}

ifs::IteratedFunctionSystem<2> weighted() {
    return canonical::system(canonical::maple(), {0.25, 0.25, 0.25, 0.25});
}

Animation<2> withMotion(const Motion<2>& motion) {
    Animation<2> animation;
    animation.length = length;
    animation.motions = {motion};
    return animation;
}

// The second map of this system becomes so large, and so heavy.
Animation<2> withMapTo(const ifs::IteratedFunctionSystem<2>& system, double size,
                       std::optional<double> weight) {
    Animation<2> animation;
    animation.length = length;
    const auto& map = system.maps[1];
    MapPose<2> end{map.map, weight};
    end.map.linear *= size;
    animation.maps = {{map.id, {{0, {map.map, map.weight}, {}}, {length, end, {}}}}};
    return animation;
}

Animation<2> withView(const attractor::View& end) {
    Animation<2> animation;
    animation.length = length;
    animation.camera = {{0, wholeView, {Ease::Kind::Linear}}, {length, end, {}}};
    return animation;
}

} // namespace

// The grain of frames moves with the fractal, and their brightness stays.
class GrainTest : public QObject {
    Q_OBJECT

private slots:
    void itDoesNotBoil_data();
    void itDoesNotBoil();
    void itMovesWithThePicture();
    void brightnessStays();
};

void GrainTest::itDoesNotBoil_data() {
    QTest::addColumn<ifs::IteratedFunctionSystem<2>>("system");
    QTest::addColumn<Animation<2>>("animation");
    const auto maple = systems::maple(); // the areas are its weights
    const auto gusts = swayOf<2>(swayPresets()[1], {}, {0, -1});
    QTest::newRow("wind") << maple << withMotion(gusts);
    QTest::newRow("wind, with weights") << weighted() << withMotion(gusts);
    QTest::newRow("turn") << maple << withMotion(Turn<2>{{ifs::MapId(2)}, 1});
    QTest::newRow("breathe") << maple << withMotion(Breathe<2>{{}, 0.1, 2});
    Animation<2> orbit = withMotion(Orbit<2>{1, {0, 2.5}});
    orbit.length *= 8; // else what is far from its centre moves by too many pixels
    QTest::newRow("orbit") << maple << orbit;
    QTest::newRow("a map") << maple << withMapTo(maple, 0.5, {});
    QTest::newRow("a weight") << weighted() << withMapTo(weighted(), 1, 0.5);
    QTest::newRow("zoom") << maple << withView({{0.5, 3}, 2});
}

// From one frame to the next the picture changes by far less than with other random numbers.
void GrainTest::itDoesNotBoil() {
    QFETCH(ifs::IteratedFunctionSystem<2>, system);
    QFETCH(Animation<2>, animation);
    const Film film(system, animation);
    for (int start = 20; start < length; start += 120) {
        Greys before = film.at(start);
        const double boiling = apart(before, film.at(start, 2));
        QVERIFY(boiling > 0.5);
        for (int frame = start + 1; frame < start + 4; ++frame) {
            Greys now = film.at(frame);
            const double ratio = apart(now, before) / boiling;
            QVERIFY2(ratio < 0.5, qPrintable(QStringLiteral("frame %1: %2").arg(frame).arg(ratio)));
            before = std::move(now);
        }
    }
}

// Panned by whole pixels, the picture is the same but for samples on the very border of a pixel.
void GrainTest::itMovesWithThePicture() {
    constexpr int pixels = 3; // a frame
    attractor::View end = wholeView;
    end.centre.x() += pixels * length * wholeView.height / height;
    const Film film(systems::maple(), withView(end));
    const Greys first = film.at(0);
    for (const int frame : {1, 2, 5}) {
        const Greys now = film.at(frame);
        int occupied = 0, same = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x + pixels * frame < width; ++x) {
                const int was = first[std::size_t(y * width + x + pixels * frame)];
                occupied += was > 0;
                same += was > 0 && was == now[std::size_t(y * width + x)];
            }
        QVERIFY(occupied > 1000);
        QVERIFY2(same > 0.98 * occupied, qPrintable(QStringLiteral("%1 of %2").arg(same).arg(occupied)));
    }
}

// What only turns is as bright in every frame.
void GrainTest::brightnessStays() {
    const Film film(systems::maple(), withMotion(Orbit<2>{1, {0, 2.5}}));
    double least = 255, most = 0;
    for (int frame = 0; frame < length; frame += 40) {
        const double now = mean(film.at(frame));
        least = std::min(least, now);
        most = std::max(most, now);
    }
    QVERIFY2(most < 1.03 * least, qPrintable(QStringLiteral("%1 to %2").arg(least).arg(most)));
}

BARYCAGE_TEST(GrainTest);
#include "grain_test.moc"
