// SPDX-License-Identifier: MIT
#include "io/file/hard_links.h"
#include "io/file/save_file.h"
#include "io/file/standard_output.h"
#include "support/refusing_kernel.h"
#include "support/unprivileged.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <thread>

#ifdef Q_OS_UNIX
#include "support/file_size_limit.h"
#include "support/named_test.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif
#ifdef Q_OS_LINUX
#include <sys/xattr.h>
#endif

namespace {

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(unreadable)");
}

void put(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot prepare %s", qPrintable(path));
}

#ifdef Q_OS_LINUX
// In the format of the kernel: the owner reads and writes, one other user reads, nobody else does.
QByteArray accessList(quint32 user) {
    QByteArray bytes;
    const auto number = [&bytes](quint32 value, int size) {
        for (int i = 0; i < size; ++i)
            bytes += char(value >> (8 * i));
    };
    constexpr quint32 nobody = 0xffffffff;
    number(2, 4); // version
    for (const auto& [tag, rights, id] : {std::array<quint32, 3>{0x01, 6, nobody},
                                          {0x02, 4, user},
                                          {0x04, 0, nobody},
                                          {0x10, 4, nobody},
                                          {0x20, 0, nobody}}) {
        number(tag, 2);
        number(rights, 2);
        number(id, 4);
    }
    return bytes;
}
#endif

#ifdef Q_OS_UNIX
// What call() returns while standard output is another file.
template <class Call> auto withOutput(int file, Call call) {
    std::fflush(stdout);
    const int before = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    ::dup2(file, STDOUT_FILENO);
    const auto result = call();
    ::dup2(before, STDOUT_FILENO);
    ::close(before);
    return result;
}
#endif

bool isNamingRefused = false;

QStringList everythingIn(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
}

bool says(const io::Failure& failure, const QString& words) {
    return failure && failure->contains(words);
}

} // namespace

#ifdef Q_OS_LINUX
// Some systems create files without a name and do not let them have one later.
extern "C" int linkat(int from, const char* path, int to, const char* name, int flags) noexcept {
    if (!isNamingRefused) return int(::syscall(SYS_linkat, from, path, to, name, flags));
    errno = EPERM;
    return -1;
}
#endif

class SaveFileTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        support::readsFail = support::linksAreProtected = false;
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_path = m_folder->filePath(QStringLiteral("a.ifs"));
    }

    void writesAndReads() {
        const QByteArray bytes("a {\0\r\n}", 7);
        QCOMPARE(io::saveFile(m_path, bytes), io::Failure());
        QCOMPARE(contents(m_path), bytes);
        const io::Loaded loaded = io::loadFile(m_path);
        QVERIFY(!loaded.failure);
        QCOMPARE(loaded.bytes, bytes);
        QCOMPARE(everythingIn(m_folder->path()),
                 QStringList{QStringLiteral("a.ifs")}); // nothing temporary is left
    }

    // As what puts an index in front of a video does.
    void isReadAndWrittenAnywhere() {
        io::NewFile file(m_path);
        QCOMPARE(file.write("0123456789"), 10);
        QVERIFY(file.seek(2));
        QCOMPARE(file.read(3), QByteArray("234"));
        QCOMPARE(file.write("ab"), 2);
        QVERIFY(file.seek(12));
        QCOMPARE(file.write("z"), 1);
        QVERIFY(file.seek(0));
        QCOMPARE(file.read(100), QByteArray("01234ab789\0\0z", 13));
        QVERIFY(!QFile::exists(m_path));
        QCOMPARE(file.commit(), io::Failure());
        QCOMPARE(contents(m_path), QByteArray("01234ab789\0\0z", 13));
    }

    // Whoever seeks may not look at the result.
    void refusedSeeksAreRemembered() {
        put(m_path, "old");
        for (const QString& path : {m_path, io::standardOutputPath()}) {
            io::NewFile file(path);
            QCOMPARE(file.write("new"), 3);
            QVERIFY(!file.seek(-1));
            QCOMPARE(file.write("er"), 2);
            QVERIFY(file.failure());
            const io::Failure failure = file.commit();
            QVERIFY(failure && failure->contains(QString::fromLocal8Bit(std::strerror(EINVAL))));
        }
        QCOMPARE(contents(m_path), QByteArray("old"));
    }

