// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_scene.h"
#include "document/background/background_threads.h"
#include "io/exchange/text_formats.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "support/complaints.h"
#include "support/forget_settings.h"
#include "support/paths.h"
#include "support/window_on_x.h"

#include <QClipboard>
#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPrintPreviewDialog>
#include <QRandomGenerator>
#include <QSet>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <malloc.h>
#include <string>

using support::Complaint;
using support::WindowOnX;
using support::XInput;
using view::CanvasPart;

namespace {

// A square of `side` times `side` small copies.
std::shared_ptr<const document::Fractal> square(int side) {
    document::System2 system;
    for (int i = 0; i < side * side; ++i) {
        ifs::WeightedMap<2> map;
        map.id = static_cast<ifs::MapId>(i + 1);
        map.map.linear = ifs::Matrix<2>::Identity() / (1.5 * side);
        map.map.translation = ifs::Vector<2>(i % side, i / side) / side;
        system.maps.push_back(map);
    }
    document::Fractal fractal;
    fractal.name = QStringLiteral("square%1").arg(side);
    fractal.shape = document::Shape<2>{system};
    return std::make_shared<const document::Fractal>(fractal);
}

QByteArray manyEntries(int count) {
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += "entry" + QByteArray::number(i) + " {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 .5 0 .3\n .4 .1 0 .5 ." +
                QByteArray::number(i % 97) + " .4 .4\n}\n";
    return text;
}

// malloc_trim() gives back what threads have freed of the first arena alone; there is no other.
[[maybe_unused]] const int oneArena = mallopt(M_ARENA_MAX, 1);

// Without the pages of libraries, which come as they are first used.
double anonymousMegabytes() {
    malloc_trim(0);
    std::ifstream status("/proc/self/status");
    std::string word;
    double kilobytes = 0;
    while (status >> word)
        if (word == "RssAnon:") status >> kilobytes;
    return kilobytes * 1024 / 1e6;
}

} // namespace

// A monkey at the desk: seeded random pointing, typing and choosing, on a real X server. After each of its
// actions the documents must be in order. BARYCAGE_MONKEY_SECONDS: for how long, 15 without;
// BARYCAGE_MONKEY_SEED: another course; BARYCAGE_MONKEY_LOG: what it does, as it does it; BARYCAGE_CORPUS: a
// folder of files that it opens as well.
class MonkeyTest : public WindowOnX {
    Q_OBJECT

private slots:
    void initTestCase();
    void nothingBreaks();

private:
    void makeLargeFiles();
    void put(const QString& name, const QByteArray& bytes);
    using Operation = std::function<void()>;

    void step();
    void plan();
    void planDrag();
    void planKeys();
    void planClick();
    void planWheel();
    void planMenu();
    void planClipboard();
    void planFile();
    void planDialog(QDialog* dialog);
    void then(Operation operation) { m_todo.append(std::move(operation)); }
    // What may wait for the user: the timer of the steps does not fire again before it returns.
    void thenInAnEventOfItsOwn(const Operation& operation) {
        then([operation] { QTimer::singleShot(0, qApp, operation); });
    }
    void note(const QString& action);
    void complain(const Complaint& complaint);

    void check();
    void checkHistory(MainWindow& window);
    void startAfresh();
    void follow(MainWindow* window);
    MainWindow* current() const;
    QList<MainWindow*> windows() const;

    int any(int count) { return int(m_random.bounded(count)); }
    template <typename List> auto oneOf(const List& list) { return list[any(int(list.size()))]; }
    QPoint pointIn(const QWidget* widget);
    QPoint pointOnCanvas();

    QRandomGenerator m_random;
    std::unique_ptr<XInput> m_fingers;
    QStringList m_large;     // files that it made
    QStringList m_strangers; // and those of others
    QList<Operation> m_todo;
    QStringList m_actions; // the last ones
    QStringList m_complaints;
    QSet<MainWindow*> m_live; // with a gesture under way
    QList<double> m_megabytes;
    int m_count = 0;
    int m_sinceStart = 0;
    int m_ownLevel = 0; // of event loops, in that of the test
};

namespace {

QtMessageHandler otherHandler = nullptr;
QStringList warnings;

void takeWarning(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (type == QtWarningMsg || type == QtCriticalMsg) warnings << text;
    otherHandler(type, context, text);
}

} // namespace

