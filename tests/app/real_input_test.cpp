// SPDX-License-Identifier: MIT
#include "attractor/camera.h"
#include "io/fractint_reader.h"
#include "io/save_file.h"
#include "main_window.h"

#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

// The gestures of the paper with a real pointer and real keys on a real X server: what is pressed here goes
// through the server and the window manager like a user's hand.
class RealInputTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();

    void draggingAVertexIsOneStep();
    void cursorIsAHandOverAVertexAndACrossElsewhere();
    void escapeTakesADragBack();
    void squeezedFlatAndReopenedIsExactlyTheSame();
    void threeClicksDefineTheTriangle();
    void draggedFractalSavesAndReopens();

private:
    QPoint onScreen(const ifs::Vector<2>& world) const;
    QPoint vertexOnScreen(std::size_t vertex) const;
    ifs::ControlCage<2> cage() const { return document::effectiveCage(fractal()); }
    const document::Fractal& fractal() const;
    view::CanvasView* canvas() const { return m_window->findChild<view::CanvasView*>(); }

    void moveTo(const QPoint& point);
    void drag(const QPoint& from, const QList<QPoint>& through);
    void press(const QString& key);
    void click(const QPoint& point);

    MainWindow* m_window = nullptr;
    QTemporaryDir m_folder;
};

namespace {

void xdotool(const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral("xdotool"), arguments);
    // The events must be handled while xdotool works: some of its commands wait for the window to answer.
    QTRY_VERIFY_WITH_TIMEOUT(process.state() == QProcess::NotRunning, 10'000);
    QTest::qWait(40);
}

} // namespace

void RealInputTest::initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Barycage"));
    QCoreApplication::setApplicationName(QStringLiteral("BarycageTest"));
    if (QGuiApplication::platformName() != QLatin1String("xcb")) QSKIP("needs an X server");
    if (QStandardPaths::findExecutable(QStringLiteral("xdotool")).isEmpty()) QSKIP("needs xdotool");
    QVERIFY(m_folder.isValid());
}

void RealInputTest::init() {
    m_window = new MainWindow;
    m_window->setGeometry(20, 40, 1300, 800);
    m_window->openFirstPicture();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window));
    QTest::qWait(300); // the window manager settles the geometry
    canvas()->fit();
}

void RealInputTest::cleanup() {
    if (!m_window) return;
    m_window->document().undoStack()->setClean(); // nothing to ask about
    m_window->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    m_window = nullptr;
}

const document::Fractal& RealInputTest::fractal() const {
    return m_window->document().fractal();
}

QPoint RealInputTest::onScreen(const ifs::Vector<2>& world) const {
    const ifs::Vector<2> pixel =
        attractor::toPixel(canvas()->camera(), world) / canvas()->devicePixelRatioF();
    return canvas()->viewport()->mapToGlobal(QPoint(qRound(pixel.x()), qRound(pixel.y())));
}

QPoint RealInputTest::vertexOnScreen(std::size_t vertex) const {
    return onScreen(cage().current[vertex]);
}

void RealInputTest::moveTo(const QPoint& point) {
    xdotool({QStringLiteral("mousemove"), QString::number(point.x()), QString::number(point.y())});
}

void RealInputTest::drag(const QPoint& from, const QList<QPoint>& through) {
    moveTo(from);
    xdotool({QStringLiteral("mousedown"), QStringLiteral("1")});
    for (const QPoint& point : through)
        moveTo(point);
    xdotool({QStringLiteral("mouseup"), QStringLiteral("1")});
}

void RealInputTest::press(const QString& key) {
    xdotool({QStringLiteral("key"), key});
}

void RealInputTest::click(const QPoint& point) {
    moveTo(point);
    xdotool({QStringLiteral("click"), QStringLiteral("1")});
}

void RealInputTest::draggingAVertexIsOneStep() {
    const document::Fractal before = fractal();
    const QPoint start = vertexOnScreen(1);
    drag(start, {start + QPoint(15, -10), start + QPoint(40, -30), start + QPoint(60, -55)});

    QTRY_COMPARE(m_window->document().undoStack()->count(), 1);
    const QPoint end = vertexOnScreen(1);
    QVERIFY((end - start - QPoint(60, -55)).manhattanLength() <= 2);
    QCOMPARE(fractal().system, before.system); // the code stays: the cage moves the picture

    press(QStringLiteral("ctrl+z"));
    QTRY_VERIFY(fractal() == before);
    press(QStringLiteral("ctrl+y"));
    QTRY_VERIFY((vertexOnScreen(1) - end).manhattanLength() <= 1);
}

