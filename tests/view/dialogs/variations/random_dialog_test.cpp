// SPDX-License-Identifier: MIT
#include "dialogs/variations/random_dialog.h"

#include "dialogs/variations/picture_tiles.h"
#include "support/choose.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "widgets/symmetry_groups.h"

#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QSet>
#include <QSpinBox>

#include <algorithm>

using enum ifs::SymmetryGroup;
using view::RandomDialog;

class RandomDialogTest : public QObject {
    Q_OBJECT

private slots:
    void itStartsWithAnotherSheetEachTime();
    void theChosenOneIsSeen();
    void theTilesFillTheGrid();
    void theChosenOneIsAdded();
    void systemsAreAsAskedFor();
    void symmetriesFollowTheDimension();
    void beginsInTheDimensionOfTheEntry();
};

namespace {

QListWidget* gridOf(const RandomDialog& dialog) {
    return dialog.findChild<QListWidget*>();
}

bool isFull(const RandomDialog& dialog) {
    for (int i = 0; i < RandomDialog::count; ++i)
        if (view::PictureTiles::shown(gridOf(dialog)->model()->index(i, 0)).pixmap.isNull()) return false;
    return true;
}

QAbstractButton* add(const RandomDialog& dialog) {
    return support::button(dialog, "add");
}

struct Boxes {
    QComboBox *dimension, *maps, *groups;
};

Boxes boxesOf(const RandomDialog& dialog) {
    const auto boxes = dialog.findChildren<QComboBox*>();
    return {boxes[0], boxes[1], boxes[2]};
}

} // namespace

void RandomDialogTest::itStartsWithAnotherSheetEachTime() {
    document::Document document;
    QSet<int> seeds;
    for (int time = 0; time < 3; ++time) {
        const RandomDialog dialog(&document);
        for (const auto* box : dialog.findChildren<QSpinBox*>())
            if (box->accessibleName().startsWith(QStringLiteral("Seed"))) seeds.insert(box->value());
    }
    QVERIFY(seeds.size() > 1); // all alike once in 10¹²
}

// The item in keyboard focus is not selected yet; the selected one is visible.
void RandomDialogTest::theChosenOneIsSeen() {
    document::Document document;
    RandomDialog dialog(&document);
    dialog.show();
    dialog.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    auto* grid = gridOf(dialog);
    grid->setFocus();
    QCOMPARE(grid->currentRow(), 0);
    QVERIFY(!add(dialog)->isEnabled());
    QTest::keyClick(grid, Qt::Key_Right);
    QVERIFY(add(dialog)->isEnabled());
    QCOMPARE(grid->item(1)->data(Qt::AccessibleTextRole).toString(), QStringLiteral("Fractal 2"));

    const QImage seen = grid->viewport()->grab().toImage();
    const auto stripBelow = [&](int row) {
        const QRect cell = grid->visualItemRect(grid->item(row));
        const int side = std::min(cell.width(), cell.height());
        QRect tile(0, 0, side, side);
        tile.moveCenter(cell.center());
        return seen.copy(tile.left() + 8, tile.bottom() - 3, tile.width() - 16, 1);
    };
    for (int row = 0; row < RandomDialog::count; ++row) {
        const QImage strip = stripBelow(row);
        const QColor wanted = grid->palette().color(row == 1 ? QPalette::Highlight : QPalette::Base);
        for (int x = 0; x < strip.width(); ++x)
            QCOMPARE(strip.pixelColor(x, 0).name(), wanted.name());
    }
}

void RandomDialogTest::theTilesFillTheGrid() {
    document::Document document;
    RandomDialog dialog(&document);
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    const auto* grid = gridOf(dialog);
    for (const QSize& more : {QSize(0, 0), QSize(300, 0), QSize(300, 300)}) {
        dialog.resize(dialog.minimumSizeHint() + more);
        QTRY_COMPARE(dialog.size(), dialog.minimumSizeHint() + more);
        const auto tile = [&](int row) { return grid->visualItemRect(grid->item(row)); };
        QTRY_VERIFY(grid->viewport()->width() - tile(3).right() < 20);
        QCOMPARE(tile(3).top(), tile(0).top()); // four in a row
        QVERIFY(tile(4).top() > tile(0).top());
        QVERIFY(tile(RandomDialog::count - 1).bottom() < grid->viewport()->height());
    }
}

void RandomDialogTest::theChosenOneIsAdded() {
    document::Document document;
    RandomDialog dialog(&document);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    std::uint64_t seed = 0;
    for (const auto* box : dialog.findChildren<QSpinBox*>())
        if (box->accessibleName().startsWith(QStringLiteral("Seed"))) seed = std::uint64_t(box->value());
    gridOf(dialog)->setCurrentRow(5);
    add(dialog)->click();
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QCOMPARE(document.file().entries.size(), 2);
    QCOMPARE(document.currentId(), document.file().entries[1].id);
    QVERIFY(document::isSameSystem(document.fractal(),
                                   document::randomFractal({}, seed * RandomDialog::count + 5)));
    QCOMPARE(document.fractal().name, QStringLiteral("random"));
    RandomDialog again(&document);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(again), 60'000);
    gridOf(again)->setCurrentRow(2);
    again.accept();
    QCOMPARE(document.fractal().name, QStringLiteral("random_2"));
    document.undoStack()->undo();
    document.undoStack()->undo();
    QCOMPARE(document.file().entries.size(), 1);
}

void RandomDialogTest::systemsAreAsAskedFor() {
    document::Document document;
    RandomDialog dialog(&document);
    const Boxes boxes = boxesOf(dialog);
    support::choose(boxes.dimension, 3);
    support::choose(boxes.groups, Rotation);
    support::choose(boxes.maps, 1);
    dialog.findChildren<QSpinBox*>()[0]->setValue(7);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    gridOf(dialog)->setCurrentRow(0);
    dialog.accept();
    const document::System3* system = document::system3(document.fractal());
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t{1});
    QCOMPARE(int(system->symmetry.group), int(Rotation));
    QCOMPARE(system->symmetry.order, 7);
}

void RandomDialogTest::symmetriesFollowTheDimension() {
    document::Document document;
    RandomDialog dialog(&document);
    const Boxes boxes = boxesOf(dialog);
    auto* order = dialog.findChildren<QSpinBox*>()[0];
    QVERIFY(!order->isEnabled());
    QCOMPARE(boxes.maps->findData(1), -1); // it has a point
    support::choose(boxes.groups, Mirror);
    QVERIFY(!order->isEnabled());
    QVERIFY(boxes.maps->findData(1) > 0);
    QCOMPARE(boxes.groups->findData(int(Icosahedral)), -1);
    support::choose(boxes.dimension, 3);
    QCOMPARE(int(view::chosenSymmetryGroup(boxes.groups)), int(Mirror));
    support::choose(boxes.groups, Icosahedral);
    support::choose(boxes.dimension, 2);
    QCOMPARE(int(view::chosenSymmetryGroup(boxes.groups)), int(None));
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
}

void RandomDialogTest::beginsInTheDimensionOfTheEntry() {
    document::Document document;
    document.setFile(document::fileOf(document::randomFractal({3}, 1)));
    RandomDialog dialog(&document);
    QCOMPARE(boxesOf(dialog).dimension->currentData().toInt(), 3);
}

BARYCAGE_TEST(RandomDialogTest, QApplication);
#include "random_dialog_test.moc"
