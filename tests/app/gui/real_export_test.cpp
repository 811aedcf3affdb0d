// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/export/export_preview.h"
#include "io/collection_reader.h"
#include "io/file/save_file.h"
#include "support/window_on_x.h"

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

// What leaves the program: pictures, data, paper; with a real pointer and real keys.
class RealExportTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() {
        openWindow();
        if (!QTest::currentTestFailed()) window().openPath(copyOfCollection(QStringLiteral("paper")));
    }
    void cleanup() { closeWindow(); }

    void exportsPng();
    void exportsShapes_data();
    void exportsShapes();
    void anExportUnderWayIsCancelled();
    void exportsAFlame();
    void copiesThePicture();
    void printPreviewOpensAndCloses();
    void printsToPdf();

private:
    void exportAs(QDialog& dialog, const QString& path); // begins it
    static bool isWritten(const QDialog& dialog, const QString& path);
};

// Takes what the dialog suggests, which is to be `path`.
void RealExportTest::exportAs(QDialog& dialog, const QString& path) {
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
bool RealExportTest::isWritten(const QDialog& dialog, const QString& path) {
    return named<QLabel>(dialog, QStringLiteral("Result"))->text().contains(path) && QFileInfo::exists(path);
}

void RealExportTest::exportsPng() {
    QDialog* dialog = openDialog("Control+e", "view::ExportDialog");
    QVERIFY(dialog);
    photograph(QStringLiteral("export-png.png"));
    const QString name = fractal().name;
    exportAs(*dialog, folder() + u'/' + name + QStringLiteral(".png"));
    const QString path = folder() + u'/' + name + QStringLiteral(".png");
    QTRY_VERIFY_WITH_TIMEOUT(isWritten(*dialog, path), 60'000);
    const QImage image(path);
    QCOMPARE(image.size(), canvas().viewport()->size());
    const io::Collection read = io::readCollection(io::loadFile(path).bytes);
    QCOMPARE(read.file.entries.size(), 1);
    QVERIFY(document::isSameSystem(*read.file.entries.first().fractal, fractal()));
    click(named<QPushButton>(*dialog, QStringLiteral("Close")));
    QTRY_VERIFY(!visible<QDialog>());
    QVERIFY(!window().isWindowModified());
}

void RealExportTest::exportsShapes_data() {
    QTest::addColumn<io::ShapeFile>("format");
    QTest::newRow("svg") << io::ShapeFile::Svg;
    QTest::newRow("pdf") << io::ShapeFile::Pdf;
}

void RealExportTest::exportsShapes() {
    QFETCH(io::ShapeFile, format);
    QDialog* dialog = openDialog("Control+e", "view::ExportDialog");
    QVERIFY(dialog);
    pick(named<QComboBox>(*dialog, QStringLiteral("Format")), view::ExportDialog::File(format));
    const auto& preview = *dialog->findChild<view::ExportPreview*>();
    QTRY_VERIFY(!preview.isBusy() && !preview.picture().isNull());
    photograph(QStringLiteral("export-shapes.png"));
    const QString path =
        folder() + u'/' + fractal().name + u'.' + QString::fromLatin1(QTest::currentDataTag());
    exportAs(*dialog, path);
    QTRY_VERIFY_WITH_TIMEOUT(isWritten(*dialog, path), 60'000);
    const QByteArray bytes = io::loadFile(path).bytes;
    if (path.endsWith(QLatin1String("svg"))) {
        const io::Collection read = io::readCollection(bytes);
        QCOMPARE(read.format, QStringLiteral("svg"));
        QVERIFY(document::isSameSystem(*read.file.entries.first().fractal, fractal()));
    } else {
        QVERIFY(bytes.startsWith("%PDF-") && bytes.trimmed().endsWith("%%EOF"));
    }
    hand().key("Escape");
    QTRY_VERIFY(!visible<QDialog>());
}

void RealExportTest::anExportUnderWayIsCancelled() {
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
    QTRY_VERIFY(progress->isVisible() && progress->value() > 0);
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

void RealExportTest::printPreviewOpensAndCloses() {
    const bool answered = answer<QPrintPreviewDialog>([&] { hand().key("Control+p"); },
                                                      [&](QPrintPreviewDialog&) {
                                                          support::handleEvents();
                                                          photograph(QStringLiteral("print-preview.png"));
                                                          hand().key("Escape");
                                                      });
    QVERIFY(answered);
    QVERIFY(window().isActiveWindow());
    QVERIFY(!window().isWindowModified());
}

// A .flame, as other programs read it: y turned around.
void RealExportTest::exportsAFlame() {
    QDialog* dialog = openDialog("Control+Shift+e", "view::ExportDataDialog");
    QVERIFY(dialog);
    const QString path = QDir::home().filePath(QStringLiteral("maple.flame"));
    const bool answered =
        answer<QFileDialog>([&] { click(named<QPushButton>(*dialog, QStringLiteral("Export…"))); },
                            [&](QFileDialog&) {
                                hand().key("Control+a");
                                hand().type(path);
                                hand().key("Return");
                            });
    QVERIFY(answered);
    QTRY_VERIFY(isWritten(*dialog, path));
    const io::Collection read = io::readCollection(io::loadFile(path).bytes);
    QCOMPARE(read.format, QStringLiteral("flame"));
    const auto& maps = document::system2(*read.file.entries.first().fractal)->maps;
    QCOMPARE(maps.size(), code().maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i)
        QVERIFY((maps[i].map.linear - code().maps[i].map.linear).norm() < 1e-9);
    hand().key("Escape");
    QTRY_VERIFY(!visible<QDialog>());
}

void RealExportTest::copiesThePicture() {
    hand().key("Control+Shift+c");
    QTRY_VERIFY(QGuiApplication::clipboard()->mimeData()->hasImage());
    const auto image = QGuiApplication::clipboard()->image();
    QCOMPARE(image.size(), canvas().viewport()->size());
    const QByteArray svg = QGuiApplication::clipboard()->mimeData()->data(QStringLiteral("image/svg+xml"));
    QVERIFY(document::isSameSystem(*io::readCollection(svg).file.entries.first().fractal, fractal()));
}

// Where there is no printer, as here, paper is a file.
void RealExportTest::printsToPdf() {
    const QString path = folder() + QStringLiteral("/page.pdf");
    bool printed = false;
    const bool answered = answer<QPrintPreviewDialog>(
        [&] { hand().key("Control+p"); },
        [&](QPrintPreviewDialog& preview) {
            const auto* button = named<QToolButton>(preview, QStringLiteral("Print"));
            printed =
                answer<QPrintDialog>([&] { click(button); },
                                     [&](QPrintDialog& dialog) {
                                         photograph(QStringLiteral("print.png"));
                                         type(dialog.findChild<QLineEdit*>(QStringLiteral("filename")), path);
                                         hand().key("Return");
                                     });
        });
    QVERIFY(printed && answered);
    QTRY_VERIFY(io::loadFile(path).bytes.endsWith("%%EOF\n"));
    const QByteArray pdf = io::loadFile(path).bytes;
    QVERIFY(pdf.startsWith("%PDF"));
    QVERIFY(pdf.contains("/Image")); // the picture is on it
    QVERIFY(!window().isWindowModified());
}

BARYCAGE_TEST_ON_X(RealExportTest);

#include "real_export_test.moc"
