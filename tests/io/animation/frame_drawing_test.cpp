// SPDX-License-Identifier: MIT
#include "io/animation/frame_drawing.h"

#include "animation/motions/motion_presets.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <vector>

using animation::Moment;
using animation::moment;

namespace {

constexpr int frames = 32; // pilots at even ones

document::Fractal swayingMaple() {
    document::Fractal fractal;
    auto& shape = fractal.shape.emplace<document::Shape<2>>();
    shape.system = canonical::system<2>(canonical::maple(), {});
    shape.animation.emplace();
    shape.animation->length = frames;
    shape.animation->loop = animation::Loop::Cycle;
    shape.animation->motions = {animation::swayOf<2>(animation::swayPresets()[1], {}, {0, -1})};
    return fractal;
}

// Small pictures of the maple; notes which moments are asked for.
class NotingSource : public io::FrameSource {
public:
    NotingSource(int threads, std::vector<Moment>& asked) : m_threads(threads), m_asked(asked) {}

    const document::Fractal& entry() const override { return m_entry; }
    io::PlaneExport planeAt(const Moment& at) const override {
        m_asked.push_back(at);
        const document::AnimatedFrame frame = document::frameAt(m_entry, at);
        io::PlaneExport picture{
            m_entry,
            document::renderRequest(frame.fractal, attractor::cameraOf({{0, 2.5}, 11}, {80, 60})),
            {}};
        picture.request.samples = 200'000;
        picture.request.threads = m_threads;
        return picture;
    }
    io::SpaceExport spaceAt(const Moment&) const override { return {}; }

private:
    document::Fractal m_entry = swayingMaple();
    int m_threads;
    std::vector<Moment>& m_asked;
};

struct Drawn {
    explicit Drawn(int threads)
        : drawing(std::make_unique<NotingSource>(threads, asked), io::FrameOptions()) {}
    QImage frame(int number) { return drawing.draw(number, {}, {}).image; }
    bool measures(const Moment& pilot) const { return std::ranges::find(asked, pilot) != asked.end(); }

    std::vector<Moment> asked;
    io::FrameDrawing drawing;
};

} // namespace

// Frames one after another, and the exposures that they are drawn with.
class FrameDrawingTest : public QObject {
    Q_OBJECT

private slots:
    // Whichever pilots are measured at the same time as others.
    void aFrameIsThatOfTheSequence() {
        Drawn all(4), one(1);
        for (int number = 0; number < 9; ++number) {
            const QImage image = all.frame(number);
            QVERIFY(!image.isNull());
            QCOMPARE(Drawn(3).frame(number), image);
            QCOMPARE(one.frame(number), image);
        }
    }

    void pilotsAreMeasuredOnceAndInPairs() {
        Drawn drawn(2);
        drawn.frame(0); // is a pilot
        QVERIFY(!drawn.measures(moment(2)));
        drawn.frame(1);
        QVERIFY(drawn.measures(moment(2)) && drawn.measures(moment(4)) && !drawn.measures(moment(6)));
        drawn.frame(3);
        QVERIFY(!drawn.measures(moment(6)));
        QCOMPARE(std::ranges::count(drawn.asked, moment(4)), 1);
        drawn.frame(5);
        QVERIFY(drawn.measures(moment(6)) && drawn.measures(moment(8)) && !drawn.measures(moment(10)));
        drawn.frame(31);
        QVERIFY(drawn.measures(moment(30)) && drawn.measures(moment(32)) && !drawn.measures(moment(28)));
    }

    // A frame by itself needs no pilot that lies further on, and one thread measures no two at once.
    void noPilotIsMeasuredInVain() {
        Drawn drawn(2);
        drawn.frame(1);
        QVERIFY(drawn.measures(moment(0)) && drawn.measures(moment(2)) && !drawn.measures(moment(4)));
        Drawn alone(1);
        alone.frame(1);
        alone.frame(3);
        QVERIFY(alone.measures(moment(4)) && !alone.measures(moment(6)));
    }
};

BARYCAGE_TEST(FrameDrawingTest);
#include "frame_drawing_test.moc"
