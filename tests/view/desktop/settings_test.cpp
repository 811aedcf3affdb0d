// SPDX-License-Identifier: MIT
#include "desktop/settings.h"
#include "support/file_size_limit.h"
#include "support/forget_settings.h"
#include "support/named_test.h"
#include "support/own_settings.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>

#include <sys/stat.h>

class SettingsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init() { support::forgetSettings(); }

    void whatIsStoredIsFound();
    void aSlowDiskIsNotWaitedFor();
    void theOwnerAloneReadsThem();
    void aFullDiskIsSaidOnce();
};

void SettingsTest::whatIsStoredIsFound() {
    QCOMPARE(view::stored(QStringLiteral("a/b"), 7).toInt(), 7);
    for (int i = 0; i < 100; ++i) {
        view::store(QStringLiteral("a/b"), i);
        view::store(QStringLiteral("c%1").arg(i), i);
        QCOMPARE(view::stored(QStringLiteral("a/b"), 7).toInt(), i);
    }
    view::store(QStringLiteral("c3"), {});
    QCOMPARE(view::stored(QStringLiteral("c3"), 7).toInt(), 7);
    view::finishStoring();
    QCOMPARE(QSettings().value(QStringLiteral("a/b")).toInt(), 99);
    QCOMPARE(QSettings().allKeys().size(), 100);
    QVERIFY(!QSettings().contains(QStringLiteral("c3")));
    QSettings().setValue(QStringLiteral("a/b"), 5); // as another process does
    QCOMPARE(view::stored(QStringLiteral("a/b")).toInt(), 5);
    support::forgetSettings();
    view::store(QStringLiteral("other"), 1);
    QCOMPARE(view::stored(QStringLiteral("a/b"), 7).toInt(), 7);
}

// Another process holds the lock that is needed to write the file.
void SettingsTest::aSlowDiskIsNotWaitedFor() {
    const QString file = QSettings().fileName();
    view::store(QStringLiteral("first"), 1);
    view::finishStoring();
    QFile lock(file + QStringLiteral(".lock"));
    QVERIFY(lock.open(QIODevice::WriteOnly));
    lock.write("1\nsomebody\nelsewhere\n");
    lock.flush();
    view::store(QStringLiteral("second"), 2);
    QCOMPARE(view::stored(QStringLiteral("second")).toInt(), 2);
    QFile held(file);
    QVERIFY(held.open(QIODevice::ReadOnly));
    QVERIFY(!held.readAll().contains("second")); // not yet
    lock.remove();
    view::finishStoring();
    QCOMPARE(QSettings().value(QStringLiteral("second")).toInt(), 2);
}

// From the first time on, whatever the umask says; also what an earlier version has left to others.
void SettingsTest::theOwnerAloneReadsThem() {
    const QString file = QSettings().fileName();
    const QString folder = QFileInfo(file).path();
    const auto modeOf = [](const QString& path) {
        struct stat status {};
        return ::stat(QFile::encodeName(path).constData(), &status) == 0 ? status.st_mode & 07777 : 0;
    };
    QVERIFY(QDir(folder).removeRecursively());
    const mode_t before = ::umask(0022);
    view::store(QStringLiteral("first"), 1);
    view::finishStoring();
    const auto modes = std::pair(modeOf(folder), modeOf(file));
    ::umask(before);
    QCOMPARE(modes, std::pair(mode_t(0700), mode_t(0600)));
    QCOMPARE(::chmod(QFile::encodeName(folder).constData(), 0755), 0);
    QCOMPARE(::chmod(QFile::encodeName(file).constData(), 0644), 0);
    view::store(QStringLiteral("first"), 2);
    view::finishStoring();
    QCOMPARE(modeOf(folder), mode_t(0700));
    QCOMPARE(modeOf(file), mode_t(0600));
    QCOMPARE(QSettings().value(QStringLiteral("first")).toInt(), 2);
}

void SettingsTest::aFullDiskIsSaidOnce() {
    QSignalSpy said(view::storingReport(), &view::StoringReport::cannotStore);
    const auto stored = [](int value) {
        view::store(QStringLiteral("a"), value);
        view::finishStoring();
        QCoreApplication::sendPostedEvents(); // from the thread that writes
    };
    stored(1);
    QCOMPARE(said.size(), 0);
    for (int times = 1; times <= 2; ++times) {
        support::FileSizeLimit full(0);
        QVERIFY(full.isSet());
        stored(10 * times);
        QCOMPARE(said.size(), times);
        QVERIFY(said.last().first().toString().contains(QSettings().fileName()));
        stored(10 * times + 1);
        QCOMPARE(said.size(), times);
        full.lift();
        stored(10 * times + 2);
        QCOMPARE(said.size(), times);
        QFile file(QSettings().fileName());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("a=" + QByteArray::number(10 * times + 2)));
    }
}

BARYCAGE_TEST(SettingsTest, QCoreApplication);
#include "settings_test.moc"
