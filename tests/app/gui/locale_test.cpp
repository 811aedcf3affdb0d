// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"
#include "io/exchange/text_formats.h"
#include "io/file/save_file.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_writer.h"
#include "io/picture/vector/pdf_writer.h"
#include "io/picture/vector/svg_writer.h"
#include "main_window.h"
#include "panels/maps/maps_model.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/paths.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_text.h"

#include <QFile>
#include <QLocale>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include <clocale>

namespace {

struct Written {
    QString what;
    QByteArray bytes;
};

// What every writer makes of every entry of the file, all coefficients printed anew.
QList<Written> everythingOf(const QString& path) {
    QList<Written> written;
    const io::Loaded loaded = io::loadFile(path);
    const io::Collection collection = io::readCollection(loaded.bytes, path);
    written.append({QStringLiteral("format"), collection.format.toUtf8()});
    document::FractalFile file = collection.file;
    written.append({QStringLiteral("as read"), io::writeFractint(file)});
    for (const document::Entry& entry : file.entries) {
        const document::Fractal& fractal = *entry.fractal;
        if (!document::system2(fractal)) continue;
        const auto add = [&](const char* format, const QByteArray& bytes) {
            written.append({fractal.name + u' ' + QLatin1String(format), bytes});
        };
        add("entry", io::writeEntry(fractal));
        for (const auto format :
             {io::TextFormat::Flame, io::TextFormat::Aifs, io::TextFormat::Csv, io::TextFormat::Tsv})
            add("text", io::textOf({entry.fractal}, format));
        attractor::Camera camera;
        camera.width = 120;
        camera.height = 90;
        camera.pixelsPerUnit = 20.5;
        io::SvgFormat shapes;
        shapes.depth = 2;
        add("svg", io::svgPicture(fractal, camera, shapes).bytes);
        add("pdf", io::pdfPicture({{fractal, camera, shapes}}).bytes);
    }
    return written;
}

} // namespace

// A language writes numbers with a comma, capitals without a dot or groups of thousands: no file changes, and
// what is typed or pasted means the same.
class LocaleTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup() { speak(QLocale::c(), "C"); }
    void filesAreTheSame_data() { languages(); }
    void filesAreTheSame();
    void fieldsTakeTheSame_data() { languages(); }
    void fieldsTakeTheSame();

private:
    static void languages() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"de_DE", "mk_MK", "tr_TR", "fr_FR"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    // Of Qt and, where the machine has it, of the C library.
    static void speak(const QLocale& locale, const QByteArray& name) {
        QLocale::setDefault(locale);
        if (!std::setlocale(LC_ALL, (name + ".UTF-8").constData())) std::setlocale(LC_ALL, name.constData());
    }
    static void speak(const QString& name) { speak(QLocale(name), name.toLatin1()); }
    void makeLocales() const;

    QTemporaryDir m_locales;
    QStringList m_files;
    QList<QList<Written>> m_plain;
};

// Few machines have these locales; where their descriptions are (package locales), they are made here.
void LocaleTest::makeLocales() const {
    for (const char* name : {"de_DE", "mk_MK", "tr_TR", "fr_FR"}) {
        const QString wanted = QString::fromLatin1(name);
        QProcess::execute(QStringLiteral("localedef"),
                          {QStringLiteral("-i"), wanted, QStringLiteral("-f"), QStringLiteral("UTF-8"),
                           m_locales.filePath(wanted + QStringLiteral(".UTF-8"))});
    }
    qputenv("LOCPATH", QFile::encodeName(m_locales.path()));
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8"))
        qInfo("Without localedef and its descriptions only the locales of Qt are looked at.");
    else
        QCOMPARE(QString::fromLatin1(std::localeconv()->decimal_point), QStringLiteral(","));
}

void LocaleTest::initTestCase() {
    makeLocales();
    support::useOwnSettings();
    for (const char* name : {"shapes.ifs", "dos.ifs", "utf8_bom.ifs"})
        m_files << support::testData(QString::fromLatin1(name));
    m_files << support::sourcePath(QStringLiteral("ifs_library/paper.ifs"));
    speak(QLocale::c(), "C");
    for (const QString& path : m_files)
        m_plain << everythingOf(path);
}

void LocaleTest::filesAreTheSame() {
    QFETCH(QString, name);
    speak(name);
    for (qsizetype i = 0; i < m_files.size(); ++i) {
        const QList<Written> here = everythingOf(m_files[i]);
        QCOMPARE(here.size(), m_plain[i].size());
        for (qsizetype k = 0; k < here.size(); ++k)
            QVERIFY2(here[k].bytes == m_plain[i][k].bytes,
                     qPrintable(m_files[i] + QStringLiteral(": ") + here[k].what));
    }
}

void LocaleTest::fieldsTakeTheSame() {
    QFETCH(QString, name);
    speak(name);
    QCOMPARE(view::shortNumber(1234.5), QStringLiteral("1234.5"));
    QCOMPARE(view::fullNumber(0.1), QStringLiteral("0.1"));

    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.openFirstPicture();
    view::MapsModel model(&window.document());
    const auto value = [&] {
        return document::system2(window.document().fractal())->maps[0].map.linear(0, 0);
    };
    QVERIFY(model.setData(model.index(0, view::MapsModel::A), QStringLiteral("0.125")));
    QCOMPARE(value(), 0.125);
    QVERIFY(model.setData(model.index(0, view::MapsModel::A), QStringLiteral("0,25")));
    QCOMPARE(value(), 0.25);
    QVERIFY(!model.setData(model.index(0, view::MapsModel::A), QStringLiteral("1.234,5")));
    QCOMPARE(model.index(0, view::MapsModel::A).data(Qt::EditRole).toDouble(), 0.25);
    QVERIFY(!model.index(0, view::MapsModel::A).data().toString().contains(u','));

    view::NumberField field;
    QTest::keyClicks(&field, QStringLiteral("2.5"));
    QCOMPARE(field.value(), 2.5);
    window.document().undoStack()->setClean();
}

BARYCAGE_TEST(LocaleTest, QApplication);
#include "locale_test.moc"
