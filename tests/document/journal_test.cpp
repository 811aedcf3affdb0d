// SPDX-License-Identifier: MIT
#include "document/disk/journal.h"
#include "support/file_size_limit.h"
#include "support/named_test.h"
#include "support/unprivileged.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/stat.h>

using document::Journal;
using document::Snapshot;

class JournalTest : public QObject {
    Q_OBJECT

private slots:
    void aLivingWindowIsNotAbandoned();
    void whatWasWrittenIsOfferedAfterTheProcessIsGone();
    void aKilledProcessLeavesItsLastSnapshot();
    void leftoversAreTakenAway();
    void discardedWorkIsNotOffered();
    void damagedJournalsAreIgnored();
    void damagedJournalsAreSetAside();
    void onlyTheOwnerMayRead();
    void anUnsavedLessonIsKeptAlong();
    void everyByteCounts();
    void filesOfEarlierVersionsAreRead();
    void aPipeIsNotWaitedFor();
    void aFolderThatMayNotBeWrittenIsSaid();
    void withoutRoomTheLastSnapshotStays();
    void lockAndFolderAreMadeAgain();
    void theSameWorkIsOfferedOnce();
    void aLockThatNamesNobodyHidesNothing();
    void hostileRecoveryFilesAreIgnored();
};

namespace {

Snapshot snapshot(const QByteArray& bytes) {
    return {QStringLiteral("/somewhere/ferns.ifs"),
            QStringLiteral("ferns.ifs"),
            3,
            QDateTime::fromMSecsSinceEpoch(1'700'000'000'123, Qt::UTC),
            bytes,
            QByteArray(32, '\x9c')};
}

QStringList journalsIn(const QString& folder) {
    return QDir(folder).entryList({QStringLiteral("*.journal")}, QDir::Files);
}

} // namespace

// A file that may not grow is the nearest thing to a full disk that a test can have.
void JournalTest::anUnsavedLessonIsKeptAlong() {
    Snapshot kept = snapshot("a");
    QVERIFY(!document::recoveryFile(kept).contains("lesson")); // as in earlier versions
    kept.lesson = "lesson: Ferns\n\n## One\n\nWhat is “self-similar”?\n";
    kept.lessonPath = QStringLiteral("/somewhere/ferns.lesson");
    const QByteArray file = document::recoveryFile(kept);
    QVERIFY(document::snapshotIn(file) == kept);
    QVERIFY(!document::snapshotIn(QByteArray(file).replace("One", "Two"))); // damaged
}

void JournalTest::withoutRoomTheLastSnapshotStays() {
    const QTemporaryDir folder;
    Snapshot last = snapshot("kept");
    {
        Journal journal(folder.path());
        QVERIFY(journal.write(last));
        support::FileSizeLimit limit(0);
        QVERIFY(limit.isSet());
        const bool written = journal.write(snapshot("lost"));
        limit.lift();
        QVERIFY(!written);
    }
    const auto found = document::abandonedSnapshots(folder.path());
    QCOMPARE(found.size(), 1);
    QCOMPARE(found.front().snapshot, last);
}

void JournalTest::lockAndFolderAreMadeAgain() {
    const QTemporaryDir folder;
    const QString place = folder.filePath(QStringLiteral("recovery"));
    QFile inTheWay(place); // no folder can be made there
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    Journal journal(place);
    QVERIFY(!journal.write(snapshot("a")));
    QVERIFY(inTheWay.remove());
    QVERIFY(journal.write(snapshot("b")));
    QVERIFY(document::abandonedSnapshots(place).isEmpty()); // it lives, and that is known
    QVERIFY(QDir(place).removeRecursively());
    QVERIFY(journal.write(snapshot("c")));
    QCOMPARE(journalsIn(place).size(), 1);
    QVERIFY(document::abandonedSnapshots(place).isEmpty());
}

