// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "panels/lesson/lesson_card.h"
#include "session/session.h"
#include "support/named_test.h"

#include <QAction>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

// A restart shows again what was open: the entry, and the lesson with its step.
class RestartPlaceTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theEntryIsShownAgain();
    void anEntryOfTheFirstFileIsShownAgain();
    void anotherEntryInItsPlaceIsNotTakenForIt();
    void theLessonGoesOnAtItsStep();
    void placesAreTakenOnce();

private:
    static QString nameIn(MainWindow& window) { return window.document().entryFractal().name; }
    QString fileWith(const QByteArray& text) const {
        QFile file(m_folder.filePath(QStringLiteral("two.ifs")));
        if (file.open(QIODevice::WriteOnly)) file.write(text);
        return file.fileName();
    }
    QTemporaryDir m_folder;
};

namespace {

const QByteArray twoPictures = "first { .5 0 0 .5 0 0 .5  .5 0 0 .5 1 1 .5 }\n"
                               "second { .4 0 0 .4 0 0 .5  .4 0 0 .4 1 1 .5 }\n";

} // namespace

void RestartPlaceTest::theEntryIsShownAgain() {
    const QString path = fileWith(twoPictures);
    QVERIFY(m_window->openPath(path));
    m_window->document().setCurrent(m_window->document().file().entries.back().id);
    const QVariantMap place = m_window->restartPlace();
    MainWindow other;
    other.setAttribute(Qt::WA_DeleteOnClose, false);
    other.returnTo(place);
    QCOMPARE(other.path(), path);
    QCOMPARE(nameIn(other), QStringLiteral("second"));
}

void RestartPlaceTest::anEntryOfTheFirstFileIsShownAgain() {
    const auto& entries = m_window->document().file().entries;
    for (const document::Entry& entry : entries)
        if (entry.id != m_window->document().currentId()) m_window->document().setCurrent(entry.id);
    const QString name = nameIn(*m_window);
    MainWindow other;
    other.setAttribute(Qt::WA_DeleteOnClose, false);
    other.returnTo(m_window->restartPlace());
    QCOMPARE(nameIn(other), name);
}

void RestartPlaceTest::anotherEntryInItsPlaceIsNotTakenForIt() {
    const QString path = fileWith(twoPictures);
    QVERIFY(m_window->openPath(path));
    m_window->document().setCurrent(m_window->document().file().entries.back().id);
    QVariantMap place = m_window->restartPlace();
    fileWith("first { .5 0 0 .5 0 0 .5  .5 0 0 .5 1 1 .5 }\n"
             "third { .4 0 0 .4 0 0 .5  .4 0 0 .4 1 1 .5 }\n");
    MainWindow other;
    other.setAttribute(Qt::WA_DeleteOnClose, false);
    other.returnTo(place);
    QCOMPARE(nameIn(other), QStringLiteral("first"));
}

void RestartPlaceTest::theLessonGoesOnAtItsStep() {
    for (auto* action : m_window->findChildren<QAction*>())
        if (action->data() == QStringLiteral("chaos_game")) action->trigger();
    QVariantMap place = m_window->restartPlace();
    QCOMPARE(place.value(QStringLiteral("ready-made")).toString(), QStringLiteral("chaos_game"));
    QCOMPARE(place.value(QStringLiteral("step")).toInt(), 0);
    place.insert(QStringLiteral("step"), 1);
    MainWindow other;
    other.setAttribute(Qt::WA_DeleteOnClose, false);
    other.show();
    other.returnTo(place);
    QVERIFY(other.findChild<view::LessonCard*>() && other.findChild<view::LessonCard*>()->isVisible());
    const QVariantMap again = other.restartPlace();
    for (const char* key : {"ready-made", "step"})
        QCOMPARE(again.value(QLatin1String(key)), place.value(QLatin1String(key)));
}

void RestartPlaceTest::placesAreTakenOnce() {
    QVERIFY(session::takeRestartPlaces().isEmpty());
    const QString name = nameIn(*m_window);
    m_window->setAttribute(Qt::WA_DeleteOnClose, false);
    session::restart();
    QVERIFY(session::filesToReopen());
    const QList<QVariantMap> places = session::takeRestartPlaces();
    QCOMPARE(places.size(), 1);
    QCOMPARE(places.front().value(QStringLiteral("entry")).toString(), name);
    QVERIFY(session::takeRestartPlaces().isEmpty());
}

BARYCAGE_TEST(RestartPlaceTest, QApplication);
#include "restart_place_test.moc"
