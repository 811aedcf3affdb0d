// SPDX-License-Identifier: MIT
#include "panels/collection/collection_panel.h"

#include "desktop/settings.h"
#include "io/picture/thumbnail_cache.h"
#include "panels/collection/collection_grid.h"
#include "panels/collection/collection_model.h"
#include "panels/collection/collection_window.h"
#include "widgets/file_dialogs.h"
#include "widgets/flat_buttons.h"
#include "widgets/focus_shortcuts.h"
#include "widgets/icon.h"
#include "widgets/thumbnails.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>

namespace view {
namespace {

const QString foldersKey = QStringLiteral("collection/folders");
const QString favouritesKey = QStringLiteral("collection/favourites");
const QString recentKey = QStringLiteral("collection/recent");
constexpr int pictureSide = 76;                    // device-independent pixels
constexpr std::chrono::milliseconds patience{400}; // delay before reading is reported

} // namespace

CollectionPanel::CollectionPanel(QWidget* parent)
    : QWidget(parent),
      m_thumbnails(new Thumbnails(this)),
      m_model(new CollectionModel(m_thumbnails, this)),
      m_search(new QLineEdit(this)),
      m_grid(new CollectionGrid(m_model, pictureSide, this)),
      m_progress(createProgress()) {
    setAccessibleName(tr("Collection"));
    m_thumbnails->setCache(std::make_unique<io::ThumbnailCache>(io::ThumbnailCache::usualFolder()));
    m_search->setAccessibleName(tr("Search the collection"));
    m_search->setWhatsThis(tr("Shows only the fractals whose name, theme or comment contains these words. "
                              "Enter opens the first of them."));
    m_search->setPlaceholderText(tr("Search the collection"));
    m_search->setStatusTip(tr("Show only fractals whose name, title, theme or source contains these words."));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    createGrid();
    createActions();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(m_search);
    layout->addWidget(m_grid, 1);
    layout->addWidget(m_progress);
    layout->addWidget(
        buttonBar({m_browse, m_add, m_onlyFavourites, m_onlyRecent, m_addFolder}, m_onlyFavourites, this));

    m_model->setFavourites(stored(favouritesKey).toStringList());
    m_model->setRecent(stored(recentKey).toStringList());
    connect(m_model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex&, const QModelIndex&, const QList<int>& roles) {
                if (roles.contains(CollectionModel::FavouriteRole))
                    store(favouritesKey, m_model->favourites());
                if (roles.contains(CollectionModel::RecentRole)) store(recentKey, m_model->recent());
            });
    read({});
    m_folders = stored(foldersKey).toStringList();
    for (const QString& folder : std::as_const(m_folders))
        read(folder);
    updateActions();
}

CollectionPanel::~CollectionPanel() {
    for (const Reading& reading : std::as_const(m_readings))
        reading.watcher->cancel(); // the threads do not use this object
}

void CollectionPanel::createGrid() {
    m_grid->setWhatsThis(tr("Ready-made fractals. Double-click one or press Enter to open it in this window; "
                            "right-click it to add it to the file instead."));
    m_grid->setDragEnabled(true);
    m_grid->setDragDropMode(QAbstractItemView::DragOnly);
    connect(m_search, &QLineEdit::textChanged, m_grid, &CollectionGrid::search);
    connect(m_search, &QLineEdit::returnPressed, this, [this] { m_use->trigger(); });
    connect(m_grid, &QListView::doubleClicked, this, [this] { m_use->trigger(); });
    connect(m_grid->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &CollectionPanel::updateActions);
    connect(m_grid, &QWidget::customContextMenuRequested, this, &CollectionPanel::showContextMenu);
}