void MonkeyTest::initTestCase() {
    if (const QString obstacle = XInput::obstacle(); !obstacle.isEmpty()) QSKIP(qPrintable(obstacle));
    support::forgetSettings();
    QDir::setCurrent(folder()); // whatever it writes stays there
    for (const QFileInfo& file : QDir(support::testData()).entryInfoList({QStringLiteral("*.ifs")}))
        QFile::copy(file.filePath(), QDir(folder()).filePath(file.fileName()));
    copyOfCollection(QStringLiteral("paper"));
    copyOfCollection(QStringLiteral("ferns"));
    makeLargeFiles();
    if (const QString corpus = qEnvironmentVariable("BARYCAGE_CORPUS"); !corpus.isEmpty()) {
        QDirIterator files(corpus, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext())
            m_strangers << files.next();
        m_strangers.sort(); // the same course for the same seed
    }
    m_fingers = std::make_unique<XInput>(std::chrono::milliseconds(0));
}

void MonkeyTest::makeLargeFiles() {
    const std::shared_ptr<const document::Fractal> large = square(100);
    put(QStringLiteral("maps.ifs"), io::writeFractint(document::fileOf(*large)));
    put(QStringLiteral("entries.ifs"), manyEntries(2000));
    for (const io::TextFormat format : {io::TextFormat::Flame, io::TextFormat::Csv})
        put(QStringLiteral("maps.") + io::suffixOf(format), io::textOf({square(40)}, format, {}));
}

void MonkeyTest::put(const QString& name, const QByteArray& bytes) {
    m_large << QDir(folder()).filePath(name);
    QFile file(m_large.last());
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

void MonkeyTest::nothingBreaks() {
    const int seconds = qEnvironmentVariable("BARYCAGE_MONKEY_SECONDS", QStringLiteral("15")).toInt();
    const auto seed = qEnvironmentVariable("BARYCAGE_MONKEY_SEED", QStringLiteral("1")).toUInt();
    m_random.seed(seed);
    otherHandler = qInstallMessageHandler(takeWarning);
    QEventLoop loop;
    m_ownLevel = QThread::currentThread()->loopLevel() + 1;
    QElapsedTimer clock;
    clock.start();
    QTimer steps;
    connect(&steps, &QTimer::timeout, this, [&] {
        watchdog().ignoreThisEvent();
        // The loops of dialogs that are open end first: they are inside this one.
        if (!m_complaints.isEmpty() || clock.elapsed() > 1000LL * seconds) {
            for (QWidget* widget : QApplication::topLevelWidgets())
                if (auto* dialog = qobject_cast<QDialog*>(widget)) dialog->reject();
            if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
            loop.quit();
        } else {
            step();
        }
    });
    startAfresh();
    steps.start(6);
    loop.exec();
    steps.stop();
    m_fingers.reset();
    qInstallMessageHandler(otherHandler);
    for (MainWindow* window : windows())
        delete window;
    qInfo("seed %u: %d actions", seed, m_count);

    m_complaints += watchdog().takeLate();
    if (!m_complaints.isEmpty()) qInfo("after\n  %s", qPrintable(m_actions.join(QStringLiteral("\n  "))));
    QVERIFY2(m_complaints.isEmpty(), qPrintable(m_complaints.join(u'\n')));
#if !defined(__SANITIZE_ADDRESS__)
    // What is first used, and kept, comes at some restarts; what leaks, at each. Caches fill in the first
    // half.
    QStringList all;
    QList<double> grown;
    for (qsizetype i = 0; i < m_megabytes.size(); ++i) {
        all << QString::number(m_megabytes[i], 'f', 1);
        if (i >= m_megabytes.size() / 2 && i > 0) grown << m_megabytes[i] - m_megabytes[i - 1];
    }
    const QString resident = QStringLiteral("megabytes: ") + all.join(u' ');
    qInfo("%s", qPrintable(resident));
    if (m_megabytes.size() >= 6) {
        const auto median = grown.begin() + grown.size() / 2;
        std::nth_element(grown.begin(), median, grown.end());
        QVERIFY2(*median < 4, qPrintable(resident));
    }
#endif
}

QList<MainWindow*> MonkeyTest::windows() const {
    QList<MainWindow*> found;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* window = qobject_cast<MainWindow*>(widget)) found << window;
    return found;
}

MainWindow* MonkeyTest::current() const {
    const QList<MainWindow*> all = windows();
    for (MainWindow* window : all)
        if (window->isActiveWindow()) return window;
    return all.value(0);
}

void MonkeyTest::note(const QString& action) {
    ++m_count;
    m_actions << action;
    if (m_actions.size() > 30) m_actions.removeFirst();
    if (qEnvironmentVariableIsSet("BARYCAGE_MONKEY_LOG")) qInfo("%s", qPrintable(action));
}

