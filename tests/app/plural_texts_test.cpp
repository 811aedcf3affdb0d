// SPDX-License-Identifier: MIT
#include "support/paths.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>

namespace {

QString contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

// A text that counts ("%n entries") has its English singular in the catalogue that the programs carry.
class PluralTextsTest : public QObject {
    Q_OBJECT

private slots:
    void everyCountingTextIsInTheCatalogue() {
        const QString catalogue =
            contents(support::sourcePath(QStringLiteral("resources/translations/barycage_en.ts")));
        const QRegularExpression counting(QStringLiteral("\"([^\"\\n]*%n[^\"\\n]*)\""));
        int found = 0;
        for (const char* folder : {"app", "model", "view"}) {
            QDirIterator it(support::sourcePath(QLatin1String(folder)), {QStringLiteral("*.cpp")},
                            QDir::Files, QDirIterator::Subdirectories);
            while (it.hasNext()) {
                const QString path = it.next();
                QRegularExpressionMatchIterator texts = counting.globalMatch(contents(path));
                while (texts.hasNext()) {
                    const QString text = texts.next().captured(1);
                    ++found;
                    QVERIFY2(catalogue.contains(text.toHtmlEscaped()),
                             qPrintable(path + QStringLiteral(": ") + text +
                                        QStringLiteral(" — see lupdate in resources/CMakeLists.txt")));
                }
            }
        }
        QVERIFY(found > 5);
        QVERIFY(!catalogue.contains(QStringLiteral("unfinished")));
    }

    void oneIsSingular() {
        QTranslator english;
        QVERIFY(english.load(QStringLiteral(":/translations/barycage_en.qm")));
        QCOMPARE(english.translate("MainWindow", "%n entries", nullptr, 1), QStringLiteral("%n entry"));
        QCOMPARE(english.translate("MainWindow", "%n entries", nullptr, 2), QStringLiteral("%n entries"));
        QCOMPARE(english.translate("MainWindow", "%n entries", nullptr, 0), QStringLiteral("%n entries"));
    }
};

QTEST_GUILESS_MAIN(PluralTextsTest)
#include "plural_texts_test.moc"