void JournalTest::theSameWorkIsOfferedOnce() {
    const QTemporaryDir folder;
    for (const char* bytes : {"a", "b", "a"})
        QVERIFY(Journal(folder.path()).write(snapshot(bytes)));
    QCOMPARE(document::abandonedSnapshots(folder.path()).size(), 2);
    QCOMPARE(journalsIn(folder.path()).size(), 2);
}

void JournalTest::aLockThatNamesNobodyHidesNothing() {
    const auto programName = [] {
        return QFileInfo(QCoreApplication::applicationFilePath()).fileName().toUtf8();
    };
    const QTemporaryDir folder;
    { QVERIFY(Journal(folder.path()).write(snapshot("a"))); }
    const QString journal = folder.filePath(journalsIn(folder.path()).front());
    QFile lock(journal + QStringLiteral(".lock"));
    // Nobody's, or that of a process which now is another one: this.
    for (const QByteArray& owner :
         {QByteArray(), QByteArray::number(QCoreApplication::applicationPid()) + "\n" + programName() + "\n" +
                            QSysInfo::machineHostName().toUtf8() + "\n\n\n"}) {
        for (const int seconds : {-60, 0, 3600}) { // the clock has been set back since
            QVERIFY(lock.open(QIODevice::WriteOnly));
            QCOMPARE(lock.write(owner), owner.size());
            lock.flush();
            QVERIFY(
                lock.setFileTime(QDateTime::currentDateTime().addSecs(seconds), QFile::FileModificationTime));
            lock.close();
            QCOMPARE(document::abandonedSnapshots(folder.path()).size(), 1);
            QVERIFY(!lock.exists());
        }
    }
}

void JournalTest::aLivingWindowIsNotAbandoned() {
    const QTemporaryDir folder;
    Journal journal(folder.path());
    QVERIFY(journal.write(snapshot("a")));
    QVERIFY(document::abandonedSnapshots(folder.path()).isEmpty());
}

void JournalTest::whatWasWrittenIsOfferedAfterTheProcessIsGone() {
    const QTemporaryDir folder;
    const QByteArray bytes("fern {\r\n\0 ; \xe9\n}\x1a", 17);
    {
        Journal journal(folder.path());
        QVERIFY(journal.write(snapshot("older")));
        QVERIFY(journal.write(snapshot(bytes)));
    }
    const auto offered = document::abandonedSnapshots(folder.path());
    QCOMPARE(offered.size(), 1);
    QVERIFY(offered.first().snapshot == snapshot(bytes));
    document::forget(offered.first());
    QVERIFY(document::abandonedSnapshots(folder.path()).isEmpty());
    QVERIFY(journalsIn(folder.path()).isEmpty());
}

void JournalTest::aKilledProcessLeavesItsLastSnapshot() {
    const QTemporaryDir folder;
    QProcess writer; // this program again, writing until it is killed
    writer.start(QCoreApplication::applicationFilePath(),
                 {QStringLiteral("journal_test"), QStringLiteral("--write-until-killed"), folder.path()});
    QVERIFY(writer.waitForReadyRead());
    writer.kill();
    QVERIFY(writer.waitForFinished());
    const int announced = writer.readAllStandardOutput().split('\n').first().toInt();
    const auto offered = document::abandonedSnapshots(folder.path());
    QCOMPARE(offered.size(), 1);
    QVERIFY(offered.first().snapshot.bytes.toInt() >= announced);
}

// Locks, and files that were being written, of killed processes; not what belongs to a living window.
void JournalTest::leftoversAreTakenAway() {
    const QTemporaryDir folder;
    QProcess writer;
    writer.start(QCoreApplication::applicationFilePath(),
                 {QStringLiteral("journal_test"), QStringLiteral("--write-until-killed"), folder.path()});
    QVERIFY(writer.waitForReadyRead());
    writer.kill();
    QVERIFY(writer.waitForFinished());
    const QString dead = folder.filePath(journalsIn(folder.path()).value(0));
    QFile half(dead + QStringLiteral(".Xy12Ab"));
    QVERIFY(half.open(QIODevice::WriteOnly) && QFile::exists(dead + QStringLiteral(".lock")));
    Journal living(folder.path());
    QVERIFY(living.write(snapshot("a")));
    {
        const auto offered = document::abandonedSnapshots(folder.path());
        QCOMPARE(offered.size(), 1);
        QVERIFY(document::abandonedSnapshots(folder.path()).isEmpty()); // it is being offered
        document::forget(offered.first());
    }
    QCOMPARE(journalsIn(folder.path()).size(), 1);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 2); // the living window's and its lock
    QVERIFY(living.write(snapshot("b")));
}

