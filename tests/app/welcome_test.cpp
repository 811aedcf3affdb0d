// SPDX-License-Identifier: MIT
#include "welcome.h"

#include "app/window_fixture.h"

#include "canvas/canvas_view.h"
#include "recent_files.h"

#include <QApplication>
#include <QCommandLinkButton>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

// A window that opened nothing offers what was open before, and steps aside at the first thing done.
class WelcomeTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theCollectionIsOfferedBeforeTheFirstFile() {
        Welcome::offer(m_window.get());
        QVERIFY(card());
        QVERIFY(!card()->findChild<QCommandLinkButton*>());
        QStringList buttons;
        for (const auto* button : card()->findChildren<QPushButton*>())
            buttons << button->text();
        QVERIFY(buttons.contains(QStringLiteral("&Collection")) &&
                buttons.contains(QStringLiteral("&Open…")));
    }

    void theNewestFilesAreOffered() {
        for (int n = 0; n < 7; ++n)
            recent_files::add(file(QStringLiteral("leaf%1.ifs").arg(n)));
        QFile::remove(file(QStringLiteral("leaf5.ifs")));
        Welcome::offer(m_window.get());
        QVERIFY(card());
        QTRY_VERIFY(m_window->rect().contains(card()->geometry()));
        QStringList names;
        for (const auto* button : card()->findChildren<QCommandLinkButton*>())
            names << button->text();
        std::sort(names.begin(), names.end());
        QStringList expected;
        for (const char* number : {"2", "3", "4", "6"})
            expected << QStringLiteral("leaf%1.ifs").arg(QLatin1String(number));
        QCOMPARE(names, expected);
    }

    void aFileIsOpened() {
        const QString path = file(QStringLiteral("a&b.ifs"));
        recent_files::add(path);
        Welcome::offer(m_window.get());
        card()->findChild<QCommandLinkButton*>()->click();
        QCOMPARE(m_window->path(), path);
        QTRY_VERIFY(!card());
    }

    void theCollectionIsShown() {
        recent_files::add(file(QStringLiteral("leaf.ifs")));
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("collection"));
        dock->hide();
        Welcome::offer(m_window.get());
        for (auto* button : card()->findChildren<QPushButton*>())
            if (button->text() == QStringLiteral("&Collection")) button->click();
        QVERIFY(dock->isVisible());
        QVERIFY(dock->isAncestorOf(QApplication::focusWidget()) || dock->findChild<QLineEdit*>()->hasFocus());
        QTRY_VERIFY(!card());
    }

    void aPressOnTheCanvasClosesIt() {
        recent_files::add(file(QStringLiteral("leaf.ifs")));
        Welcome::offer(m_window.get());
        QTest::qWait(50);
        QVERIFY(card());
        QTest::mouseClick(m_window->findChild<view::CanvasView*>()->viewport(), Qt::LeftButton, {}, {5, 5});
        QTRY_VERIFY(!card());
    }

    void anEditClosesIt() {
        recent_files::add(file(QStringLiteral("leaf.ifs")));
        Welcome::offer(m_window.get());
        document::Fractal edited = m_window->document().fractal();
        edited.headerComment = QStringLiteral("mine");
        m_window->document().edit(QStringLiteral("Comment"), edited);
        QTRY_VERIFY(!card());
    }

private:
    Welcome* card() const { return m_window->findChild<Welcome*>(); }
    QString file(const QString& name) const {
        QFile file(m_folder.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write("leaf { .5 0 0 .5 0 0 .5  .5 0 0 .5 1 1 .5 }\n");
        return file.fileName();
    }

    QTemporaryDir m_folder;
};

QTEST_MAIN(WelcomeTest)
#include "welcome_test.moc"