void MonkeyTest::complain(const Complaint& complaint) {
    if (!complaint.isEmpty()) m_complaints << complaint;
}

// All windows closed, nothing unsaved: what is still in memory is what stays there.
void MonkeyTest::startAfresh() {
    for (MainWindow* window : windows()) {
        window->document().undoStack()->setClean();
        delete window;
    }
    m_live.clear();
    m_sinceStart = 0;
    QGuiApplication::clipboard()->clear();
    document::backgroundFinishes(std::chrono::seconds(30)); // what was let go is freed there
    m_megabytes << anonymousMegabytes();
    auto* window = new MainWindow;
    window->setGeometry(20, 40, 1300, 800);
    window->openFirstPicture();
    window->show();
    follow(window);
}

void MonkeyTest::follow(MainWindow* window) {
    connect(&window->document(), &document::Document::changed, this, [this, window](const auto& change) {
        using document::Change;
        const bool isOther = bool(change.parts & (Change::Current | Change::File));
        if (change.parts & Change::Time && !isOther) return; // time runs or stops, whatever the gesture does
        if (change.live)
            m_live.insert(window);
        else
            m_live.remove(window);
    });
    connect(window, &QObject::destroyed, this, [this, window] { m_live.remove(window); });
}

void MonkeyTest::step() {
    if (m_todo.isEmpty()) {
        check();
        if (m_complaints.isEmpty()) plan();
    } else {
        m_todo.takeFirst()();
    }
}

void MonkeyTest::check() {
    for (const QString& warning : std::exchange(warnings, {}))
        complain(QStringLiteral("warning: ") + warning);
    for (MainWindow* window : windows()) {
        const document::Document& document = window->document();
        if (window->property("checked").toULongLong() != document.revision()) {
            window->setProperty("checked", qulonglong(document.revision()));
            for (const document::Entry& entry : document.file().entries)
                complain(support::complaintAbout(*entry.fractal));
            complain(support::complaintAbout(document.file(),
                                             QFileInfo(window->windowFilePath()).completeBaseName()));
        }
        const attractor::Camera& camera = window->findChild<view::CanvasView*>()->camera();
        if (!camera.centre.allFinite() || !(camera.pixelsPerUnit > 0) || !std::isfinite(camera.pixelsPerUnit))
            complain(QStringLiteral("the camera is nowhere"));
        if (!m_live.contains(window) && window->isWindowModified() != document.isModified())
            complain(QStringLiteral("the mark of unsaved changes is wrong"));
        if (!m_live.contains(window) && !QApplication::activeModalWidget() &&
            !QApplication::activePopupWidget() && QGuiApplication::mouseButtons() == Qt::NoButton)
            checkHistory(*window);
    }
}

// One step, and now and then the whole history, back and forth.
void MonkeyTest::checkHistory(MainWindow& window) {
    QUndoStack& history = *window.document().undoStack();
    const document::FractalFile before = window.document().file();
    const int place = history.index();
    if (place == 0) return;
    history.setIndex(any(40) == 0 ? 0 : place - 1);
    history.setIndex(place);
    document::FractalFile after = window.document().file();
    // What was remarked when the file was last read or saved is not part of the history.
    after.problems = before.problems;
    if (after.entries.size() == before.entries.size())
        for (qsizetype i = 0; i < after.entries.size(); ++i)
            after.entries[i].problems = before.entries[i].problems;
    if (after == before) return;
    QString what = QStringLiteral("undo and redo do not lead back: %1").arg(history.undoText());
    if (history.index() != place) what += QStringLiteral(", step %1 of %2").arg(history.index()).arg(place);
    if (after.entries.size() != before.entries.size()) what += QStringLiteral(", other number of entries");
    for (qsizetype i = 0; i < std::min(after.entries.size(), before.entries.size()); ++i) {
        const document::Entry &a = before.entries[i], &b = after.entries[i];
        if (a.id != b.id) what += QStringLiteral(", id %1").arg(i);
        if (a.source != b.source) what += QStringLiteral(", source %1").arg(i);
        if (const auto parts = document::difference(*a.fractal, *b.fractal))
            what += QStringLiteral(", fractal %1: parts %2").arg(i).arg(int(parts));
    }
    complain(what);
}

QPoint MonkeyTest::pointIn(const QWidget* widget) {
    return widget->mapToGlobal(QPoint(any(std::max(1, widget->width())), any(std::max(1, widget->height()))));
}

