// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"
#include "document/disk/journal.h"
#include "document/fractal/fractal_geometry.h"
#include "files/recent_files.h"
#include "io/fractint/fractint_reader.h"
#include "panels/problems/problems_panel.h"
#include "session/session.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/window_on_x.h"

#include <QCommandLinkButton>
#include <QDialog>
#include <QDir>
#include <QDragMoveEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSettings>

#include <optional>

using ifs::Vector;

namespace {

// Where on the screen something was last dragged over the program.
class DragWatch : public QObject {
public:
    DragWatch() { qApp->installEventFilter(this); }
    std::optional<QPoint> position() const { return m_position; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        const bool isDrag = event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove;
        if (const auto* widget = qobject_cast<QWidget*>(watched); widget && isDrag)
            m_position = widget->mapToGlobal(static_cast<QDragMoveEvent*>(event)->position().toPoint());
        return QObject::eventFilter(watched, event);
    }

private:
    std::optional<QPoint> m_position;
};

// Of the first entry of a file, where that can be read.
std::optional<Vector<2>> cornerIn(const QByteArray& file, std::size_t corner) {
    const document::FractalFile read = io::readFractint(file);
    if (read.entries.isEmpty() || document::dimension(*read.entries.first().fractal) != 2) return {};
    return document::effectiveCage(*read.entries.first().fractal).current[corner];
}

} // namespace

// Windows and their files, kept, asked about, dropped and recovered, with a real pointer and real keys.
class RealFilesTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void draggedFractalSavesAndReopens();
    void aNewFileGivesUpTheDrag();
    void aFileIsOpenedByItsName_data();
    void aFileIsOpenedByItsName();
    void aRecentFileIsOpened();
    void aBrokenEntryIsToldAndKept();
    void unsavedWorkIsAskedAbout();
    void anotherWindowIsAnotherDocument();
    void theWelcomeOffersTheLastFile();
    void workIsRecoveredAfterAKill();
    void aFileIsDroppedFromAnotherProgram();

private:
    QString put(const QString& name, const QByteArray& bytes) const {
        QString path = folder() + u'/' + name;
        if (io::saveFile(path, bytes)) qFatal("no test file");
        return path;
    }
    MainWindow* another() const { // beside that of the test
        for (SessionWindow* found : session::windows())
            if (found != &window() && found->isVisible()) return qobject_cast<MainWindow*>(found);
        return nullptr;
    }
    static void close(MainWindow* another) {
        another->document().undoStack()->setClean();
        another->close();
    }
};

void RealFilesTest::draggedFractalSavesAndReopens() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    dragBy(vertex(1), {-60, -45});
    const std::vector<Vector<2>> placed = vertices();
    QVERIFY(window().isWindowModified());
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(document::plane(savedEntry(path))->cage->current, placed);
}

// What is only half done is not kept as an edit: no question about it, no step.
void RealFilesTest::aNewFileGivesUpTheDrag() {
    hand().moveTo(vertex(1));
    hand().press();
    hand().moveTo(vertex(1) + QPoint(40, -30));
    QTRY_VERIFY(document().isModified());
    hand().key("Control+n");
    QTRY_COMPARE(fractal().name, document::sierpinskiTriangle().name);
    const document::Fractal fresh = fractal();
    hand().moveTo(vertex(1) + QPoint(-30, -60));
    hand().release();
    QVERIFY(fractal() == fresh);
    QCOMPARE(steps(), 0);
    QVERIFY(!visible<QDialog>());
}

void RealFilesTest::aFileIsDroppedFromAnotherProgram() {
    QProcess other;
    other.start(support::buildPath(QStringLiteral("tests/support/drag_source")),
                {support::testData(QStringLiteral("shapes.ifs"))});
    QByteArray said;
    const auto says = [&](const char* word) {
        return support::waitFor([&] {
            said += other.readAllStandardOutput();
            return said.contains(word);
        });
    };
    QVERIFY(says("ready"));
    const QPoint target = middleOf(canvas().viewport());
    const QPoint source(60, 890);
    hand().moveTo(source);
    hand().press();
    hand().moveTo(source + QPoint(12, -4));
    QVERIFY(says("drags"));
    const DragWatch watch;
    for (const double part : {0.2, 0.5, 0.8, 0.97, 1.0})
        hand().moveTo(source + (target - source) * part);
    QTRY_COMPARE(watch.position(), std::optional(target));
    photograph(QStringLiteral("drop.png"));
    hand().release();
    QTRY_COMPARE(window().windowTitle().section(QLatin1Char('['), 0, 0), QStringLiteral("shapes.ifs"));
    QVERIFY(says("copied"));
    QVERIFY(!window().isWindowModified());
    other.terminate();
    other.waitForFinished();
}

