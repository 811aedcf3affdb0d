// SPDX-License-Identifier: MIT
#include "panels/collection/collection_window.h"

#include "desktop/reduced_motion.h"
#include "io/picture/thumbnail_cache.h"
#include "panels/collection/collection_delegate.h"
#include "panels/collection/collection_grid.h"
#include "panels/collection/collection_model.h"
#include "panels/collection/collection_pictures.h"
#include "panels/collection/moving_picture.h"
#include "widgets/flat_buttons.h"
#include "widgets/icon.h"
#include "widgets/thumbnails.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>

namespace view {

namespace {

using Part = CollectionFilter::Part;

constexpr int partRole = Qt::UserRole;
constexpr int sectionRole = Qt::UserRole + 1;
constexpr int linesAbout = 3;
constexpr int gapHeight = 6; // pixels between the user's own parts and the themes

} // namespace

CollectionWindow::CollectionWindow(CollectionModel* collection, QWidget* parent)
    : QDialog(parent),
      m_collection(collection),
      m_thumbnails(new Thumbnails(this)),
      m_pictures(new CollectionPictures(collection, m_thumbnails, this)),
      m_grid(new CollectionGrid(m_pictures, pictureSide, this)),
      m_moving(new MovingPicture(this)),
      m_search(new QLineEdit(this)) {
    setObjectName(QStringLiteral("collection-window"));
    setWindowTitle(tr("Collection"));
    m_thumbnails->setCache(std::make_unique<io::ThumbnailCache>(io::ThumbnailCache::usualFolder()));
    m_grid->setSpacing(6);
    m_grid->setMouseTracking(true);
    m_grid->viewport()->installEventFilter(this);
    m_grid->setWhatsThis(tr("Ready-made fractals. Double-click one or press Enter to open it. Those with a "
                            "triangle in the corner move under the pointer."));
    m_search->setObjectName(QStringLiteral("search"));
    m_search->setAccessibleName(tr("Search the collection"));
    m_search->setPlaceholderText(m_search->accessibleName());
    m_search->setWhatsThis(tr("Shows only the fractals whose name, theme or comment contains these words. "
                              "Enter opens the first of them."));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);

    auto* right = new QVBoxLayout;
    right->addWidget(m_search);
    right->addWidget(m_grid, 1);
    auto* columns = new QHBoxLayout;
    columns->addWidget(createThemes());
    columns->addLayout(right, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns, 1);
    layout->addWidget(createFoot());
    layout->addWidget(createButtons());

    connect(m_search, &QLineEdit::textChanged, this, &CollectionWindow::search);
    connect(m_grid, &QListView::doubleClicked, m_open, &QPushButton::click);
    connect(m_grid, &QListView::entered, this, &CollectionWindow::play);
    connect(m_grid->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &CollectionWindow::updateCurrent);
    connect(m_moving, &MovingPicture::shown, this, [this](const QPixmap& frame) {
        m_grid->delegate()->setFrame(m_played, frame);
        m_grid->update(m_played);
    });
    fillThemes();
    for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(collection, changed, this, &CollectionWindow::fillThemes);
    updateCurrent();
    m_search->setFocus();
    if (!parent) return;
    resize(parent->window()->size());
    move(parent->window()->pos());
}

CollectionWindow::~CollectionWindow() = default;

QWidget* CollectionWindow::createThemes() {
    m_themes = new QListWidget(this);
    m_themes->setObjectName(QStringLiteral("themes"));
    m_themes->setAccessibleName(tr("Themes"));
    m_themes->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_themes->setTextElideMode(Qt::ElideRight);
    m_themes->setSpacing(2);
    connect(m_themes, &QListWidget::currentRowChanged, this, &CollectionWindow::showPart);
    return m_themes;
}

// What the selected fractal is, and whether it is a favourite.
QWidget* CollectionWindow::createFoot() {
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    m_about = new QLabel(foot);
    m_about->setObjectName(QStringLiteral("about"));
    m_about->setWordWrap(true);
    m_about->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    m_about->setTextFormat(Qt::RichText);
    m_about->setFixedHeight(linesAbout * fontMetrics().lineSpacing());
    m_favourite = flatButton(QStringLiteral("favourite"), tr("Favourite"),
                             tr("Add the selected fractal to your favourites (Ctrl+D)"), foot);
    m_favourite->setObjectName(QStringLiteral("favourite"));
    m_favourite->setCheckable(true);
    m_favourite->setShortcut(Qt::CTRL | Qt::Key_D);
    connect(m_favourite, &QToolButton::clicked, this,
            [this](bool on) { m_pictures->setData(m_grid->current(), on, CollectionModel::FavouriteRole); });
    row->addWidget(m_about, 1);
    row->addWidget(m_favourite, 0, Qt::AlignTop);
    return foot;
}

