// SPDX-License-Identifier: MIT
#include "dialogs/export/copy_picture.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/export/export_preview.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/export/print_fractal.h"
#include "dialogs/export/printed_parts.h"

#include "document/document.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "io/picture/png/png_system.h"
#include "io/picture/vector/svg_system.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/maps_support.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QProgressBar>
#include <QRegularExpression>
#include <QSet>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <initializer_list>

using namespace view;

namespace {

// Pictures to look at, in the folder that BARYCAGE_KEEP names.
void keep(const QImage& picture, const char* name) {
    const QString folder = qEnvironmentVariable("BARYCAGE_KEEP");
    if (!folder.isEmpty()) QVERIFY(picture.save(folder + u'/' + QLatin1String(name)));
}

} // namespace

class ExportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void writesPng();
    void previewIsWhatIsWritten_data();
    void previewIsWhatIsWritten();
    void previewKeepsTheShape();
    void framesTheAttractor();
    void theEndingOfTheNameDecides_data();
    void theEndingOfTheNameDecides();
    void aNameWithoutAFormatIsRefused();
    void writesSvg();
    void shapesAreAsLargeAsTheSheet();
    void saysWhatTheSvgWillBe();
    void saysHowLargeAnOutlineIs();
    void saysThatShadesNeedPixels();
    void saysWhenAPixelNeedsMore();
    void failureIsTold();
    void closingWhileExportingIsSafe();
    void aSmallScreenHoldsIt();
    void clipboardHoldsBothForms();
    void pageOfASolidHoldsItsNumbers();
    void aSolidIsPrintedAsItIsSeen();
    void pageHoldsNamePictureAndTable();
    void pageHoldsTheNumbersOfThePicture();
    void manyMapsGoOnFurtherPages();

private:
    attractor::Camera camera() const {
        attractor::Camera view;
        view.width = 160;
        view.height = 120;
        return fitted(view, {0, 0}, {1, 0.9});
    }
    template <typename Widget> static Widget* named(QWidget& parent, const char* name) {
        for (auto* child : parent.findChildren<Widget*>())
            if (child->accessibleName() == QLatin1String(name)) return child;
        return nullptr;
    }
    static void chooseFormat(QWidget& dialog, const ExportDialog::File& file) {
        support::choose(named<QComboBox>(dialog, "Format"), file);
    }
    QTemporaryDir m_folder;
};