QPoint MonkeyTest::pointOnCanvas() {
    const auto* canvas = current()->findChild<view::CanvasView*>();
    const std::vector<CanvasPart> handles = canvas->canvas().handles().parts();
    if (handles.empty() || any(3) == 0) return pointIn(canvas->viewport());
    CanvasPart part = handles[std::size_t(any(int(handles.size())))];
    if (any(5) == 0) part.kind = CanvasPart::Kind::Edge;
    if (part.kind == CanvasPart::Kind::Edge && part.index >= int(canvas->canvas().cagePolygon().size()))
        part.index = 0;
    const QPoint at = canvas->viewport()->mapToGlobal(canvas->canvas().positionOf(part).toPoint());
    const QRect shown(canvas->viewport()->mapToGlobal(QPoint(0, 0)), canvas->viewport()->size());
    return shown.contains(at) ? at : pointIn(canvas->viewport());
}

void MonkeyTest::plan() {
    // Not while the program waits in a loop of its own.
    const bool mayStartAfresh = QThread::currentThread()->loopLevel() == m_ownLevel;
    if (mayStartAfresh && (++m_sinceStart > 250 || windows().size() > 2 || !current())) {
        startAfresh();
        if (any(2)) planFile();
        return;
    }
    if (!current()) return then([this] { m_fingers->key("Escape"); });
    for (MainWindow* window : windows())
        if (!window->property("followed").toBool()) {
            window->setProperty("followed", true);
            follow(window);
        }
    if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) return planDialog(dialog);
    if (QApplication::activePopupWidget() && any(2) == 0) {
        note(QStringLiteral("leave the menu"));
        return then([this] { m_fingers->key("Escape"); });
    }
    const int what = any(100);
    if (what < 35)
        planDrag();
    else if (what < 60)
        planKeys();
    else if (what < 80)
        planClick();
    else if (what < 86)
        planWheel();
    else if (what < 94)
        planMenu();
    else if (what < 97)
        planClipboard();
    else
        planFile();
}

void MonkeyTest::planDrag() {
    const QPoint from = pointOnCanvas();
    const char* modifier = oneOf(QList<const char*>{"", "", "", "Control", "Alt", "Shift"});
    const XInput::Button button = any(6) == 0 ? XInput::Middle : XInput::Left;
    note(QStringLiteral("drag from %1 %2 with button %3 %4")
             .arg(from.x())
             .arg(from.y())
             .arg(button)
             .arg(QLatin1String(modifier)));
    if (*modifier) then([=, this] { m_fingers->hold(modifier); });
    then([=, this] { m_fingers->moveTo(from); });
    then([=, this] { m_fingers->press(button); });
    for (int moves = 1 + any(6); moves > 0; --moves) {
        const QPoint to = any(2) ? from + QPoint(any(200) - 100, any(200) - 100) : pointOnCanvas();
        then([=, this] { m_fingers->moveTo(to); });
    }
    if (any(6) == 0) {
        const char* key = oneOf(QList<const char*>{"Escape", "Control+z", "Control+n", "Control+s", "f",
                                                   "Tab", "Left", "d", "h", "y"});
        note(QStringLiteral("in mid-drag ") + QLatin1String(key));
        then([=, this] { m_fingers->key(key); });
        then([=, this] { m_fingers->moveTo(from + QPoint(7, 9)); });
    }
    then([=, this] { m_fingers->release(button); });
    if (*modifier) then([=, this] { m_fingers->letUp(modifier); });
}

void MonkeyTest::planKeys() {
    static const QList<QByteArray> keys =
        QByteArrayLiteral(
            "Tab Tab Tab Shift+Tab Left Right Up Down Shift+Up Alt+Left Return Return Escape "
            "Escape 1 2 0 period minus 9 e BackSpace Delete Insert Home End Next Prior space F2 "
            "F6 F11 c d f g a y h plus Alt+Up Alt+Down Control+z Control+z Control+y Control+a "
            "Control+c Control+v Control+Shift+v Control+b Control+x Control+Insert Control+k "
            "Control+slash")
            .split(' ');
    QStringList pressed;
    for (int count = 1 + any(4); count > 0; --count) {
        const QByteArray key = oneOf(keys);
        pressed << QLatin1String(key);
        then([=, this] { m_fingers->key(key.constData()); });
    }
    note(QStringLiteral("keys ") + pressed.join(u' '));
}