#ifdef Q_OS_UNIX
    // Node.js and others start programs with such pipes.
    void aFullPipeIsWaitedFor() {
        const QByteArray bytes(1 << 20, 'x');
        std::array<int, 2> pipe{};
        QVERIFY(::pipe(pipe.data()) == 0 && ::fcntl(pipe[1], F_SETFL, O_NONBLOCK) == 0);
        QByteArray read;
        std::thread reader([&] {
            for (pollfd end{pipe[1], POLLOUT, 0}; ::poll(&end, 1, 0) == 1;) // until it is full
                std::this_thread::yield();
            std::array<char, 4096> piece{};
            for (ssize_t size = 1; size > 0; read.append(piece.data(), qsizetype(size)))
                size = std::max<ssize_t>(0, ::read(pipe[0], piece.data(), piece.size()));
        });
        const auto [failure, isPrinted] = withOutput(pipe[1], [&] {
            const io::Failure found = io::saveFile(io::standardOutputPath(), bytes);
            return std::pair(found, io::printBytes(bytes.constData(), std::size_t(bytes.size())));
        });
        ::close(pipe[1]);
        reader.join();
        ::close(pipe[0]);
        QCOMPARE(failure, io::Failure());
        QVERIFY(isPrinted);
        QCOMPARE(read, bytes + bytes);
    }

    void outputThatFailsIsSaidWithTheReason() {
        const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
        if (full < 0) QSKIP("needs /dev/full");
        const io::Failure failure =
            withOutput(full, [] { return io::saveFile(io::standardOutputPath(), "x"); });
        ::close(full);
        QCOMPARE(failure, QStringLiteral("Standard output cannot be written to: %1.")
                              .arg(QString::fromLocal8Bit(std::strerror(ENOSPC))));
    }
