// SPDX-License-Identifier: MIT
#include "dialogs/export_data_dialog.h"
#include "io/collection_reader.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
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
    void writesPoints();

private:
    QByteArray written(view::ExportDataDialog& dialog);

    QTemporaryDir m_folder;
};

namespace {

document::Fractal doubled() {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.cage = document::effectiveCage(fractal);
    for (auto& vertex : fractal.cage->current)
        vertex *= 2;
    return fractal;
}

} // namespace

QByteArray ExportDataDialogTest::written(view::ExportDataDialog& dialog) {
    const QString path = m_folder.filePath(QStringLiteral("data"));
    QSignalSpy exported(&dialog, &view::ExportDataDialog::exported);
    dialog.exportTo(path);
    if (exported.isEmpty() && !exported.wait()) return {};
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void ExportDataDialogTest::everyFormatIsWrittenAsItIsShown() {
    document::Document document;
    document.setFile(document::fileOf(document::sierpinskiTriangle()));
    view::ExportDataDialog dialog(&document);
    auto* format = dialog.findChildren<QComboBox*>().first();
    const QByteArrayList beginnings{"<flames>", "@", "a,b,c,d,e,f,p\n", "a\tb\tc\td\te\tf\tp\n"};
    for (int i = 0; i < beginnings.size(); ++i) {
        format->setCurrentIndex(i);
        const QByteArray bytes = written(dialog);
        QVERIFY2(bytes.startsWith(beginnings[i]), bytes.constData());
        QCOMPARE(dialog.findChild<QPlainTextEdit*>()->toPlainText().toUtf8(), bytes.left(8000));
    }
    dialog.findChildren<QComboBox*>().last()->setCurrentIndex(1);
    QVERIFY(written(dialog).startsWith("a\tb\te\tc\td\tf\tp\n"));
    auto* columns = dialog.findChildren<QComboBox*>().last();
    columns->setCurrentIndex(columns->count() - 1); // the one that is typed
    auto* typed = columns->parentWidget()->findChild<QLineEdit*>();
    typed->clear();
    QTest::keyClicks(typed, QStringLiteral("fedcba cumulative"));
    const auto isOffered = [&dialog] {
        for (const auto* button : dialog.findChildren<QPushButton*>())
            if (button->text().contains(QStringLiteral("Export"))) return button->isEnabled();
        return false;
    };
    QVERIFY(!isOffered()); // letters alone are an order, letters and a word are not
    typed->clear();
    QTest::keyClicks(typed, QStringLiteral("f e d c b a cumulative"));
    QVERIFY(isOffered());
    QVERIFY(written(dialog).startsWith("f\te\td\tc\tb\ta\tcumulative\n"));
}

void ExportDataDialogTest::bakesWhatIsShown() {
    document::Document document;
    document.setFile(document::fileOf(doubled()));
    view::ExportDataDialog dialog(&document);
    const auto largestShift = [this, &dialog] {
        const io::Collection back = io::readCollection(written(dialog));
        double largest = 0;
        for (const auto& map : document::system2(*back.file.entries.value(0).fractal)->maps)
            largest = std::max(largest, map.map.translation.cwiseAbs().maxCoeff());
        return largest;
    };
    const double baked = largestShift();
    for (auto* box : dialog.findChildren<QCheckBox*>())
        if (box->text().contains(QStringLiteral("Bake"))) box->setChecked(false);
    QVERIFY(std::abs(baked - 2 * largestShift()) < 1e-12);
}

void ExportDataDialogTest::writesPoints() {
    document::Document document;
    document.setFile(document::fileOf(document::sierpinskiTriangle()));
    view::ExportDataDialog dialog(&document);
    dialog.findChildren<QComboBox*>().first()->setCurrentIndex(4);
    dialog.findChild<QSpinBox*>()->setValue(300);
    QCOMPARE(written(dialog).count('\n'), 301);
}

QTEST_MAIN(ExportDataDialogTest)
#include "export_data_dialog_test.moc"
