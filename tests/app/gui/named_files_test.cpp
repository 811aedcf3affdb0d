// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "panels/lesson/lesson_notebook.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAbstractButton>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;

// Files that other files name.
class NamedFilesTest : public WindowFixture {
    Q_OBJECT

private slots:
    void lessonsAskForFilesOutsideTheirFolder();
};

namespace {

void writeFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

} // namespace

// By their names or behind links: a lesson from a stranger could name any collection.
void NamedFilesTest::lessonsAskForFilesOutsideTheirFolder() {
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(u"course"_s));
    const QString path = folder.filePath(u"course/my.lesson"_s);
    const QString outside = folder.filePath(u"a.ifs"_s), inside = folder.filePath(u"course/b.ifs"_s);
    for (const QString& file : {outside, inside})
        writeFile(file, "a {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\n");
    QVERIFY(QFile::link(outside, folder.filePath(u"course/link.ifs"_s)));
    const auto question = [this]() -> QMessageBox* {
        for (auto* box : m_window->findChildren<QMessageBox*>())
            if (box->isVisible()) return box;
        return nullptr;
    };
    const auto naming = [&](const QString& reference) {
        writeFile(path, "lesson: a\nfile: " + reference.toUtf8() + "\n\n## One\n\nText.\n");
        return m_window->openPath(path);
    };
    for (const QString& reference : {u"../a.ifs"_s, outside, u"link.ifs"_s}) {
        QVERIFY(naming(u"b.ifs"_s)); // without a question
        QVERIFY(!question());
        QCOMPARE(m_window->path(), inside);
        for (const bool isAgreed : {false, true}) {
            QVERIFY(!naming(reference));
            QMessageBox* box = question();
            QVERIFY(box && box->informativeText().contains(QFileInfo(reference).fileName()));
            QCOMPARE(box->defaultButton(), box->button(QMessageBox::Cancel));
            QCOMPARE(m_window->path(), inside);
            QAbstractButton* open = support::button(*box, "open");
            (isAgreed ? open : box->button(QMessageBox::Cancel))->click();
            QTRY_VERIFY(!question());
            if (isAgreed)
                QTRY_COMPARE(QFileInfo(m_window->path()).fileName(), QFileInfo(reference).fileName());
            QCOMPARE(m_window->path() == inside, !isAgreed);
        }
        QCOMPARE(m_window->findChild<view::LessonNotebook*>()->path(), path);
    }
}

BARYCAGE_TEST(NamedFilesTest, QApplication);
#include "named_files_test.moc"
