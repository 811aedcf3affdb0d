// SPDX-License-Identifier: MIT
#include "bridges/render_bridge.h"
#include "document/tops/kept_theft.h"
#include "io/fractint/fractint_reader.h"
#include "support/commands.h"
#include "support/events.h"
#include "support/named.h"
#include "support/named_test.h"
#include "transformation/transformation_view.h"
#include "window_fixture.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QListWidget>
#include <QMenu>
#include <QTemporaryDir>
#include <QThread>
#include <QToolButton>
#include <QUrl>

#include <cstdint>
#include <vector>

using document::KeptTheft;
using Order = std::vector<std::size_t>;

// The order of the maps in the window of fractal transformations, and what it says once something has
// changed.
class TransformationStateTest : public WindowFixture {
    Q_OBJECT

private slots:
    void dividingKeepsTheOrder();
    void theOrderIsReset();
    void anOrderThatDoesNotFitIsReset();
    void nothingOldIsSaid();
    void theBarKeepsItsHeight();
    void picturesStayWithTheirEntries();
    void anotherEntryDropsWhatIsBeingRead();
    void lateFramesOfAnotherEntryAreDropped();
    void anEmbeddedPictureNeedsNoFile();
    void picturesOutsideTheFolderAreAskedFor();
    void picturesAreFoundFromTheFileThatIsOpened();

private:
    document::Document& document() { return m_window->document(); }
    view::TransformationView* view() const { return m_window->findChild<view::TransformationView*>(); }
    void open(const char* text) {
        document().setFile(io::readFractint(text));
        toggle();
    }
    QAbstractButton* button(const char* name) const { return support::button(*view(), name); }
    bool isRemedy(const char* name) const {
        const auto* found = view()->bar()->findChild<QAbstractButton*>(QLatin1String(name));
        return found && found->isVisible();
    }
    QAction* embedding() const { return support::action(*view()->bar(), "embed"); }
    int pictureWidth() const { return view()->theft()->picture() ? view()->theft()->picture()->width() : 0; }
    void toggle() { support::command(*m_window, "fractal-transformation")->trigger(); }
    KeptTheft kept() { return document::keptTheft(document().entryFractal()).value_or(KeptTheft()); }
    QString problem() const { return view()->bar()->problem(); }
    QStringList listed() const {
        const auto* list = view()->findChild<QListWidget*>();
        QStringList maps;
        for (int row = 0; row < list->count(); ++row)
            maps << list->item(row)->text();
        return maps;
    }
};