void RealInputTest::cursorIsAHandOverAVertexAndACrossElsewhere() {
    const QPoint vertex = vertexOnScreen(0);
    moveTo(vertex);
    QTRY_COMPARE(canvas()->viewport()->cursor().shape(), Qt::OpenHandCursor);
    xdotool({QStringLiteral("mousedown"), QStringLiteral("1")});
    moveTo(vertex + QPoint(8, 8));
    QTRY_COMPARE(canvas()->viewport()->cursor().shape(), Qt::ClosedHandCursor);
    moveTo(vertex);
    xdotool({QStringLiteral("mouseup"), QStringLiteral("1")});
    moveTo(canvas()->viewport()->mapToGlobal(QPoint(12, canvas()->viewport()->height() / 2)));
    QTRY_COMPARE(canvas()->viewport()->cursor().shape(), Qt::CrossCursor);
}

void RealInputTest::escapeTakesADragBack() {
    const document::Fractal before = fractal();
    const QPoint start = vertexOnScreen(2);
    moveTo(start);
    xdotool({QStringLiteral("mousedown"), QStringLiteral("1")});
    moveTo(start + QPoint(50, 20));
    QTRY_VERIFY(fractal() != before);
    press(QStringLiteral("Escape"));
    QTRY_VERIFY(fractal() == before);
    xdotool({QStringLiteral("mouseup"), QStringLiteral("1")});
    QTRY_VERIFY(fractal() == before);
    QCOMPARE(m_window->document().undoStack()->count(), 0);
}

void RealInputTest::squeezedFlatAndReopenedIsExactlyTheSame() {
    const document::Fractal before = fractal();
    const ifs::ControlCage<2> held = cage();
    const QPoint start = vertexOnScreen(2);
    // Through the opposite edge (the middle of the other two vertices), to the mirror side, and home.
    const QPoint middle = (vertexOnScreen(0) + vertexOnScreen(1)) / 2;
    const QPoint mirrored = middle * 2 - start;
    drag(start, {middle, mirrored, middle, start + QPoint(20, 0), start});
    QTRY_COMPARE(cage().current, held.current);
    QTRY_VERIFY(fractal() == before);
    QCOMPARE(m_window->document().undoStack()->count(), 0);
}

void RealInputTest::threeClicksDefineTheTriangle() {
    const QPoint middle = canvas()->viewport()->mapToGlobal(canvas()->viewport()->rect().center());
    press(QStringLiteral("d"));
    QTRY_COMPARE(canvas()->tool(), view::CanvasView::Tool::DefineTriangle);
    const QList<QPoint> corners{middle + QPoint(-150, 120), middle + QPoint(160, 130),
                                middle + QPoint(10, -180)};
    for (const QPoint& corner : corners)
        click(corner);
    QTRY_COMPARE(canvas()->tool(), view::CanvasView::Tool::Cage);
    QTRY_COMPARE(m_window->document().undoStack()->count(), 1);
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY((vertexOnScreen(i) - corners[qsizetype(i)]).manhattanLength() <= 2);
}

void RealInputTest::draggedFractalSavesAndReopens() {
    const QString path = m_folder.filePath(QStringLiteral("dragged.ifs"));
    QVERIFY(QFile::copy(QStringLiteral(":/ifs_library/paper.ifs"), path));
    QFile(path).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    m_window->openPath(path);
    QTest::qWait(100);
    const QPoint start = vertexOnScreen(1);
    drag(start, {start + QPoint(-30, -40), start + QPoint(-60, -45)});
    const ifs::ControlCage<2> placed = cage();
    QVERIFY(m_window->isWindowModified());
    press(QStringLiteral("ctrl+s"));
    QTRY_VERIFY(!m_window->isWindowModified());

    const document::EntryId current = m_window->document().currentId();
    const qsizetype index = document::indexOf(m_window->document().file(), current);
    const document::FractalFile reread = io::readFractint(io::loadFile(path).bytes);
    QVERIFY(index >= 0 && index < reread.entries.size());
    QVERIFY(reread.entries[index].fractal->cage.has_value());
    QCOMPARE(reread.entries[index].fractal->cage->current, placed.current);
}

QTEST_MAIN(RealInputTest)
#include "real_input_test.moc"
