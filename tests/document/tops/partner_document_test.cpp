// SPDX-License-Identifier: MIT
#include "document/tops/partner_document.h"

#include "document/edits/coupled_entries.h"
#include "document/edits/entries_edits.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/tops/divided_words.h"
#include "document/tops/laid_picture.h"
#include "document/tops/theft_starters.h"
#include "document/tops/theft_thread.h"
#include "ifs/dimension/moments.h"
#include "support/named_test.h"

#include <QTest>

#include <semaphore>

using document::Document;
using document::EntryId;
using document::Fractal;
using document::PartnerDocument;
using document::TheftFamily;
using document::TheftMode;

namespace {

Fractal moved(Fractal fractal, double by) {
    document::system2(fractal)->maps.front().map.translation.x() += by;
    return fractal;
}

const Fractal& fractalOf(const Document& document, EntryId id) {
    return *document.file().entries[document::indexOf(document.file(), id)].fractal;
}

std::shared_ptr<const attractor::MipPicture> wheel() {
    return std::make_shared<const attractor::MipPicture>(attractor::picture(attractor::Pattern::Wheel, 64));
}

} // namespace

// Two entries of one document at once, and what is drawn of them.
class PartnerDocumentTest : public QObject {
    Q_OBJECT

private:
    Document m_document;
    std::unique_ptr<PartnerDocument> m_partner;

    void start(TheftFamily family) {
        m_document.setFile({});
        document::StartedTheft started = document::withStarter(m_document.file(), family);
        m_document.setFile(std::move(started.file), started.from);
        m_partner = std::make_unique<PartnerDocument>(&m_document);
        m_partner->setPartner(
            document::entryNamed(m_document.file(), document::keptTheft(m_document.entryFractal())->partner));
        QVERIFY(m_partner->id() != EntryId::None);
    }

private slots:
    void aFinishedGestureIsOneStepOfTheHost() {
        start(TheftFamily::Triangle);
        const Fractal before = m_partner->document().fractal();
        const EntryId current = m_document.currentId();
        {
            document::EditGesture gesture = m_partner->document().beginGesture(QStringLiteral("Pull"));
            for (int k = 1; k <= 5; ++k)
                gesture.preview(moved(gesture.before(), .01 * k));
            QCOMPARE(m_document.undoStack()->count(), 0);
            QVERIFY(fractalOf(m_document, m_partner->id()) == before);
            gesture.commit();
        }
        QCOMPARE(m_document.undoStack()->count(), 1);
        QCOMPARE(m_document.undoStack()->undoText(), QStringLiteral("Pull"));
        QVERIFY(fractalOf(m_document, m_partner->id()) == moved(before, .05));
        QCOMPARE(m_document.currentId(), current);
        m_document.undoStack()->undo();
        QVERIFY(m_partner->document().fractal() == before);
        m_document.undoStack()->redo();
        QVERIFY(m_partner->document().fractal() == moved(before, .05));
        QCOMPARE(m_document.undoStack()->count(), 1);
    }

    void aCancelledGestureIsNone() {
        start(TheftFamily::Square);
        {
            document::EditGesture gesture = m_partner->document().beginGesture(QStringLiteral("Pull"));
            gesture.preview(moved(gesture.before(), .1));
        }
        QCOMPARE(m_document.undoStack()->count(), 0);
    }

    void thePartnerMayGo() {
        start(TheftFamily::Square);
        const EntryId id = m_partner->id();
        m_document.editFile(QStringLiteral("Remove"), document::removed(m_document.file(), {id}));
        QCOMPARE(m_partner->id(), EntryId::None);
        QVERIFY(m_partner->document().file().entries.isEmpty()); // nothing is shown in its place
        m_partner->document().edit(QStringLiteral("Pull"), Fractal());
        QCOMPARE(m_document.file().entries.size(), 1);
        m_document.undoStack()->undo();
        m_partner->setPartner(id);
        QVERIFY(m_partner->document().entryFractal() == fractalOf(m_document, id));
    }

