// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "dialogs/go_to_dialog.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "panels/collection/collection_window.h"
#include "panels/timeline/stretch_dialog.h"
#include "support/commands.h"
#include "support/named_test.h"

#include <QAction>
#include <QClipboard>
#include <QLineEdit>
#include <QMimeData>
#include <QSpinBox>
#include <QTest>

#include <cmath>

// Commands as their users give them, from the menu or by their keys, and what they do to the window.
class MenuCommandsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void cornersStayInView_data();
    void cornersStayInView();
    void goToLooksThere();
    void stretchedKeysSpread();
    void theCollectionOpensByItsKeys();
    void theCanvasIsCopiedByItsKeys();

private:
    document::Document& document() const { return m_window->document(); }
    view::CanvasView& canvas() const { return *m_window->findChild<view::CanvasView*>(); }
    void trigger(const char* id) const { support::command(*m_window, id)->trigger(); }
    bool areCornersSeen() const {
        const QRectF whole = canvas().viewport()->rect();
        for (const ifs::Vector<2>& corner : document::effectiveCage(document().fractal()).current)
            if (!whole.contains(view::pixelOf(canvas().camera(), corner))) return false;
        return true;
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers) const {
        canvas().setFocus();
        QTest::keyClick(m_window.get(), key, modifiers);
    }
};

void MenuCommandsTest::cornersStayInView_data() {
    QTest::addColumn<QByteArray>("command");
    for (const char* id : {"reset", "fit-simplex", "make-regular", "bake"})
        QTest::newRow(id) << QByteArray(id);
}

// The view shows a small cage beside its place of rest.
void MenuCommandsTest::cornersStayInView() {
    QFETCH(const QByteArray, command);
    ifs::ControlCage<2> cage = document::effectiveCage(document().fractal());
    for (ifs::Vector<2>& corner : cage.current)
        corner = 0.1 * corner + ifs::Vector<2>(3, 3);
    cage.current.front() += ifs::Vector<2>(-0.05, 0.02); // not regular
    document().edit(QStringLiteral("Move"),
                    document::withCageMoved(document().fractal(), cage, document::CageMode::Place));
    canvas().fit();
    QTRY_VERIFY(areCornersSeen());
    const auto before = document().fractal();
    trigger(command.constData());
    QTRY_VERIFY(!(document().fractal() == before));
    QTRY_VERIFY(areCornersSeen());
    document().undoStack()->undo();
    QTRY_VERIFY(areCornersSeen());
    document().undoStack()->setClean();
}

void MenuCommandsTest::goToLooksThere() {
    trigger("go-to");
    auto* dialog = m_window->findChild<view::GoToDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    const auto fields = dialog->findChildren<QLineEdit*>();
    fields[0]->setText(QStringLiteral("0.25"));
    fields[1]->setText(QStringLiteral("1/2"));
    fields[2]->setText(QStringLiteral("0.01"));
    dialog->accept();
    QTRY_COMPARE(canvas().camera().centre, ifs::Vector<2>(0.25, 0.5));
    const double height = canvas().camera().height / canvas().camera().pixelsPerUnit;
    QVERIFY2(std::abs(height - 0.01) < 1e-9, qPrintable(QString::number(height)));
}

void MenuCommandsTest::stretchedKeysSpread() {
    const ifs::MapId map = document::system2(document().fractal())->maps[1].id;
    document::Fractal keyed = document().entryFractal();
    for (const int frame : {0, 24})
        keyed = document::withKey(keyed, {document::Track::Kind::Map, {map}}, frame, std::nullopt);
    document().editEntry(QStringLiteral("Keys"), keyed);
    const int length = document::animationFacts(document().entryFractal())->length;
    trigger("stretch-keys");
    auto* dialog = m_window->findChild<view::StretchDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    const auto boxes = dialog->findChildren<QSpinBox*>();
    boxes[0]->setValue(0);
    boxes[1]->setValue(24);
    boxes[2]->setValue(36);
    QCOMPARE(dialog->stretch(), (document::Stretch{0, 24, 36}));
    dialog->accept();
    QTRY_VERIFY(!(document().entryFractal() == keyed));
    QCOMPARE(document::keyFramesOfMaps(document().entryFractal()), (std::set<int>{0, 36}));
    QCOMPARE(document::animationFacts(document().entryFractal())->length, length + 12);
    document().undoStack()->setClean();
}

void MenuCommandsTest::theCollectionOpensByItsKeys() {
    press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    auto* collection = m_window->findChild<view::CollectionWindow*>();
    QVERIFY(collection && collection->isVisible());
    QTest::keyClick(collection, Qt::Key_Escape);
    QTRY_VERIFY(!collection->isVisible());
}

void MenuCommandsTest::theCanvasIsCopiedByItsKeys() {
    QGuiApplication::clipboard()->clear();
    press(Qt::Key_C, Qt::ControlModifier);
    QTRY_VERIFY(QGuiApplication::clipboard()->mimeData()->hasImage());
}

BARYCAGE_TEST(MenuCommandsTest, QApplication);
#include "menu_commands_test.moc"
