// SPDX-License-Identifier: MIT
#include "support/window_on_x.h"

#include "attractor/request/camera.h"
#include "canvas/scene/canvas_scene.h"
#include "io/file/save_file.h"
#include "io/fractint/fractint_reader.h"
#include "support/background_rest.h"
#include "support/forget_settings.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QTabBar>
#include <QTimer>

#include <cmath>

namespace support {

namespace {

QAction* actionNamed(const QWidget* menu, const QString& name) {
    for (QAction* action : menu->actions())
        if (action->text().remove(u'&').section(u'\t', 0, 0) == name) return action;
    qFatal("no menu entry %s", qPrintable(name));
}

} // namespace

bool KeyPresses::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
        const quint64 time = static_cast<QKeyEvent*>(event)->timestamp();
        if (std::exchange(m_last, time) != time) ++m_count;
    }
    return QObject::eventFilter(watched, event);
}

bool waitFor(const std::function<bool()>& condition) {
    QElapsedTimer since;
    since.start();
    while (!condition()) {
        if (since.elapsed() > 20'000) return false;
        QEventLoop loop;
        QTimer::singleShot(10, &loop, &QEventLoop::quit);
        loop.exec();
    }
    return true;
}

void WindowOnX::openWindow() {
    if (const QString obstacle = XInput::obstacle(); !obstacle.isEmpty()) QSKIP(qPrintable(obstacle));
    support::forgetSettings();
    m_hand = std::make_unique<XInput>();
    m_window = new MainWindow;
    m_window->setGeometry(20, 40, 1300, 800);
    m_window->openFirstPicture();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window));
    QVERIFY(waitFor([this] { return isInPlace(m_window); }));
    QVERIFY(backgroundRests()); // it is laid out, and shows what it opened
    canvas().fit();
}

void WindowOnX::closeWindow() {
    if (!m_window) return;
    m_hand.reset();
    document().undoStack()->setClean(); // nothing to ask about but snapshots
    QTimer discarding;
    QObject::connect(&discarding, &QTimer::timeout, &discarding, [] {
        const auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box && box->informativeText().startsWith(QStringLiteral("Snapshots")))
            box->button(QMessageBox::Discard)->click();
    });
    discarding.start(20);
    m_window->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(!m_window);
    const QStringList late = watchdog().takeLate();
    QVERIFY2(late.isEmpty(), qPrintable(late.join(u'\n')));
}

view::CanvasView& WindowOnX::canvas() const {
    return *m_window->findChild<view::CanvasView*>();
}

QPoint WindowOnX::onScreen(const ifs::Vector<2>& world) const {
    const ifs::Vector<2> pixel = attractor::toPixel(canvas().camera(), world) / canvas().devicePixelRatioF();
    return onCanvas({qRound(pixel.x()), qRound(pixel.y())});
}

QPoint WindowOnX::handle(const view::CanvasPart& part) const {
    return onCanvas(canvas().canvas().positionOf(part).toPoint());
}

QPoint WindowOnX::vertex(int index) const {
    return onScreen(cage().current[std::size_t(index)]);
}

QString WindowOnX::copyOfCollection(const QString& name) {
    QString path = m_folder.filePath(name + QStringLiteral(".ifs"));
    QFile::remove(path);
    if (!QFile::copy(QStringLiteral(":/ifs_library/%1.ifs").arg(name), path)) return {};
    QFile(path).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    return path;
}

document::Fractal WindowOnX::savedEntry(const QString& path) const {
    const qsizetype index = document::indexOf(document().file(), document().currentId());
    return *io::readFractint(io::loadFile(path).bytes).entries.at(index).fractal;
}

double WindowOnX::pixelsPerUnit() const {
    return canvas().camera().pixelsPerUnit;
}

double WindowOnX::offsetInPixels(const ifs::Vector<2>& after, const ifs::Vector<2>& before,
                                 const QPoint& by) const {
    const ifs::Vector<2> offset = (after - before) * pixelsPerUnit();
    return std::hypot(offset.x() - by.x(), offset.y() + by.y()); // y is up in the plane
}

