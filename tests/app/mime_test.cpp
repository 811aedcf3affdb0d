// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "support/paths.h"

#include <QDir>
#include <QMimeDatabase>
#include <QTemporaryDir>
#include <QTest>

// Desktops know collections by their name, and most of them by what is in them.
class MimeTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void byName();
    void byContent();
    void lessons();
    void otherTextsAreLeftAlone_data();
    void otherTextsAreLeftAlone();

private:
    QTemporaryDir m_data;
    const QString m_type = QStringLiteral("application/x-fractint-ifs");
};

void MimeTest::initTestCase() {
    QVERIFY(QDir(m_data.path()).mkpath(QStringLiteral("mime/packages")));
    QVERIFY(QFile::copy(support::sourcePath(QStringLiteral("resources/linux/mime.xml")),
                        m_data.filePath(QStringLiteral("mime/packages/barycage.xml"))));
    qputenv("XDG_DATA_HOME", m_data.path().toLocal8Bit());
}

void MimeTest::byName() {
    const QMimeDatabase database;
    QVERIFY(database.mimeTypeForName(m_type).isValid());
    QVERIFY(database.mimeTypeForName(m_type).inherits(QStringLiteral("text/plain")));
    QCOMPARE(database.mimeTypeForFile(QStringLiteral("Some Ferns.IFS"), QMimeDatabase::MatchExtension).name(),
             m_type);
}

void MimeTest::byContent() {
    const QMimeDatabase database;
    const QDir library(support::sourcePath(QStringLiteral("ifs_library")));
    const QFileInfoList files = library.entryInfoList({QStringLiteral("*.ifs")});
    QVERIFY(files.size() > 8);
    for (const QFileInfo& info : files) {
        QFile file(info.filePath());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(database.mimeTypeForData(file.readAll()).name(), m_type);
    }
    for (const char* text : {"fern {; Barnsley\r\n 0 0 0 .16 0 0 .01\r\n .85 .04 -.04 .85 0 1.6 .99 }\r\n",
                             "a {\n-0.5 0 0 .5 0 0 .5\n0.5 0 0 .5 1 0 .5\n}\n", "a { ; barycage: 1\n}\n"})
        QCOMPARE(database.mimeTypeForData(QByteArray(text)).name(), m_type);
}

void MimeTest::lessons() {
    const QMimeDatabase database;
    const QString type = QStringLiteral("application/x-barycage-lesson");
    QVERIFY(database.mimeTypeForName(type).inherits(QStringLiteral("text/plain")));
    QCOMPARE(database.mimeTypeForFile(QStringLiteral("My.lesson"), QMimeDatabase::MatchExtension).name(),
             type);
    const QDir folder(support::sourcePath(QStringLiteral("resources/lessons")));
    for (const QFileInfo& info : folder.entryInfoList({QStringLiteral("*.lesson")})) {
        QFile file(info.filePath());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(database.mimeTypeForData(file.readAll()).name(), type);
    }
    QVERIFY(database.mimeTypeForData(QByteArray("lesson: plan for Monday\nRead chapter 3.\n")).name() !=
            type);
    QFile desktop(support::sourcePath(QStringLiteral("resources/linux/barycage.desktop.in")));
    QVERIFY(desktop.open(QIODevice::ReadOnly));
    const QByteArray entry = desktop.readAll();
    QVERIFY(entry.contains("\nMimeType=" + m_type.toUtf8() + ';' + type.toUtf8() +
                           ";x-scheme-handler/barycage;\n"));
    QVERIFY(entry.contains("\nExec=barycage %U\n")); // with %F, a desktop passes no links
}

void MimeTest::otherTextsAreLeftAlone_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("sentences") << QByteArray("Chapter 1 {draft}\nOnce upon a time there was a fern.\n");
    QTest::newRow("numbers") << QByteArray("0.5 0.25\n.5 .75\n");
    QTest::newRow("settings") << QByteArray("/var/log/some.log {\n    weekly\n    rotate 4\n}\n");
    QTest::newRow("program") << QByteArray("#!/bin/sh\nf() {\n  echo 0.5\n}\n");
}

void MimeTest::otherTextsAreLeftAlone() {
    QFETCH(QByteArray, text);
    QVERIFY(QMimeDatabase().mimeTypeForData(text).name() != m_type);
}

BARYCAGE_TEST(MimeTest, QCoreApplication);
#include "mime_test.moc"
