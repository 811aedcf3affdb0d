// SPDX-License-Identifier: MIT
#include "dialogs/export/export_data_dialog.h"
#include "document/fractal/fractal_geometry.h"
#include "io/collection_reader.h"
#include "support/choose.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

class ExportDataDialogTest : public QObject {
    Q_OBJECT

private slots:
    void everyFormatIsWrittenAsItIsShown();
    void bakesWhatIsShown();
    void systemsInSpaceGiveWhatFormatsHold();
    void aSolidStartsWithAFormatThatHoldsIt();
    void writesPoints();
    void tellsWhatIsLost();

private:
    using Format = view::ExportDataDialog::Format;
    QByteArray written(view::ExportDataDialog& dialog);

    QTemporaryDir m_folder;
};

namespace {

document::Fractal doubled() {
    document::Fractal fractal = document::sierpinskiTriangle();
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    for (auto& vertex : document::plane(fractal)->cage->current)
        vertex *= 2;
    return fractal;
}

} // namespace

QByteArray ExportDataDialogTest::written(view::ExportDataDialog& dialog) {
    const QString path = m_folder.filePath(QStringLiteral("data"));
    QSignalSpy exported(&dialog, &view::ExportDataDialog::exported);
    dialog.exportTo(path);
    if (exported.isEmpty() && !exported.wait(60000)) return {};
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void ExportDataDialogTest::everyFormatIsWrittenAsItIsShown() {
    document::Document document;
    document.setFile(document::fileOf(document::sierpinskiTriangle()));
    view::ExportDataDialog dialog(&document);
    auto* format = dialog.findChildren<QComboBox*>().first();
    const std::pair<Format, QByteArray> beginnings[] = {
        {Format(io::TextFormat::Flame), "<flames>"},
        {Format(io::TextFormat::Aifs), "@"},
        {Format(io::TextFormat::Latex), "% sierpinski\n"},
        {Format(io::TextFormat::Csv), "a,b,c,d,e,f,p\n"},
        {Format(io::TextFormat::Tsv), "a\tb\tc\td\te\tf\tp\n"}};
    for (const auto& [wanted, beginning] : beginnings) {
        support::choose(format, wanted);
        const QByteArray bytes = written(dialog);
        QVERIFY2(bytes.startsWith(beginning), bytes.constData());
        QCOMPARE(dialog.findChild<QPlainTextEdit*>()->toPlainText().toUtf8(), bytes.left(8000));
    }
    auto* columns = dialog.findChildren<QComboBox*>().last();
    support::choose(columns, QStringLiteral("a b e c d f p"));
    QVERIFY(written(dialog).startsWith("a\tb\te\tc\td\tf\tp\n"));
    support::choose(columns, QString()); // the one that is typed
    auto* typed = columns->parentWidget()->findChild<QLineEdit*>();
    typed->clear();
    QTest::keyClicks(typed, QStringLiteral("fedcba cumulative"));
    const auto isOffered = [&dialog] { return support::button(dialog, "export")->isEnabled(); };
    QVERIFY(!isOffered()); // letters alone are an order, letters and a word are not
    typed->clear();
    QTest::keyClicks(typed, QStringLiteral("f e d c b a cumulative"));
    QVERIFY(isOffered());
    QVERIFY(written(dialog).startsWith("f\te\td\tc\tb\ta\tcumulative\n"));
}

void ExportDataDialogTest::systemsInSpaceGiveWhatFormatsHold() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("solid");
    document::Shape<3> cube;
    for (int k = 0; k < 8; ++k)
        ifs::append<3>(cube.system, {0.5 * ifs::Matrix<3>::Identity(),
                                     ifs::Vector<3>((k & 1) / 2.0, (k >> 1 & 1) / 2.0, (k >> 2) / 2.0)});
    fractal.shape = cube;
    document::Document document;
    document.setFile(document::fileOf(fractal));
    view::ExportDataDialog dialog(&document);
    auto* format = dialog.findChildren<QComboBox*>().first();
    const auto isOffered = [&dialog] { return support::button(dialog, "export")->isEnabled(); };
    support::choose(format, Format(io::TextFormat::Flame)); // flames lie in the plane
    QVERIFY(!isOffered());
    support::choose(format, Format(io::PointFormat::Ply));
    QVERIFY(isOffered());
    dialog.findChild<QSpinBox*>()->setValue(2000);
    const QByteArray points = written(dialog);
    QVERIFY(points.startsWith("ply"));
    QVERIFY(points.contains("property float z") || points.contains("property double z"));
}