void JournalTest::discardedWorkIsNotOffered() {
    const QTemporaryDir folder;
    {
        Journal journal(folder.path());
        QVERIFY(journal.write(snapshot("a")));
        journal.discard();
    }
    QVERIFY(document::abandonedSnapshots(folder.path()).isEmpty());
}

void JournalTest::damagedJournalsAreIgnored() {
    const QTemporaryDir folder;
    {
        Journal journal(folder.path());
        QVERIFY(journal.write(snapshot("some bytes that matter")));
    }
    const QString path = folder.filePath(journalsIn(folder.path()).value(0));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    const QByteArray whole = file.readAll();
    for (qsizetype length = 0; length < whole.size(); ++length) {
        file.resize(0);
        file.seek(0);
        file.write(whole.left(length));
        file.flush();
        QVERIFY(document::abandonedSnapshots(folder.path()).isEmpty());
    }
}

// The one that is damaged, not what is offered, nor a living window's; and once.
void JournalTest::damagedJournalsAreSetAside() {
    const QTemporaryDir folder;
    const auto written = [&](const QByteArray& bytes) {
        QFile file(folder.filePath(QString::fromLatin1(bytes) + QStringLiteral(".journal")));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
    };
    QVERIFY(written("broken"));
    Journal living(folder.path());
    QVERIFY(living.write(snapshot("a")));
    { // whole, of a process that is gone
        Journal gone(folder.path());
        QVERIFY(gone.write(snapshot("b")));
    }
    const QString aside = folder.filePath(QStringLiteral("broken.damaged"));
    QCOMPARE(document::setDamagedAside(folder.path()), QStringList{aside});
    QFile kept(aside);
    QVERIFY(kept.open(QIODevice::ReadOnly));
    QCOMPARE(kept.readAll(), QByteArray("broken"));
    QVERIFY(document::setDamagedAside(folder.path()).isEmpty());
    const auto offered = document::abandonedSnapshots(folder.path());
    QCOMPARE(offered.size(), 1);
    QCOMPARE(offered.first().snapshot.bytes, QByteArray("b"));
    QVERIFY(QFile::exists(aside));
}

// Whatever the umask, and when the folder is there already.
void JournalTest::onlyTheOwnerMayRead() {
    const QTemporaryDir parent;
    const QString folder = parent.filePath(QStringLiteral("recovery"));
    const auto mode = [](const QString& path) {
        struct stat status = {};
        return ::stat(QFile::encodeName(path).constData(), &status) == 0 ? status.st_mode & 07777U : ~0U;
    };
    const mode_t before = ::umask(0);
    Journal journal(folder);
    const bool written = journal.write(snapshot("a"));
    ::umask(before);
    QVERIFY(written);
    QCOMPARE(mode(folder), 0700U);
    QCOMPARE(mode(QDir(folder).filePath(journalsIn(folder).value(0))), 0600U);
    QCOMPARE(::chmod(QFile::encodeName(folder).constData(), 0755), 0);
    Journal another(folder);
    QVERIFY(another.write(snapshot("b")));
    QCOMPARE(mode(folder), 0700U);
    const QStringList files = QDir(folder).entryList(QDir::Files);
    QCOMPARE(files.size(), 4); // two journals, each with its lock
    for (const QString& file : files)
        QCOMPARE(mode(QDir(folder).filePath(file)), 0600U);
}

