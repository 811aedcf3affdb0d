// SPDX-License-Identifier: MIT
#include "desktop/preferences.h"
#include "desktop/settings.h"
#include "io/collection_source.h"
#include "panels/collection/collection_delegate.h"
#include "panels/collection/collection_grid.h"
#include "panels/collection/collection_model.h"
#include "panels/collection/collection_panel.h"
#include "panels/collection/collection_window.h"
#include "panels/collection/moving_picture.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "widgets/thumbnails.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QToolButton>

#include <memory>

using view::CollectionFilter;
using view::CollectionGrid;
using view::CollectionModel;
using view::CollectionWindow;

class CollectionWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        for (const QString& path : io::bundledCollection())
            m_model.append(io::readTheme(path));
    }

    void init() {
        m_model.setFavourites({});
        m_model.setRecent({});
        m_window = std::make_unique<CollectionWindow>(&m_model, nullptr);
        m_window->resize(1100, 720);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() { m_window.reset(); }

    void picturesFillTheirRows() {
        const int spare = grid().delegate()->pictureSide() / 2;
        for (const int width : {760, 1000, 1234}) {
            m_window->resize(width, 720);
            QCoreApplication::processEvents();
            int right = 0;
            for (int row = 0; row < grid().model()->rowCount(); ++row) {
                const QModelIndex index = grid().model()->index(row, 0);
                if (!index.data(CollectionModel::HeadingRole).toBool())
                    right = qMax(right, grid().visualRect(index).right());
            }
            const int room = grid().viewport()->width();
            QVERIFY2(right < room && right > room - spare,
                     qPrintable(QStringLiteral("%1 of %2").arg(right).arg(room)));
        }
    }

    void aThemeIsShownAlone() {
        QCOMPARE(grid().model()->rowCount(), m_model.rowCount());
        auto& themes = *m_window->findChild<QListWidget*>(QStringLiteral("themes"));
        const io::CollectionTheme ferns = io::readTheme(QStringLiteral(":/ifs_library/ferns.ifs"));
        const QList<QListWidgetItem*> found = themes.findItems(ferns.title, Qt::MatchExactly);
        QCOMPARE(found.size(), 1);
        themes.setCurrentItem(found.front());
        QCOMPARE(grid().model()->rowCount(), int(ferns.entries.size()));
        for (int row = 0; row < grid().model()->rowCount(); ++row)
            QVERIFY(!grid().model()->index(row, 0).data(CollectionModel::HeadingRole).toBool());
        // All, Favourites, Recent, a gap, and a line for each theme.
        QCOMPARE(themes.count(), 4 + int(io::bundledCollection().size()));
        QVERIFY(!found.front()->toolTip().isEmpty());
        // Folders that are read later do not change what is chosen.
        CollectionModel& model = m_model;
        io::CollectionTheme late;
        late.title = QStringLiteral("Late");
        late.entries = {ferns.entries.front()};
        model.append(late, QStringLiteral("/late"));
        QCOMPARE(themes.currentItem()->text(), ferns.title);
        QCOMPARE(themes.count(), 5 + int(io::bundledCollection().size()));
        QCOMPARE(grid().model()->rowCount(), int(ferns.entries.size()));
        model.removeFolder(QStringLiteral("/late"));
    }

    // Kinds are not in names.
    void kindsAreFound() {
        for (const char* word : {"solid", "3d", "moving"}) {
            search()->clear();
            QTest::keyClicks(search(), QLatin1String(word));
            const QAbstractItemModel* shown = grid().model();
            QVERIFY2(shown->rowCount() > 5, word);
        }
    }

    void searchLooksEverywhere() {
        auto& themes = *m_window->findChild<QListWidget*>(QStringLiteral("themes"));
        themes.setCurrentRow(2); // Recent: nothing yet
        QCOMPARE(grid().model()->rowCount(), 0);
        QTest::keyClicks(search(), QStringLiteral("sunset"));
        QCOMPARE(themes.currentRow(), 0);
        QVERIFY(grid().model()->rowCount() >= 2);
        QVERIFY(grid().currentIndex().isValid());
        QSignalSpy chosen(m_window.get(), &CollectionWindow::chosen);
        QTest::keyClick(search(), Qt::Key_Return);
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].value<QList<document::Fractal>>().size(), 2); // with its partner
        QVERIFY(!m_window->isVisible());
    }

    void aDoubleClickOpens() {
        QSignalSpy chosen(m_window.get(), &CollectionWindow::chosen);
        const QModelIndex second = grid().model()->index(2, 0);
        const QPoint place = grid().visualRect(second).center();
        QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, place);
        QVERIFY(m_window->isVisible() && chosen.isEmpty());
        QTest::mouseDClick(grid().viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(chosen.size(), 1);
        QVERIFY(!m_window->isVisible());
        QCOMPARE(m_model.recent().size(), 1);
    }

    void arrowsLeadFromTheSearchToThePictures() {
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QVERIFY(search()->hasFocus());
        QTest::keyClick(search(), Qt::Key_Down);
        QVERIFY(grid().hasFocus());
        grid().setCurrentIndex(grid().model()->index(1, 0));
        QSignalSpy added(m_window.get(), &CollectionWindow::addRequested);
        support::button(*m_window, "add")->click();
        QCOMPARE(added.size(), 1);
    }

    void nothingIsOpenedWithoutAChoice() {
        QVERIFY(!support::button(*m_window, "open")->isEnabled());
        QVERIFY(!support::button(*m_window, "add")->isEnabled());
        grid().setCurrentIndex(grid().model()->index(1, 0));
        QVERIFY(support::button(*m_window, "open")->isEnabled());
        search()->setText(QStringLiteral("no such fractal"));
        QVERIFY(!support::button(*m_window, "open")->isEnabled());
    }

    void favouritesAndRecentOnes() {
        auto& themes = *m_window->findChild<QListWidget*>(QStringLiteral("themes"));
        grid().setCurrentIndex(grid().model()->index(2, 0));
        auto* star = m_window->findChild<QToolButton*>(QStringLiteral("favourite"));
        QVERIFY(star->isEnabled() && !star->isChecked());
        star->click();
        QCOMPARE(m_model.favourites().size(), 1);
        themes.setCurrentRow(1);
        QCOMPARE(grid().model()->rowCount(), 2); // with its title
        grid().setCurrentIndex(grid().model()->index(1, 0));
        QVERIFY(star->isChecked());
        star->click();
        QCOMPARE(grid().model()->rowCount(), 0);
        const auto* why = grid().viewport()->findChild<QLabel*>();
        QVERIFY(why->isVisible() && why->text().contains(QStringLiteral("Ctrl+D")));

        m_model.addRecent(m_model.index(5));
        m_model.addRecent(m_model.index(2));
        m_model.addRecent(m_model.index(4));
        m_model.addRecent(m_model.index(2)); // once more
        themes.setCurrentRow(2);
        QStringList names;
        for (int row = 0; row < grid().model()->rowCount(); ++row)
            names << grid().model()->index(row, 0).data().toString();
        QCOMPARE(names, (QStringList{m_model.index(2).data().toString(), m_model.index(4).data().toString(),
                                     m_model.index(5).data().toString()}));
    }

    void onlyTheLastTwoDozenAreRecent() {
        for (int row = 0, used = 0; used < 30; ++row)
            if (m_model.fractalAt(m_model.index(row))) {
                m_model.addRecent(m_model.index(row));
                ++used;
            }
        QCOMPARE(m_model.recent().size(), 24);
    }

    void entriesMoveUnderThePointer() {
        const int row = movingRow();
        const QModelIndex moving = grid().model()->index(row, 0);
        grid().scrollTo(moving);
        auto* picture = m_window->findChild<view::MovingPicture*>();
        QSignalSpy shown(picture, &view::MovingPicture::shown);
        hover(moving);
        QVERIFY(picture->isPlaying());
        QTRY_VERIFY_WITH_TIMEOUT(shown.size() >= 3, 60'000);
        const auto frame = [&](int index) { return shown[index][0].value<QPixmap>().toImage(); };
        QCOMPARE(frame(0).width(), qRound(CollectionWindow::pictureSide * m_window->devicePixelRatioF()));
        QVERIFY(frame(0) != frame(2));
        // Beside it, nothing moves.
        const QModelIndex still = grid().model()->index(1, 0);
        grid().scrollTo(still);
        hover(still);
        QVERIFY(!picture->isPlaying());
    }

    void reducedMotionLeavesThemStill() {
        view::Preferences preferences;
        preferences.motion = view::Preferences::Motion::Reduced;
        preferences.store();
        auto* picture = m_window->findChild<view::MovingPicture*>();
        grid().setCurrentIndex(grid().model()->index(movingRow(), 0));
        QVERIFY(!picture->isPlaying());
        view::Preferences().store();
        grid().setCurrentIndex(grid().model()->index(1, 0));
        grid().setCurrentIndex(grid().model()->index(movingRow(), 0));
        QVERIFY(picture->isPlaying());
    }

    // The panel remembers what was used, and shows it by itself.
    void thePanelKeepsWhatWasUsed() {
        {
            view::CollectionPanel panel;
            auto* list = panel.findChild<CollectionGrid*>();
            QTRY_VERIFY(list->model()->rowCount() > 5);
            list->setCurrentIndex(list->model()->index(2, 0));
            support::action(panel, "open")->trigger();
            m_name = list->currentIndex().data().toString();
        }
        view::CollectionPanel again;
        auto* list = again.findChild<CollectionGrid*>();
        QTRY_VERIFY(list->model()->rowCount() > 5);
        support::action(again, "recent-only")->setChecked(true);
        QCOMPARE(list->model()->rowCount(), 1);
        QCOMPARE(list->model()->index(0, 0).data().toString(), m_name);
        support::action(again, "favourites-only")->setChecked(true);
        QVERIFY(!support::action(again, "recent-only")->isChecked());
        QCOMPARE(list->model()->rowCount(), 0);
        view::store(QStringLiteral("collection/recent"), {});
    }

private:
    CollectionGrid& grid() const { return *m_window->findChild<CollectionGrid*>(); }
    QLineEdit* search() const { return m_window->findChild<QLineEdit*>(QStringLiteral("search")); }
    void hover(const QModelIndex& index) const {
        const QPointF place = grid().visualRect(index).center();
        QMouseEvent move(QEvent::MouseMove, place, grid().viewport()->mapToGlobal(place), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(grid().viewport(), &move);
    }
    int movingRow() const {
        for (int row = 0; row < grid().model()->rowCount(); ++row)
            if (grid().model()->index(row, 0).data(CollectionModel::MovesRole).toBool()) return row;
        qFatal("nothing in the collection moves");
    }

    view::Thumbnails m_thumbnails;
    CollectionModel m_model{&m_thumbnails};
    std::unique_ptr<CollectionWindow> m_window;
    QString m_name;
};

BARYCAGE_TEST(CollectionWindowTest, QApplication);
#include "collection_window_test.moc"