void RealFilesTest::aFileIsOpenedByItsName_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("collection") << QStringLiteral("pair.ifs")
                                << QByteArray("pair {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }\n");
    QTest::newRow("flame") << QStringLiteral("pair.flame")
                           << QByteArray("<flame name=\"pair\"><xform weight=\"1\" linear=\"1\" "
                                         "coefs=\"0.5 0 0 0.5 0 0\"/><xform weight=\"1\" linear=\"1\" "
                                         "coefs=\"0.5 0 0 0.5 0.5 0\"/></flame>");
    QTest::newRow("table") << QStringLiteral("pair.csv")
                           << QByteArray("a,b,c,d,e,f,p\n.5,0,0,.5,0,0,.5\n.5,0,0,.5,.5,0,.5\n");
}

void RealFilesTest::aFileIsOpenedByItsName() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    const QString path = put(file, bytes);
    const bool answered = answer<QFileDialog>([&] { hand().key("Control+o"); },
                                              [&](QFileDialog&) {
                                                  hand().type(path);
                                                  hand().key("Return");
                                              });
    QVERIFY(answered);
    QTRY_COMPARE(code().maps.size(), std::size_t{2});
    QCOMPARE(code().maps[1].map.translation, Vector<2>(0.5, 0));
    QVERIFY(!window().isWindowModified());
}

void RealFilesTest::aRecentFileIsOpened() {
    window().openPath(copyOfCollection(QStringLiteral("dragons")));
    window().openPath(copyOfCollection(QStringLiteral("trees")));
    choose({QStringLiteral("File"), QStringLiteral("Open Recent"), QStringLiteral("dragons.ifs")});
    QTRY_COMPARE(QFileInfo(window().path()).fileName(), QStringLiteral("dragons.ifs"));
    QCOMPARE(fractal().name, QStringLiteral("heighway_dragon"));
}

void RealFilesTest::aBrokenEntryIsToldAndKept() {
    const QByteArray broken = "broken {\n .5 0 0\n .5 nonsense }\n";
    const QString path =
        put(QStringLiteral("half.ifs"), broken + "whole {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }\n");
    window().openPath(path);
    QCOMPARE(fractal().name, QStringLiteral("whole"));
    QVERIFY(window().findChild<view::ProblemsPanel*>()->isVisible());
    dragBy(vertex(1), {-40, -30});
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QVERIFY(io::loadFile(path).bytes.startsWith(broken));
    QCOMPARE(document::plane(savedEntry(path))->cage, document::plane(fractal())->cage);
}

void RealFilesTest::unsavedWorkIsAskedAbout() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    dragBy(vertex(1), {-40, -30});
    QTRY_VERIFY(window().isWindowModified());
    const bool stayed =
        answer<QMessageBox>([&] { hand().key("Control+w"); }, [&](QMessageBox&) { hand().key("Escape"); });
    QVERIFY(stayed);
    QVERIFY(window().isVisible());
    const std::vector<Vector<2>> placed = vertices();
    const bool saved = answer<QMessageBox>([&] { hand().key("Control+n"); },
                                           [&](QMessageBox& box) { click(box.button(QMessageBox::Save)); });
    QVERIFY(saved);
    QTRY_COMPARE(fractal().name, document::sierpinskiTriangle().name);
    QCOMPARE(
        document::plane(*io::readFractint(io::loadFile(path).bytes).entries.first().fractal)->cage->current,
        placed);
}

void RealFilesTest::anotherWindowIsAnotherDocument() {
    const document::Fractal before = fractal();
    hand().key("Control+Shift+n");
    QTRY_VERIFY(another());
    QVERIFY(QTest::qWaitForWindowActive(another()));
    hand().key("Control+n");
    QTRY_COMPARE(another()->document().fractal().name, document::sierpinskiTriangle().name);
    QVERIFY(fractal() == before);
    hand().key("Control+w");
    QTRY_VERIFY(!another());
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    dragBy(vertex(1), {-40, -30});
    QTRY_COMPARE(steps(), 1);
}