void CollectionPanel::createActions() {
    m_use = createAction(
        tr("&Use"),
        tr("Add the selected fractal to the open file, or open it if you have not edited anything."),
        QStringLiteral("add"), {Qt::Key_Return, Qt::Key_Enter});
    connect(m_use, &QAction::triggered, this, [this] { use(&CollectionPanel::chosen); });
    m_open =
        createAction(tr("&Open as New Document"), tr("Open the selected fractal as a separate document."),
                     QStringLiteral("open"), {});
    m_open->setObjectName(QStringLiteral("open"));
    connect(m_open, &QAction::triggered, this, [this] { use(&CollectionPanel::openRequested); });
    m_add = createAction(tr("&Add to This File"), tr("Add the selected fractal to the open file."),
                         QStringLiteral("add"), {Qt::SHIFT | Qt::Key_Return, Qt::SHIFT | Qt::Key_Enter});
    connect(m_add, &QAction::triggered, this, [this] { use(&CollectionPanel::addRequested); });
    m_favourite = createAction(tr("Fa&vourite"), tr("Add the selected fractal to your favourites."),
                               QStringLiteral("favourite"), {Qt::CTRL | Qt::Key_D});
    m_favourite->setObjectName(QStringLiteral("favourite"));
    m_favourite->setCheckable(true);
    connect(m_favourite, &QAction::triggered, this,
            [this](bool on) { m_model->setData(m_grid->current(), on, CollectionModel::FavouriteRole); });
    m_browse =
        createAction(tr("&Browse…"), tr("Show the collection over the whole window, in large pictures."),
                     QStringLiteral("collection"), {});
    m_browse->setObjectName(QStringLiteral("browse"));
    connect(m_browse, &QAction::triggered, this, &CollectionPanel::browse);
    m_onlyFavourites = createAction(tr("Fa&vourites Only"), tr("Show only your favourites."),
                                    QStringLiteral("favourite"), {});
    m_onlyFavourites->setObjectName(QStringLiteral("favourites-only"));
    m_onlyRecent = createAction(tr("&Recent Only"), tr("Show only the fractals that you used last."),
                                QStringLiteral("history"), {});
    m_onlyRecent->setObjectName(QStringLiteral("recent-only"));
    auto* parts = new QActionGroup(this);
    parts->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (QAction* part : {m_onlyFavourites, m_onlyRecent}) {
        part->setCheckable(true);
        parts->addAction(part);
        connect(part, &QAction::toggled, this, &CollectionPanel::showPart);
    }
    m_addFolder =
        createAction(tr("Add &Folder…"), tr("Add the .ifs files of one of your own folders to this list."),
                     QStringLiteral("add-folder"), {});
    connect(m_addFolder, &QAction::triggered, this, &CollectionPanel::chooseFolder);
    new FocusShortcuts(m_grid);
}

void CollectionPanel::showPart() {
    using Part = CollectionFilter::Part;
    m_grid->setPart(m_onlyFavourites->isChecked() ? Part::Favourites
                    : m_onlyRecent->isChecked()   ? Part::Recent
                                                  : Part::All);
}

void CollectionPanel::use(void (CollectionPanel::*used)(const QList<document::Fractal>&)) {
    const QList<document::Fractal> fractals = current();
    if (fractals.isEmpty()) return;
    m_model->addRecent(m_grid->current());
    emit(this->*used)(fractals);
}

void CollectionPanel::browse() {
    auto* browser = new CollectionWindow(m_model, window());
    browser->setAttribute(Qt::WA_DeleteOnClose);
    connect(browser, &CollectionWindow::chosen, this, &CollectionPanel::chosen);
    connect(browser, &CollectionWindow::addRequested, this, &CollectionPanel::addRequested);
    browser->open();
}

QAction* CollectionPanel::createAction(const QString& text, const QString& statusTip, const QString& iconName,
                                       const QList<QKeySequence>& keys) {
    auto* action = new QAction(icon(iconName), text, this);
    action->setStatusTip(statusTip);
    action->setToolTip(statusTip);
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    m_grid->addAction(action);
    return action;
}

QWidget* CollectionPanel::createProgress() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    m_done = new QProgressBar(row);
    m_done->setAccessibleName(tr("Progress of reading the collection"));
    layout->addWidget(m_done, 1);
    auto* stop = new QToolButton(row);
    stop->setIcon(icon(QStringLiteral("close")));
    stop->setIconSize({18, 18});
    stop->setAutoRaise(true);
    stop->setAccessibleName(tr("Stop reading"));
    stop->setToolTip(tr("Stop reading this folder; files that were already read stay in the list"));
    stop->setStatusTip(stop->toolTip());
    layout->addWidget(stop);
    row->hide();
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience);
    connect(&m_patience, &QTimer::timeout, row, &QWidget::show);
    connect(stop, &QToolButton::clicked, this, [this] {
        if (!m_readings.isEmpty()) endReading(m_readings.first().watcher);
    });
    return row;
}

