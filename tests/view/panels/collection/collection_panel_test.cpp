// SPDX-License-Identifier: MIT
#include "desktop/clipboard.h"
#include "desktop/settings.h"
#include "document/tops/kept_theft.h"
#include "io/picture/thumbnail_cache.h"
#include "panels/collection/collection_filter.h"
#include "panels/collection/collection_model.h"
#include "panels/collection/collection_panel.h"
#include "support/background_rest.h"
#include "support/events.h"
#include "support/forget_settings.h"
#include "support/languages.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"
#include "support/slow_disk.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMimeData>
#include <QProgressBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include <memory>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;
using view::CollectionModel;
using view::CollectionPanel;

namespace {

io::CollectionTheme theme(const QString& title, const QStringList& names) {
    io::CollectionTheme result;
    result.title = title;
    for (const QString& name : names) {
        document::Fractal fractal = document::sierpinskiTriangle();
        fractal.name = name;
        fractal.comments = QStringList{u"Source of "_s + name};
        document::Entry entry;
        entry.fractal = std::make_shared<const document::Fractal>(fractal);
        result.entries.append(entry);
    }
    return result;
}

int bundledRows() {
    int rows = 0;
    for (const QString& path : io::bundledCollection())
        rows += 1 + int(io::readTheme(path).entries.size());
    return rows;
}

void writeEntries(const QString& path, int count) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) qFatal("no test file");
    for (int i = 0; i < count; ++i)
        file.write("e" + QByteArray::number(i) + " { .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }\n");
}

} // namespace

class CollectionPanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyBundledEntryIsReadable();
    void modelGroupsByTheme();
    void searchKeepsTitlesOfWhatIsFound();
    void opensAndAdds();
    void arrowsSkipTitles();
    void asksOnlyForWhatIsSeen();
    void ownFolders();
    void readsBesideTheWindow();
    void readingCanBeStopped();
    void aFolderThatDoesNotAnswerHidesNoOther();
    void whatDoesNotAnswerCanBeStopped();
    void dragsAsText();
    void favouritesAreKept();
    void favouritesAreKeptInEveryLanguage();
    void partnersComeAlong();
    void bundledNamesAreTranslated();
};

void CollectionPanelTest::initTestCase() {
    support::useOwnSettings();
    QDir(io::ThumbnailCache::usualFolder()).removeRecursively();
}

void CollectionPanelTest::everyBundledEntryIsReadable() {
    const QStringList paths = io::bundledCollection();
    QVERIFY(paths.size() >= 8);
    QVERIFY(paths.front().endsWith(u"paper.ifs"_s));
    qsizetype count = 0;
    for (const QString& path : paths) {
        const io::CollectionTheme theme = io::readTheme(path);
        QVERIFY2(!theme.title.isEmpty() && !theme.entries.isEmpty(), qPrintable(path));
        for (const document::Entry& entry : theme.entries) {
            QVERIFY2(document::dimension(*entry.fractal) != 0, qPrintable(entry.fractal->name));
            QVERIFY2(entry.problems.isEmpty(), qPrintable(entry.fractal->name));
        }
        count += theme.entries.size();
    }
    QVERIFY(count >= 40);
}

void CollectionPanelTest::modelGroupsByTheme() {
    view::Thumbnails thumbnails;
    CollectionModel model(&thumbnails);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    io::CollectionTheme withBroken = theme(u"Ferns"_s, {u"a"_s, u"b"_s});
    withBroken.entries.append(
        {document::EntryId::None, std::make_shared<const document::Fractal>(), nullptr, {}});
    model.append(withBroken);
    model.append(theme(u"Mine"_s, {u"c"_s}), u"/home/me"_s);
    QStringList shown;
    for (int row = 0; row < model.rowCount(); ++row)
        shown.append(model.index(row).data().toString());
    QCOMPARE(shown, (QStringList{u"Ferns"_s, u"a"_s, u"b"_s, u"Mine"_s, u"c"_s}));
    QVERIFY(!model.fractalAt(model.index(0)));
    QCOMPARE(model.fractalAt(model.index(4))->name, u"c"_s);
    QVERIFY(!(model.flags(model.index(3)) & Qt::ItemIsSelectable));
    model.removeFolder(u"/home/me"_s);
    QCOMPARE(model.rowCount(), 3);
}

