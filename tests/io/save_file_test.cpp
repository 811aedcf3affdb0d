// SPDX-License-Identifier: MIT
#include "io/save_file.h"
#include "support/unprivileged.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>

#include <memory>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
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

QStringList everythingIn(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
}

} // namespace

class SaveFileTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
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

    void danglingLinkGetsItsFile() {
        const QString link = m_folder->filePath(QStringLiteral("link.ifs"));
        QVERIFY(QFile::link(m_path, link));
        QCOMPARE(io::saveFile(link, "new"), io::Failure());
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(contents(m_path), QByteArray("new"));
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
        QVERIFY(failure && failure->contains(QStringLiteral("may not write")));
        QCOMPARE(contents(m_path), QByteArray("old"));
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

    // A limit on the size of files stands in for a full disk: the write fails halfway.
    void failedWriteLeavesTheOldFile() {
        put(m_path, "old");
        rlimit before{};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit small = before;
        small.rlim_cur = 4096;
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const io::Failure failure = io::saveFile(m_path, QByteArray(100'000, 'x'));
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &before), 0);
        QVERIFY(failure && failure->contains(QStringLiteral("not saved")));
        QCOMPARE(contents(m_path), QByteArray("old"));
        QCOMPARE(everythingIn(m_folder->path()), QStringList{QStringLiteral("a.ifs")});
    }

    void devicesAreNotReplaced() {
        const io::Failure failure = io::saveFile(QStringLiteral("/dev/null"), "x");
        QVERIFY(failure && failure->contains(QStringLiteral("not an ordinary file")));
    }
#endif

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

QTEST_APPLESS_MAIN(SaveFileTest)
#include "save_file_test.moc"
