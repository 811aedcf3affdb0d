// SPDX-License-Identifier: MIT
#include "attractor/solid/bend_tree.h"

#include "attractor/render/solid_rendering.h"
#include "attractor/solid/depth_range.h"
#include "attractor/solid/space_view.h"
#include "attractor/space_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <functional>
#include <thread>
#include <vector>

using namespace attractor;
using ifs::Vector;

namespace {

// Menger's sponge in its box, of which two corners are pulled.
SpaceRequest pulled() {
    SpaceRequest request = systems::spaceRequest(systems::menger(), 200, 160);
    std::vector<Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    request.cage = ifs::polygonAtRest<3>(corners);
    request.cage->current[7] += Vector<3>(0.5, 0.4, 0.3);
    request.cage->current[1] += Vector<3>(0.2, -0.3, 0.1);
    request.camera.target = {0.6, 0.5, 0.5};
    request.camera.height = 2.4;
    return request;
}

// The words down to the second level, and the tree that is asked for them.
struct Walk {
    PreparedSpace system;
    std::vector<ifs::AffineMap<3>> maps;
    SpaceView view;
    std::shared_ptr<BendTree> tree;

    explicit Walk(const SpaceRequest& request, std::size_t byteLimit = BendTree::maxBytes)
        : system(preparedSpace(request.system)), tree(std::make_shared<BendTree>(byteLimit)) {
        for (const ifs::AffineMap<3>& map : system.maps)
            maps.push_back(system.inBox(map));
        follow(request);
    }
    void follow(const SpaceRequest& request) {
        view = spaceView(request, {});
        view.bends = tree;
        tree->follow(*view.bend, view.afterBend, system.fromBox(), maps);
    }
    std::vector<WalkedWord> words() const {
        std::vector<WalkedWord> result{rootWord(system.fromBox(), view)};
        for (std::size_t level = 0, first = 0; level < 2; ++level) {
            const std::size_t end = result.size();
            for (; first < end; ++first)
                for (std::size_t i = 0; i < maps.size(); ++i)
                    result.push_back(childWord(result[first], i, maps[i], view));
        }
        return result;
    }
    std::vector<StraightWord> straight() const {
        std::vector<StraightWord> result;
        for (WalkedWord& word : words())
            result.push_back(straightened(word, view));
        return result;
    }
    std::vector<StraightWord> straightAlone() const { // without the tree
        SpaceView alone = view;
        alone.bends = nullptr;
        std::vector<StraightWord> result;
        for (const WalkedWord& word : words()) {
            WalkedWord same{word.word};
            result.push_back(straightened(same, alone));
        }
        return result;
    }
};

bool same(const std::vector<StraightWord>& a, const std::vector<StraightWord>& b) {
    return std::ranges::equal(a, b, [](const StraightWord& x, const StraightWord& y) {
        return x.word == y.word && x.miss == y.miss;
    });
}

std::vector<std::uint32_t> freshKeys(const SpaceRequest& request) {
    SolidRendering rendering(request);
    rendering.draw();
    return rendering.takeRaster().keys;
}

} // namespace

class BendTreeTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsKeptIsWhatTheCageSays() {
        SpaceRequest request = pulled();
        Walk walk(request);
        for (int frame = 0; frame < 3; ++frame) {
            const auto kept = walk.straight();
            QVERIFY(same(kept, walk.straightAlone()) && same(kept, walk.straight()));
            request.cage->current[7] -= Vector<3>(0.1, 0.05, 0);
            request.camera.orientation = orbit(40 + 10 * frame, 15);
            walk.follow(request);
        }
    }

    void theCageAtRestIsLookedAtOnce() {
        SpaceRequest request = pulled();
        Walk walk(request);
        const std::size_t words = walk.straight().size();
        QCOMPARE(walk.tree->looks(), words);
        request.cage->current[3] += Vector<3>(0.1, 0.2, 0.3);
        walk.follow(request);
        walk.straight();
        QCOMPARE(walk.tree->looks(), words);
        request.cage->rest[7] += Vector<3>(0.125, 0.125, 0.125);
        QVERIFY(ifs::isValid(*request.cage));
        walk.follow(request);
        QVERIFY(same(walk.straight(), walk.straightAlone()));
        QCOMPARE(walk.tree->looks(), 2 * words);
        walk.maps[4].translation *= 0.75;
        walk.follow(request);
        QVERIFY(same(walk.straight(), walk.straightAlone()));
        QCOMPARE(walk.tree->looks(), 3 * words);
    }

    void aFullTreeChangesNothing() {
        for (const std::size_t bytes : {std::size_t(0), std::size_t(4096), std::size_t(100'000)}) {
            SpaceRequest request = pulled();
            Walk walk(request, bytes);
            QVERIFY(same(walk.straight(), walk.straightAlone()));
            QVERIFY(walk.tree->bytes() <= bytes);
            QVERIFY(walk.tree->looks() * sizeof(BentWord) <= bytes);
        }
    }

    // Words that nobody asks for any more make room.
    void aFullTreeBeginsAgain() {
        Walk walk(pulled(), 100'000);
        walk.straight();
        const std::size_t looks = walk.tree->looks();
        walk.follow(pulled());
        walk.straight();
        QCOMPARE(walk.tree->looks(), looks); // all of them were asked for
        walk.follow(pulled());               // and now none
        walk.follow(pulled());
        walk.straight();
        QCOMPARE(walk.tree->looks(), 2 * looks);
    }

    void threadsMayAskForTheSameWords() {
        Walk walk(pulled());
        std::vector<std::vector<StraightWord>> found(4);
        std::vector<std::jthread> threads;
        for (auto& words : found)
            threads.emplace_back([&] { words = walk.straight(); });
        threads.clear();
        for (const auto& words : found)
            QVERIFY(same(words, walk.straightAlone()));
        QCOMPARE(walk.tree->looks(), found[0].size());
    }

    void theRangeOfDepthsIsTheSame() {
        Walk walk(pulled());
        const DepthRange kept = depthRange(walk.system, walk.view);
        walk.view.bends = nullptr;
        const DepthRange alone = depthRange(walk.system, walk.view);
        QCOMPARE(kept.near, alone.near);
        QCOMPARE(kept.far, alone.far);
    }

    // One rendering serves all of these, one after the other; whatever changes, the bytes are those of a new
    // one.
    void picturesAreTheSameKeptOrNot() {
        SpaceRequest request = pulled();
        SolidRendering rendering(request);
        const std::vector<std::function<void()>> changes{
            [] {},
            [&] { request.camera.orientation = orbit(50, 10); },
            [&] { request.cage->current[7] += Vector<3>(0, -0.2, 0.1); },
            [&] { request.camera.projection = OrbitCamera::Projection::Perspective; },
            [&] { request.cage->rest[7] += Vector<3>(0.125, 0.125, 0.125); },
            [&] { request.key = SolidKey::Address; },
            [&] { request.system.maps[3].map.linear *= 0.5; },
            [&] { request.system.maps.pop_back(); },
            [&] { request.cage->deformation = ifs::Deformation::AffineFit; },
            [&] { request.cage->deformation = ifs::Deformation::Bend; },
            [&] { request.threads = 2; },
            [&] { request = pulled(); },
        };
        for (const auto& change : changes) {
            change();
            rendering.restart(request);
            rendering.draw();
            QVERIFY(rendering.raster().keys == freshKeys(request));
            rendering.draw(); // again, from what is kept
            QVERIFY(rendering.raster().keys == freshKeys(request));
        }
    }
};

BARYCAGE_TEST(BendTreeTest);
#include "bend_tree_test.moc"
