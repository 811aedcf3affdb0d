// SPDX-License-Identifier: MIT
#include "panels/timeline/morph_dialog.h"

#include "document/edits/entries_edits.h"
#include "document/moments/animated_fractal.h"
#include "panels/timeline/morph_lines.h"
#include "panels/timeline/timeline_panel.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>

#include <algorithm>
#include <memory>

using view::MorphDialog;
using view::MorphLines;

namespace {

// Copies of the square in its corners, from the one with that number on.
document::Fractal corners(const QString& name, int first, std::vector<double> weights) {
    document::Fractal fractal;
    fractal.name = name;
    document::Shape<2> shape;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const int corner = (int(i) + first) % 4;
        const double x = corner == 1 || corner == 2 ? 0.5 : 0, y = corner >= 2 ? 0.5 : 0;
        ifs::append(shape.system, ifs::affineMap(0.4, 0, 0, 0.4, x, y), weights[i]);
    }
    fractal.shape = std::move(shape);
    return fractal;
}

} // namespace

// Which map becomes which, shown and pinned.
class MorphDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init();
    void cleanup() { m_dialog.reset(); }

    void pairsAreTheCheapest();
    void aDragPinsAPair();
    void clicksPinAPair();
    void keysPinAPair();
    void splitMapsAreTold();
    void obstaclesAreTold();
    void theMorphIsOneStep();
    void longNamesLeaveTheMenuNarrow();

private:
    MorphLines& lines() { return *m_dialog->lines(); }
    void drag(const MorphLines::Place& from, const MorphLines::Place& to);
    std::vector<std::pair<std::size_t, std::size_t>> pairs();
    void add(const document::Fractal& fractal);

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<MorphDialog> m_dialog;
};

void MorphDialogTest::add(const document::Fractal& fractal) {
    document::Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(fractal);
    const auto current = m_document->currentId();
    m_document->editFile(QStringLiteral("Add"),
                         document::inserted(m_document->file(), {entry}, document::EntryId::None).file,
                         current);
}

void MorphDialogTest::init() {
    m_document = std::make_unique<document::Document>();
    m_document->setFile(document::fileOf(corners(QStringLiteral("one"), 0, {1, 1, 1, 1})));
    add(corners(QStringLiteral("two"), 1, {1, 1, 1, 1}));
    add(corners(QStringLiteral("three"), 0, {2, 1, 1}));
    m_dialog = std::make_unique<MorphDialog>(*m_document, 60);
    m_dialog->resize(560, 620);
    m_dialog->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
    m_dialog->target()->setCurrentIndex(m_dialog->target()->findText(QStringLiteral("two")));
    QTRY_VERIFY(m_dialog->isSolved());
}

// What the solved morph is made of: the maps at both ends.
std::vector<std::pair<std::size_t, std::size_t>> MorphDialogTest::pairs() {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    const auto cornerOf = [](const ifs::AffineMap<2>& map) {
        const bool right = map.translation.x() > 0.25, up = map.translation.y() > 0.25;
        return std::size_t(up ? (right ? 2 : 3) : (right ? 1 : 0));
    };
    for (const auto& track : document::plane(m_dialog->morph())->animation->maps)
        result.emplace_back(cornerOf(track.keys.front().value.map), cornerOf(track.keys.back().value.map));
    return result;
}

