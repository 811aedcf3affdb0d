// SPDX-License-Identifier: MIT
#include "io/file/save_file.h"
#include "support/named_test.h"
#include "support/refusing_kernel.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

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

private:
    mode_t m_mask = 0;
};

BARYCAGE_TEST(PrivateFilesTest, QCoreApplication);
#include "private_files_test.moc"
