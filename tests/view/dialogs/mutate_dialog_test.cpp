// SPDX-License-Identifier: MIT
#include "dialogs/mutate_dialog.h"
#include "document/variations.h"

#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

using view::MutateDialog;

class MutateDialogTest : public QObject {
    Q_OBJECT

private slots:
    void everyTileShowsAPicture();
    void theChosenOneIsSeen();
    void thePickedOneIsOneStep();
    void chanceAddsAnEntry();
    void variesWhatIsChosen();
};

namespace {

// Once all tiles can be chosen and their pictures are there.
bool isFull(const MutateDialog& dialog) {
    const auto* grid = dialog.findChild<QListWidget*>();
    for (int i = 0; i < MutateDialog::count; ++i)
        if (grid->item(i)->icon().isNull()) return false;
    return true;
}

QPushButton* button(const MutateDialog& dialog, const QString& text) {
    for (auto* candidate : dialog.findChildren<QPushButton*>())
        if (candidate->text().contains(text)) return candidate;
    return nullptr;
}

} // namespace

void MutateDialogTest::everyTileShowsAPicture() {
    document::Document document;
    MutateDialog dialog(&document, MutateDialog::Source::Current);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    const auto* grid = dialog.findChild<QListWidget*>();
    QVERIFY(grid->item(0)->icon().pixmap(64).toImage() != grid->item(1)->icon().pixmap(64).toImage());
    QVERIFY(!button(dialog, QStringLiteral("Use"))->isEnabled());
}

// The item in keyboard focus is not selected yet; the selected one is visible.
void MutateDialogTest::theChosenOneIsSeen() {
    document::Document document;
    MutateDialog dialog(&document, MutateDialog::Source::Current);
    dialog.show();
    dialog.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    auto* grid = dialog.findChild<QListWidget*>();
    grid->setFocus();
    QCOMPARE(grid->currentRow(), 0);
    QVERIFY(!button(dialog, QStringLiteral("Use"))->isEnabled());
    QVERIFY(!button(dialog, QStringLiteral("Mutate Again"))->isEnabled());
    QTest::keyClick(grid, Qt::Key_Right);
    QVERIFY(button(dialog, QStringLiteral("Use"))->isEnabled());

    const QImage seen = grid->viewport()->grab().toImage();
    const auto stripBelow = [&](int row) {
        const QRect tile = grid->visualItemRect(grid->item(row));
        return seen.copy(tile.left() + 8, tile.bottom() - 3, tile.width() - 16, 1);
    };
    for (int row = 0; row < MutateDialog::count; ++row) {
        const QImage strip = stripBelow(row);
        const QColor wanted = grid->palette().color(row == 1 ? QPalette::Highlight : QPalette::Base);
        for (int x = 0; x < strip.width(); ++x)
            QCOMPARE(strip.pixelColor(x, 0).name(), wanted.name());
    }
}

void MutateDialogTest::thePickedOneIsOneStep() {
    document::Document document;
    const document::Fractal before = document.fractal();
    MutateDialog dialog(&document, MutateDialog::Source::Current);
    dialog.findChild<QSpinBox*>()->setValue(4);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    dialog.findChild<QListWidget*>()->setCurrentRow(3);
    button(dialog, QStringLiteral("Use"))->click();
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QVERIFY(document.fractal() == document::variation(before, 0.3, 4 * MutateDialog::count + 3));
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
}

void MutateDialogTest::chanceAddsAnEntry() {
    document::Document document;
    MutateDialog dialog(&document, MutateDialog::Source::Chance);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    dialog.findChild<QListWidget*>()->setCurrentRow(0);
    button(dialog, QStringLiteral("Add"))->click();
    QCOMPARE(document.file().entries.size(), 2);
    QCOMPARE(document.currentId(), document.file().entries[1].id);
    document.undoStack()->undo();
    QCOMPARE(document.file().entries.size(), 1);
}

void MutateDialogTest::variesWhatIsChosen() {
    document::Document document;
    MutateDialog dialog(&document, MutateDialog::Source::Current);
    const document::Fractal first =
        document::variation(document.fractal(), 0.3, std::uint64_t{MutateDialog::count} + 2);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    dialog.findChild<QListWidget*>()->setCurrentRow(2);
    button(dialog, QStringLiteral("Mutate Again"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    dialog.findChild<QListWidget*>()->setCurrentRow(5);
    dialog.accept();
    QVERIFY(document.fractal() == document::variation(first, 0.3, std::uint64_t{MutateDialog::count} + 5));
}

QTEST_MAIN(MutateDialogTest)
#include "mutate_dialog_test.moc"