#endif

    void keepsPermissions() {
        put(m_path, "old");
        const auto permissions = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner | QFile::ReadGroup;
        QVERIFY(QFile::setPermissions(m_path, permissions));
        QCOMPARE(io::saveFile(m_path, "new"), io::Failure());
        QCOMPARE(contents(m_path), QByteArray("new"));
        const auto kept = QFile::permissions(m_path) & (permissions | QFile::ReadOther | QFile::WriteGroup);
        QCOMPARE(kept, permissions);
    }

    void followsSymbolicLinks() {
        put(m_path, "old");
        const QString link = m_folder->filePath(QStringLiteral("link.ifs"));
        const QString chain = m_folder->filePath(QStringLiteral("chain.ifs"));
        QVERIFY(QFile::link(QStringLiteral("a.ifs"), link));
        QVERIFY(QFile::link(link, chain));
        QCOMPARE(io::saveFile(chain, "new"), io::Failure());
        QVERIFY(QFileInfo(chain).isSymLink());
        QVERIFY(QFileInfo(link).isSymLink());
        QVERIFY(!QFileInfo(m_path).isSymLink());
        QCOMPARE(contents(m_path), QByteArray("new"));
    }

    // The parent of a linked folder is not the folder that contains the link.
    void linksAreFollowedAsTheSystemDoes() {
        const auto at = [this](const char* name) { return m_folder->filePath(QLatin1String(name)); };
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("b/c")));
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("a")));
        QVERIFY(QFile::link(QStringLiteral("../b/c"), at("a/elsewhere")));
        QVERIFY(QFile::link(QStringLiteral("../x.ifs"), at("b/c/link.ifs")));
        put(at("a/x.ifs"), "another's");
        put(at("b/x.ifs"), "old");
        QCOMPARE(io::saveFile(at("a/elsewhere/link.ifs"), "new"), io::Failure());
        QCOMPARE(contents(at("b/x.ifs")), QByteArray("new"));
        QCOMPARE(contents(at("a/x.ifs")), QByteArray("another's"));
        QVERIFY(QFileInfo(at("b/c/link.ifs")).isSymLink());
        QCOMPARE(io::saveFile(at("a/elsewhere/../y.ifs"), "new"), io::Failure());
        QVERIFY(QFileInfo::exists(at("b/y.ifs")));
        QVERIFY(!QFileInfo::exists(at("a/y.ifs")));
    }

    // Names are bytes; Qt knows those that are UTF-8.
    void linksLeadToNamesThatAreNotUtf8() {
        const QByteArray folder = QFile::encodeName(m_folder->path());
        const QByteArray file = folder + "/f\xff.ifs";
        const QByteArray inside = folder + "/d\xff";
        QCOMPARE(::mkdir(inside.constData(), 0700), 0);
        const QString toFile = m_folder->filePath(QStringLiteral("file.ifs"));
        const QString toInside = m_folder->filePath(QStringLiteral("inside.ifs"));
        QCOMPARE(::symlink(file.constData(), QFile::encodeName(toFile).constData()), 0);
        QCOMPARE(::symlink((inside + "/x.ifs").constData(), QFile::encodeName(toInside).constData()), 0);
        for (const QString& link : {toFile, toInside})
            for (const char* bytes : {"new", "newer"}) { // dangling, then leading to a file
                QCOMPARE(io::saveFile(link, bytes), io::Failure());
                QVERIFY(QFileInfo(link).isSymLink());
                QCOMPARE(contents(link), QByteArray(bytes));
            }
        const QString lost = m_folder->filePath(QStringLiteral("f\uFFFD.ifs")); // as Qt reads the name itself
        QVERIFY(io::saveFile(lost, "new")->contains(QStringLiteral("not valid UTF-8")));
        QVERIFY(!QFileInfo::exists(lost));
        ::unlink(file.constData()); // QTemporaryDir cannot
        ::unlink((inside + "/x.ifs").constData());
        ::rmdir(inside.constData());
    }

    void danglingLinkGetsItsFile() {
        const QString link = m_folder->filePath(QStringLiteral("link.ifs"));
        QVERIFY(QFile::link(m_path, link));
        QCOMPARE(io::saveFile(link, "new"), io::Failure());
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(contents(m_path), QByteArray("new"));
    }

    // In a folder as /tmp, anybody can put a link where a file of somebody else is about to be written.
    void linksOfOthersAreNotFollowed_data() {
        QTest::addColumn<QByteArray>("linked"); // what the victim's file holds; null: it does not exist yet
        QTest::addColumn<bool>("isChained");    // through a link of our own
        QTest::newRow("file") << QByteArray("theirs") << false;
        QTest::newRow("dangling") << QByteArray() << false;
        QTest::newRow("chained") << QByteArray("theirs") << true;
        QTest::newRow("chained, dangling") << QByteArray() << true;
    }

    void linksOfOthersAreNotFollowed() {
#ifdef Q_OS_LINUX
        if (::geteuid() != 0) QSKIP("Only root can give a link to another user.");
        QFETCH(QByteArray, linked);
        QFETCH(bool, isChained);
        const QString shared = m_folder->filePath(QStringLiteral("shared"));
        const QString link = shared + QStringLiteral("/a.ifs");
        QVERIFY(QDir().mkdir(shared));
        QCOMPARE(::chmod(qPrintable(shared), 01777), 0);
        if (!linked.isNull()) put(m_path, linked);
        QVERIFY(QFile::link(m_path, link));
        const QString own = m_folder->filePath(QStringLiteral("own.ifs"));
        QVERIFY(QFile::link(link, own));
        const QString saved = isChained ? own : link;

        support::linksAreProtected = true;
        QCOMPARE(io::saveFile(saved, linked.isNull() ? "" : linked), io::Failure()); // the link is our own
        if (linked.isNull()) QVERIFY(QFile::remove(m_path));
        QCOMPARE(::lchown(qPrintable(link), 65534, 65534), 0);
        const io::Failure failure = io::saveFile(saved, "ours");
        QVERIFY2(says(failure, QStringLiteral("does not follow the symbolic link “%1”").arg(saved)),
                 qPrintable(failure.value_or(QStringLiteral("no failure"))));
        const io::Failure unread = io::loadFile(saved).failure;
        QVERIFY2(says(unread, QStringLiteral("does not follow the symbolic link")),
                 qPrintable(unread.value_or(QStringLiteral("no failure"))));
        support::linksAreProtected = false;
        QCOMPARE(QFile::exists(m_path), !linked.isNull());
        if (!linked.isNull()) QCOMPARE(contents(m_path), linked);
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(everythingIn(shared), QStringList{QStringLiteral("a.ifs")});
#endif
    }

    void linksThatLeadToThemselvesStay() {
        const QString here = m_folder->filePath(QStringLiteral("here.ifs"));
        const QString there = m_folder->filePath(QStringLiteral("there.ifs"));
        QVERIFY(QFile::link(QStringLiteral("there.ifs"), here));
        QVERIFY(QFile::link(QStringLiteral("here.ifs"), there));
        const QString folder = m_folder->filePath(QStringLiteral("round"));
        QVERIFY(QFile::link(QStringLiteral("round"), folder));
        for (const QString& path : {here, folder + QStringLiteral("/a.ifs")}) {
            const QString link = path == here ? here : folder;
            for (const io::Failure& failure : {io::saveFile(path, "new"), io::loadFile(path).failure}) {
                QVERIFY2(says(failure, QStringLiteral("“%1” is a symbolic link").arg(link)),
                         qPrintable(failure.value_or(QString())));
            }
        }
        QVERIFY(QFileInfo(here).isSymLink() && QFileInfo(there).isSymLink() && QFileInfo(folder).isSymLink());
        QString end = m_path; // more links than the system follows
        put(m_path, "old");
        for (int i = 0; i < 50; ++i) {
            const QString link = m_folder->filePath(QStringLiteral("link%1.ifs").arg(i));
            QVERIFY(QFile::link(end, link));
            end = link;
        }
        QVERIFY(says(io::saveFile(end, "new"), QStringLiteral("is a symbolic link")));
        QVERIFY(QFileInfo(end).isSymLink());
        QCOMPARE(contents(m_path), QByteArray("old"));
    }

    void otherNamesAreCounted() {
        QCOMPARE(io::otherNames(m_path), 0);
        put(m_path, "old");
        QCOMPARE(io::otherNames(m_path), 0);
        const QString other = m_folder->filePath(QStringLiteral("other.ifs"));
        const QString link = m_folder->filePath(QStringLiteral("link.ifs"));
        QCOMPARE(::link(QFile::encodeName(m_path).constData(), QFile::encodeName(other).constData()), 0);
        QVERIFY(QFile::link(m_path, link));
        for (const QString& path : {m_path, other, link})
            QCOMPARE(io::otherNames(path), 1);
        QCOMPARE(io::otherNames(m_folder->path()), 0);
        QCOMPARE(io::saveFile(m_path, "new"), io::Failure());
        QCOMPARE(contents(other), QByteArray("old"));
        QCOMPARE(io::otherNames(m_path), 0);
    }

    void saysWhatIsInTheWay() {
        const auto says = [](const io::Failure& failure, const char* word) {
            return failure && failure->contains(QLatin1String(word));
        };
        QVERIFY(says(io::saveFile(m_folder->filePath(QStringLiteral("none/a.ifs")), "x"), "does not exist"));
        QVERIFY(says(io::saveFile(m_folder->path(), "x"), "folder"));
        QVERIFY(says(io::saveFile(QString(), "x"), "name"));
        QVERIFY(says(io::saveFile(m_folder->filePath(QString(300, QLatin1Char('n'))), "x"), "too long"));
        QVERIFY(says(io::loadFile(m_path).failure, "does not exist"));
        QVERIFY(says(io::loadFile(m_folder->path()).failure, "folder"));
        const QByteArray name = m_folder->path().toUtf8() + "/f\xe9.ifs"; // Latin-1
        const int other = ::open(name.constData(), O_CREAT | O_WRONLY, 0600);
        QVERIFY(other >= 0);
        ::close(other);
        QVERIFY(says(io::loadFile(QFile::decodeName(name)).failure, "not valid UTF-8"));
        QFile large(m_folder->filePath(QStringLiteral("large")));
        QVERIFY(large.open(QIODevice::WriteOnly) && large.resize(257LL * 1024 * 1024)); // sparse
        QVERIFY(says(io::loadFile(large.fileName()).failure, "256 MB"));
    }

