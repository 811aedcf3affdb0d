// SPDX-License-Identifier: MIT
#include "dialogs/variations/mutate_dialog.h"

#include "dialogs/variations/picture_tiles.h"
#include "document/edits/entries_edits.h"
#include "document/edits/maps/map_locks.h"
#include "document/variations/random_systems.h"
#include "support/choose.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

#include <algorithm>
#include <span>
#include <vector>

using view::MutateDialog;
using view::VariationRing;

class MutateDialogTest : public QObject {
    Q_OBJECT

private slots:
    void everyTileShowsAPicture_data();
    void everyTileShowsAPicture();
    void theParentIsInTheMiddle();
    void aClickMakesAChildTheParent();
    void enterMakesAChildTheParent();
    void whatIsInTheMiddleIsUsed();
    void aDoubleClickUsesAChild();
    void theLineLeadsBack();
    void aLineThatIsLeftGoesOn();
    void allMapsAreLocked();
    void nothingMayChange();
    void entriesAreCrossed();
    void closingAtOnceIsSafe();
};

namespace {

VariationRing& ringOf(const MutateDialog& dialog) {
    return *dialog.findChild<VariationRing*>();
}

QPixmap pictureOf(const MutateDialog& dialog, QTableWidgetItem* item) {
    return view::PictureTiles::shown(ringOf(dialog).indexFromItem(item)).pixmap;
}

int childrenShown(const MutateDialog& dialog) {
    int shown = 0;
    for (int child = 0; child < MutateDialog::count; ++child)
        shown += !pictureOf(dialog, ringOf(dialog).childItem(child)).isNull();
    return shown;
}

// Once all pictures are there.
bool isFull(const MutateDialog& dialog) {
    return childrenShown(dialog) == MutateDialog::count &&
           !pictureOf(dialog, ringOf(dialog).parentItem()).isNull();
}

QAbstractButton* use(const MutateDialog& dialog) {
    return support::button(dialog, "use");
}

QListWidget* lineOf(const MutateDialog& dialog) {
    return dialog.findChild<QListWidget*>();
}

document::Fractal child(const document::Fractal& parent, int index, int seed = 1) {
    return document::variation(parent, {}, std::uint64_t(seed) * MutateDialog::count + std::uint64_t(index));
}

void click(const MutateDialog& dialog, QTableWidgetItem* item) {
    QTest::mouseClick(ringOf(dialog).viewport(), Qt::LeftButton, {},
                      ringOf(dialog).visualItemRect(item).center());
}

void open(MutateDialog& dialog) {
    dialog.show();
    dialog.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
}

} // namespace

void MutateDialogTest::everyTileShowsAPicture_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("plane") << 2;
    QTest::newRow("space") << 3;
}

void MutateDialogTest::everyTileShowsAPicture() {
    QFETCH(int, dimension);
    document::Document document;
    document.setFile(document::fileOf(document::randomFractal({dimension}, 3)));
    MutateDialog dialog(&document);
    open(dialog);
    const VariationRing& ring = ringOf(dialog);
    QVERIFY(pictureOf(dialog, ring.childItem(0)).toImage() != pictureOf(dialog, ring.childItem(1)).toImage());
    QVERIFY(!use(dialog)->isEnabled());
    for (int i = 0; i < MutateDialog::count; ++i)
        QVERIFY(ring.childItem(i)->data(Qt::AccessibleTextRole).toString().contains(QString::number(i + 1)));
}

void MutateDialogTest::theParentIsInTheMiddle() {
    document::Document document;
    MutateDialog dialog(&document);
    open(dialog);
    const VariationRing& ring = ringOf(dialog);
    const QRect middle = ring.visualItemRect(ring.parentItem());
    QVERIFY((middle.center() - ring.viewport()->rect().center()).manhattanLength() <= 4);
    for (int i = 0; i < MutateDialog::count; ++i) {
        const QRect other = ring.visualItemRect(ring.childItem(i));
        QVERIFY(!other.intersects(middle));
        QVERIFY(2 * other.width() <= middle.width() + 2);
    }
    // On a tile of the colour of selections.
    const QImage seen = ringOf(dialog).viewport()->grab().toImage();
    const int inset = (middle.height() - ring.parentSide()) / 2;
    QCOMPARE(seen.pixelColor(middle.center().x(), middle.top() + inset - 2).name(),
             ring.palette().color(QPalette::Highlight).name());
}