void RealFilesTest::theWelcomeOffersTheLastFile() {
    const QString path = copyOfCollection(QStringLiteral("dragons"));
    recent_files::add(path);
    QSettings().setValue(QStringLiteral("hints/firstDrag"), true); // not the first run
    static_cast<Application*>(qApp)->openWindows({}, Application::Start::New);
    QTRY_VERIFY(another());
    QVERIFY(QTest::qWaitForWindowActive(another()));
    click(named<QCommandLinkButton>(*another(), QStringLiteral("dragons.ifs")));
    QTRY_COMPARE(another()->path(), path);
    QTRY_VERIFY(another()->findChildren<QCommandLinkButton*>().isEmpty()); // the banner is gone
    close(another());
}

// The other program is this one again. It is killed while its work is not saved; then it is offered here.
void RealFilesTest::workIsRecoveredAfterAKill() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const QPoint start = vertex(1);
    const std::vector<Vector<2>> held = vertices();
    const double scale = pixelsPerUnit();
    window().hide();

    QProcess other;
    other.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("real_files_test"), QStringLiteral("--edit"), path});
    const auto says = [&](const char* word) {
        QByteArray said;
        return support::waitFor([&] {
            said += other.readAllStandardOutput();
            return said.contains(word);
        });
    };
    QVERIFY(says("ready"));
    dragBy(start, {-60, -45});
    QVERIFY(says("changed"));
    const QDir journals(Recovery::folder());
    const auto isMoved = [&](const std::optional<Vector<2>>& corner) {
        return corner && ((*corner - held[1]) * scale - Vector<2>(-60, 45)).norm() < 2;
    };
    QVERIFY(support::waitFor([&] { // until the end of the drag is kept
        for (const QString& name : journals.entryList({QStringLiteral("*.journal")}, QDir::Files)) {
            const auto kept = document::snapshotIn(io::loadFile(journals.filePath(name)).bytes);
            if (kept && isMoved(cornerIn(kept->bytes, 1))) return true;
        }
        return false;
    }));
    other.kill();
    QVERIFY(other.waitForFinished());

    const bool recovered = answer<QMessageBox>([&] { static_cast<Application*>(qApp)->openWindows({}); },
                                               [&](QMessageBox& box) {
                                                   photograph(QStringLiteral("recover.png"));
                                                   click(named<QPushButton>(box, QStringLiteral("Recover")));
                                               });
    QVERIFY(recovered);
    QTRY_VERIFY(another());
    QCOMPARE(another()->path(), path);
    QVERIFY(another()->isWindowModified());
    const Vector<2> moved =
        (document::effectiveCage(another()->document().fractal()).current[1] - held[1]) * scale;
    QVERIFY2((moved - Vector<2>(-60, 45)).norm() < 2,
             qPrintable(QStringLiteral("moved by %1, %2").arg(moved.x()).arg(moved.y())));
    QVERIFY(QTest::qWaitForWindowActive(another()));
    hand().key("Control+s");
    QTRY_VERIFY(!another()->isWindowModified());
    QVERIFY(
        document::plane(*io::readFractint(io::loadFile(path).bytes).entries.first().fractal)->cage->current !=
        document::plane(*io::readFractint(io::loadFile(path).bytes).entries.first().fractal)->cage->rest);
    close(another());
    window().show();
}

namespace {

int edit(int& argc, char** argv) {
    Application application(argc, argv);
    support::useTestFolders();
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.setGeometry(20, 40, 1300, 800);
    window.openPath(QCoreApplication::arguments().value(2));
    window.show();
    if (!QTest::qWaitForWindowActive(&window)) return 1;
    if (!support::waitFor([&] { return support::isInPlace(&window); })) return 1;
    support::handleEvents(); // it is laid out
    window.findChild<view::CanvasView*>()->fit();
    support::handleEvents();
    const auto say = [](const char* word) {
        std::puts(word);
        std::fflush(stdout);
    };
    QObject::connect(window.document().undoStack(), &QUndoStack::indexChanged, qApp,
                     [say] { say("changed"); });
    say("ready");
    return QApplication::exec();
}

} // namespace

static int runRealFiles(int argc, char** argv) {
    if (argc > 1 && QByteArray(argv[1]) == "--edit") return edit(argc, argv);
    return support::runOnX<RealFilesTest>(argc, argv);
}

static const support::NamedTest namedRealFiles(__FILE__, runRealFiles);

#include "real_files_test.moc"
