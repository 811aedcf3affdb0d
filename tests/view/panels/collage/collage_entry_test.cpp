// SPDX-License-Identifier: MIT
#include "animation/motions/motion_presets.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "panels/collage/suggestion_list.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "view/panels/collage_panel_fixture.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QToolButton>

#include <cmath>

// What becomes of the entry whose target suggestions are for.
class CollageEntryTest : public CollagePanelFixture {
    Q_OBJECT

private slots:
    void init() { openPanel(); }
    void cleanup() {
        m_panel.reset();
        close();
    }

    void theTargetLiesOnTheFractal() {
        document::Fractal far = m_document->fractal();
        const ifs::AffineMap<2> away{11 * ifs::Matrix<2>::Identity(), {40, -7}};
        for (auto& map : document::system2(far)->maps)
            map.map = *ifs::conjugate<2>(away, map.map);
        document::plane(far)->cage.reset();
        m_document->edit(QStringLiteral("Move"), far);
        traceLeaf();
        verifyOnBox();
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Crop to Shape")), Qt::LeftButton);
        settle();
        verifyOnBox();
    }

    void aSuggestionIsAnEntryOfItsOwn() {
        const document::Fractal moving =
            *document::withWind(m_document->entryFractal(), animation::swayPresets()[0]);
        m_document->editEntry(QStringLiteral("Wind"), moving);
        m_document->undoStack()->clear();
        const document::EntryId first = m_document->currentId();
        m_document->setMoment(animation::moment(7));
        traceLeaf();
        const auto traced = m_panel->target()->traced();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.5);
        support::choose(named<QComboBox>(QStringLiteral("Number of maps")), 4);
        push("Suggest");
        settle();
        m_canvas->navigation().zoomBy(3);
        QVERIFY(!m_canvas->navigation().isFitted());
        use(0);
        QCOMPARE(m_document->file().entries.size(), 2);
        QVERIFY(*m_document->file().entries[0].fractal == moving); // not overwritten
        const document::EntryId made = m_document->currentId();
        QVERIFY(made != first);
        QCOMPARE(m_document->fractal().name, QStringLiteral("leaf"));
        QVERIFY(!document::animationFacts(m_document->entryFractal())); // still
        QVERIFY(m_canvas->navigation().isFitted());
        // In the place of the target, which is that of the fractal before.
        QVERIFY(m_panel->target()->traced() == traced);
        const auto box = document::displayedBox(m_document->fractal());
        const double height = traced->place.height;
        QVERIFY(box && std::abs((box->max - box->min).y() / height - 0.9) < 0.2);
        QVERIFY(meanDistance() < 8);
        const document::Fractal chosen = m_document->fractal();
        auto* list = m_panel->findChild<view::SuggestionList*>();
        if (list->count() > 1) { // another one instead, in the same entry
            m_canvas->navigation().zoomBy(3);
            use(1);
            QVERIFY(m_canvas->navigation().isFitted());
            QCOMPARE(m_document->currentId(), made);
            QCOMPARE(m_document->file().entries.size(), 2);
            QVERIFY(!(m_document->fractal() == chosen));
            m_document->undoStack()->undo();
            QVERIFY(m_document->fractal() == chosen);
        }
        m_document->undoStack()->undo();
        settle();
        QCOMPARE(m_document->file().entries.size(), 1);
        QVERIFY(m_document->entryFractal() == moving);
        QVERIFY(list->count() > 0); // they can still be used
        use(0);
        QCOMPARE(m_document->file().entries.size(), 2);
    }

private:
    void use(int row) {
        auto* list = m_panel->findChild<view::SuggestionList*>();
        QVERIFY(list->count() > row);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->item(row)).center());
        settle();
    }

    // The shape in the middle of the box around the fractal, and as large as fits in.
    void verifyOnBox() {
        const auto box = document::displayedBox(m_document->fractal());
        ifs::Vector<2> low(1e9, 1e9), high(-1e9, -1e9);
        for (const auto& corner : m_panel->target()->traced()->outlines.front()) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        const double pixel =
            m_panel->target()->traced()->place.height / m_panel->target()->traced()->mask.height;
        const ifs::Vector<2> size = box->max - box->min, shape = high - low;
        QVERIFY(((low + high - box->min - box->max) / 2).norm() < pixel);
        QVERIFY(std::abs(std::max(shape.x() / size.x(), shape.y() / size.y()) - 1) < 0.02);
    }
};

BARYCAGE_TEST(CollageEntryTest, QApplication);
#include "collage_entry_test.moc"
