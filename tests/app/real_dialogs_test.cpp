// SPDX-License-Identifier: MIT
#include "canvas/canvas_scene.h"
#include "ifs/decomposition.h"
#include "io/collection_reader.h"
#include "io/save_file.h"
#include "support/paths.h"
#include "support/window_on_x.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPrintPreviewDialog>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>

#include <cmath>

// What goes through dialogs and through other programs, with a real pointer and real keys.
class RealDialogsTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void exportsPng();
    void exportsSvg();
    void anExportUnderWayIsCancelled();
    void transformsAsPlacement();
    void transformsAsCode();
    void printPreviewOpensAndCloses();
    void aFileIsDroppedFromAnotherProgram();

private:
    QDialog* openDialog(const char* shortcut, const char* className);
    void click(const QWidget* widget) { hand().clickAt(middleOf(widget)); }
    void exportAs(QDialog& dialog, const QString& path); // begins it
    static bool isWritten(const QDialog& dialog, const QString& path);
    void type(QWidget* field, const QString& text);
};

QDialog* RealDialogsTest::openDialog(const char* shortcut, const char* className) {
    hand().key(shortcut);
    QDialog* found = nullptr;
    support::waitFor([&] {
        for (auto* dialog : window().findChildren<QDialog*>())
            if (dialog->isActiveWindow() && QByteArray(dialog->metaObject()->className()) == className)
                found = dialog;
        return found != nullptr;
    });
    return found;
}

void RealDialogsTest::type(QWidget* field, const QString& text) {
    click(field);
    hand().key("Control+a");
    hand().type(text);
    hand().key("Tab");
}

// Takes what the dialog suggests, which is to be `path`.
void RealDialogsTest::exportAs(QDialog& dialog, const QString& path) {
    const bool answered =
        answer<QFileDialog>([&] { click(named<QPushButton>(dialog, QStringLiteral("Export…"))); },
                            [&](QFileDialog& files) {
                                const QStringList suggested = files.selectedFiles();
                                hand().key(suggested == QStringList(path) ? "Return" : "Escape");
                                QCOMPARE(suggested, QStringList(path));
                            });
    QVERIFY(answered);
}

// Whether the dialog says so. The file itself is there a little earlier, while the dialog still offers to
// stop.
bool RealDialogsTest::isWritten(const QDialog& dialog, const QString& path) {
    return named<QLabel>(dialog, QStringLiteral("Result"))->text().contains(path) && QFileInfo::exists(path);
}

