// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/placements.h"
#include "document/fractal/fractal_geometry.h"
#include "io/fractint/fractint_reader.h"
#include "messages/placement_banner.h"
#include "panels/entries/entries_model.h"
#include "support/named_test.h"

#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

using namespace Qt::StringLiterals;

// Whoever saves a placement is told what other programs make of it.
class PlacementBannerTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theFirstSaveSaysSo();
    void whatIsFlatCannotBeBaked();
    void whatIsAtRestIsNotSpokenOf();
    void aCopyForOthersIsBaked();

private:
    document::Document& document() { return m_window->document(); }
    PlacementBanner* banner() const {
        for (auto* one : m_window->findChildren<PlacementBanner*>())
            if (one->isVisible()) return one;
        return nullptr;
    }
    void open() {
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("one {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .25\n .5 0 0 .5 0 .5 .25\n}\n\n"
                   "other {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n");
        file.close();
        QVERIFY(m_window->openPath(path()));
    }
    void drag(double by = 0.25) {
        ifs::ControlCage<2> cage = document::effectiveCage(document().fractal());
        cage.current[0].x() += by;
        document().edit(u"Move"_s,
                        document::withCageMoved(document().fractal(), cage, document::CageMode::Place));
    }
    void save() {
        for (QAction* action : m_window->findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(QKeySequence::Save)) return action->trigger();
        QFAIL("no such action");
    }
    QString path() const { return m_folder.filePath(u"fractals.ifs"_s); }
    static QByteArray contents(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir m_folder;
};

void PlacementBannerTest::theFirstSaveSaysSo() {
    open();
    const auto* entries = m_window->findChild<view::EntriesModel*>();
    const auto subtitle = [&](int row) {
        return entries->index(row).data(view::EntriesModel::SubtitleRole).toString();
    };
    QCOMPARE(subtitle(0), u"3 maps"_s);
    drag();
    QCOMPARE(subtitle(0), u"3 maps, placed"_s);
    QCOMPARE(subtitle(1), u"2 maps"_s);
    QVERIFY(!banner());
    save();
    QTRY_VERIFY(banner());
    bool isNamed = false;
    for (const auto* label : banner()->findChildren<QLabel*>())
        isNamed = isNamed || label->text().contains(u"“one”"_s);
    QVERIFY(isNamed);
    const document::Box shown = *document::displayedBox(document().fractal());
    const auto buttons = banner()->findChildren<QPushButton*>();
    QCOMPARE(buttons.size(), 2);
    const int steps = document().undoStack()->count();
    QPointer before = banner();
    buttons.first()->click(); // Bake
    QTRY_VERIFY(!before);
    QCOMPARE(document().undoStack()->count(), steps + 1);
    QVERIFY(document::isAtRest(document().fractal()));
    QVERIFY((document::displayedBox(document().fractal())->max - shown.max).norm() < 1e-9);
    QCOMPARE(subtitle(0), u"3 maps"_s);
    document().undoStack()->undo();
    QCOMPARE(subtitle(0), u"3 maps, placed"_s);
    drag();
    save(); // once is enough
    QTRY_VERIFY(!document().isModified());
    QVERIFY(!banner());
}

void PlacementBannerTest::whatIsFlatCannotBeBaked() {
    open();
    drag(1); // onto the next corner
    save();
    QTRY_VERIFY(banner());
    const auto buttons = banner()->findChildren<QPushButton*>();
    QVERIFY(!buttons.first()->isEnabled() && buttons.last()->isEnabled());
    QVERIFY(!buttons.first()->toolTip().isEmpty()); // why
    buttons.last()->click();
    QTRY_VERIFY(!banner());
}

void PlacementBannerTest::whatIsAtRestIsNotSpokenOf() {
    open();
    document::Fractal renamed = document().fractal();
    renamed.name = u"renamed"_s;
    document().edit(u"Rename"_s, renamed);
    save();
    QTRY_VERIFY(!document().isModified());
    QVERIFY(!banner());
    drag(); // which is said now
    save();
    QTRY_VERIFY(banner());
}

void PlacementBannerTest::aCopyForOthersIsBaked() {
    open();
    drag();
    const document::Box shown = *document::displayedBox(document().fractal());
    const document::FractalFile before = document().file();
    const QString copy = m_folder.filePath(u"copy.ifs"_s);
    QTimer answering;
    connect(&answering, &QTimer::timeout, this, [&copy] {
        auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!files) return;
        files->findChild<QLineEdit*>(u"fileNameEdit"_s)->setText(copy);
        QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
    });
    answering.start(50);
    m_window->findChild<QAction*>(u"save-for-other-programs"_s)->trigger();
    answering.stop();
    QTRY_VERIFY(QFile::exists(copy));
    const document::FractalFile written = io::readFractint(contents(copy));
    QCOMPARE(written.entries.size(), 2);
    document::Fractal bare; // as another program reads it
    document::Shape<2> shape;
    shape.system = *document::system2(*written.entries[0].fractal);
    bare.shape = shape;
    QVERIFY((document::displayedBox(bare)->max - shown.max).norm() < 1e-6);
    QVERIFY((document::displayedBox(bare)->min - shown.min).norm() < 1e-6);
    QVERIFY2(document::placedEntries(written).isEmpty(), contents(copy).constData());
    // The window goes on with its own file.
    QVERIFY(document().file() == before && document().isModified());
    QCOMPARE(m_window->path(), path());
    QTRY_VERIFY(m_window->statusBar()->currentMessage().contains(u"copy.ifs"_s));
    QVERIFY(!banner());
    document().undoStack()->setClean();
}

BARYCAGE_TEST(PlacementBannerTest, QApplication);
#include "placement_banner_test.moc"
