// SPDX-License-Identifier: MIT
#include "support/commands.h"
#include "welcome.h"

#include "app/gui/window_fixture.h"

#include "canvas/canvas_view.h"
#include "files/recent_files.h"
#include "support/events.h"
#include "support/languages.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QCommandLinkButton>
#include <QDialog>
#include <QFile>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>

// A window that opened nothing offers what was open before, and steps aside at the first thing done.
class WelcomeTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theCollectionIsOfferedBeforeTheFirstFile() {
        Welcome::offer(m_window.get());
        QVERIFY(banner());
        QVERIFY(!banner()->findChild<QCommandLinkButton*>());
        QStringList buttons;
        for (const auto* button : banner()->findChildren<QPushButton*>())
            buttons << button->text();
        QVERIFY(buttons.contains(QStringLiteral("Co&llection")) &&
                buttons.contains(QStringLiteral("&Open…")));
    }

    void theNewestFilesAreOffered() {
        for (int n = 0; n < 7; ++n)
            recent_files::add(file(QStringLiteral("leaf%1.ifs").arg(n)));
        QFile::remove(file(QStringLiteral("leaf5.ifs")));
        Welcome::offer(m_window.get());
        QVERIFY(banner());
        QTRY_VERIFY(m_window->rect().contains(banner()->geometry()));
        QStringList names;
        for (const auto* button : banner()->findChildren<QCommandLinkButton*>())
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
        banner()->findChild<QCommandLinkButton*>()->click();
        QCOMPARE(m_window->path(), path);
        QTRY_VERIFY(!banner());
    }

    void theCollectionIsShown() {
        recent_files::add(file(QStringLiteral("leaf.ifs")));
        Welcome::offer(m_window.get());
        support::button(*banner(), "collection")->click();
        auto* collection = m_window->findChild<QDialog*>(QStringLiteral("collection-window"));
        QVERIFY(collection && collection->isVisible());
        QCOMPARE(collection->size(), m_window->size());
        QTRY_VERIFY(!banner());
        QTest::keyClick(collection, Qt::Key_Escape);
        QVERIFY(!collection->isVisible());
    }

    void aPressOnTheCanvasClosesIt() {
        recent_files::add(file(QStringLiteral("leaf.ifs")));
        Welcome::offer(m_window.get());
        support::handleEvents();
        QVERIFY(banner());
        QTest::mouseClick(m_window->findChild<view::CanvasView*>()->viewport(), Qt::LeftButton, {}, {5, 5});
        QTRY_VERIFY(!banner());
    }

    void whateverIsDoneClosesIt_data() {
        QTest::addColumn<std::function<void(MainWindow&)>>("done");
        using Done = std::function<void(MainWindow&)>;
        const auto trigger = [](const char* id) {
            return Done([id](MainWindow& window) { support::command(window, id)->trigger(); });
        };
        QTest::newRow("tour") << trigger("tour");
        QTest::newRow("command") << trigger("grid");
        QTest::newRow("bar") << trigger("how-it-is-built");
        QTest::newRow("tool") << Done([](MainWindow& window) {
            window.findChild<view::CanvasView*>()->setTool(view::CanvasView::Tool::Maps);
        });
        QTest::newRow("panel") << Done([](MainWindow& window) {
            auto* panels = window.findChild<QTabBar*>({}, Qt::FindDirectChildrenOnly);
            QVERIFY(panels);
            QTest::mouseClick(panels, Qt::LeftButton, {}, panels->tabRect(1).center());
        });
    }

    void whateverIsDoneClosesIt() {
        QFETCH(std::function<void(MainWindow&)>, done);
        Welcome::offer(m_window.get());
        support::handleEvents();
        QVERIFY(banner());
        done(*m_window);
        QTRY_VERIFY(!banner());
    }

    void itStaysOnASmallCanvas_data() { support::addLanguages(); }

    void itStaysOnASmallCanvas() {
        QFETCH(QString, language);
        const support::Spoken spoken(language);
        QVERIFY(spoken.isInstalled());
        m_window->resize(810, 600); // so that no panel makes way
        Welcome::offer(m_window.get());
        const QWidget* canvas = m_window->centralWidget();
        const auto room = [&] { return QRect(canvas->mapTo(m_window.get(), QPoint()), canvas->size()); };
        QTRY_VERIFY(banner()->width() < MessageBanner::usualWidth && room().contains(banner()->geometry()));
        support::handleEvents();
        int rounds = 0; // it comes to rest, also where its buttons are in a column
        while (rounds < 2000 && QAbstractEventDispatcher::instance()->processEvents(QEventLoop::AllEvents))
            ++rounds;
        QVERIFY(rounds < 2000);
        for (const auto* button : banner()->findChildren<QPushButton*>())
            QVERIFY2(banner()->rect().contains(button->geometry()) &&
                         button->width() >= button->minimumSizeHint().width(),
                     qPrintable(button->text()));
        m_window->resize(800, 600); // panels make way
        QTRY_VERIFY(canvas->width() >= 400 && room().contains(banner()->geometry()));
    }

    void anEditClosesIt() {
        recent_files::add(file(QStringLiteral("leaf.ifs")));
        Welcome::offer(m_window.get());
        document::Fractal edited = m_window->document().fractal();
        edited.headerComment = QStringLiteral("mine");
        m_window->document().edit(QStringLiteral("Comment"), edited);
        QTRY_VERIFY(!banner());
    }

private:
    Welcome* banner() const { return m_window->findChild<Welcome*>(); }
    QString file(const QString& name) const {
        QFile file(m_folder.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write("leaf { .5 0 0 .5 0 0 .5  .5 0 0 .5 1 1 .5 }\n");
        return file.fileName();
    }

    QTemporaryDir m_folder;
};

BARYCAGE_TEST(WelcomeTest, QApplication);
#include "welcome_test.moc"