    void numbersOfMapsAgree() {
        QCOMPARE(document::commonMapCount(2, 3), std::optional<std::size_t>(3));
        QCOMPARE(document::commonMapCount(3, 4), std::optional<std::size_t>(7));
        QCOMPARE(document::commonMapCount(4, 4), std::optional<std::size_t>(4));
        QCOMPARE(document::commonMapCount(1, 4), std::optional<std::size_t>());
        QCOMPARE(document::commonMapCount(998, 1000), std::optional<std::size_t>());
    }

    // The same attractor and the same measure: all first and second moments.
    void dividedWordsChangeNothing() {
        const Fractal whole = document::sierpinskiTriangle();
        const Fractal divided = document::withWordsDivided(whole, 7);
        const document::System2 &a = *document::system2(whole), &b = *document::system2(divided);
        QCOMPARE(b.maps.size(), std::size_t(7));
        const auto before = ifs::moments(ifs::activeMaps(a)), after = ifs::moments(ifs::activeMaps(b));
        QVERIFY(before && after);
        QVERIFY((before->mean - after->mean).norm() < 1e-12);
        QVERIFY((before->covariance - after->covariance).norm() < 1e-12);
        const auto outcome = document::coupled(divided, divided, {});
        QVERIFY(outcome.entries);
    }

    // 3 above 1 above 2: the words are 11, 12, 13, 21, 22, 23, 3.
    void dividedWordsInheritTheOrder() {
        document::KeptTheft theft;
        theft.partner = QStringLiteral("other");
        theft.order = {2, 0, 1};
        const Fractal whole = document::withTheft(document::sierpinskiTriangle(), theft);
        const auto orderOf = [](const Fractal& fractal) { return document::keptTheft(fractal)->order; };
        const Fractal divided = document::withWordsDivided(whole, 7);
        QCOMPARE(orderOf(divided), (std::vector<std::size_t>{6, 2, 0, 1, 5, 3, 4}));
        QVERIFY(document::coupled(divided, divided, orderOf(divided)).entries);
        theft.order = {};
        const Fractal inOrder = document::withTheft(whole, theft);
        QVERIFY(orderOf(document::withWordsDivided(inOrder, 7)).empty());
        theft.order = {0, 1}; // of other maps
        QVERIFY(orderOf(document::withWordsDivided(document::withTheft(whole, theft), 7)).empty());
        Fractal partly = whole; // a map that is off has an index all the same
        document::system2(partly)->maps[0].enabled = false;
        theft.order = {2, 1};
        QCOMPARE(orderOf(document::withWordsDivided(document::withTheft(partly, theft), 3)),
                 (std::vector<std::size_t>{2, 1, 0}));
    }

    void copiesUnderASymmetryKeepTheirPlaceTogether() {
        document::Fractal fractal = document::sierpinskiTriangle();
        ifs::Symmetry<2> twice;
        twice.group = ifs::SymmetryGroup::Rotation;
        twice.order = 2;
        fractal = document::withSymmetry(std::move(fractal), twice);
        const auto outcome = document::coupled(fractal, fractal, std::vector<std::size_t>{2, 0, 1});
        QVERIFY(outcome.entries);
        QCOMPARE(outcome.entries->numbers, (std::vector<std::size_t>{2, 2, 0, 0, 1, 1}));
        const std::vector<std::size_t> bad[] = {{0, 1}, {0, 1, 1}, {0, 1, 2, 2}, {0, 1, 3}};
        for (const std::vector<std::size_t>& order : bad)
            QVERIFY(document::coupled(fractal, fractal, order).flaw == document::CouplingFlaw::Order);
    }