void CollectionPanelTest::searchKeepsTitlesOfWhatIsFound() {
    view::Thumbnails thumbnails;
    CollectionModel model(&thumbnails);
    model.append(theme(u"Ferns"_s, {u"barnsley"_s, u"other"_s}));
    model.append(theme(u"Trees"_s, {u"oak"_s}));
    view::CollectionFilter filter;
    filter.setSourceModel(&model);
    const auto shown = [&filter](const QString& words) {
        filter.setWords(words);
        QStringList result;
        for (int row = 0; row < filter.rowCount(); ++row)
            result.append(filter.index(row, 0).data().toString());
        return result;
    };
    QCOMPARE(shown({}).size(), 5);
    QCOMPARE(shown(u"BARN"_s), (QStringList{u"Ferns"_s, u"barnsley"_s}));
    QCOMPARE(shown(u"tree"_s), (QStringList{u"Trees"_s, u"oak"_s}));
    QCOMPARE(shown(u"source  oak"_s), (QStringList{u"Trees"_s, u"oak"_s}));
    QCOMPARE(shown(u"source fern"_s).size(), 3);
    QVERIFY(shown(u"nowhere"_s).isEmpty());
}

void CollectionPanelTest::opensAndAdds() {
    CollectionPanel panel;
    panel.resize(300, 400);
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    auto* grid = panel.findChild<QListView*>();
    QStringList opened;
    QStringList added;
    connect(&panel, &CollectionPanel::chosen, this,
            [&opened](const QList<document::Fractal>& chosen) { opened.append(chosen.first().name); });
    connect(&panel, &CollectionPanel::addRequested, this,
            [&added](const QList<document::Fractal>& chosen) { added.append(chosen.first().name); });
    QTRY_VERIFY(grid->model()->rowCount() > 3);
    for (const QAction* action : grid->actions())
        QVERIFY(!action->statusTip().isEmpty());

    auto* search = panel.findChild<QLineEdit*>();
    search->setText(u"there is no such fractal"_s);
    grid->setFocus();
    QTest::keyClick(grid, Qt::Key_Return);
    QVERIFY(opened.isEmpty());
    search->clear();
    const QModelIndex second = grid->model()->index(2, 0);
    const QPoint place = grid->visualRect(second).center();
    QTest::mouseClick(grid->viewport(), Qt::LeftButton, {}, place);
    QVERIFY(opened.isEmpty());
    QTest::mouseDClick(grid->viewport(), Qt::LeftButton, {}, place);
    QCOMPARE(opened, (QStringList{u"flower"_s}));
    QTest::keyClick(grid, Qt::Key_Return);
    QCOMPARE(opened.size(), 2);
    QVERIFY(added.isEmpty());
    QTest::keyClick(grid, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(added, (QStringList{u"flower"_s}));
    QCOMPARE(opened.size(), 2);
}

void CollectionPanelTest::arrowsSkipTitles() {
    CollectionPanel panel;
    panel.resize(300, 500);
    panel.show();
    auto* grid = panel.findChild<QListView*>();
    QTRY_VERIFY(grid->model()->rowCount() > 60);
    support::handleEvents();
    grid->setCurrentIndex(grid->model()->index(1, 0));
    for (int step = 0; step < 12; ++step) {
        const int before = grid->currentIndex().row();
        QTest::keyClick(grid, Qt::Key_Down);
        QVERIFY(grid->currentIndex().row() > before);
        QVERIFY(!grid->currentIndex().data(CollectionModel::HeadingRole).toBool());
    }
}

void CollectionPanelTest::asksOnlyForWhatIsSeen() {
    QDir(io::ThumbnailCache::usualFolder()).removeRecursively();
    CollectionPanel panel;
    panel.resize(300, 400);
    panel.show();
    auto* grid = panel.findChild<QListView*>();
    auto* thumbnails = panel.findChild<view::Thumbnails*>();
    QTRY_VERIFY(grid->model()->rowCount() > 100);
    QTRY_VERIFY(thumbnails->drawn() > 0);
    QTRY_COMPARE_WITH_TIMEOUT(thumbnails->pending(), 0, 60'000);
    QVERIFY2(thumbnails->drawn() < 60, qPrintable(QString::number(thumbnails->drawn())));
}

void CollectionPanelTest::ownFolders() {
    QTemporaryDir folder;
    QFile file(folder.filePath(u"mine.ifs"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("qwxyz { ; my own\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n");
    file.close();
    const auto isShown = [](CollectionPanel& panel) {
        panel.findChild<QLineEdit*>()->setText(u"qwxyz"_s);
        return panel.findChild<QListView*>()->model()->rowCount() == 2; // the title and the entry
    };
    {
        CollectionPanel panel;
        panel.addFolder(folder.path());
        panel.addFolder(folder.path());
        QTRY_VERIFY(isShown(panel));
    }
    CollectionPanel later;
    QCOMPARE(later.folders(), QStringList{folder.path()});
    QTRY_VERIFY(isShown(later));
    later.removeFolder(folder.path());
    QVERIFY(!isShown(later));
    QVERIFY(CollectionPanel().folders().isEmpty());
}

// Nothing is read before the thread of the window continues, and a panel may be deleted during reading.
void CollectionPanelTest::readsBesideTheWindow() {
    const QTemporaryDir folder;
    for (const QString& name : {u"a"_s, u"b"_s, u"c"_s})
        writeEntries(folder.filePath(name + u".ifs"_s), 2000);
    {
        CollectionPanel panel;
        auto* grid = panel.findChild<QListView*>();
        const int before = bundledRows();
        QTRY_COMPARE(grid->model()->rowCount(), before);
        panel.addFolder(folder.path());
        QCOMPARE(grid->model()->rowCount(), before);
        QTRY_COMPARE(grid->model()->rowCount(), before + 3 * 2001);
        QCOMPARE(grid->model()->index(before + 2001, 0).data().toString(), u"b"_s);
    }
    const CollectionPanel other;
    const CollectionPanel another;
}

void CollectionPanelTest::readingCanBeStopped() {
    support::forgetSettings();
    const QTemporaryDir folder;
    writeEntries(folder.filePath(u"a.ifs"_s), 2);
    writeEntries(folder.filePath(u"b.ifs"_s), 20'000);
    CollectionPanel panel;
    const auto* rows = panel.findChild<QListView*>()->model();
    const int before = bundledRows();
    QTRY_COMPARE(rows->rowCount(), before);
    auto* stop = panel.findChild<QProgressBar*>()->parentWidget()->findChild<QToolButton*>();
    panel.addFolder(folder.path());
    connect(rows, &QAbstractItemModel::rowsInserted, stop, &QToolButton::click);
    QTRY_COMPARE(rows->rowCount(), before + 3); // a title and the entries of the first file
    QVERIFY(support::backgroundRests());
    QCOMPARE(rows->rowCount(), before + 3);
    QCOMPARE(panel.folders(), QStringList{folder.path()});
}

namespace {

QStringList titles(const QAbstractItemModel& model) {
    QStringList found;
    for (int row = 0; row < model.rowCount(); ++row)
        if (model.index(row, 0).data(CollectionModel::HeadingRole).toBool())
            found << model.index(row, 0).data().toString();
    return found;
}

} // namespace

// When it does after all, its files stand before those of the folders behind it.
void CollectionPanelTest::aFolderThatDoesNotAnswerHidesNoOther() {
    support::forgetSettings();
    const QTemporaryDir late;
    const QTemporaryDir other;
    writeEntries(late.filePath(u"late.ifs"_s), 2);
    writeEntries(other.filePath(u"other.ifs"_s), 2);
    support::SlowDisk disk(late.path(), 20s);
    CollectionPanel panel;
    const auto* rows = panel.findChild<QListView*>()->model();
    panel.addFolder(late.path());
    panel.addFolder(other.path());
    QTRY_VERIFY(titles(*rows).contains(u"other"_s));
    QVERIFY(!titles(*rows).contains(u"late"_s));
    disk.answer();
    QTRY_VERIFY(titles(*rows).contains(u"late"_s));
    QCOMPARE(titles(*rows).last(2), (QStringList{u"late"_s, u"other"_s}));
}

// The button is not held down by what it stops.
void CollectionPanelTest::whatDoesNotAnswerCanBeStopped() {
    support::forgetSettings();
    const QTemporaryDir late;
    writeEntries(late.filePath(u"late.ifs"_s), 2);
    const support::SlowDisk disk(late.path(), 20s);
    CollectionPanel panel;
    panel.show();
    auto* progress = panel.findChild<QProgressBar*>();
    panel.addFolder(late.path());
    QTRY_VERIFY(progress->isVisible() && progress->format().contains(u'“'));
    progress->parentWidget()->findChild<QToolButton*>()->click();
    QVERIFY(!progress->isVisible());
}

void CollectionPanelTest::dragsAsText() {
    view::Thumbnails thumbnails;
    CollectionModel model(&thumbnails);
    model.append(theme(u"Ferns"_s, {u"a"_s, u"b"_s}));
    const std::unique_ptr<QMimeData> mimeData(model.mimeData({model.index(0), model.index(2)}));
    const view::FoundEntries found = view::entriesIn(*mimeData);
    QCOMPARE(found.entries.size(), 1);
    QCOMPARE(found.entries.front().fractal->name, u"b"_s);
}

void CollectionPanelTest::favouritesAreKept() {
    view::finishStoring();
    QSettings().remove(u"collection/favourites"_s);
    const auto grid = [](const view::CollectionPanel& panel) { return panel.findChild<QListView*>(); };
    QString name;
    {
        view::CollectionPanel panel;
        panel.show();
        QTRY_VERIFY(grid(panel)->model()->rowCount() > 20);
        const QModelIndex third = grid(panel)->model()->index(2, 0);
        name = third.data().toString();
        grid(panel)->setCurrentIndex(third);
        QVERIFY(!support::action(panel, "favourite")->isChecked());
        support::action(panel, "favourite")->trigger();
        QVERIFY(third.data(CollectionModel::FavouriteRole).toBool());
    }
    view::CollectionPanel again;
    again.show();
    QTRY_VERIFY(grid(again)->model()->rowCount() > 20);
    support::action(again, "favourites-only")->setChecked(true);
    QTRY_COMPARE(grid(again)->model()->rowCount(), 2); // a title and the favourite
    QCOMPARE(grid(again)->model()->index(1, 0).data().toString(), name);
    grid(again)->setCurrentIndex(grid(again)->model()->index(1, 0));
    support::action(again, "favourite")->trigger();
    QVERIFY(view::stored(u"collection/favourites"_s).toStringList().isEmpty());
    // An empty grid says why.
    const auto* why = grid(again)->viewport()->findChild<QLabel*>();
    QTRY_VERIFY(why->isVisible());
    const QString none = why->text();
    again.findChild<QLineEdit*>()->setText(u"no such fractal"_s);
    QVERIFY(why->isVisible() && why->text() != none);
    support::action(again, "favourites-only")->setChecked(false);
    again.findChild<QLineEdit*>()->clear();
    QTRY_VERIFY(!why->isVisible());
}

// They are named by the file of their theme. Earlier versions named them by its title.
void CollectionPanelTest::favouritesAreKeptInEveryLanguage() {
    io::CollectionTheme ferns = theme(u"Ferns"_s, {u"a"_s, u"b"_s});
    ferns.file = u"ferns.ifs"_s;
    const auto isFavourite = [](const io::CollectionTheme& shown, const QStringList& kept, int row) {
        view::Thumbnails thumbnails;
        CollectionModel model(&thumbnails);
        model.append(shown);
        model.setFavourites(kept);
        return model.index(row).data(CollectionModel::FavouriteRole).toBool();
    };
    view::Thumbnails thumbnails;
    CollectionModel model(&thumbnails);
    model.append(ferns);
    model.setFavourites({u"|Ferns|a"_s});
    QVERIFY(model.setData(model.index(1), true, CollectionModel::FavouriteRole));
    QVERIFY(model.setData(model.index(2), true, CollectionModel::FavouriteRole));
    QCOMPARE(model.favourites().size(), 2);
    io::CollectionTheme farne = ferns;
    farne.title = u"Farne"_s;
    QVERIFY(isFavourite(farne, model.favourites(), 1) && isFavourite(farne, model.favourites(), 2));
    QVERIFY(isFavourite(ferns, {u"|Ferns|b"_s}, 2) && !isFavourite(ferns, {u"|Ferns|b"_s}, 1));
    QVERIFY(model.setData(model.index(1), false, CollectionModel::FavouriteRole));
    QVERIFY(!isFavourite(ferns, model.favourites(), 1));
}

// Of the same theme, with the picture by its full path where the folder is the user's own.
void CollectionPanelTest::partnersComeAlong() {
    view::Thumbnails thumbnails;
    CollectionModel model(&thumbnails);
    io::CollectionTheme pair = theme(u"Pairs"_s, {u"f"_s, u"g"_s, u"alone"_s});
    const auto keep = [&](qsizetype index, const QString& partner) {
        document::KeptTheft theft;
        theft.partner = partner;
        theft.picture = u"a.png"_s;
        pair.entries[index].fractal = std::make_shared<const document::Fractal>(
            document::withTheft(*pair.entries[index].fractal, theft));
    };
    keep(0, u"G"_s);
    keep(2, u"missing"_s);
    model.append(pair, u"/home/me"_s);
    const QList<document::Fractal> both = model.withPartnerAt(model.index(1));
    QCOMPARE(both.size(), 2);
    QCOMPARE(both[1].name, u"g"_s);
    QCOMPARE(document::keptTheft(both[0])->picture, u"/home/me/a.png"_s);
    QCOMPARE(model.withPartnerAt(model.index(2)).size(), 1);
    QCOMPARE(model.withPartnerAt(model.index(3)).size(), 1);
    QVERIFY(model.withPartnerAt(model.index(0)).isEmpty()); // a title
    const std::unique_ptr<QMimeData> dragged(model.mimeData({model.index(1)}));
    QVERIFY(dragged->text().contains(u"f {"_s) && dragged->text().contains(u"g {"_s));
}

// What is shown, said and searched; what is opened, dragged or saved stays as it is.
void CollectionPanelTest::bundledNamesAreTranslated() {
    const support::Spoken german(u"de"_s);
    QVERIFY(german.isInstalled());
    io::CollectionTheme ferns = io::readTheme(u":/ifs_library/ferns.ifs"_s);
    ferns.entries.removeIf(
        [](const document::Entry& entry) { return entry.fractal->name != u"lady_fern"_s; });
    QCOMPARE(ferns.entries.size(), 1);
    view::Thumbnails thumbnails;
    CollectionModel model(&thumbnails);
    model.append(ferns);
    model.append(ferns, u"/home/me"_s);
    const QModelIndex bundled = model.index(1);
    QCOMPARE(bundled.data().toString(), u"Frauenfarn"_s);
    for (const int role :
         {int(Qt::ToolTipRole), int(Qt::AccessibleTextRole), int(CollectionModel::SearchRole)})
        QVERIFY(bundled.data(role).toString().contains(u"Frauenfarn: wechsel"_s));
    QVERIFY(bundled.data(CollectionModel::SearchRole).toString().contains(u"Lady fern"_s));
    QCOMPARE(model.index(3).data().toString(), u"Lady fern"_s);
    QVERIFY(model.fractalAt(bundled)->headerComment.contains(u"Lady fern: "_s));
    const std::unique_ptr<QMimeData> dragged(model.mimeData({bundled}));
    QVERIFY(dragged->text().contains(u"Lady fern"_s) && !dragged->text().contains(u"Frauenfarn"_s));
    const support::Spoken french(u"fr"_s);
    QVERIFY(french.isInstalled());
    QCOMPARE(bundled.data().toString(), u"Fougère femelle"_s); // has a blank before the colon
}

BARYCAGE_TEST(CollectionPanelTest, QApplication);
#include "collection_panel_test.moc"