void MonkeyTest::planClick() {
    QWidget* top = QApplication::activePopupWidget();
    if (!top) top = QApplication::activeWindow();
    if (!top) top = current();
    QList<QWidget*> targets;
    for (auto* child : top->findChildren<QWidget*>())
        if (child->isVisible() && child->window() == top && child->focusPolicy() != Qt::NoFocus &&
            !child->visibleRegion().isEmpty())
            targets << child;
    targets << top;
    const QWidget* target = oneOf(targets);
    const QPoint at = pointIn(target);
    const int kind = any(8);
    note(QStringLiteral("%1 %2 %3 at %4 %5")
             .arg(kind == 0   ? QStringLiteral("right-click")
                  : kind == 1 ? QStringLiteral("double-click")
                              : QStringLiteral("click"),
                  QLatin1String(target->metaObject()->className()), target->accessibleName())
             .arg(at.x())
             .arg(at.y()));
    if (kind == 1)
        then([=, this] { m_fingers->doubleClickAt(at); });
    else
        then([=, this] { m_fingers->clickAt(at, kind == 0 ? XInput::Right : XInput::Left); });
}

void MonkeyTest::planWheel() {
    const QPoint at = any(3) ? pointOnCanvas() : pointIn(current());
    const int notches = any(13) - 6;
    note(QStringLiteral("wheel %1").arg(notches));
    then([=, this] {
        m_fingers->moveTo(at);
        m_fingers->wheel(notches);
    });
}

// By its shortcut or its name: what cannot be chosen is not.
void MonkeyTest::planMenu() {
    QList<QAction*> actions;
    QList<QMenu*> menus = current()->menuBar()->findChildren<QMenu*>();
    for (QMenu* menu : menus)
        for (QAction* action : menu->actions())
            if (!action->isSeparator() && !action->menu() && action->isEnabled()) actions << action;
    if (actions.isEmpty()) return;
    const QPointer<QAction> action = oneOf(actions);
    note(QStringLiteral("choose ") + action->text());
    thenInAnEventOfItsOwn([=] {
        if (action && action->isEnabled() && !QApplication::activeModalWidget()) action->trigger();
    });
}

void MonkeyTest::planClipboard() {
    static const QStringList texts{
        QStringLiteral("0.5 0 0 0.5 0 0 0.5\n0.5 0 0 0.5 1 0 0.5\n"),
        QStringLiteral("0.3\t0.1\t-0.2\t0.6\t1\t0"),
        QStringLiteral("pasted {\n .5 0 0 .5 0 0 .33\n .5 0 0 .5 .5 0 .33\n .5 0 0 .5 .25 .43 .34\n}\n"),
        QStringLiteral("1e308 1e308 -1e308 5 nan inf 2"),
        QStringLiteral("no numbers at all"),
        QStringLiteral("1"),
    };
    const QString text = oneOf(texts);
    note(QStringLiteral("clipboard: ") + text.left(20));
    then([=] { QGuiApplication::clipboard()->setText(text); });
}

// What is saved stays in its own folder: the files of others are copied there.
void MonkeyTest::planFile() {
    QString path = QDir(folder()).filePath(oneOf(QDir(folder()).entryList(QDir::Files)));
    if (!m_strangers.isEmpty() && any(2)) {
        const QString stranger = oneOf(m_strangers);
        path = QDir(folder()).filePath(QStringLiteral("stranger.") + QFileInfo(stranger).suffix());
        note(QStringLiteral("copy ") + stranger);
        then([=] {
            QFile::remove(path);
            QFile::copy(stranger, path);
            QFile(path).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        });
    } else if (any(3) == 0) {
        path = oneOf(m_large);
    }
    note(QStringLiteral("open ") + path);
    const QPointer<MainWindow> window = current();
    thenInAnEventOfItsOwn([=] {
        if (window && !QApplication::activeModalWidget()) window->openPath(path);
    });
}

// Files are named inside its own folder, and nothing is printed.
void MonkeyTest::planDialog(QDialog* dialog) {
    const QString kind = QLatin1String(dialog->metaObject()->className());
    if (qobject_cast<QPrintPreviewDialog*>(dialog) || any(4) == 0) {
        note(QStringLiteral("leave ") + kind);
        return then([this] { m_fingers->key("Escape"); });
    }
    if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
        const QStringList names = QDir(folder()).entryList(QDir::Files);
        const QString name = any(2) ? oneOf(names) : QStringLiteral("new%1").arg(any(5));
        note(QStringLiteral("%1: %2").arg(kind, name));
        const QPointer<QFileDialog> open = files;
        then([=, this] {
            if (!open) return;
            open->setDirectory(folder());
            if (auto* field = open->findChild<QLineEdit*>()) field->setText(name);
            m_fingers->key("Return");
        });
        return then([=, this] {
            if (open && open->isVisible()) m_fingers->key("Escape");
        });
    }
    if (any(2))
        planClick();
    else
        planKeys();
}

BARYCAGE_TEST_ON_X(MonkeyTest);

#include "monkey_test.moc"