    void likelyPartnersHaveAsManyMaps() {
        start(TheftFamily::Triangle);
        document::FractalFile file = document::fileOf(document::sierpinskiTriangle());
        file = document::inserted(file, m_document.file().entries, EntryId::None).file;
        QCOMPARE(document::likelyPartner(file, file.entries[1].id), file.entries[2].id);
        QCOMPARE(document::likelyPartner(file, file.entries[0].id), file.entries[1].id);
        QCOMPARE(document::likelyPartner(document::fileOf(document::sierpinskiTriangle()), EntryId(1)),
                 EntryId::None);
    }

    void divisionIsOneFile() {
        start(TheftFamily::Triangle);
        document::FractalFile file =
            document::inserted(m_document.file(), document::fileOf(document::sierpinskiTriangle()).entries,
                               EntryId::None)
                .file;
        file = document::withWordsDivided(file, file.entries[0].id, file.entries[2].id);
        for (const int index : {0, 2})
            QCOMPARE(document::system2(*file.entries[index].fractal)->maps.size(), std::size_t(7));
    }

    // Every mode has a picture on both sides; other numbers of maps have a reason.
    void drawsEveryMode_data() {
        QTest::addColumn<int>("mode");
        for (const TheftMode mode : {TheftMode::StealColours, TheftMode::TransformPicture,
                                     TheftMode::DeformationGrid, TheftMode::Reduce, TheftMode::Posterise})
            QTest::addRow("%d", int(mode)) << int(mode);
    }

    void drawsEveryMode() {
        QFETCH(int, mode);
        start(TheftFamily::Square);
        std::binary_semaphore ready(0);
        document::TheftThread thread(2, [&] { ready.release(); });
        document::TheftJob job;
        const attractor::Camera camera{{.5, .5}, 60, 80, 80, attractor::YAxis::Up};
        job.from = {m_document.sharedFractal(), camera, 7};
        job.to = {m_partner->document().sharedFractal(), camera, 8};
        job.mode = TheftMode(mode);
        job.picture = wheel();
        job.isLive = true;
        thread.submit(job);
        ready.acquire();
        const auto frames = thread.newest();
        QVERIFY(frames && !frames->flaw && frames->from && frames->to);
        QCOMPARE(frames->from->revision, std::uint64_t(7));
        QCOMPARE(frames->to->revision, std::uint64_t(8));
        const std::uint32_t middle = frames->from->pixels[40 * 80 + 33];
        QVERIFY(middle != frames->from->pixels[0]); // the square, not the background
        QCOMPARE(frames->from->pixels.size(), std::size_t(6400));
        QVERIFY(std::ranges::all_of(frames->to->pixels, [](auto pixel) { return pixel >> 24 == 255; }));
    }

    // While only F moves, the picture of G is the one there is; with another camera it is another.
    void theFrameOfTheOtherStays() {
        std::binary_semaphore ready(0);
        document::TheftThread thread(2, [&] { ready.release(); });
        start(TheftFamily::Square);
        const attractor::Camera camera{{.5, .5}, 60, 80, 80, attractor::YAxis::Up};
        document::TheftJob job;
        job.from = {m_document.sharedFractal(), camera, 1};
        job.to = {m_partner->document().sharedFractal(), camera, 1};
        job.picture = wheel();
        job.isLive = true;
        const auto drawn = [&] {
            thread.submit(job);
            for (;;) { // a finer one of the job before may come first
                ready.acquire();
                const auto frames = thread.newest();
                if (frames->from && frames->from->revision == job.from.revision) return frames;
            }
        };
        const auto first = drawn();
        document::Fractal moved = m_document.fractal();
        document::plane(moved)->system.maps[0].map.translation.x() += 0.01;
        job.from = {std::make_shared<const Fractal>(moved), camera, 2};
        const auto second = drawn();
        QVERIFY(second->from != first->from);
        QVERIFY(second->to == first->to || second->to->samples > first->to->samples);
        job.from.revision = 3;
        job.to.camera.pixelsPerUnit = 40;
        QVERIFY(drawn()->to->pixels != first->to->pixels);
    }