namespace {

constexpr auto twoAndThree = "two {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n"
                             "three {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 1 0 .3\n .5 0 0 .5 0 1 .4\n}\n";
constexpr auto threeOfThree = "a {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 1 0 .3\n .5 0 0 .5 0 1 .4\n}\n"
                              "b {\n .5 0 0 .5 0 0 .3\n .4 0 0 .4 1 0 .3\n .5 0 0 .5 0 1 .4\n}\n"
                              "c {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 1 0 .3\n .4 0 0 .4 0 1 .4\n}\n";
constexpr auto threeAndThree = "three {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 1 0 .3\n .5 0 0 .5 0 1 .4\n}\n"
                               "other {\n .5 0 0 .5 0 0 .3\n .4 0 0 .4 1 0 .3\n .5 0 0 .5 0 1 .4\n}\n";

bool saveBlue(const QString& path, int width) {
    QImage blue(width, 40, QImage::Format_RGB32);
    blue.fill(QColor(20, 60, 250));
    return blue.save(path);
}

// Three entries of three maps, of which the first has a picture on the second.
bool saveNaming(const QString& path, const QString& picture) {
    QByteArray text = threeOfThree;
    text.insert(text.indexOf('}'), "; barycage: partner b\n; barycage: partner-picture " +
                                       QUrl::toPercentEncoding(picture, "/") + "\n");
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

} // namespace

// The upper map stays on top of the words that it is divided into, and undoing brings back all.
void TransformationStateTest::dividingKeepsTheOrder() {
    open(twoAndThree);
    QTRY_VERIFY(problem().startsWith(QStringLiteral("“two” and “three” must have the same number")));
    view()->findChild<QListWidget*>()->setCurrentRow(1);
    button("up")->click();
    QCOMPARE(kept().order, (Order{1, 0}));
    QTRY_VERIFY(isRemedy("divide-words"));
    button("divide-words")->click();
    QTRY_COMPARE(listed(), QStringList({QStringLiteral("3"), QStringLiteral("2"), QStringLiteral("1")}));
    QCOMPARE(kept().order, (Order{2, 1, 0})); // 2, 12, 11
    QTRY_VERIFY2(problem().isEmpty() && view()->isPainted(), qPrintable(problem()));
    document().undoStack()->undo();
    QCOMPARE(kept().order, (Order{1, 0}));
    QTRY_VERIFY(problem().startsWith(QStringLiteral("“two” and “three” must have the same number")));
}

void TransformationStateTest::theOrderIsReset() {
    open(threeAndThree);
    const char* name = "reset-order";
    QVERIFY(!button(name)->isEnabled());
    view()->findChild<QListWidget*>()->setCurrentRow(2);
    button("up")->click();
    button("up")->click();
    QCOMPARE(kept().order, (Order{2, 0, 1}));
    QVERIFY(button(name)->isEnabled());
    const int steps = document().undoStack()->count();
    button(name)->click();
    QCOMPARE(document().undoStack()->count(), steps + 1);
    QVERIFY(kept().order.empty());
    QCOMPARE(listed(), QStringList({QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3")}));
    QVERIFY(!button(name)->isEnabled());
    document().undoStack()->undo();
    QCOMPARE(kept().order, (Order{2, 0, 1}));
    QVERIFY(button(name)->isEnabled());
}

// As of a file that was edited by hand. What is said has a remedy beside it.
void TransformationStateTest::anOrderThatDoesNotFitIsReset() {
    open(threeAndThree);
    KeptTheft theft;
    theft.partner = QStringLiteral("other");
    theft.order = {0, 1};
    document().editEntry(QStringLiteral("order"), document::withTheft(document().entryFractal(), theft));
    QTRY_VERIFY(problem().startsWith(QStringLiteral("The stored order")));
    QAbstractButton* remedy = support::button(*view()->bar(), "reset-order");
    QVERIFY(remedy->isVisible());
    remedy->click();
    QVERIFY(kept().order.empty());
    QTRY_VERIFY2(problem().isEmpty() && view()->isPainted(), qPrintable(problem()));
}

// What was true before a step of the history goes with it, and does not wait for what is computed next.
void TransformationStateTest::nothingOldIsSaid() {
    open(twoAndThree);
    QTRY_VERIFY(problem().startsWith(QStringLiteral("“two” and “three” must have the same number")));
    button("divide-words")->click();
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    document().undoStack()->undo();
    QVERIFY(problem().startsWith(QStringLiteral("“two” and “three” must have the same number")));
    document().undoStack()->redo();
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    QTRY_VERIFY(!view()->bar()->continuity().isEmpty());
    document().undoStack()->undo();
    QVERIFY(view()->bar()->continuity().isEmpty());
}

// Until the picture of an entry is there, the one of the entry before is not shown on it.
void TransformationStateTest::picturesStayWithTheirEntries() {
    open(threeOfThree);
    QTRY_VERIFY(view()->isPainted());
    const document::EntryId other = document().file().entries[2].id;
    KeptTheft theft;
    theft.partner = QStringLiteral("b");
    theft.pattern = attractor::Pattern::Marble;
    document().editEntry(QStringLiteral("marble"), document::withTheft(document().entryFractal(), theft));
    const auto wheel = view()->theft()->picture();
    QTRY_VERIFY(view()->theft()->picture() != wheel);
    const auto marble = view()->theft()->picture();
    QVERIFY(marble);
    document().setCurrent(other);
    QVERIFY(view()->theft()->picture() != marble);
    QTRY_VERIFY(view()->theft()->picture() && view()->isPainted());
    QVERIFY(view()->theft()->picture() != marble);
}

// A picture that is chosen is kept with its entry or not at all.
void TransformationStateTest::anotherEntryDropsWhatIsBeingRead() {
    open(threeOfThree);
    QTRY_VERIFY(view()->isPainted());
    const QTemporaryDir folder;
    QImage blue(40, 40, QImage::Format_RGB32);
    blue.fill(QColor(20, 60, 250));
    const QString path = folder.filePath(QStringLiteral("blue.png"));
    QVERIFY(blue.save(path));
    const auto before = view()->theft()->picture();
    view()->usePicture(path);
    document().setCurrent(document().file().entries[2].id);
    QTRY_VERIFY(view()->theft()->picture() && view()->theft()->picture() != before && view()->isPainted());
    QCOMPARE(document().undoStack()->count(), 0);
    for (const document::Entry& entry : document().file().entries)
        QVERIFY(!document::keptTheft(*entry.fractal));
    view()->usePicture(path); // here it is kept, whatever happens to the entry meanwhile
    document::Fractal changed = document().entryFractal();
    document::system2(changed)->maps[0].weight = 2;
    document().editEntry(QStringLiteral("weight"), changed);
    QTRY_COMPARE(kept().picture, path);
}

// Whatever is said below the canvases, they keep their size.
void TransformationStateTest::theBarKeepsItsHeight() {
    toggle();
    QTRY_VERIFY_WITH_TIMEOUT(!view()->bar()->problem().isEmpty(), 60'000);
    support::handleEvents();
    const int height = view()->bar()->height();
    auto* bar = const_cast<view::TransformationBar*>(view()->bar());
    for (const QString& sentence : {QString(), QString(200, u'w'), QStringLiteral("short")})
        for (const auto remedy :
             {view::TransformationBar::Remedy::None, view::TransformationBar::Remedy::FindPicture}) {
            bar->showProblem(sentence, remedy);
            support::handleEvents();
            QCOMPARE(bar->height(), height);
        }
}

// They are finished but not yet shown when another entry is chosen.
void TransformationStateTest::lateFramesOfAnotherEntryAreDropped() {
    const auto* render = m_window->findChild<view::RenderBridge*>(); // the partner's is made later
    open(threeOfThree);
    QTRY_VERIFY(view()->isPainted());
    for (int k = 0; k < 5; ++k) {
        support::button(*view()->bar(), "overlay")->click(); // asks for new frames
        QThread::msleep(200); // no event tells that they are finished, as none is handled
        const std::uint64_t last = render->requested();
        bool isLate = false;
        const auto watch = connect(render, &view::RenderBridge::frameChanged, this, [&] {
            isLate = isLate || (render->frame() && render->frame()->revision <= last);
        });
        document().setCurrent(document().file().entries[k % 2 == 0 ? 2 : 0].id);
        QTRY_VERIFY(render->frame() && render->frame()->revision > last);
        disconnect(watch);
        QVERIFY(!isLate);
    }
}

void TransformationStateTest::anEmbeddedPictureNeedsNoFile() {
    open(threeOfThree);
    QTRY_VERIFY(view()->isPainted());
    QAction* embed = embedding();
    QVERIFY(embed && !embed->isEnabled()); // a pattern is no file
    const QTemporaryDir folder;
    QImage blue(40, 40, QImage::Format_RGB32);
    blue.fill(QColor(20, 60, 250));
    const QString path = folder.filePath(QStringLiteral("blue.png"));
    QVERIFY(blue.save(path));
    view()->usePicture(path);
    QTRY_COMPARE(kept().picture, path);
    QVERIFY(kept().embedded.isEmpty() && embed->isEnabled() && !embed->isChecked());
    const int steps = document().undoStack()->count();
    embed->trigger();
    QTRY_VERIFY(!kept().embedded.isEmpty());
    QCOMPARE(document().undoStack()->count(), steps + 1);
    QVERIFY(embed->isChecked());
    QVERIFY(QFile::remove(path));
    const document::EntryId own = document().currentId();
    document().setCurrent(document().file().entries[2].id);
    QTRY_VERIFY(view()->isPainted());
    QVERIFY(!embed->isChecked());
    document().setCurrent(own);
    QTRY_VERIFY(view()->theft()->picture() && view()->theft()->picture()->width() == 40);
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    embed->trigger(); // now it is looked for where it was
    QVERIFY(kept().embedded.isEmpty());
    QTRY_VERIFY(problem().contains(QStringLiteral("blue.png")));
    embed->trigger();
    QTRY_VERIFY(!embed->isChecked()); // it cannot be read
    QVERIFY(kept().embedded.isEmpty());
}

// By their names or behind links: a file from a stranger could name any other. What was agreed for one file
// says nothing of the next.
void TransformationStateTest::picturesOutsideTheFolderAreAskedFor() {
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("sub")));
    const QString outside = folder.filePath(QStringLiteral("blue.png"));
    QVERIFY(saveBlue(outside, 40) && saveBlue(folder.filePath(QStringLiteral("sub/inside.png")), 30));
    QVERIFY(QFile::link(outside, folder.filePath(QStringLiteral("sub/link.png"))));
    const QString path = folder.filePath(QStringLiteral("sub/a.ifs"));
    toggle();
    for (const QString& named : {QStringLiteral("../blue.png"), outside, QStringLiteral("link.png")}) {
        QVERIFY(saveNaming(path, named));
        QVERIFY(m_window->openPath(path));
        QTRY_VERIFY2(problem().startsWith(QStringLiteral("The file names a picture outside its folder: ")),
                     qPrintable(problem()));
        QVERIFY(problem().contains(QFileInfo(named).fileName()) && !view()->theft()->picture());
        embedding()->trigger();
        QTRY_VERIFY(!embedding()->isChecked());
        QVERIFY(kept().embedded.isEmpty() && isRemedy("open-foreign-picture"));
        button("open-foreign-picture")->click();
        QTRY_COMPARE(pictureWidth(), 40);
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
        const document::EntryId own = document().currentId();
        document().setCurrent(document().file().entries[2].id);
        QTRY_VERIFY(view()->isPainted());
        document().setCurrent(own);
        QTRY_COMPARE(pictureWidth(), 40);
        embedding()->trigger();
        QTRY_VERIFY(!kept().embedded.isEmpty());
        document().undoStack()->setClean();
    }
    QVERIFY(saveNaming(path, QStringLiteral("inside.png")));
    QVERIFY(m_window->openPath(path));
    QTRY_COMPARE(pictureWidth(), 30);
    QVERIFY2(problem().isEmpty(), qPrintable(problem()));
}

// And not from the folder of the file before.
void TransformationStateTest::picturesAreFoundFromTheFileThatIsOpened() {
    const QTemporaryDir folder;
    toggle();
    for (const int width : {20, 30}) {
        const QDir own(folder.filePath(QString::number(width)));
        QVERIFY(own.mkpath(QStringLiteral(".")));
        QVERIFY(saveBlue(own.filePath(QStringLiteral("p.png")), width));
        const QString path = own.filePath(QStringLiteral("a.ifs"));
        QVERIFY(saveNaming(path, QStringLiteral("p.png")));
        QVERIFY(m_window->openPath(path));
        QTRY_COMPARE(pictureWidth(), width);
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    }
}

BARYCAGE_TEST(TransformationStateTest, QApplication);
#include "transformation_state_test.moc"