#ifdef Q_OS_UNIX
    void readOnlyFileAndFolder() {
        const support::Unprivileged nobody(m_folder->path());
        QVERIFY(nobody.isInForce());
        put(m_path, "old");
        QVERIFY(QFile::setPermissions(m_path, QFile::ReadOwner));
        io::Failure failure = io::saveFile(m_path, "new");
        QVERIFY(failure && failure->contains(QStringLiteral("read-only")));
        QVERIFY(QFile::setPermissions(m_path, QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::ExeOwner));
        failure = io::saveFile(m_path, "new");
        QVERIFY(
            QFile::setPermissions(m_folder->path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        QVERIFY(failure && failure->contains(QStringLiteral("do not have permission to write")));
        QCOMPARE(contents(m_path), QByteArray("old"));
    }

    void closedFoldersAreNamed() {
        const support::Unprivileged nobody(m_folder->path());
        QVERIFY(nobody.isInForce());
        const QString closed = m_folder->filePath(QStringLiteral("closed"));
        const QString inside = closed + QStringLiteral("/a.ifs");
        const QString link = m_folder->filePath(QStringLiteral("link.ifs"));
        QVERIFY(QDir().mkpath(closed + QStringLiteral("/deep")));
        put(inside, "old");
        QVERIFY(QFile::link(inside, link));
        QVERIFY(QFile::setPermissions(closed, QFile::ReadOwner | QFile::WriteOwner));
        QList<io::Failure> failures;
        for (const QString& path :
             {inside, closed + QStringLiteral("/new.ifs"), closed + QStringLiteral("/deep/a.ifs"), link})
            failures << io::saveFile(path, "new") << io::loadFile(path).failure;
        QVERIFY(QFile::setPermissions(closed, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        for (const io::Failure& failure : failures)
            QVERIFY2(says(failure, QStringLiteral("permission to enter the folder “%1”").arg(closed)),
                     qPrintable(failure.value_or(QString())));
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(contents(inside), QByteArray("old"));
        QCOMPARE(everythingIn(closed), QStringList({QStringLiteral("a.ifs"), QStringLiteral("deep")}));
    }

    void unreadableFile() {
        const support::Unprivileged nobody(m_folder->path());
        QVERIFY(nobody.isInForce());
        put(m_path, "secret");
        QVERIFY(QFile::setPermissions(m_path, QFile::WriteOwner));
        const io::Loaded loaded = io::loadFile(m_path);
        QVERIFY(loaded.bytes.isEmpty());
        QVERIFY(loaded.failure && loaded.failure->contains(QStringLiteral("cannot be read")));
    }

    // Neither the new file nor the one it is written to first.
    void nobodyElseReadsWhatIsPrivate() {
        const mode_t before = ::umask(0077);
        const io::Failure failure = io::saveFile(m_path, "new");
        ::umask(before);
        QCOMPARE(failure, io::Failure());
        const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
        QVERIFY(!(QFile::permissions(m_path) & others));
        QCOMPARE(io::saveFile(m_folder->filePath(QStringLiteral("b.ifs")), "new"), io::Failure());
        const bool isShared = (before & 0004) == 0;
        QCOMPARE(bool(QFile::permissions(m_folder->filePath(QStringLiteral("b.ifs"))) & QFile::ReadOther),
                 isShared);
    }

    // A limit on the size of files simulates a full disk: the write fails halfway.
    void failedWriteLeavesTheOldFile() {
        put(m_path, "old");
        support::FileSizeLimit limit(4096);
        QVERIFY(limit.isSet());
        const io::Failure failure = io::saveFile(m_path, QByteArray(100'000, 'x'));
        limit.lift();
        QVERIFY(failure && failure->contains(QStringLiteral("not saved")));
        QVERIFY(failure->endsWith(QStringLiteral("The file on disk is unchanged.")));
        QCOMPARE(contents(m_path), QByteArray("old"));
        QCOMPARE(everythingIn(m_folder->path()), QStringList{QStringLiteral("a.ifs")});
    }

    // Nothing is said of a file that is not there.
    // Whether or not who reads looks at the result.
    void failedReadLeavesTheOldFile() {
        put(m_path, "old");
        io::NewFile file(m_path);
        QCOMPARE(file.write("new"), 3);
        QVERIFY(file.seek(0));
        support::readsFail = true;
        char byte = 0;
        QCOMPARE(file.read(&byte, 1), -1);
        support::readsFail = false;
        QVERIFY(file.seek(0));
        QCOMPARE(file.read(&byte, 1), 1);
        QVERIFY(says(file.commit(), QStringLiteral("was not saved")));
        QCOMPARE(contents(m_path), QByteArray("old"));
    }

    void failedWriteOfANewFileLeavesNothing() {
        support::FileSizeLimit limit(4096);
        QVERIFY(limit.isSet());
        const io::Failure failure = io::saveFile(m_path, QByteArray(100'000, 'x'));
        limit.lift();
        QVERIFY(failure && failure->contains(QStringLiteral("not saved")));
        QVERIFY2(!failure->contains(QStringLiteral("on disk")), qPrintable(*failure));
        QCOMPARE(everythingIn(m_folder->path()), QStringList());
    }

#ifdef Q_OS_LINUX
    void aFileMayHaveItsNameFromTheStart() {
        put(m_path, "old");
        QCOMPARE(::chmod(QFile::encodeName(m_path).constData(), 0640), 0);
        const QString fresh = m_folder->filePath(QStringLiteral("b.ifs"));
        const QByteArray bytes(200'000, 'x');
        isNamingRefused = true;
        const io::Failure replaced = io::saveFile(m_path, bytes), made = io::saveFile(fresh, bytes);
        support::FileSizeLimit limit(4096);
        const io::Failure failed = io::saveFile(fresh, QByteArray(5000, 'y'));
        limit.lift();
        isNamingRefused = false;
        QCOMPARE(replaced, io::Failure());
        QCOMPARE(made, io::Failure());
        QVERIFY(failed);
        QCOMPARE(contents(m_path), bytes);
        QCOMPARE(contents(fresh), bytes);
        struct stat status {};
        QCOMPARE(::stat(QFile::encodeName(m_path).constData(), &status), 0);
        QCOMPARE(status.st_mode & 07777, 0640U);
        const mode_t mask = ::umask(0);
        ::umask(mask);
        QCOMPARE(::stat(QFile::encodeName(fresh).constData(), &status), 0);
        QCOMPARE(status.st_mode & 07777, 0666U & ~mask);
        QCOMPARE(everythingIn(m_folder->path()),
                 QStringList({QStringLiteral("a.ifs"), QStringLiteral("b.ifs")}));
    }

    void halvesOfTheDeadAreRemoved() {
        const auto putAt = [this](const char* name, int s) {
            QFile file(m_folder->filePath(QLatin1String(name)));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("half") == 4 && file.flush());
            QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(s), QFile::FileModificationTime));
        };
        for (const char* old : {".barycage-part-dead", ".barycage-part-living", ".barycage-whole"})
            putAt(old, -3600);
        putAt(".barycage-part-new", 0);
        putAt(".barycage-part-future", 3600); // the clock was set back
        QFile living(m_folder->filePath(QStringLiteral(".barycage-part-living")));
        QVERIFY(living.open(QIODevice::ReadOnly) && ::flock(living.handle(), LOCK_EX | LOCK_NB) == 0);
        isNamingRefused = true;
        const bool isSaved = !io::saveFile(m_path, "new");
        isNamingRefused = false;
        QVERIFY(isSaved);
        QCOMPARE(everythingIn(m_folder->path()).join(u' '),
                 QStringLiteral(".barycage-part-living .barycage-part-new .barycage-whole a.ifs"));
    }

    void keepsExtendedAttributes() {
        put(m_path, "old");
        const QByteArray path = QFile::encodeName(m_path);
        const QByteArray much(3000, 'x');
        if (::setxattr(path, "user.barycage.tag", "a\0b", 3, 0) != 0) {
            QCOMPARE(errno, ENOTSUP);
            QSKIP("this file system has none");
        }
        QCOMPARE(::setxattr(path, "user.barycage.empty", "", 0, 0), 0);
        QCOMPARE(::setxattr(path, "user.barycage.long", much, std::size_t(much.size()), 0), 0);
        QCOMPARE(io::saveFile(m_path, "new"), io::Failure());
        QCOMPARE(contents(m_path), QByteArray("new"));
        char value[4000];
        QCOMPARE(::getxattr(path, "user.barycage.tag", value, sizeof value), 3);
        QCOMPARE(QByteArray(value, 3), QByteArray("a\0b", 3));
        QCOMPARE(::getxattr(path, "user.barycage.empty", value, sizeof value), 0);
        QCOMPARE(::getxattr(path, "user.barycage.long", value, sizeof value), much.size());
        QCOMPARE(QByteArray(value, much.size()), much);
    }

    // The one of the file, and not one that the folder gives to new files.
    void keepsAccessControlLists() {
        put(m_path, "old");
        const QByteArray path = QFile::encodeName(m_path);
        const QByteArray folder = QFile::encodeName(m_folder->path());
        const QByteArray list = accessList(12345);
        if (::setxattr(path, "system.posix_acl_access", list, std::size_t(list.size()), 0) != 0) {
            QCOMPARE(errno, ENOTSUP);
            QSKIP("this file system has none");
        }
        const QByteArray given = accessList(54321);
        QCOMPARE(::setxattr(folder, "system.posix_acl_default", given, std::size_t(given.size()), 0), 0);
        QCOMPARE(io::saveFile(m_path, "new"), io::Failure());
        char value[200];
        QCOMPARE(::getxattr(path, "system.posix_acl_access", value, sizeof value), list.size());
        QCOMPARE(QByteArray(value, list.size()), list);

        QCOMPARE(::removexattr(path, "system.posix_acl_access"), 0);
        QCOMPARE(::chmod(path, 0640), 0);
        QCOMPARE(io::saveFile(m_path, "newer"), io::Failure());
        QCOMPARE(::getxattr(path, "system.posix_acl_access", value, sizeof value), -1);
        struct stat status {};
        QCOMPARE(::stat(path, &status), 0);
        QCOMPARE(status.st_mode & 07777, 0640U);
    }
#endif

    void devicesAreNotReplaced() {
        const io::Failure failure = io::saveFile(QStringLiteral("/dev/null"), "x");
        QVERIFY(failure && failure->contains(QStringLiteral("not a regular file")));
    }

    // As /dev/stdout leads to one.
    void pipesBehindLinksAreNotReplaced() {
        int ends[2];
        QCOMPARE(::pipe(ends), 0);
        const QString link = QStringLiteral("/proc/self/fd/%1").arg(ends[1]);
        if (!QFileInfo(link).isSymLink()) QSKIP("no /proc here");
        const io::Failure failure = io::saveFile(link, "x");
        ::close(ends[0]);
        ::close(ends[1]);
        QVERIFY(failure && failure->contains(QStringLiteral("not a regular file")));
        QVERIFY2(failure->contains(link), qPrintable(*failure));
    }
#endif

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

BARYCAGE_TEST(SaveFileTest);
#include "save_file_test.moc"