QWidget* CollectionWindow::createButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_open = buttons->addButton(tr("&Open"), QDialogButtonBox::AcceptRole);
    m_open->setObjectName(QStringLiteral("open"));
    m_open->setToolTip(
        tr("Add the selected fractal to the open file, or open it if you have not edited anything."));
    m_open->setDefault(true);
    m_add = buttons->addButton(tr("&Add to This File"), QDialogButtonBox::ActionRole);
    m_add->setObjectName(QStringLiteral("add"));
    m_add->setToolTip(tr("Add the selected fractal to the open file."));
    m_add->setAutoDefault(false);
    connect(m_open, &QPushButton::clicked, this, [this] { use(&CollectionWindow::chosen); });
    connect(m_add, &QPushButton::clicked, this, [this] { use(&CollectionWindow::addRequested); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void CollectionWindow::use(void (CollectionWindow::*used)(const QList<document::Fractal>&)) {
    const QModelIndex entry = m_pictures->mapToSource(m_grid->current());
    const QList<document::Fractal> fractals = m_collection->withPartnerAt(entry);
    if (fractals.isEmpty()) return;
    m_collection->addRecent(entry);
    accept();
    emit(this->*used)(fractals);
}

// Themes of the user's folders come while they are read.
void CollectionWindow::fillThemes() {
    const QListWidgetItem* before = m_themes->currentItem();
    const QVariant part = before ? before->data(partRole) : int(Part::All);
    const QVariant section = before ? before->data(sectionRole) : QVariant();
    const QSignalBlocker quiet(m_themes);
    m_themes->clear();
    const auto add = [&](const QString& title, Part added, const QModelIndex& heading = {}) {
        auto* item = new QListWidgetItem(title, m_themes);
        item->setData(partRole, int(added));
        item->setData(sectionRole, heading.data(CollectionModel::SectionRole));
        item->setToolTip(heading.data(Qt::ToolTipRole).toString());
        if (item->data(partRole) == part && item->data(sectionRole) == section)
            m_themes->setCurrentItem(item);
    };
    add(tr("All"), Part::All);
    add(tr("Favourites"), Part::Favourites);
    add(tr("Recent"), Part::Recent);
    auto* gap = new QListWidgetItem(m_themes);
    gap->setFlags(Qt::NoItemFlags);
    gap->setSizeHint({0, gapHeight});
    for (int row = 0; row < m_collection->rowCount(); ++row) {
        const QModelIndex heading = m_collection->index(row);
        if (heading.data(CollectionModel::HeadingRole).toBool())
            add(heading.data().toString(), Part::Theme, heading);
    }
    if (m_themes->currentRow() < 0) m_themes->setCurrentRow(0);
    const int room = m_themes->sizeHintForColumn(0) + 2 * (m_themes->frameWidth() + m_themes->spacing()) +
                     m_themes->verticalScrollBar()->sizeHint().width() + 8;
    m_themes->setFixedWidth(std::min(room, 40 * fontMetrics().averageCharWidth()));
    showPart();
}

void CollectionWindow::showPart() {
    const QListWidgetItem* item = m_themes->currentItem();
    m_grid->setPart(Part(item->data(partRole).toInt()), item->data(sectionRole).toString());
    updateCurrent();
}

// Words are looked for everywhere.
void CollectionWindow::search(const QString& words) {
    if (!words.isEmpty()) m_themes->setCurrentRow(0);
    m_grid->search(words);
    updateCurrent();
}

void CollectionWindow::updateCurrent() {
    const QModelIndex current = m_grid->currentIndex();
    const bool isFractal = m_collection->fractalAt(m_pictures->mapToSource(m_grid->current())) != nullptr;
    for (QWidget* button :
         {static_cast<QWidget*>(m_open), static_cast<QWidget*>(m_add), static_cast<QWidget*>(m_favourite)})
        button->setEnabled(isFractal);
    m_favourite->setChecked(current.data(CollectionModel::FavouriteRole).toBool());
    m_about->setText(isFractal ? current.data(Qt::ToolTipRole).toString()
                               : tr("Double-click a fractal to open it."));
    play(current);
}

void CollectionWindow::play(const QModelIndex& index) {
    if (index == m_played && m_moving->isPlaying()) return;
    m_grid->update(m_played);
    m_grid->delegate()->setFrame({}, {});
    m_played = index;
    m_moving->stop();
    if (!index.data(CollectionModel::MovesRole).toBool() || reducesMotion()) return;
    const auto* shown = qobject_cast<const CollectionFilter*>(m_grid->model());
    m_moving->play(m_collection->fractalAt(m_pictures->mapToSource(shown->mapToSource(index))), pictureSide,
                   devicePixelRatioF());
}

bool CollectionWindow::event(QEvent* event) {
    if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal)
        m_thumbnails->setSize(pictureSide, devicePixelRatioF());
    return QDialog::event(event);
}

bool CollectionWindow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_grid->viewport() && event->type() == QEvent::Leave) play(m_grid->currentIndex());
    if (watched == m_search && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down) {
        m_grid->setFocus();
        return true;
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace view