void RealDialogsTest::exportsPng() {
    window().openPath(copyOfCollection(QStringLiteral("paper")));
    QDialog* dialog = openDialog("Control+e", "view::ExportDialog");
    QVERIFY(dialog);
    photograph(QStringLiteral("export-png.png"));
    const QString name = fractal().name;
    exportAs(*dialog, folder() + u'/' + name + QStringLiteral(".png"));
    const QString path = folder() + u'/' + name + QStringLiteral(".png");
    QTRY_VERIFY_WITH_TIMEOUT(isWritten(*dialog, path), 30'000);
    const QImage image(path);
    QCOMPARE(image.size(), canvas().viewport()->size());
    const io::Collection read = io::readCollection(io::loadFile(path).bytes);
    QCOMPARE(read.file.entries.size(), 1);
    QCOMPARE(read.file.entries.first().fractal->system, fractal().system);
    click(named<QPushButton>(*dialog, QStringLiteral("Close")));
    QTRY_VERIFY(!visible<QDialog>());
    QVERIFY(!window().isWindowModified());
}

void RealDialogsTest::exportsSvg() {
    window().openPath(copyOfCollection(QStringLiteral("paper")));
    QDialog* dialog = openDialog("Control+e", "view::ExportDialog");
    QVERIFY(dialog);
    auto* format = named<QComboBox>(*dialog, QStringLiteral("Format"));
    click(format);
    hand().key("Down");
    hand().key("Return");
    QTRY_COMPARE(format->currentIndex(), 1);
    QTest::qWait(300);
    photograph(QStringLiteral("export-svg.png"));
    const QString path = folder() + u'/' + fractal().name + QStringLiteral(".svg");
    exportAs(*dialog, path);
    QTRY_VERIFY_WITH_TIMEOUT(isWritten(*dialog, path), 30'000);
    const io::Collection read = io::readCollection(io::loadFile(path).bytes);
    QCOMPARE(read.format, QStringLiteral("svg"));
    QCOMPARE(read.file.entries.first().fractal->system, fractal().system);
    hand().key("Escape");
    QTRY_VERIFY(!visible<QDialog>());
}

void RealDialogsTest::anExportUnderWayIsCancelled() {
    window().openPath(copyOfCollection(QStringLiteral("paper")));
    QDialog* dialog = openDialog("Control+e", "view::ExportDialog");
    QVERIFY(dialog);
    type(named<QDoubleSpinBox>(*dialog, QStringLiteral("Width")), QStringLiteral("4000"));
    auto* quality = named<QComboBox>(*dialog, QStringLiteral("Quality"));
    click(quality);
    hand().key("End");
    hand().key("Return");
    QTRY_COMPARE(quality->currentIndex(), quality->count() - 1);
    const QString path = folder() + u'/' + fractal().name + QStringLiteral(".png");
    QFile::remove(path);
    const QStringList before = QDir(folder()).entryList(QDir::Files | QDir::Hidden);
    QVERIFY(!QFileInfo::exists(path));
    exportAs(*dialog, path);
    auto* progress = dialog->findChild<QProgressBar*>();
    QTRY_VERIFY(progress->isVisible());
    QTest::qWait(200);
    photograph(QStringLiteral("export-under-way.png"));
    click(named<QPushButton>(*dialog, QStringLiteral("Stop")));
    QTRY_VERIFY(!progress->isVisible());
    QVERIFY(named<QLabel>(*dialog, QStringLiteral("Result"))->text().contains(QStringLiteral("stopped")));
    QVERIFY(!QFileInfo::exists(path));
    QCOMPARE(QDir(folder()).entryList(QDir::Files | QDir::Hidden), before); // nor a part of it
    QVERIFY(dialog->isVisible());                                           // to try again with less
    hand().key("Escape");
    QTRY_VERIFY(!visible<QDialog>());
}

void RealDialogsTest::transformsAsPlacement() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const document::Fractal before = fractal();
    const std::vector<ifs::Vector<2>> held = cage().current;
    QDialog* dialog = openDialog("Control+t", "view::TransformDialog");
    QVERIFY(dialog);
    type(named<QLineEdit>(*dialog, QStringLiteral("Rotation in degrees, counter-clockwise")),
         QStringLiteral("90"));
    type(named<QLineEdit>(*dialog, QStringLiteral("Translation in x")), QStringLiteral("0.5"));
    photograph(QStringLiteral("transform.png"));
    click(named<QPushButton>(*dialog, QStringLiteral("OK")));
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(fractal().system, before.system);
    for (std::size_t i = 0; i < 3; ++i) { // (x, y) → (−y, x), and the shift goes with both ends of an edge
        const ifs::Vector<2> edge = held[(i + 1) % 3] - held[i];
        const ifs::Vector<2> turned = cage().current[(i + 1) % 3] - cage().current[i];
        QVERIFY((turned - ifs::Vector<2>(-edge.y(), edge.x())).norm() < 1e-12);
    }
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(savedEntry(path).cage, fractal().cage);
    QCOMPARE(savedEntry(path).system, before.system);
}

void RealDialogsTest::transformsAsCode() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const document::Fractal before = fractal();
    QDialog* dialog = openDialog("Control+t", "view::TransformDialog");
    QVERIFY(dialog);
    click(named<QRadioButton>(*dialog, QStringLiteral("Rewrite the code")));
    type(named<QLineEdit>(*dialog, QStringLiteral("Scale in x")), QStringLiteral("2"));
    QTRY_VERIFY(fractal() != before); // live, before it is applied
    click(named<QPushButton>(*dialog, QStringLiteral("Cancel")));
    QTRY_VERIFY(fractal() == before);
    QCOMPARE(steps(), 0);

    dialog = openDialog("Control+t", "view::TransformDialog");
    QVERIFY(dialog);
    click(named<QRadioButton>(*dialog, QStringLiteral("Rewrite the code")));
    type(named<QLineEdit>(*dialog, QStringLiteral("x of the fixed point")), QStringLiteral("0"));
    type(named<QLineEdit>(*dialog, QStringLiteral("y of the fixed point")), QStringLiteral("0"));
    type(named<QLineEdit>(*dialog, QStringLiteral("Scale in x")), QStringLiteral("2"));
    hand().key("Return");
    QTRY_COMPARE(steps(), 1);
    const auto& maps = document::system2(fractal())->maps;
    const auto& old = document::system2(before)->maps;
    for (std::size_t i = 0; i < maps.size(); ++i) { // conjugation by a scaling about the origin
        QVERIFY((maps[i].map.linear - old[i].map.linear).norm() < 1e-12);
        QVERIFY((maps[i].map.translation - 2 * old[i].map.translation).norm() < 1e-12);
    }
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(savedEntry(path).system, fractal().system);
}

void RealDialogsTest::printPreviewOpensAndCloses() {
    const bool answered = answer<QPrintPreviewDialog>([&] { hand().key("Control+p"); },
                                                      [&](QPrintPreviewDialog&) {
                                                          QTest::qWait(500);
                                                          photograph(QStringLiteral("print-preview.png"));
                                                          hand().key("Escape");
                                                      });
    QVERIFY(answered);
    QVERIFY(window().isActiveWindow());
    QVERIFY(!window().isWindowModified());
}

void RealDialogsTest::aFileIsDroppedFromAnotherProgram() {
    QProcess other;
    other.start(QStringLiteral(BARYCAGE_DRAG_SOURCE), {support::testData(QStringLiteral("shapes.ifs"))});
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
    hand().moveTo(source + QPoint(12, -4)); // the drag begins
    QTest::qWait(300);
    for (const double part : {0.2, 0.5, 0.8, 0.97, 1.0}) {
        hand().moveTo(source + (target - source) * part);
        QTest::qWait(100);
    }
    photograph(QStringLiteral("drop.png"));
    hand().release();
    QTRY_COMPARE(window().windowTitle().section(QLatin1Char('['), 0, 0), QStringLiteral("shapes.ifs"));
    QVERIFY(says("copied"));
    QVERIFY(!window().isWindowModified());
    other.terminate();
    other.waitForFinished();
}

int main(int argc, char** argv) {
    RealDialogsTest test;
    return support::run(test, argc, argv);
}

#include "real_dialogs_test.moc"
