// SPDX-License-Identifier: MIT
#include "panels/maps/symmetry_row.h"

#include "document/edits/maps/symmetry_edits.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include <memory>

using namespace maps_support;
using document::Document;
using view::SymmetryRow;
using enum ifs::SymmetryGroup;

// Real keys and clicks.
class SymmetryRowTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<Document> m_document;
    std::unique_ptr<SymmetryRow> m_row;

    const ifs::Symmetry<2>& symmetry() const { return systemOf(*m_document).symmetry; }
    int steps() const { return m_document->undoStack()->count(); }

    // With the keyboard: the letter of the entry, then Enter.
    void choose(const QString& text) {
        QComboBox* groups = m_row->groups();
        groups->setFocus();
        const int wanted = groups->findText(text);
        QVERIFY2(wanted >= 0, qPrintable(text));
        while (groups->currentIndex() < wanted)
            QTest::keyClick(groups, Qt::Key_Down);
        while (groups->currentIndex() > wanted)
            QTest::keyClick(groups, Qt::Key_Up);
    }
    void type(view::NumberField* field, const QString& text) {
        QTest::mouseClick(field, Qt::LeftButton);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }

private slots:
    void init() {
        m_document = std::make_unique<Document>();
        m_document->edit(QStringLiteral("maple"), maple());
        m_row = std::make_unique<SymmetryRow>(m_document.get());
        m_row->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_row.get()));
    }
    void cleanup() {
        m_row.reset();
        m_document.reset();
    }

    void choosingAGroupIsOneStep() {
        QVERIFY(!m_row->order()->isVisible());
        QVERIFY(!m_row->expandButton()->isVisible());
        const int before = steps();
        choose(QStringLiteral("Mirror"));
        QCOMPARE(steps(), before + 1);
        QCOMPARE(int(symmetry().group), int(Mirror));
        choose(QStringLiteral("Rotation"));
        QCOMPARE(int(symmetry().group), int(Rotation));
        QCOMPARE(symmetry().order, 6);
        QVERIFY(m_row->order()->isVisible());
        QVERIFY(!m_row->angle()->isVisible());
        m_document->undoStack()->undo();
        QCOMPARE(int(symmetry().group), int(Mirror));
        QCOMPARE(m_row->groups()->currentText(), QStringLiteral("Mirror"));
        m_document->undoStack()->undo();
        QCOMPARE(m_row->groups()->currentText(), QStringLiteral("None"));
        QVERIFY(!document::isSymmetric(m_document->fractal()));
    }

    void theAngleIsInDegrees() {
        choose(QStringLiteral("Mirror"));
        for (const char* typed : {"45", "45°", "pi/4", "atan(1)", "90°/2"}) {
            view::NumberField* angle = m_row->angle();
            angle->setFocus();
            angle->selectAll();
            for (const QChar c : QString::fromUtf8(typed))
                QTest::sendKeyEvent(QTest::Click, angle, Qt::Key_unknown, QString(c), Qt::NoModifier);
            QTest::keyClick(angle, Qt::Key_Return);
            QCOMPARE(symmetry().angle, 45.0);
            QCOMPARE(angle->text(), QStringLiteral("45"));
            type(angle, QStringLiteral("10"));
            QCOMPARE(symmetry().angle, 10.0);
        }
    }

    void theOrderIsTyped() {
        choose(QStringLiteral("Dihedral"));
        const int before = steps();
        m_row->order()->selectAll();
        QTest::keyClicks(m_row->order(), QStringLiteral("24"));
        QTest::keyClick(m_row->order(), Qt::Key_Return);
        QCOMPARE(symmetry().order, 24);
        QCOMPARE(steps(), before + 1);
        QTest::keyClick(m_row->order(), Qt::Key_Down);
        QCOMPARE(symmetry().order, 23);
    }

    // As the nudges of a handle: within a second, they are one step.
    void turnsOfTheWheelAreOneStep() {
        choose(QStringLiteral("Rotation"));
        const int before = steps();
        QSpinBox* order = m_row->order();
        order->setFocus();
        QVERIFY(order->hasFocus());
        const QPointF at = order->rect().center();
        for (int i = 0; i < 3; ++i) {
            QWheelEvent event(at, order->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(order, &event);
        }
        QCOMPARE(symmetry().order, 9);
        QCOMPARE(steps(), before + 1);
        m_document->undoStack()->undo();
        QCOMPARE(symmetry().order, 6);
    }

    void centreAndAngleAreTyped() {
        choose(QStringLiteral("Dihedral"));
        const int before = steps();
        type(m_row->centre(0), QStringLiteral("0.25"));
        type(m_row->centre(1), QStringLiteral("-1"));
        type(m_row->angle(), QStringLiteral("30"));
        QCOMPARE(symmetry().centre, ifs::Vector<2>(0.25, -1));
        QCOMPARE(symmetry().angle, 30.0);
        QCOMPARE(steps(), before + 3);
        QVERIFY(!m_row->centre(2)->isVisible());
        choose(QStringLiteral("Rotation")); // where an angle means nothing
        QCOMPARE(symmetry().angle, 0.0);
        QCOMPARE(symmetry().centre, ifs::Vector<2>(0.25, -1));
    }

    void expandListsTheMaps() {
        choose(QStringLiteral("Rotation"));
        const document::Fractal symmetric = m_document->fractal();
        const int before = steps();
        QTest::mouseClick(m_row->expandButton(), Qt::LeftButton);
        QCOMPARE(systemOf(*m_document).maps.size(), 24);
        QVERIFY(m_document->fractal() == document::expanded(symmetric));
        QCOMPARE(steps(), before + 1);
        QVERIFY(!m_row->expandButton()->isVisible());
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == symmetric);
    }

    void polyhedraAreInSpace() {
        QCOMPARE(m_row->groups()->count(), 4);
        m_document->edit(QStringLiteral("space"), fernInSpace());
        QCOMPARE(m_row->groups()->count(), 7);
        choose(QStringLiteral("Icosahedral"));
        QCOMPARE(int(solidOf(*m_document).symmetry.group), int(Icosahedral));
        QVERIFY(m_row->centre(2)->isVisible());
        type(m_row->centre(2), QStringLiteral("2"));
        QCOMPARE(solidOf(*m_document).symmetry.centre, ifs::Vector<3>(0, 0, 2));
        QTest::mouseClick(m_row->expandButton(), Qt::LeftButton);
        QCOMPARE(solidOf(*m_document).maps.size(), 240);
    }

    void tooManyMapsAreRefused() {
        document::System3 system;
        for (std::size_t i = 0; i <= ifs::maxSymmetricMaps / 60; ++i)
            system.maps.push_back(
                {.id = ifs::MapId{std::uint32_t(i + 1)}, .map = canonical::fern3()[0], .weight = 1.0});
        document::Fractal crowd = fernInSpace();
        document::space(crowd)->system = system;
        m_document->edit(QStringLiteral("crowd"), crowd);
        const QSignalSpy said(m_row.get(), &SymmetryRow::message);
        choose(QStringLiteral("Octahedral"));
        QVERIFY(document::isSymmetric(m_document->fractal()));
        QTest::keyClick(m_row->groups(), Qt::Key_Down);
        QCOMPARE(said.size(), 1);
        QVERIFY(said[0][0].toString().contains(QStringLiteral("100000")));
        QCOMPARE(int(solidOf(*m_document).symmetry.group), int(Octahedral));
        QCOMPARE(m_row->groups()->currentText(), QStringLiteral("Octahedral"));
    }
};

BARYCAGE_TEST(SymmetryRowTest, QApplication);
#include "symmetry_row_test.moc"
