// SPDX-License-Identifier: MIT
#include "document/text/file_names.h"
#include "support/named_test.h"

#include <QTest>

#include <initializer_list>
#include <random>

// Names of entries as names of files, and on one line.
class FileNamesTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsHarmlessStays() {
        for (const char* name :
             {"maple", "two words", "Ahorn-ä", "a.b", "100%", "a:b", "back\\slash", "🍁", "❤️"}) {
            const QString text = QString::fromUtf8(name);
            QCOMPARE(document::fileNamePart(text), text);
            QCOMPARE(document::oneLine(text), text);
        }
        const QString byte = QStringLiteral("m") + QChar(0xdce4); // a byte that is no UTF-8
        QCOMPARE(document::fileNamePart(byte), byte);
    }
    void whatCannotBeSeenIsShown() {
        for (const char32_t c : {0xadU, 0x34fU, 0x115fU, 0x17b4U, 0x180bU, 0x200bU, 0x2800U, 0x3164U, 0xfe00U,
                                 0xfe0fU, 0xffa0U, 0xe0100U}) {
            const QString text = u'a' + QString::fromUcs4(&c, 1) + u'b';
            QCOMPARE(document::fileNamePart(text), QStringLiteral("a_b"));
            QCOMPARE(document::oneLine(text), QStringLiteral("a_b"));
        }
        // A name with it is taken for bytes that could not be read.
        QCOMPARE(document::fileNamePart(QStringLiteral("\ufffd")), QStringLiteral("_"));
    }
    void nothingIsEmptyOrAFolder() {
        for (const char* name : {"", ".", "..", "/", "  ", "./"}) {
            const QString part = document::fileNamePart(QString::fromUtf8(name));
            QVERIFY2(part.startsWith(u'_'), qPrintable(part));
            QVERIFY(!part.contains(u'/'));
        }
    }
    void linesStayLines() {
        const QString text = QStringLiteral("a\nb\rc\u2028d\u2029e\u0085f") + QChar(0);
        QCOMPARE(document::oneLine(text), QStringLiteral("a_b_c_d_e_f_"));
        QCOMPARE(document::oneLine(QStringLiteral("../a")), QStringLiteral("../a"));
    }
    void longNamesAreCutBetweenLetters() {
        const QString maples = QStringLiteral("🍁").repeated(100);
        QCOMPARE(document::fileNamePart(maples, 10), QStringLiteral("🍁🍁"));
        QCOMPARE(document::fileNamePart(QStringLiteral("aää"), 4), QStringLiteral("aä"));
    }
    void anyTextBecomesAName() {
        std::mt19937 random(1);
        for (int round = 0; round < 20'000; ++round) {
            QString text;
            for (int i = std::uniform_int_distribution(0, 12)(random); i > 0; --i)
                text += QChar(std::uniform_int_distribution(0, round % 2 ? 255 : 65'535)(random));
            const QString part = document::fileNamePart(text, 20);
            QVERIFY(!part.isEmpty() && part.toUtf8().size() <= 20);
            QVERIFY(!part.startsWith(u'.') && !part.contains(u'/') && !part.contains(u'\n') &&
                    !part.contains(QChar(0)));
            QCOMPARE(document::fileNamePart(part, 20), part);
        }
    }
};

BARYCAGE_TEST(FileNamesTest);
#include "file_names_test.moc"