void MutateDialogTest::aClickMakesAChildTheParent() {
    document::Document document;
    MutateDialog dialog(&document);
    open(dialog);
    const document::Fractal first = child(document.fractal(), 4);
    click(dialog, ringOf(dialog).childItem(4));
    QCOMPARE(lineOf(dialog)->count(), 2);
    QVERIFY(use(dialog)->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    click(dialog, ringOf(dialog).childItem(7));
    QCOMPARE(lineOf(dialog)->count(), 3);
    QCOMPARE(document.undoStack()->count(), 0);
    use(dialog)->click();
    QVERIFY(document.fractal() == child(first, 7));
    QCOMPARE(document.undoStack()->count(), 1);
}

void MutateDialogTest::enterMakesAChildTheParent() {
    document::Document document;
    const document::Fractal before = document.fractal();
    MutateDialog dialog(&document);
    open(dialog);
    VariationRing& ring = ringOf(dialog);
    QVERIFY(ring.hasFocus());
    QCOMPARE(ring.currentItem(), ring.parentItem());
    QTest::keyClick(&ring, Qt::Key_Return); // the original: nothing to use
    QVERIFY(dialog.isVisible());
    QTest::keyClick(&ring, Qt::Key_Right);
    QTest::keyClick(&ring, Qt::Key_Return);
    QVERIFY(dialog.isVisible());
    QCOMPARE(lineOf(dialog)->count(), 2);
    QTest::keyClick(&ring, Qt::Key_Left);
    QCOMPARE(ring.visualItemRect(ring.currentItem()), ring.visualItemRect(ring.parentItem()));
    QTest::keyClick(&ring, Qt::Key_Return);
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QVERIFY(document.fractal() == child(before, 5)); // to the right of the parent
}

void MutateDialogTest::whatIsInTheMiddleIsUsed() {
    document::Document document;
    const document::Fractal before = document.fractal();
    MutateDialog dialog(&document);
    dialog.findChild<QSpinBox*>()->setValue(4);
    open(dialog);
    click(dialog, ringOf(dialog).childItem(3));
    use(dialog)->click();
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QVERIFY(document.fractal() == child(before, 3, 4));
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
}

void MutateDialogTest::aDoubleClickUsesAChild() {
    document::Document document;
    const document::Fractal before = document.fractal();
    MutateDialog dialog(&document);
    open(dialog);
    const QPoint middle = ringOf(dialog).visualItemRect(ringOf(dialog).parentItem()).center();
    QTest::mouseDClick(ringOf(dialog).viewport(), Qt::LeftButton, {}, middle);
    QVERIFY(dialog.isVisible()); // the original: nothing to use
    const QPoint place = ringOf(dialog).visualItemRect(ringOf(dialog).childItem(9)).center();
    QTest::mouseClick(ringOf(dialog).viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(ringOf(dialog).viewport(), Qt::LeftButton, {}, place);
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QVERIFY(document.fractal() == child(before, 9));
}

void MutateDialogTest::theLineLeadsBack() {
    document::Document document;
    const document::Fractal before = document.fractal();
    MutateDialog dialog(&document);
    open(dialog);
    for (const int picked : {1, 2}) {
        click(dialog, ringOf(dialog).childItem(picked));
        QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    }
    dialog.findChild<QSpinBox*>()->setValue(8);
    QCOMPARE(lineOf(dialog)->count(), 3);
    lineOf(dialog)->setCurrentRow(1);
    QCOMPARE(lineOf(dialog)->count(), 3);                // its descendants are still there
    QCOMPARE(dialog.findChild<QSpinBox*>()->value(), 1); // its sheet
    lineOf(dialog)->setCurrentRow(2);
    QCOMPARE(dialog.findChild<QSpinBox*>()->value(), 8);
    lineOf(dialog)->setCurrentRow(0);
    QVERIFY(!use(dialog)->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    click(dialog, ringOf(dialog).childItem(11));
    QCOMPARE(lineOf(dialog)->count(), 2); // another line
    use(dialog)->click();
    QVERIFY(document.fractal() == child(before, 11));
}

void MutateDialogTest::aLineThatIsLeftGoesOn() {
    document::Document document;
    const document::Fractal before = document.fractal();
    MutateDialog::Descent left;
    {
        MutateDialog dialog(&document);
        open(dialog);
        click(dialog, ringOf(dialog).childItem(4));
        dialog.findChild<QSpinBox*>()->setValue(6);
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
        left = dialog.descent();
    }
    {
        MutateDialog dialog(&document, nullptr, left);
        QCOMPARE(lineOf(dialog)->count(), 2);
        QCOMPARE(lineOf(dialog)->currentRow(), 1);
        QCOMPARE(dialog.findChild<QSpinBox*>()->value(), 6);
        use(dialog)->click();
        QVERIFY(document.fractal() == child(before, 4));
    }
    const MutateDialog other(&document, nullptr, left); // the entry is another one now
    QCOMPARE(lineOf(other)->count(), 1);
}

void MutateDialogTest::allMapsAreLocked() {
    document::Document document;
    std::vector<ifs::MapId> all;
    for (const auto& map : document::system2(document.fractal())->maps)
        all.push_back(map.id);
    const auto says = [&document] {
        const MutateDialog dialog(&document);
        const auto labels = dialog.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text().startsWith(QStringLiteral("All maps are locked"));
        });
    };
    document::lockMaps(document, std::span(all).first(2), true);
    QVERIFY(!says());
    document::lockMaps(document, all, true);
    QVERIFY(says());
}

void MutateDialogTest::nothingMayChange() {
    document::Document document;
    MutateDialog dialog(&document);
    open(dialog);
    support::button(dialog, "shape")->setChecked(false);
    support::button(dialog, "weights")->setChecked(false);
    QVERIFY(!isFull(dialog));
    click(dialog, ringOf(dialog).childItem(0));
    QCOMPARE(lineOf(dialog)->count(), 1);
    const document::Fractal before = document.fractal();
    support::button(dialog, "colour")->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    click(dialog, ringOf(dialog).childItem(2));
    use(dialog)->click();
    QVERIFY(document::isSameSystem(document.fractal(), before));
    QVERIFY(!(document.fractal().appearance == before.appearance));
}

void MutateDialogTest::entriesAreCrossed() {
    document::Document document;
    const document::Fractal before = document.fractal();
    QVERIFY(!MutateDialog(&document).findChild<QComboBox*>()->isEnabled());
    document::Entry plane, space;
    plane.fractal = std::make_shared<const document::Fractal>(document::randomFractal({2}, 5));
    space.fractal = std::make_shared<const document::Fractal>(document::randomFractal({3}, 5));
    document.editFile(QStringLiteral("add"),
                      document::inserted(document.file(), {plane, space}, document::EntryId::None).file,
                      document.currentId());
    MutateDialog dialog(&document);
    auto* partner = dialog.findChild<QComboBox*>();
    QCOMPARE(partner->count(), 2); // nothing, and the one in the plane
    open(dialog);
    support::choose(partner, document.file().entries[1].fractal);
    QTRY_VERIFY_WITH_TIMEOUT(isFull(dialog), 60'000);
    click(dialog, ringOf(dialog).childItem(6));
    use(dialog)->click();
    QVERIFY(document.fractal() == document::variation(before, {0.3, {}, document.file().entries[1].fractal},
                                                      std::uint64_t{MutateDialog::count} + 6));
}

void MutateDialogTest::closingAtOnceIsSafe() {
    document::Document document;
    for (int i = 0; i < 5; ++i) {
        MutateDialog dialog(&document);
        dialog.show();
        dialog.findChild<QSpinBox*>()->setValue(2 + i);
        QTRY_VERIFY(childrenShown(dialog) >= i); // sooner or later
    }
    QVERIFY(document.undoStack()->count() == 0);
}

BARYCAGE_TEST(MutateDialogTest, QApplication);
#include "mutate_dialog_test.moc"