void CollectionPanel::showContextMenu(const QPoint& position) {
    QMenu menu(this);
    menu.addActions({m_use, m_add, m_open, m_favourite});
    menu.addSeparator();
    menu.addAction(m_addFolder);
    const QString folder = m_grid->indexAt(position).data(CollectionModel::FolderRole).toString();
    if (!folder.isEmpty()) {
        QString name = folder;
        QAction* remove =
            menu.addAction(tr("&Remove Folder “%1”").arg(name.replace(u'&', QLatin1String("&&"))));
        remove->setStatusTip(tr("Remove this folder from the list. Its files are not changed."));
        connect(remove, &QAction::triggered, this, [this, folder] { removeFolder(folder); });
    }
    menu.exec(m_grid->viewport()->mapToGlobal(position));
}

void CollectionPanel::addFolder(const QString& folder) {
    if (folder.isEmpty() || m_folders.contains(folder)) return;
    m_folders.append(folder);
    saveFolders();
    read(folder);
}

void CollectionPanel::removeFolder(const QString& folder) {
    m_folders.removeAll(folder);
    saveFolders();
    const QList<Reading> readings = m_readings;
    for (const Reading& reading : readings)
        if (reading.folder == folder) endReading(reading.watcher);
    m_model->removeFolder(folder);
}

void CollectionPanel::read(const QString& folder) {
    m_model->expect(folder);
    auto* watcher = new Watcher(this);
    m_readings.append({folder, watcher});
    connect(watcher, &QFutureWatcherBase::progressRangeChanged, this, &CollectionPanel::updateProgress);
    connect(watcher, &QFutureWatcherBase::progressValueChanged, this, &CollectionPanel::updateProgress);
    connect(watcher, &QFutureWatcherBase::resultReadyAt, this,
            [this, folder, watcher](int theme) { m_model->append(watcher->resultAt(theme), folder); });
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher] { endReading(watcher); });
    watcher->setFuture(io::readThemes(folder));
    if (m_readings.size() == 1) showProgress();
}

// Gives up on folders that do not answer.
void CollectionPanel::endReading(const Watcher* watcher) {
    const auto found = std::ranges::find(m_readings, watcher, &Reading::watcher);
    if (found == m_readings.end()) return;
    Watcher* ended = found->watcher;
    const bool isShown = found == m_readings.begin();
    m_readings.erase(found);
    ended->disconnect(this);
    ended->cancel();
    ended->deleteLater();
    if (isShown) showProgress();
}

void CollectionPanel::showProgress() {
    m_patience.stop();
    m_progress->hide();
    if (m_readings.isEmpty()) return;
    const QString& folder = m_readings.first().folder;
    m_done->setFormat(folder.isEmpty() ? tr("Reading the collection…")
                                       : tr("Reading “%1”…").arg(QFileInfo(folder).fileName()));
    updateProgress();
    m_patience.start();
}

void CollectionPanel::updateProgress() {
    if (m_readings.isEmpty()) return;
    const Watcher* shown = m_readings.first().watcher;
    m_done->setRange(shown->progressMinimum(), shown->progressMaximum());
    m_done->setValue(shown->progressValue());
}

void CollectionPanel::chooseFolder() {
    addFolder(view::chooseFolder(this, tr("Folder of .ifs Files")));
}

void CollectionPanel::saveFolders() const {
    store(foldersKey, m_folders);
}

void CollectionPanel::updateActions() {
    const bool isFractal = !current().isEmpty();
    for (QAction* action : {m_use, m_open, m_add, m_favourite})
        action->setEnabled(isFractal);
    m_favourite->setChecked(m_grid->currentIndex().data(CollectionModel::FavouriteRole).toBool());
}

QList<document::Fractal> CollectionPanel::current() const {
    return m_model->withPartnerAt(m_grid->current());
}

bool CollectionPanel::event(QEvent* event) {
    if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal)
        m_thumbnails->setSize(pictureSide, devicePixelRatioF());
    return QWidget::event(event);
}

} // namespace view