void MorphDialogTest::drag(const MorphLines::Place& from, const MorphLines::Place& to) {
    const QPoint begin = lines().rectOf(from).center(), end = lines().rectOf(to).center();
    QTest::mousePress(&lines(), Qt::LeftButton, {}, begin);
    QMouseEvent move(QEvent::MouseMove, QPointF(end), lines().mapToGlobal(QPointF(end)), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(&lines(), &move);
    QTest::mouseRelease(&lines(), Qt::LeftButton, {}, end);
}

void MorphDialogTest::pairsAreTheCheapest() {
    for (const auto& [from, to] : pairs())
        QCOMPARE(to, from);                                    // each corner stays where it is
    QVERIFY(lines().sentence().contains(QStringLiteral("4"))); // map 1 is map 4 of the other
}

void MorphDialogTest::aDragPinsAPair() {
    const QSignalSpy spy(&lines(), &MorphLines::pinsChanged);
    drag({MorphLines::From, 0}, {MorphLines::To, 1});
    QCOMPARE(spy.size(), 1);
    QCOMPARE(lines().pins().size(), std::size_t(1));
    QVERIFY(!m_dialog->isSolved()); // anew
    QTRY_VERIFY(m_dialog->isSolved());
    const auto pinned = pairs();
    QVERIFY(std::ranges::find(pinned, std::pair<std::size_t, std::size_t>(0, 2)) != pinned.end());
    QVERIFY(lines().sentence().contains(QStringLiteral("pinned")));
    drag({MorphLines::To, 1}, {MorphLines::From, 0}); // the same pair from the other side
    QVERIFY(lines().pins().empty());
    QTRY_VERIFY(m_dialog->isSolved());
    for (const auto& [from, to] : pairs())
        QCOMPARE(to, from);
    drag({MorphLines::From, 0}, {MorphLines::From, 2}); // within a column: nothing
    QVERIFY(lines().pins().empty());
}

void MorphDialogTest::clicksPinAPair() {
    const auto click = [&](const MorphLines::Place& place) {
        QTest::mouseClick(&lines(), Qt::LeftButton, {}, lines().rectOf(place).center());
    };
    click({MorphLines::To, 2});
    QVERIFY(lines().pins().empty());
    click({MorphLines::From, 3});
    QCOMPARE(lines().pins().size(), std::size_t(1));
    QVERIFY(lines().pins()[0].from == 3 && lines().pins()[0].to == 2);
    click({MorphLines::From, 0});
    click({MorphLines::From, 0}); // let go
    click({MorphLines::To, 0});
    QCOMPARE(lines().pins().size(), std::size_t(1));
}

void MorphDialogTest::keysPinAPair() {
    lines().setFocus();
    QTest::keyClick(&lines(), Qt::Key_Down);
    QTest::keyClick(&lines(), Qt::Key_Space);
    QTest::keyClick(&lines(), Qt::Key_Right);
    QTest::keyClick(&lines(), Qt::Key_End);
    QTest::keyClick(&lines(), Qt::Key_Space);
    QCOMPARE(lines().pins().size(), std::size_t(1));
    QVERIFY(lines().pins()[0].from == 1 && lines().pins()[0].to == 3);
    QTest::keyClick(&lines(), Qt::Key_Delete);
    QVERIFY(lines().pins().empty());
    QTest::keyClick(&lines(), Qt::Key_Space);
    QTest::keyClick(&lines(), Qt::Key_Escape); // lets go of the map, and keeps the dialog
    QVERIFY(m_dialog->isVisible());
    QTest::keyClick(&lines(), Qt::Key_Escape);
    QVERIFY(!m_dialog->isVisible());
}

// More than one line starts at a map whose weight is split.
void MorphDialogTest::splitMapsAreTold() {
    m_dialog->target()->setCurrentIndex(m_dialog->target()->findText(QStringLiteral("three")));
    QTRY_VERIFY(m_dialog->isSolved());
    QVERIFY(document::plane(m_dialog->morph())->system.maps.size() <= 6); // 4 + 3 − 1
    lines().setFocus();
    QTest::keyClick(&lines(), Qt::Key_Right);
    QVERIFY(lines().sentence().startsWith(QStringLiteral("Map 1 comes from map ")));
    QVERIFY(lines().sentence().contains(QStringLiteral(", ")));
}

void MorphDialogTest::obstaclesAreTold() {
    add(corners(QStringLiteral("many"), 0, std::vector<double>(300, 1)));
    MorphDialog dialog(*m_document, 60);
    dialog.target()->setCurrentIndex(dialog.target()->findText(QStringLiteral("many")));
    const auto told = [&](const QString& text) {
        return std::ranges::any_of(dialog.findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(text); });
    };
    QTRY_VERIFY(told(QStringLiteral("256")));
    QVERIFY(!dialog.isSolved());
    QVERIFY(!support::button(dialog, "add")->isEnabled());
}

void MorphDialogTest::theMorphIsOneStep() {
    view::TimelinePanel panel(m_document.get());
    panel.show();
    QMenu* entries = panel.motions().back()->menu();
    emit entries->aboutToShow();
    const int steps = m_document->undoStack()->index();
    entries->actions().back()->trigger();
    auto* dialog = panel.findChild<MorphDialog*>();
    QVERIFY(dialog != nullptr);
    dialog->target()->setCurrentIndex(dialog->target()->findText(QStringLiteral("two")));
    QTRY_VERIFY(dialog->isSolved());
    dialog->accept();
    panel.timeline().playback().setPlaying(false);
    QCOMPARE(m_document->undoStack()->index(), steps + 1);
    QCOMPARE(m_document->file().entries.size(), 4);
    QCOMPARE(m_document->entryFractal().name, QStringLiteral("one-two"));
    QVERIFY(panel.timeline().timing().loop == animation::Loop::ThereAndBack);
    m_document->undoStack()->undo();
    QCOMPARE(m_document->file().entries.size(), 3);
    QCOMPARE(m_document->entryFractal().name, QStringLiteral("one"));
}

void MorphDialogTest::longNamesLeaveTheMenuNarrow() {
    const QString name = QStringLiteral("a&b ") + QString(300, u'm');
    document::FractalFile file = m_document->file();
    file.entries.back().fractal = std::make_shared<const document::Fractal>(corners(name, 2, {1, 1, 1}));
    m_document->setFile(file);
    view::TimelinePanel panel(m_document.get());
    QMenu* entries = panel.motions().back()->menu();
    emit entries->aboutToShow();
    const auto actions = entries->actions();
    const auto found = std::ranges::find_if(
        actions, [&](const QAction* action) { return action->toolTip().contains(name); });
    QVERIFY(found != actions.end()); // all of it is in the tool tip
    QVERIFY(entries->toolTipsVisible());
    QVERIFY((*found)->text().startsWith(QStringLiteral("a&&b m")));
    QVERIFY((*found)->text().contains(u'…'));
    QVERIFY(entries->sizeHint().width() < 100 * entries->fontMetrics().averageCharWidth());
}

BARYCAGE_TEST(MorphDialogTest, QApplication);
#include "morph_dialog_test.moc"