    // Over F, as opaque as asked: at 1, the square of G hides that of F.
    void theOtherIsLaidOver() {
        start(TheftFamily::Square);
        std::binary_semaphore ready(0);
        document::TheftThread thread(2, [&] { ready.release(); });
        const attractor::Camera camera{{.5, .5}, 60, 80, 80, attractor::YAxis::Up};
        document::TheftJob job;
        job.from = {m_document.sharedFractal(), camera, 0};
        job.to = {m_partner->document().sharedFractal(), camera, 1};
        job.mode = TheftMode::TransformPicture;
        job.picture = wheel();
        job.isLive = true;
        const auto drawn = [&](double overlay) {
            job.overlay = overlay;
            ++job.from.revision;
            thread.submit(job);
            for (;;) { // a finer one of the job before may come first
                ready.acquire();
                const auto frames = thread.newest();
                if (frames->from && frames->from->revision == job.from.revision) return frames;
            }
        };
        const auto without = drawn(0), half = drawn(.5), whole = drawn(1);
        const auto share = [](const auto& frame, const auto& expected) { // of the pixels inside the squares
            int equal = 0;
            for (std::size_t k = 0; k < 40 * 40; ++k) {
                const std::size_t at = (20 + k / 40) * 80 + 20 + k % 40;
                bool isEqual = true;
                for (const int shift : {0, 8, 16})
                    isEqual =
                        isEqual && std::abs(int(frame->pixels[at] >> shift & 255) - expected(at, shift)) < 24;
                equal += isEqual ? 1 : 0;
            }
            return equal / 1600.0;
        };
        const auto channel = [](const auto& frame, std::size_t at, int shift) {
            return int(frame->pixels[at] >> shift & 255);
        };
        const auto ofG = [&](std::size_t at, int shift) { return channel(whole->to, at, shift); };
        const auto ofBoth = [&](std::size_t at, int shift) {
            return (channel(without->from, at, shift) + channel(whole->to, at, shift)) / 2;
        };
        QVERIFY(share(without->from, ofG) < .8);
        QVERIFY(share(whole->from, ofG) > .95);
        QVERIFY(share(half->from, ofBoth) > .9);
        QCOMPARE(whole->from->pixels[0], without->from->pixels[0]); // where G is not
    }

    void theGridGoesThroughTheTransformation() {
        start(TheftFamily::Square);
        const auto outcome = document::coupled(m_document.fractal(), m_partner->document().fractal(), {});
        attractor::DeferredTheft there(1);
        const auto laid =
            document::laid(*outcome.entries, wheel(), TheftMode::TransformPicture, std::nullopt, there, {});
        QVERIFY(laid);
        const auto corner = laid->toPicture(ifs::Vector<2>(0, 1)); // of the box of G: the unit square
        QVERIFY(corner.norm() < 1e-6);
        QVERIFY((laid->toPicture(ifs::Vector<2>(1, 0)) - ifs::Vector<2>(64, 64)).norm() < 1e-6);
    }

    void refusesOtherNumbers() {
        std::binary_semaphore ready(0);
        document::TheftThread thread(1, [&] { ready.release(); });
        start(TheftFamily::Square);
        document::TheftJob job;
        const attractor::Camera camera{{.5, .5}, 60, 80, 80, attractor::YAxis::Up};
        job.from = {m_document.sharedFractal(), camera, 1};
        job.to = {std::make_shared<const Fractal>(document::sierpinskiTriangle()), camera, 1};
        job.picture = wheel();
        thread.submit(job);
        ready.acquire();
        const auto frames = thread.newest();
        QVERIFY(frames->flaw && !frames->from && !frames->to);
        QCOMPARE(frames->flaw->flaw, document::CouplingFlaw::Counts);
        QCOMPARE(frames->flaw->fromCount, std::size_t(4));
        QCOMPARE(frames->flaw->toCount, std::size_t(3));
    }
};

BARYCAGE_TEST(PartnerDocumentTest, QCoreApplication);
#include "partner_document_test.moc"