// A title that is another one is damage as well.
void JournalTest::everyByteCounts() {
    Snapshot whole = snapshot("a");
    whole.lesson = "lesson";
    whole.lessonPath = QStringLiteral("/a.lesson");
    const QByteArray file = document::recoveryFile(whole);
    QVERIFY(document::snapshotIn(file));
    for (qsizetype i = 0; i < file.size(); ++i) {
        QByteArray damaged = file;
        damaged[i] = char(damaged[i] ^ 1);
        const auto read = document::snapshotIn(damaged);
        QVERIFY2(!read || *read == whole, damaged.constData());
    }
}

// Without the digest of the header.
void JournalTest::filesOfEarlierVersionsAreRead() {
    QByteArray file = document::recoveryFile(snapshot("a"));
    const qsizetype begin = file.indexOf("\"digest\":");
    QVERIFY(begin > 0);
    file.remove(begin, file.indexOf(',', begin) + 1 - begin);
    const auto read = document::snapshotIn(file);
    QVERIFY(read && *read == snapshot("a"));
}

void JournalTest::aPipeIsNotWaitedFor() {
    const QTemporaryDir folder;
    const QString pipe = folder.filePath(QStringLiteral("pipe"));
    const QString lock = folder.filePath(QStringLiteral("b.journal.lock"));
    for (const QString& name : {pipe, lock})
        QCOMPARE(::mkfifo(QFile::encodeName(name).constData(), 0600), 0);
    const timespec longAgo[2] = {};
    QCOMPARE(::utimensat(AT_FDCWD, QFile::encodeName(lock).constData(), longAgo, 0), 0);
    QVERIFY(QFile::link(pipe, folder.filePath(QStringLiteral("a.journal"))));
    QVERIFY(QFile::link(pipe, folder.filePath(QStringLiteral("b.journal"))));
    QVERIFY(document::abandonedSnapshots(folder.path()).isEmpty());
    document::setDamagedAside(folder.path());
}

void JournalTest::aFolderThatMayNotBeWrittenIsSaid() {
    const QTemporaryDir folder;
    Journal journal(folder.path());
    const support::Unprivileged nobody(folder.path());
    QVERIFY(nobody.isInForce());
    QVERIFY(journal.write(snapshot("kept")));
    QVERIFY(QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::ExeOwner));
    const bool written = journal.write(snapshot("lost"));
    QVERIFY(QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    QVERIFY(!written);
    QFile file(folder.filePath(journalsIn(folder.path()).value(0)));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto kept = document::snapshotIn(file.readAll());
    QVERIFY(kept && kept->bytes == "kept");
}

void JournalTest::hostileRecoveryFilesAreIgnored() {
    const QByteArray digest = QCryptographicHash::hash({}, QCryptographicHash::Sha256).toHex();
    const QByteArray head = "barycage-journal 1\n";
    QVERIFY(document::snapshotIn(head + R"({"sha256":")" + digest + "\"}\n")); // nothing else is needed
    QVERIFY(!document::snapshotIn(head + R"({"sha256":")" + digest + "\"}\nx"));
    QVERIFY(!document::snapshotIn(head + QByteArray("[").repeated(100'000) + "\n"));
    QVERIFY(!document::snapshotIn(head + R"({"sha256":1})" + "\n"));
    const auto odd =
        document::snapshotIn(head + R"({"current":1e300,"when":[],"title":{},"sha256":")" + digest + "\"}\n");
    QVERIFY(odd && odd->current == 0 && odd->title.isEmpty() && !odd->when.isValid());
}

static int run(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == QLatin1String("--write-until-killed")) {
        Journal journal(arguments.value(2));
        for (int i = 0;; ++i) {
            journal.write(snapshot(QByteArray::number(i)));
            fprintf(stdout, "%d\n", i);
            fflush(stdout);
        }
    }
    JournalTest test;
    return QTest::qExec(&test, argc, argv);
}

static const support::NamedTest namedJournal(__FILE__, run);

#include "journal_test.moc"