void ExportDialogTest::writesPng() {
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.show();
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    const QString path = m_folder.filePath(QStringLiteral("a.png"));
    dialog.exportTo(path);
    QVERIFY(exported.wait(20'000));
    keep(dialog.grab().toImage(), "export-png.png");
    const QImage picture(path);
    QCOMPARE(picture.size(), QSize(160, 120));
    QCOMPARE(picture.dotsPerMeterX(), 11811);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(io::readPngSystem(file.readAll()).text.startsWith(document.fractal().name.toUtf8()));
}

void ExportDialogTest::previewIsWhatIsWritten_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("isWhole");
    QTest::addColumn<bool>("isTransparent");
    QTest::newRow("the view") << QSize(160, 120) << false << false;
    QTest::newRow("the view, wide") << QSize(200, 50) << false << false;
    QTest::newRow("the view, tall and transparent") << QSize(40, 200) << false << true;
    QTest::newRow("the attractor") << QSize(150, 150) << true << false;
    QTest::newRow("the attractor, transparent") << QSize(200, 80) << true << true;
}

// The largest one of a byte of a pixel.
static int difference(const QImage& one, const QImage& other) {
    if (one.size() != other.size() || one.format() != other.format()) return 256;
    int most = 0;
    for (int y = 0; y < one.height(); ++y) {
        const uchar *here = one.constScanLine(y), *there = other.constScanLine(y);
        for (int byte = 0; byte < 4 * one.width(); ++byte)
            most = std::max(most, std::abs(int(here[byte]) - int(there[byte])));
    }
    return most;
}

// Small pictures are shown pixel by pixel.
void ExportDialogTest::previewIsWhatIsWritten() {
    QFETCH(const QSize, size);
    QFETCH(const bool, isWhole);
    QFETCH(const bool, isTransparent);
    document::Document document;
    attractor::Camera elsewhere = camera();
    elsewhere.centre += ifs::Vector<2>(0.2, 0.1);
    ExportDialog dialog(&document, elsewhere);
    dialog.resize(1000, 700);
    dialog.show();
    if (isWhole) dialog.setSection(ExportDialog::Section::Attractor);
    for (auto* box : dialog.findChildren<QCheckBox*>())
        if (box->text().contains(QStringLiteral("background"))) box->setChecked(isTransparent);
    dialog.findChild<ExportSizeEditor*>()->setPixels(size);
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    const QString path = m_folder.filePath(QStringLiteral("preview.png"));
    dialog.exportTo(path);
    QVERIFY(exported.wait(20'000));
    const QImage written = QImage(path).convertToFormat(QImage::Format_ARGB32_Premultiplied);
    QTRY_COMPARE_WITH_TIMEOUT(dialog.preview().picture().size(), size, 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().isBusy(), 60'000);
    QCOMPARE(written.size(), size);
    // PNG holds colours that are not multiplied by their opacity. What is shown before the last wish differs.
    QTRY_VERIFY_WITH_TIMEOUT(difference(dialog.preview().picture(), written) <= (isTransparent ? 2 : 0),
                             60'000);
    const QImage shown = dialog.preview().picture();
    QCOMPARE(qAlpha(shown.pixel(0, 0)), isTransparent ? 0 : 255);
    keep(dialog.grab().toImage(), (QByteArray("preview-") + QTest::currentDataTag() + ".png").constData());
    if (!isTransparent) return;
    // The chequer shows through.
    const QRect frame = dialog.preview().frame();
    const QImage widget = dialog.findChild<ExportPreview*>()->grab().toImage();
    QSet<QRgb> greys;
    for (int x = 2; x < std::min(40, frame.width() - 2); ++x)
        greys.insert(widget.pixel(frame.left() + x, frame.top() + 3) | 0xff000000);
    QVERIFY(greys.contains(qRgb(255, 255, 255)) && greys.contains(qRgb(204, 204, 204)));
}

void ExportDialogTest::previewKeepsTheShape() {
    ExportPreview preview;
    preview.resize(300, 200);
    for (const QSize& size : {QSize(4000, 1000), QSize(30, 60), QSize(100'000, 1), QSize(1, 100'000)}) {
        preview.show(size, nullptr);
        const QRect frame = preview.frame();
        QVERIFY(preview.rect().contains(frame));
        const double wanted = double(size.width()) / size.height();
        const bool isThin = wanted > 200 || wanted < 0.005; // a pixel is as thin as can be
        QVERIFY(isThin || std::abs(frame.width() - frame.height() * wanted) <= 1 + wanted);
        QVERIFY(frame.width() >= 298 || frame.height() >= 198);
    }
}

// Wherever the canvas looks; and what was said of one file goes when another kind is chosen.
void ExportDialogTest::framesTheAttractor() {
    document::Document document;
    attractor::Camera elsewhere = camera();
    elsewhere.centre = {100, 100};
    ExportDialog dialog(&document, elsewhere);
    dialog.setSection(ExportDialog::Section::Attractor);
    dialog.show();
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    const QString path = m_folder.filePath(QStringLiteral("framed.png"));
    dialog.exportTo(path);
    QVERIFY(exported.wait(20'000));
    const QImage picture(path);
    QRect seen;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (picture.pixel(x, y) != picture.pixel(0, 0)) seen |= QRect(x, y, 1, 1);
    QVERIFY(seen.height() > 100 && seen.height() < 116); // of 120, with a margin of a twentieth
    QVERIFY((seen.center() - picture.rect().center()).manhattanLength() <= 4);
    auto* result = named<QLabel>(dialog, "Result");
    QVERIFY(result->isVisible());
    chooseFormat(dialog, io::ShapeFile::Svg);
    QVERIFY(!result->isVisible());
}

void ExportDialogTest::theEndingOfTheNameDecides_data() {
    QTest::addColumn<QByteArray>("begins");
    QTest::newRow("png") << QByteArray("\x89PNG");
    QTest::newRow("JPG") << QByteArray("\xff\xd8\xff");
    QTest::newRow("jpeg") << QByteArray("\xff\xd8\xff");
    QTest::newRow("webp") << QByteArray("RIFF");
    QTest::newRow("tif") << QByteArray("II");
    QTest::newRow("tiff") << QByteArray("II");
    QTest::newRow("exr") << QByteArray("\x76\x2f\x31\x01");
    QTest::newRow("svg") << QByteArray("<?xml");
    QTest::newRow("pdf") << QByteArray("%PDF");
}

// Whatever the list says, and whatever was chosen for another format.
void ExportDialogTest::theEndingOfTheNameDecides() {
    QFETCH(const QByteArray, begins);
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.show();
    for (auto* box : dialog.findChildren<QCheckBox*>())
        if (box->text().contains(QStringLiteral("background"))) box->setChecked(true);
    support::choose(named<QComboBox>(dialog, "Colour depth"), io::PictureFormat::Depth::Bits16);
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    const QString path =
        m_folder.filePath(QStringLiteral("by name.") + QLatin1String(QTest::currentDataTag()));
    dialog.exportTo(path);
    QVERIFY(exported.wait(20'000));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith(begins));
    keep(dialog.grab().toImage(), (QByteArray("export-") + QTest::currentDataTag() + ".png").constData());
}

void ExportDialogTest::aNameWithoutAFormatIsRefused() {
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.show();
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    for (const QString& name : {QStringLiteral("fern.gif"), QStringLiteral("fern v1.2")}) {
        dialog.exportTo(m_folder.filePath(name));
        QVERIFY(named<QLabel>(dialog, "Result")->text().contains(name));
        QVERIFY(!exported.wait(100));
        QVERIFY(!QFile::exists(m_folder.filePath(name)));
    }
}

void ExportDialogTest::writesSvg() {
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.show();
    chooseFormat(dialog, io::ShapeFile::Svg);
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    const QString path = m_folder.filePath(QStringLiteral("a.svg"));
    dialog.exportTo(path);
    QVERIFY(exported.wait(20'000));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(!io::readSvgSystem(file.readAll()).failure);
}

void ExportDialogTest::shapesAreAsLargeAsTheSheet() {
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.show();
    auto* sizes = named<QComboBox>(dialog, "Named size");
    support::choose(sizes,
                    sizes->itemData(sizes->findText(QStringLiteral("A4"), Qt::MatchStartsWith)).toSize());
    const auto written = [&](const ExportDialog::File& format, const QString& name) {
        chooseFormat(dialog, format);
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.exportTo(m_folder.filePath(name));
        QFile file(m_folder.filePath(name));
        return exported.wait(20'000) && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray svg = written(io::ShapeFile::Svg, QStringLiteral("a4.svg"));
    auto* plan = named<QLabel>(dialog, "Description of the picture");
    QTRY_VERIFY(plan->text().contains(QStringLiteral(" mm. ")));
    auto* unit = named<QComboBox>(dialog, "Unit of length");
    support::choose(unit, ExportSizeEditor::Unit::Pixels);
    QTRY_VERIFY(plan->text().contains(QStringLiteral(" px. ")));
    support::choose(unit, ExportSizeEditor::Unit::Millimetres);
    QVERIFY2(svg.contains("width=\"297mm\" height=\"210mm\" viewBox=\"0 0 3508 2480\""),
             svg.left(400).constData());
    const QByteArray pdf = written(io::ShapeFile::Pdf, QStringLiteral("a4.pdf"));
    static const QRegularExpression box(QStringLiteral("/MediaBox ?\\[0 0 ([0-9.]+) ([0-9.]+)"));
    const auto page = box.match(QString::fromLatin1(pdf));
    QVERIFY2(std::abs(page.captured(1).toDouble() - 841.92) < 0.01 &&
                 std::abs(page.captured(2).toDouble() - 595.2) < 0.01,
             qPrintable(page.captured()));
}

void ExportDialogTest::saysWhatTheSvgWillBe() {
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.show();
    chooseFormat(dialog, io::ShapeFile::Svg);
    auto* plan = named<QLabel>(dialog, "Description of the picture");
    QTRY_VERIFY(plan->text().contains(QStringLiteral("Copies drawn by")));
    const QString automatic = plan->text();
    keep(dialog.grab().toImage(), "export-svg.png");
    for (auto* box : dialog.findChildren<QCheckBox*>())
        if (box->text().contains(QStringLiteral("Automatic"))) box->setChecked(false);
    named<QSpinBox>(dialog, "Levels of copies")->setValue(2);
    QTRY_VERIFY(
        plan->text().contains(QStringLiteral("open the file: 12 (the"))); // 3 + 9 for a Sierpiński triangle
    QVERIFY(plan->text() != automatic);
    QVERIFY(!automatic.contains(QStringLiteral("More levels would be more accurate")));
}

// Makers measure what is cut, not the page around it.
void ExportDialogTest::saysHowLargeAnOutlineIs() {
    document::Document document;
    const auto box = *document::displayedBox(document.fractal());
    attractor::Camera view;
    view.width = view.height = 300;
    view = fitted(view, box.min, box.max, 0.1);
    ExportDialog dialog(&document, view);
    dialog.show();
    chooseFormat(dialog, io::ShapeFile::Svg);
    support::choose(named<QComboBox>(dialog, "Kind of shapes"), io::ShapeStyle::Outline);
    auto* size = dialog.findChild<view::ExportSizeEditor*>();
    auto* plan = named<QLabel>(dialog, "Description of the picture");
    const ifs::Vector<2> pixels = view.pixelsPerUnit * size->pixels().width() / 300 * (box.max - box.min);
    const QString width = QString::number(pixels.x(), 'f', 2), height = QString::number(pixels.y(), 'f', 2);
    QTRY_VERIFY2(plan->text().contains(width) && plan->text().contains(height), qPrintable(plan->text()));
    QVERIFY(!plan->text().contains(QStringLiteral("Copies drawn by"))); // nothing draws copies of one path
    support::choose(named<QComboBox>(dialog, "Kind of shapes"), io::ShapeStyle::Structured);
    QTRY_VERIFY(plan->text().contains(QStringLiteral("Copies drawn by")));
}

void ExportDialogTest::saysThatShadesNeedPixels() {
    const QString sentence = QStringLiteral("Shades of density need pixels");
    for (const attractor::ColourBy colours : {attractor::ColourBy::Density, attractor::ColourBy::Map}) {
        document::Document document;
        document::Fractal fractal = document.fractal();
        fractal.appearance.colourBy = colours;
        document.setFile(document::fileOf(fractal));
        ExportDialog dialog(&document, camera());
        dialog.show();
        chooseFormat(dialog, io::ShapeFile::Svg);
        auto* plan = named<QLabel>(dialog, "Description of the picture");
        QTRY_VERIFY(plan->text().contains(QStringLiteral("Copies drawn by")));
        QCOMPARE(plan->text().contains(sentence), colours == attractor::ColourBy::Density);
    }
}

// A curve whose copies have to become smaller still. The long thin copies of the maple stay long instead,
// however many there are.
void ExportDialogTest::saysWhenAPixelNeedsMore() {
    document::Document document;
    attractor::Camera view;
    view.width = 1000;
    view.height = 800;
    const QString remark = QStringLiteral("More levels would be more accurate");
    {
        document.setFile(document::fileOf(maps_support::maple()));
        ExportDialog dialog(&document, fitted(view, {-6, -5}, {6, 6}));
        dialog.show();
        chooseFormat(dialog, io::ShapeFile::Svg);
        auto* plan = named<QLabel>(dialog, "Description of the picture");
        QTRY_VERIFY(plan->text().contains(QStringLiteral("Copies drawn by")));
        QVERIFY(!plan->text().contains(remark));
    }
    document::Fractal ice;
    document::System2 system;
    for (const auto& map : {ifs::affineMap(.5, 0, 0, .5, 0, 0), ifs::affineMap(0, -.35, .35, 0, .5, 0),
                            ifs::affineMap(0, .35, -.35, 0, .5, .35), ifs::affineMap(.5, 0, 0, .5, .5, 0)})
        ifs::append(system, map, 1.0);
    ice.shape = document::Shape<2>{system};
    document.setFile(document::fileOf(ice));
    ExportDialog dialog(&document, fitted(view, {0, -.05}, {1, .4}));
    dialog.show();
    chooseFormat(dialog, io::ShapeFile::Svg);
    auto* plan = named<QLabel>(dialog, "Description of the picture");
    QTRY_VERIFY(plan->text().contains(remark));
    QVERIFY(plan->text().contains(QStringLiteral("the limit is 400\u202f000")));
    QTRY_VERIFY(plan->height() >= plan->heightForWidth(plan->width()));
    for (auto* box : dialog.findChildren<QCheckBox*>())
        if (box->text().contains(QStringLiteral("Automatic"))) box->setChecked(false);
    QTRY_VERIFY(!plan->text().contains(remark)); // the depth is one's own
}

void ExportDialogTest::failureIsTold() {
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.show();
    QSignalSpy failed(&dialog, &ExportDialog::failed);
    dialog.exportTo(m_folder.filePath(QStringLiteral("no/such/folder.png")));
    QVERIFY(failed.wait(20'000));
    QVERIFY(named<QLabel>(dialog, "Result")->text().contains(QStringLiteral("no/such")));
}

void ExportDialogTest::closingWhileExportingIsSafe() {
    document::Document document;
    const QString path = m_folder.filePath(QStringLiteral("never.png"));
    {
        ExportDialog dialog(&document, camera());
        dialog.show();
        dialog.findChild<ExportSizeEditor*>()->setPixels({4000, 3000});
        support::choose(named<QComboBox>(dialog, "Quality"), 2000);
        dialog.exportTo(path);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QProgressBar*>()->value() > 0, 60'000);
    }
    QCoreApplication::processEvents();
    QVERIFY(!QFile::exists(path));
}

void ExportDialogTest::aSmallScreenHoldsIt() {
    document::Document document;
    ExportDialog dialog(&document, camera());
    dialog.setQueue(nullptr);
    for (const ExportDialog::File& format : std::initializer_list<ExportDialog::File>{
             io::PictureFile::Png, io::PictureFile::Tiff, io::ShapeFile::Svg}) {
        chooseFormat(dialog, format);
        const QString shown = named<QComboBox>(dialog, "Format")->currentText();
        QVERIFY2(dialog.minimumSizeHint().width() <= 780, qPrintable(shown));
        QVERIFY2(dialog.width() <= 780, qPrintable(shown));
    }
}

void ExportDialogTest::clipboardHoldsBothForms() {
    document::Document document;
    QImage shown(16, 12, QImage::Format_ARGB32_Premultiplied);
    shown.fill(Qt::red);
    copyPicture(&document, camera(), shown);
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    QVERIFY(data->hasImage());
    QCOMPARE(data->imageData().value<QImage>().size(), shown.size());
    QVERIFY(io::looksLikeSvg(data->data(QStringLiteral("image/svg+xml"))));
}

// What is printed is the code of the picture that is printed.
void ExportDialogTest::pageHoldsTheNumbersOfThePicture() {
    QImage picture(40, 30, QImage::Format_RGB32);
    picture.fill(Qt::blue);
    const auto page = [&picture](const document::Fractal& fractal) {
        QImage made(420, 594, QImage::Format_RGB32);
        made.fill(Qt::white);
        QPainter painter(&made);
        paintPages(painter, made.rect(), fractal, picture, [] {});
        return made;
    };
    const document::Fractal rests = document::Document().fractal();
    document::Fractal moved = rests;
    document::plane(moved)->cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{2, 0}, {4, 0}, {2, 4}}};
    document::Fractal rewritten = rests;
    rewritten.shape = document::Shape<2>{*document::effectiveSystem(moved)};
    QVERIFY(page(moved) == page(rewritten));
    QVERIFY(page(moved) != page(rests));
    document::Fractal flat = rests;
    document::plane(flat)->cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1, 0}, {2, 0}}};
    QVERIFY(page(flat) != page(rests)); // it says that the numbers are others
}

// In space as well, with the corners of the cage.
void ExportDialogTest::pageOfASolidHoldsItsNumbers() {
    QImage picture(40, 30, QImage::Format_RGB32);
    picture.fill(Qt::blue);
    int more = 0;
    const auto page = [&](const document::Fractal& fractal) {
        QImage made(420, 594, QImage::Format_RGB32);
        made.fill(Qt::white);
        QPainter painter(&made);
        more = 0;
        paintPages(painter, made.rect(), fractal, picture, [&more] { ++more; });
        return made;
    };
    document::Fractal rests;
    rests.name = QStringLiteral("dust");
    document::Shape<3> dust;
    ifs::append<3>(dust.system, {0.5 * ifs::Matrix<3>::Identity(), {0, 0, 0}});
    ifs::append<3>(dust.system, {0.25 * ifs::Matrix<3>::Identity(), {0.5, 0.25, 1}});
    dust.cage = ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    rests.shape = dust;
    document::Fractal moved = rests;
    for (ifs::Vector<3>& corner : document::space(moved)->cage->current)
        corner = 2 * corner + ifs::Vector<3>(0, 1, 0);
    document::Fractal rewritten = moved;
    *document::system3(rewritten) = *document::effectiveSystem<3>(moved);
    document::space(rewritten)->cage->rest = document::space(moved)->cage->current;
    QVERIFY(page(moved) == page(rewritten));
    QVERIFY(page(moved) != page(rests));
    document::Fractal flat = rests;
    document::space(flat)->cage->current[3] = {1, 1, 0};
    QVERIFY(page(flat) != page(rests)); // it says that the numbers are others
    keep(page(rests), "page-of-a-solid.png");
    QCOMPARE(more, 0);
    document::system3(rests)->maps.resize(20, document::system3(rests)->maps.front());
    page(rests);
    QCOMPARE(more, 1); // one more page is enough
}

// The picture as it is seen, lit, on white, without its empty sides.
void ExportDialogTest::aSolidIsPrintedAsItIsSeen() {
    document::Fractal cube;
    document::Shape<3> shape;
    for (int corner = 0; corner < 8; ++corner)
        ifs::append<3>(shape.system,
                       {0.5 * ifs::Matrix<3>::Identity(),
                        ifs::Vector<3>((corner & 1) / 2.0, (corner >> 1 & 1) / 2.0, (corner >> 2) / 2.0)});
    cube.shape = shape;
    cube.inSpace.fog = 0.5;
    cube.inSpace.lightAzimuth = 60;
    attractor::OrbitCamera orbit;
    orbit.orientation = attractor::orbit(30, 20);
    orbit.size = {100, 60};
    orbit = document::fittedToPicture(cube, orbit, 0.2);
    const io::SpaceExport picture = spacePicture(cube, orbit, 200);
    QCOMPARE(picture.request.camera.size.width, 200);
    QCOMPARE(picture.request.camera.size.height, 120);
    QVERIFY(picture.request.camera.height == orbit.height && picture.request.camera.target == orbit.target);
    const attractor::SolidAppearance seen = document::solidAppearance(cube);
    QVERIFY(picture.solid.keyLight == seen.keyLight && picture.solid.plain == seen.plain);
    QCOMPARE(picture.solid.fog, seen.fog);
    QCOMPARE(picture.solid.background.red, 255);
    const QImage drawn = io::drawSpacePicture(picture).image;
    QCOMPARE(drawn.pixelColor(0, 0), QColor(Qt::white));
    const QImage trimmed = withoutEmptySides(drawn, qRgb(255, 255, 255));
    QVERIFY(trimmed.width() < 120 && trimmed.width() > 40);
    const auto dark = [](const QImage& image) {
        int all = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                all += image.pixel(x, y) != qRgb(255, 255, 255);
        return all;
    };
    QCOMPARE(dark(trimmed), dark(drawn));
    QImage nothing(trimmed.size(), QImage::Format_RGB32);
    nothing.fill(Qt::black);
    QCOMPARE(withoutEmptySides(nothing, 0xff000000).size(), nothing.size());
}

void ExportDialogTest::pageHoldsNamePictureAndTable() {
    document::Document document;
    QImage picture(40, 30, QImage::Format_RGB32);
    picture.fill(Qt::blue);
    QImage page(420, 594, QImage::Format_RGB32);
    page.fill(Qt::white);
    QPainter painter(&page);
    int more = 0;
    paintPages(painter, page.rect(), document.fractal(), picture, [&] { ++more; });
    QCOMPARE(more, 0);
    painter.end();
    keep(page, "page.png");
    QCOMPARE(page.pixelColor(210, 150), QColor(Qt::blue));
    const auto ink = [&](int top, int bottom) {
        int dark = 0;
        for (int y = top; y < bottom; ++y)
            for (int x = 0; x < page.width(); ++x)
                dark += qGray(page.pixel(x, y)) < 128 && qBlue(page.pixel(x, y)) < 128;
        return dark;
    };
    QVERIFY(ink(0, 20) > 20);     // the name
    QVERIFY(ink(355, 594) > 100); // the table
}

// A page takes as many maps as can be read; every page has some.
void ExportDialogTest::manyMapsGoOnFurtherPages() {
    document::Document document;
    document::Fractal fractal = document.fractal();
    auto* system = document::system2(fractal);
    system->maps.resize(200, system->maps.front());
    fractal.comments = {QStringLiteral(" by nobody")};
    QImage page(420, 594, QImage::Format_RGB32);
    page.fill(Qt::white);
    QPainter painter(&page);
    int more = 0;
    int least = INT_MAX;
    paintPages(painter, page.rect(), fractal, QImage(40, 30, QImage::Format_RGB32), [&] {
        ++more;
        int dark = 0;
        for (int y = 0; y < page.height(); ++y)
            for (int x = 0; x < page.width(); ++x)
                dark += qGray(page.pixel(x, y)) < 128;
        least = std::min(least, dark);
        page.fill(Qt::white);
    });
    const int pages = more;
    paintPages(painter, QRectF(), fractal, QImage(40, 30, QImage::Format_RGB32), [&] { ++more; });
    QCOMPARE(more, pages); // of no size, as some printers say before they are set up: there is an end
    QCOMPARE(pages, 4);    // 200 maps, at most 59 on a page and fewer under the picture
    QVERIFY(least > 500);
}

BARYCAGE_TEST(ExportDialogTest, QApplication);
#include "export_dialog_test.moc"
