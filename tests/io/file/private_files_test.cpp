// SPDX-License-Identifier: MIT
#include "document/disk/process_lock.h"
#include "io/file/replacement_file.h"
#include "io/file/save_file.h"
#include "support/named_test.h"
#include "support/refusing_kernel.h"

#include <QByteArrayView>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

bool isProcMissing = false;

} // namespace

// Without /proc, a file needs a name from the start.
extern "C" int access(const char* path, int mode) noexcept {
    if (!isProcMissing || !QByteArrayView(path).startsWith("/proc/"))
        return int(::syscall(SYS_faccessat, AT_FDCWD, path, mode));
    errno = ENOENT;
    return -1;
}

// What replaces a file that others may not read is theirs at no moment, not even before it has its
// permissions.
class PrivateFilesTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_mask = ::umask(0);
        support::permissionsOfNewFiles = 0;
    }
    void cleanup() { ::umask(m_mask); }

    void theHalfOfAPrivateFileIsPrivate() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.ifs"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("old") == 3);
        file.close();
        for (const mode_t mode : {0600U, 0640U, 0400U}) {
            QCOMPARE(::chmod(QFile::encodeName(path).constData(), mode), 0);
            support::permissionsOfNewFiles = 0;
            QCOMPARE(io::saveFile(path, "new"), io::Failure());
            QVERIFY(support::permissionsOfNewFiles != 0);
            QCOMPARE(support::permissionsOfNewFiles & 077U, 0U);
            struct stat status {};
            QCOMPARE(::stat(QFile::encodeName(path).constData(), &status), 0);
            QCOMPARE(status.st_mode & 0777U, mode);
        }
    }
    // One that was not there gets what the user gives all files.
    void aNewFileIsAsTheUserWants() {
        const QTemporaryDir folder;
        QCOMPARE(io::saveFile(folder.filePath(QStringLiteral("b.ifs")), "new"), io::Failure());
        QCOMPARE(support::permissionsOfNewFiles, 0666U);
    }
    // Nor does anything of it stay when the program is interrupted.
    void anEndLeavesNoHalves() {
        const QTemporaryDir folder;
        const auto names = [&folder] {
            return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).join(u' ');
        };
        const QString path = folder.filePath(QStringLiteral("a.ifs"));
        isProcMissing = true;
        io::ReplacementFile file(QFile::encodeName(path).toStdString());
        isProcMissing = false;
        QVERIFY(file.write(0, "new", 3));
        QVERIFY2(names().startsWith(QStringLiteral(".barycage-part-")), qPrintable(names()));
        io::removeUnfinished();
        QCOMPARE(names(), QString());
    }
    // The folders of the program, those above included, where the user gives others everything.
    void foldersAreOfTheirOwner() {
        const QTemporaryDir folder;
        document::makePrivateFolder(folder.filePath(QStringLiteral("share/Barycage/recovery")));
        for (const char* name : {"share", "share/Barycage", "share/Barycage/recovery"}) {
            struct stat status {};
            QCOMPARE(::stat(QFile::encodeName(folder.filePath(QLatin1String(name))).constData(), &status), 0);
            QCOMPARE(status.st_mode & 0777U, 0700U);
        }
    }

private:
    mode_t m_mask = 0;
};

BARYCAGE_TEST(PrivateFilesTest, QCoreApplication);
#include "private_files_test.moc"
