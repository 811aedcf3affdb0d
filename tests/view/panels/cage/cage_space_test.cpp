// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "ifs/extent/extent.h"
#include "panels/cage/cage_panel.h"
#include "panels/cage/cage_texts.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_text.h"

#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>

#include <memory>

using namespace maps_support;
using view::CagePanel;
using view::NumberField;

// The Cage panel with a system in space.
class CageSpaceTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(withTetrahedron(fernInSpace())));
        m_panel = std::make_unique<CagePanel>(m_document.get());
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup() { m_panel.reset(); } // before its document

    void aTypedVertexMovesTheSolid() {
        QVERIFY(m_panel->isEnabled());
        QCOMPARE(m_panel->status(), QStringLiteral("At rest: the picture shows the code."));
        for (std::size_t vertex = 0; vertex < 4; ++vertex)
            for (int axis = 0; axis < 3; ++axis) {
                const NumberField* field = m_panel->field(CagePanel::Vertices::Current, vertex, axis);
                QVERIFY(field->isVisible());
                QCOMPARE(field->value(), cage().current[vertex][axis]);
                QVERIFY(!m_panel->field(CagePanel::Vertices::Rest, vertex, axis)->isVisible());
            }
        NumberField* z = m_panel->field(CagePanel::Vertices::Current, 3, 2);
        type(z, QStringLiteral("12"));
        QCOMPARE(cage().current[3].z(), 12.0); // live
        QCOMPARE(cage().rest[3].z(), 8.0);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTest::keyClick(z, Qt::Key_Return);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(m_panel->status(), QStringLiteral("Placed: volumes change by the factor 1.5."));
        m_document->undoStack()->undo();
        QCOMPARE(cage().current[3].z(), 8.0);
        QCOMPARE(z->value(), 8.0);
    }

    void escapeCancels() {
        const document::Fractal before = m_document->fractal();
        NumberField* y = m_panel->field(CagePanel::Vertices::Current, 2, 1);
        type(y, QStringLiteral("-3"));
        QCOMPARE(cage().current[2].y(), -3.0);
        QVERIFY(m_panel->status().startsWith(QStringLiteral("Placed and mirrored: volumes")));
        QTest::keyClick(y, Qt::Key_Escape);
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    // Whatever the panel has to say of the cage meanwhile.
    void theFieldsStayWhereTheyAre() {
        m_panel->resize(m_panel->minimumSizeHint().width(), 900);
        NumberField* y = m_panel->field(CagePanel::Vertices::Current, 2, 1);
        const QLabel* status = nullptr;
        for (const auto* label : m_panel->findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("State of the cage")) status = label;
        QVERIFY(status);
        QTRY_COMPARE(m_panel->width(), m_panel->minimumSizeHint().width());
        const QPoint place = y->mapTo(m_panel.get(), QPoint());
        const int height = status->height();
        type(y, QStringLiteral("-3"));
        QTRY_VERIFY(status->height() > height); // it has more lines
        QCOMPARE(y->mapTo(m_panel.get(), QPoint()), place);
        QTest::keyClick(y, Qt::Key_Escape);
        QTRY_COMPARE(status->height(), height);
        QCOMPARE(y->mapTo(m_panel.get(), QPoint()), place);
    }

    // Without a cage of its own, an entry is held by its minimal canonical simplex.
    void theCanonicalTetrahedronIsShownAndStoredWhenItMoves() {
        m_document->setFile(document::fileOf(fernInSpace()));
        const auto shown = *document::spaceCage(m_document->fractal());
        for (std::size_t vertex = 0; vertex < 4; ++vertex)
            for (int axis = 0; axis < 3; ++axis)
                QCOMPARE(m_panel->field(CagePanel::Vertices::Current, vertex, axis)->value(),
                         shown.current[vertex][axis]);
        QVERIFY(!document::space(m_document->fractal())->cage);
        NumberField* x = m_panel->field(CagePanel::Vertices::Current, 1, 0);
        type(x, QStringLiteral("3.5"));
        QTest::keyClick(x, Qt::Key_Return);
        QCOMPARE(cage().current[1].x(), 3.5);
        QVERIFY(cage().rest == shown.rest);
    }

    void aTypedRestVertexKeepsTheSolid() {
        document::Fractal fractal = m_document->fractal();
        document::space(fractal)->cage->current = {{1, 0, 0}, {9, 0, 1}, {0, 7, 0}, {2, 0, 8}};
        m_document->edit(QStringLiteral("place"), fractal);
        const auto before = ifs::displayMap(cage());
        NumberField* z = m_panel->field(CagePanel::Vertices::Rest, 2, 2);
        showRest();
        QVERIFY(z->isVisible());
        type(z, QStringLiteral("-5"));
        QTest::keyClick(z, Qt::Key_Return);
        QCOMPARE(cage().rest[2].z(), -5.0);
        const auto now = ifs::displayMap(cage());
        QVERIFY((now.linear - before.linear).norm() < 1e-12);
        QVERIFY((now.translation - before.translation).norm() < 1e-12);
    }

    void aCageOfMoreCornersBendsOrFits() {
        m_panel->fitPolyhedron(document::SpacePolyhedron::Octahedron, 6);
        QCOMPARE(cage().rest.size(), std::size_t(6));
        NumberField* z = m_panel->field(CagePanel::Vertices::Current, 5, 2);
        QVERIFY(z->isVisible());
        type(z, QString::number(z->value() + 3));
        QTest::keyClick(z, Qt::Key_Return);
        QVERIFY(ifs::bends(cage()));
        QVERIFY(m_panel->status().contains(QStringLiteral("bent")));
        m_panel->deformationButton(ifs::Deformation::AffineFit)->click();
        QVERIFY(!ifs::bends(cage()));
        QVERIFY(!m_panel->status().contains(QStringLiteral("bent")));
        support::action(*m_panel, "reset")->trigger();
        m_panel->fitTetrahedron();
        QCOMPARE(document::spaceCage(m_document->fractal())->rest.size(), std::size_t(4));
    }

    // Coordinates of a box are certain to some digits only; what these leave of a 0 is not shown.
    void theCornersOfABoxCanBeRead() {
        document::Fractal cube = fernInSpace();
        document::Shape<3> eight;
        for (int corner = 0; corner < 8; ++corner)
            ifs::append<3>(eight.system, {0.5 * ifs::Matrix<3>::Identity(),
                                          ifs::Vector<3>((corner & 1) / 2.0, (corner >> 1 & 1) / 2.0,
                                                         (corner >> 2) / 2.0)});
        cube.shape = eight;
        m_document->setFile(document::fileOf(cube));
        m_panel->fitPolyhedron(document::SpacePolyhedron::Box, 8);
        QCOMPARE(cage().rest.size(), std::size_t(8));
        m_panel->resize(320, 700);
        for (std::size_t vertex = 0; vertex < 8; ++vertex)
            for (int axis = 0; axis < 3; ++axis) {
                const NumberField* field = m_panel->field(CagePanel::Vertices::Current, vertex, axis);
                QCOMPARE(field->text(), QString::number(vertex >> axis & 1));
                QTRY_VERIFY2(field->width() >= 320 / 4, qPrintable(QString::number(field->width())));
            }
    }

    void aFlatRestTetrahedronIsRefused() {
        QSignalSpy messages(m_panel.get(), &CagePanel::message);
        const document::Fractal before = m_document->fractal();
        showRest();
        NumberField* z = m_panel->field(CagePanel::Vertices::Rest, 3, 2);
        type(z, QStringLiteral("0")); // (0, 0, 0) again
        QTest::keyClick(z, Qt::Key_Return);
        QVERIFY(!messages.isEmpty());
        QVERIFY(messages.front().front().toString().contains(QStringLiteral("volume")));
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(z->value(), 8.0);
    }

    void aPanelThatIsClosedWhileTypingEndsTheEdit() {
        const document::Fractal before = m_document->fractal();
        type(m_panel->field(CagePanel::Vertices::Current, 3, 2), QStringLiteral("12"));
        QVERIFY(!(m_document->fractal() == before));
        m_panel.reset();
        QVERIFY(m_document->fractal() == before);
    }

    void resetReturnsToRest() {
        QVERIFY(!support::action(*m_panel, "reset")->isEnabled());
        QCOMPARE(support::action(*m_panel, "reset")->toolTip(), QStringLiteral("The cage is at rest."));
        document::Fractal fractal = m_document->fractal();
        document::space(fractal)->cage->current[1] = {0, 0, 3}; // flat
        m_document->edit(QStringLiteral("flat"), fractal);
        QVERIFY(m_panel->status().startsWith(QStringLiteral("Flat: the solid")));
        QVERIFY(support::action(*m_panel, "reset")->isEnabled());
        m_panel->reset();
        QVERIFY(cage().current == cage().rest);
        QCOMPARE(m_document->undoStack()->count(), 2);
        QVERIFY(document::resetCage(*m_document).has_value()); // nothing left to reset
        m_document->undoStack()->undo();
        QCOMPARE(document::resetCage(*m_document), std::nullopt); // as from the menu
        QVERIFY(cage().current == cage().rest);
    }

    void whatIsForThePlaneSaysSo() {
        QVERIFY(!m_panel->deformationButton(ifs::Deformation::Bend)->isVisible());
        QVERIFY(support::action(*m_panel, "define")->isEnabled());
        QVERIFY(support::action(*m_panel, "define")->toolTip().contains(QStringLiteral("four clicks")));
    }

    void cagesOfSpaceAreFittedAndBaked() {
        const QToolButton* fit = nullptr;
        for (const auto* button : m_panel->findChildren<QToolButton*>())
            if (button->accessibleName() == QStringLiteral("Fit the cage")) fit = button;
        QVERIFY(fit && fit->isEnabled());
        QStringList choices;
        for (const QAction* choice : fit->menu()->actions())
            choices << choice->text();
        QCOMPARE(choices.filter(QStringLiteral("Canonical Simplex (")).size(), 8);
        for (QAction* choice : fit->menu()->actions())
            if (choice->text().contains(QStringLiteral("(−, +, −)"))) choice->trigger();
        QTRY_COMPARE(m_document->undoStack()->count(), 1); // found in the background
        QVERIFY(cage().current[1].x() < cage().current[0].x() &&
                cage().current[2].y() > cage().current[0].y());
        QVERIFY(!m_panel->bakeAction()->isEnabled());
        NumberField* z = m_panel->field(CagePanel::Vertices::Current, 3, 2);
        type(z, QStringLiteral("12"));
        QTest::keyClick(z, Qt::Key_Return);
        QVERIFY(m_panel->bakeAction()->isEnabled());
        const document::System3 before = solidOf(*m_document);
        m_panel->bakeAction()->trigger();
        QCOMPARE(m_document->undoStack()->count(), 3);
        QVERIFY(cage().current == cage().rest);
        QVERIFY(!(solidOf(*m_document) == before));
        m_panel->fitBox();
        QCOMPARE(m_document->undoStack()->count(), 4);
    }

    void rewritingIsOneStepOfTyping() {
        QVERIFY(m_panel->modeButton(document::CageMode::Rewrite)->isVisible());
        m_panel->modeButton(document::CageMode::Rewrite)->click();
        const document::System3 before = solidOf(*m_document);
        NumberField* z = m_panel->field(CagePanel::Vertices::Current, 3, 2);
        type(z, QStringLiteral("12"));
        QTest::keyClick(z, Qt::Key_Return);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QVERIFY(!(solidOf(*m_document) == before));
        QVERIFY(cage().current == cage().rest && cage().rest[3].z() == 12);
        m_document->undoStack()->undo();
        QVERIFY(solidOf(*m_document) == before);
    }

    void theSimplexAndThePointAreThoseOfSpace() {
        document::Fractal fractal = m_document->fractal();
        document::space(fractal)->cage->current = {{1, 0, 0}, {9, 0, 1}, {0, 7, 0}, {2, 0, 8}};
        m_document->edit(QStringLiteral("place"), fractal);
        const auto maps = ifs::mapsOf(*ifs::conjugate(ifs::displayMap(cage()), solidOf(*m_document)));
        const auto simplex = ifs::minimalCanonicalSimplex(*ifs::SupportFunction<3>::of(maps), 1e-7);
        const QString leg = QStringLiteral("leg ") + view::shortNumber(simplex.leg);
        QTRY_VERIFY2_WITH_TIMEOUT(shownText().contains(leg), qPrintable(leg + u' ' + shownText()), 60'000);

        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(m_panel->pointField(axis)->isVisible());
            type(m_panel->pointField(axis), axis == 0 ? QStringLiteral("9") : QString::number(axis - 1));
        }
        QCOMPARE(m_panel->barycentric(), QStringLiteral("(0, 1, 0, 0)")); // (9, 0, 1)
    }

    // What rounding or a stated error has left of 0 reads 0; the coordinate keeps its bits.
    void noiseReadsZero() {
        document::Fractal fractal = m_document->fractal();
        document::space(fractal)->cage->current = {
            {-4.4e-16, 0, 1.7e-21}, {9, 0, 1}, {1e-9, 7, 0}, {2.0 / 3, 0, 8}};
        m_document->edit(QStringLiteral("place"), fractal);
        if (QWidget* focused = m_panel->focusWidget()) focused->clearFocus(); // there all digits are seen
        const auto text = [&](std::size_t vertex, int axis) {
            return m_panel->field(CagePanel::Vertices::Current, vertex, axis)->text();
        };
        QCOMPARE(text(0, 0), QStringLiteral("0"));
        QCOMPARE(text(0, 2), QStringLiteral("0"));
        QCOMPARE(text(2, 0), QStringLiteral("1e-09")); // that is not rounding
        QCOMPARE(m_panel->field(CagePanel::Vertices::Current, 0, 0)->value(), -4.4e-16);
        const ifs::ControlCage<3> cage = document::space(fractal)->cage.value();
        const ifs::Vector<3> onFace = 0.1 * cage.current[1] + 0.2 * cage.current[2] + 0.7 * cage.current[3];
        QVERIFY(view::barycentricText<3>(cage, onFace).startsWith(QStringLiteral("(0, ")));
        QVERIFY(!view::enclosingSimplexText(m_document->fractal()).contains(QStringLiteral("e-")));
    }

    void thePlaneIsAsItWasAfterwards() {
        m_document->setFile(document::fileOf(withTriangle(maple())));
        QVERIFY(!m_panel->field(CagePanel::Vertices::Current, 0, 2)->isVisible());
        QVERIFY(!m_panel->field(CagePanel::Vertices::Current, 3, 0)->isVisible());
        QVERIFY(!m_panel->pointField(2)->isVisible());
        QVERIFY(m_panel->modeButton(document::CageMode::Place)->isVisible());
        QVERIFY(support::action(*m_panel, "define")->isEnabled());
        QVERIFY(!shownText().contains(QStringLiteral("z at rest")));
        NumberField* x = m_panel->field(CagePanel::Vertices::Current, 1, 0);
        type(x, QStringLiteral("6.5"));
        QCOMPARE(document::cage2(m_document->fractal())->current[1].x(), 6.5);
    }

private:
    const ifs::ControlCage<3>& cage() const { return *document::space(m_document->fractal())->cage; }
    void showRest() {
        for (auto* button : m_panel->findChildren<QToolButton*>())
            if (button->accessibleName() == QStringLiteral("Show the rest cage")) button->setChecked(true);
    }
    QString shownText() const {
        QString text;
        for (const auto* label : m_panel->findChildren<QLabel*>())
            if (label->isVisible()) text += label->text() + u'\n';
        return text;
    }
    static void type(NumberField* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<CagePanel> m_panel;
};

BARYCAGE_TEST(CageSpaceTest, QApplication);
#include "cage_space_test.moc"
