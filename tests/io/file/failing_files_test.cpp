// SPDX-License-Identifier: MIT
#include "document/disk/journal.h"
#include "io/exports/task_folder.h"
#include "support/faults.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/thorough.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using support::Ended;
using support::FaultyProgram;
using support::Lasting;

// What only the window writes, while each system call and each request for memory fails in turn: what was
// there is there, or the new one, whole, and nothing else. Qt may end the program when memory is missing.
class FailingFilesTest : public QObject {
    Q_OBJECT

private slots:
    void everyFileIsOldOrNew_data();
    void everyFileIsOldOrNew();
};

namespace {

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

// What is in the folder, a word for each file or folder; of files whose process ended, what they offer.
QStringList stateOf(const QString& kind, const QString& folder) {
    QStringList state;
    if (kind == u"recovery") {
        for (const document::Abandoned& found : document::abandonedSnapshots(folder))
            state << QString::fromLatin1(found.snapshot.bytes);
        if (!document::setDamagedAside(folder).isEmpty()) state << QStringLiteral("damaged");
        return state;
    }
    if (kind == u"task") {
        io::TaskFolder tasks(folder);
        const io::TaskFolder::TakenOver taken = tasks.takeOver();
        for (const io::TaskFolder::Found& found : taken.tasks)
            state << QFileInfo(found.task.path).baseName();
        return state + taken.skipped;
    }
    const auto files = support::contentsOf(folder);
    for (auto at = files.begin(); at != files.end(); ++at)
        state << at.key() + QStringLiteral(": ") + QString::fromUtf8(at.value());
    for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot | QDir::Hidden)) {
        const auto inner = support::contentsOf(QDir(folder).filePath(name));
        for (auto at = inner.begin(); at != inner.end(); ++at)
            state << name + u'/' + at.key() + QStringLiteral(": ") + QString::fromUtf8(at.value());
        if (inner.isEmpty()) state << name;
    }
    return state;
}

// A run in a folder of its own, and what it leaves there.
class Run {
public:
    explicit Run(const QString& kind) : m_kind(kind) {
        write(m_folder.filePath(QStringLiteral("a.ifs")), "new");
        if (kind == u"lesson") write(m_folder.filePath(QStringLiteral("a.lesson")), "old");
        if (kind == u"previous") write(m_folder.filePath(QStringLiteral("a.ifs~")), "older");
        if (kind == u"recovery" || kind == u"task") QFile::remove(m_folder.filePath(QStringLiteral("a.ifs")));
    }

    FaultyProgram program() const {
        return {{support::buildPath(QStringLiteral("tests/support/writing")), m_kind, m_folder.path()},
                support::markOfWriting()};
    }
    QStringList state() const { return stateOf(m_kind, m_folder.path()); }

private:
    QString m_kind;
    QTemporaryDir m_folder;
};

} // namespace

void FailingFilesTest::everyFileIsOldOrNew_data() {
    QTest::addColumn<QStringList>("old"); // as stateOf() has it
    const QString file = QStringLiteral("a.ifs: new");
    QTest::newRow("recovery") << QStringList(QStringLiteral("old"));
    QTest::newRow("task") << QStringList(QStringLiteral("old"));
    QTest::newRow("lesson") << QStringList{file, QStringLiteral("a.lesson: old")};
    QTest::newRow("previous") << QStringList{file, QStringLiteral("a.ifs~: older")};
    QTest::newRow("cluster") << QStringList(file);
}

void FailingFilesTest::everyFileIsOldOrNew() {
    QFETCH(const QStringList, old);
    const QString kind = QString::fromLatin1(QTest::currentDataTag());
    const Run whole(kind);
    Ended ended;
    const auto calls = whole.program().calls(ended);
    if (!calls) QSKIP("The kernel does not let a program answer the calls of another one.");
    QCOMPARE(ended.status, 0);
    QVERIFY(calls->size() > 5);
    const QStringList expected = whole.state();
    QVERIFY(expected != old && !expected.isEmpty());
    const auto judge = [&](const Run& run, const Ended& now, const QByteArray& what) {
        const QStringList state = run.state();
        const QByteArray said = what + ", status " + QByteArray::number(now.status) + ": " +
                                state.join(QStringLiteral(", ")).left(300).toUtf8() + now.err;
        QVERIFY2(state == expected || (now.status != 0 && state == old), said.constData());
    };
    const int turn = int(qHash(QByteArray(QTest::currentDataTag())) % 1000);
    const int most = support::isThorough() ? int(calls->size()) : 5;
    for (const Lasting lasting : {Lasting::No, Lasting::Yes}) {
        if (lasting == Lasting::Yes && kind == u"cluster") continue; // what may not be listed is not removed
        for (const int which : support::sampleOf(*calls, most, turn)) {
            const Run run(kind);
            const Ended now = run.program().withFailingCall(which, lasting);
            judge(run, now, calls->at(which - 1) + ", call " + QByteArray::number(which));
            QVERIFY2(now.status == 0 || now.status == 3, now.err.constData());
            if (QTest::currentTestFailed()) return;
        }
    }
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which have an allocator of their own
    const long count = Run(kind).program().allocations();
    QVERIFY(count > 20);
    for (const long which : support::sampleOf(count, support::isThorough() ? 1000 : 3, turn)) {
        const Run run(kind);
        const Ended now = run.program().withFailingAllocation(which, Lasting::No);
        if (now.status < 0 && kind == u"cluster") continue; // Qt ended the program between two of its files
        judge(run, now, "allocation " + QByteArray::number(qint64(which)));
        if (QTest::currentTestFailed()) return;
    }
#endif
}

BARYCAGE_TEST(FailingFilesTest, QCoreApplication);
#include "failing_files_test.moc"