void WindowOnX::dragBy(const QPoint& start, const QPoint& by) {
    hand().drag(start, {start + by / 4, start + by * 2 / 3, start + by});
}

void WindowOnX::zoomOut(int notches) {
    constexpr double notchesToHalf = 4;
    const double wanted = pixelsPerUnit() * std::exp2(-notches / notchesToHalf);
    hand().moveTo(middleOf(canvas().viewport()));
    hand().wheel(-notches);
    QVERIFY(waitFor([&] { return std::abs(pixelsPerUnit() / wanted - 1) < 1e-6; }));
}

void WindowOnX::clickOn(QAbstractItemView* list, const QModelIndex& index) {
    list->scrollTo(index);
    hand().clickAt(list->viewport()->mapToGlobal(list->visualRect(index).center()));
}

void WindowOnX::type(QWidget* field, const QString& text) {
    click(field);
    hand().key("Control+a");
    hand().type(text);
    hand().key("Tab");
}

void WindowOnX::pickRow(QComboBox* box, int row) {
    QVERIFY(row >= 0);
    click(box);
    hand().key("Home");
    for (int i = 0; i < row; ++i)
        hand().key("Down");
    hand().key("Return");
    QVERIFY(waitFor([&] { return box->currentIndex() == row; }));
}

QAction* WindowOnX::chooseFrom(const QMenu* menu, const QString& name) {
    waitFor([&] { return menu->isVisible(); });
    QAction* action = actionNamed(menu, name);
    hand().clickAt(menu->mapToGlobal(menu->actionGeometry(action).center()));
    return action;
}

void WindowOnX::showPanel(const QString& title) {
    for (const auto* dock : m_window->findChildren<QDockWidget*>())
        if (dock->windowTitle() == title && dock->isHidden()) {
            choose({QStringLiteral("View"), QStringLiteral("Panels"), title});
            QVERIFY(waitFor([&] { return dock->isVisible(); }));
            return handleEvents(); // it is laid out
        }
    for (const auto* tabs : m_window->findChildren<QTabBar*>())
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabText(i) == title) {
                hand().clickAt(tabs->mapToGlobal(tabs->tabRect(i).center()));
                QVERIFY(waitFor([&] { return tabs->currentIndex() == i; }));
                return handleEvents(); // it is laid out
            }
    qFatal("no tab %s", qPrintable(title));
}

QDialog* WindowOnX::openDialog(const char* shortcut, const char* className) {
    hand().key(shortcut);
    QDialog* found = nullptr;
    waitFor([&] {
        for (auto* dialog : m_window->findChildren<QDialog*>())
            if (isInPlace(dialog) && QByteArray(dialog->metaObject()->className()) == className)
                found = dialog;
        return found != nullptr;
    });
    handleEvents(); // it is laid out
    return found;
}

void WindowOnX::choose(const QStringList& path) {
    QAction* action = actionNamed(m_window->menuBar(), path.first());
    hand().clickAt(m_window->menuBar()->mapToGlobal(m_window->menuBar()->actionGeometry(action).center()));
    for (const QString& name : path.mid(1))
        action = chooseFrom(action->menu(), name);
}

void WindowOnX::photograph(const QString& name) const {
    const QString folder = qEnvironmentVariable("BARYCAGE_KEEP");
    if (!folder.isEmpty()) QVERIFY(m_window->screen()->grabWindow().save(folder + u'/' + name));
}

void useTestFolders() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Barycage"));
    QCoreApplication::setApplicationName(QStringLiteral("BarycageTest"));
}

int runOnX(QObject& test, int& argc, char** argv) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QStandardPaths::setTestModeEnabled(true);
    WatchedApplication application(argc, argv);
    useTestFolders();
    QApplication::setQuitOnLastWindowClosed(false); // tests close and open windows
    const int failures = QTest::qExec(&test, argc, argv);
    qInfo("%s", qPrintable(application.summary()));
    return failures;
}

} // namespace support