void ExportDataDialogTest::bakesWhatIsShown() {
    document::Document document;
    document.setFile(document::fileOf(doubled()));
    view::ExportDataDialog dialog(&document);
    const auto maxShift = [this, &dialog] {
        const io::Collection back = io::readCollection(written(dialog));
        double largest = 0;
        for (const auto& map : document::system2(*back.file.entries.value(0).fractal)->maps)
            largest = std::max(largest, map.map.translation.cwiseAbs().maxCoeff());
        return largest;
    };
    const double baked = maxShift();
    for (auto* box : dialog.findChildren<QCheckBox*>())
        if (box->text().contains(QStringLiteral("Bake"))) box->setChecked(false);
    QVERIFY(std::abs(baked - 2 * maxShift()) < 1e-12);
}

void ExportDataDialogTest::aSolidStartsWithAFormatThatHoldsIt() {
    document::Fractal solid;
    document::Shape<3> shape;
    ifs::append<3>(shape.system, {0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>::Zero()});
    solid.shape = shape;
    document::Document document;
    document.setFile(document::fileOf(solid));
    view::ExportDataDialog dialog(&document);
    QVERIFY(support::button(dialog, "export")->isEnabled());
    const auto* format = dialog.findChildren<QComboBox*>().first();
    QVERIFY(view::chosenValue<Format>(format) != Format(io::TextFormat::Flame));
    QVERIFY(!(format->model()->index(0, 0).flags() & Qt::ItemIsEnabled)); // Flame
}

void ExportDataDialogTest::writesPoints() {
    document::Document document;
    document.setFile(document::fileOf(document::sierpinskiTriangle()));
    view::ExportDataDialog dialog(&document);
    support::choose(dialog.findChildren<QComboBox*>().first(), Format(io::PointFormat::Csv));
    dialog.findChild<QSpinBox*>()->setValue(300);
    QCOMPARE(written(dialog).count('\n'), 301);
}

// Before the file is written, and after.
void ExportDataDialogTest::tellsWhatIsLost() {
    document::Document document;
    document::Fractal fractal = doubled();
    fractal.appearance.background = {255, 0, 0, 255};
    document.setFile(document::fileOf(fractal));
    view::ExportDataDialog dialog(&document);
    const auto message = [&dialog] {
        for (const auto* label : dialog.findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Result")) return label->text();
        return QString();
    };
    auto* format = dialog.findChildren<QComboBox*>().first();
    support::choose(format, Format(io::TextFormat::Flame));
    QCOMPARE(message(), QString());
    support::choose(format, Format(io::TextFormat::Latex));
    QVERIFY2(message().contains(QStringLiteral("without its background.")), qPrintable(message()));
    for (auto* box : dialog.findChildren<QCheckBox*>())
        if (box->text().contains(QStringLiteral("Bake"))) box->setChecked(false);
    const QString both = QStringLiteral("without its cage and its background: other programs will draw");
    QVERIFY2(message().contains(both), qPrintable(message()));
    QVERIFY(!written(dialog).isEmpty());
    QVERIFY2(message().contains(both) && message().contains(QStringLiteral("Written to")),
             qPrintable(message()));
    support::choose(format, Format(io::TextFormat::Flame));
    QVERIFY2(message().contains(QStringLiteral("without its cage: other")), qPrintable(message()));
}

BARYCAGE_TEST(ExportDataDialogTest, QApplication);
#include "export_data_dialog_test.moc"
