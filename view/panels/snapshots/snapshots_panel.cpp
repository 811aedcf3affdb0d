// SPDX-License-Identifier: MIT
#include "panels/snapshots/snapshots_panel.h"

#include "panels/snapshots/snapshot_delegate.h"
#include "widgets/flat_buttons.h"
#include "widgets/focus_shortcuts.h"
#include "widgets/icon.h"
#include "widgets/text/tooltip_text.h"
#include "widgets/thumbnails.h"

#include <QAction>
#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

SnapshotsPanel::SnapshotsPanel(Snapshots* snapshots, SnapshotLook* look, QAction* take, QAction* compare,
                               QWidget* parent)
    : QWidget(parent),
      m_snapshots(snapshots),
      m_look(look),
      m_take(take),
      m_compare(compare),
      m_list(new QListWidget(this)),
      m_thumbnails(new Thumbnails(this)) {
    setAccessibleName(tr("Snapshots"));
    createList();
    createActions();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttonBar({m_take, m_compare, m_add, m_rename, m_remove}, m_add, this));
    connect(snapshots, &Snapshots::changed, this, &SnapshotsPanel::follow);
    connect(look, &SnapshotLook::changed, this, &SnapshotsPanel::follow);
    connect(m_thumbnails, &Thumbnails::ready, this, &SnapshotsPanel::follow);
    m_thumbnails->setSize(SnapshotDelegate::pictureSide, devicePixelRatioF());
    follow();
}

void SnapshotsPanel::createList() {
    m_list->setAccessibleName(tr("Snapshots of the fractal"));
    m_list->setToolTip(tr("Click a snapshot to restore it; undo goes back. The arrow keys or a right click "
                          "select the one to compare with. F2 renames it, Del deletes it."));
    m_list->setStatusTip(m_list->toolTip());
    m_list->setWhatsThis(tr("States of this fractal that you kept. Click one to restore it, as one step of "
                            "the history. The frame marks the snapshot that the canvas shows. The B marks "
                            "the selected snapshot, the one to compare with: the newest, until you select "
                            "another one with the arrow keys or a right click. Snapshots last "
                            "until the file is closed; Add as Entry keeps one in the file."));
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setSpacing(1);
    m_list->setUniformItemSizes(true);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers); // F2 and the menu start editing
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setItemDelegate(new SnapshotDelegate(m_list));
    m_list->viewport()->setAttribute(Qt::WA_Hover);
    m_list->viewport()->installEventFilter(this);
    connect(m_list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
        m_snapshots->restore(item->data(SnapshotDelegate::KeyRole).toULongLong());
    });
    connect(m_list, &QListWidget::currentItemChanged, this, [this] {
        if (!m_isFollowing) m_snapshots->mark(currentKey());
    });
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (m_isFollowing) return;
        m_snapshots->rename(item->data(SnapshotDelegate::KeyRole).toULongLong(), item->text());
        follow(); // restores the name if the new one has no letters
    });
    connect(m_list, &QWidget::customContextMenuRequested, this, &SnapshotsPanel::showContextMenu);
}

void SnapshotsPanel::createActions() {
    m_restore =
        createAction(tr("&Restore"), tr("Restore the fractal to this snapshot."), nullptr,
                     {Qt::Key_Return, Qt::Key_Enter}, [this](quint64 key) { m_snapshots->restore(key); });
    m_add = createAction(tr("&Add as Entry"),
                         tr("Add the snapshot to the file as an entry of its own, after this one."), "add",
                         {}, [this](quint64 key) { m_snapshots->addAsEntry(key); });
    m_rename = createAction(tr("Re&name"), tr("Give the snapshot another name."), "edit", {Qt::Key_F2},
                            [this](quint64) { m_list->editItem(m_list->currentItem()); });
    m_remove = createAction(tr("&Delete"), tr("Delete the snapshot; the fractal stays as it is."), "remove",
                            {QKeySequence::Delete}, [this](quint64 key) { m_snapshots->remove(key); });
    m_bringBack = new QAction(tr("&Bring Back"), this);
    m_bringBack->setStatusTip(tr("Bring back the snapshot that was deleted last."));
    connect(m_bringBack, &QAction::triggered, m_snapshots, &Snapshots::bringBack);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        for (QAction* action : {m_restore, m_add, m_rename, m_remove})
            action->setEnabled(row >= 0);
    });
    new FocusShortcuts(m_list);
}

QAction* SnapshotsPanel::createAction(const QString& text, const QString& tip, const char* iconName,
                                      const QList<QKeySequence>& keys,
                                      const std::function<void(quint64)>& operation) {
    auto* action = new QAction(text, this);
    action->setStatusTip(tip);
    if (iconName) action->setIcon(icon(QLatin1String(iconName)));
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    const QString shortcut = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(shortcut.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, shortcut));
    connect(action, &QAction::triggered, this, [this, operation] {
        if (const quint64 key = currentKey()) operation(key);
    });
    m_list->addAction(action);
    action->setEnabled(false);
    return action;
}

quint64 SnapshotsPanel::currentKey() const {
    const QListWidgetItem* item = m_list->currentItem();
    return item ? item->data(SnapshotDelegate::KeyRole).toULongLong() : 0;
}

// Tiles stay where their snapshots do, so that one that is being renamed goes on being so.
void SnapshotsPanel::follow() {
    const QScopedValueRollback<bool> guard(m_isFollowing, true);
    const std::vector<Snapshot>& snapshots = m_snapshots->list();
    for (int row = 0; row < int(snapshots.size()) || row < m_list->count(); ++row) {
        const auto isListed = [&](int at) {
            const quint64 key = m_list->item(at)->data(SnapshotDelegate::KeyRole).toULongLong();
            return std::ranges::any_of(snapshots, [key](const Snapshot& one) { return one.key == key; });
        };
        while (row < m_list->count() && !isListed(row))
            delete m_list->takeItem(row);
        if (row >= int(snapshots.size())) continue;
        const Snapshot& snapshot = snapshots[std::size_t(row)];
        if (row >= m_list->count() ||
            m_list->item(row)->data(SnapshotDelegate::KeyRole).toULongLong() != snapshot.key) {
            m_list->insertItem(row, new QListWidgetItem);
            m_list->item(row)->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
            m_list->item(row)->setData(SnapshotDelegate::KeyRole, snapshot.key);
        }
        showTile(m_list->item(row), snapshot);
        const Snapshot* marked = m_snapshots->marked();
        if (marked && marked->key == snapshot.key) m_list->setCurrentRow(row);
    }
    m_bringBack->setEnabled(!m_snapshots->removed().isEmpty());
    m_list->viewport()->update();
}

void SnapshotsPanel::showTile(QListWidgetItem* item, const Snapshot& snapshot) {
    const auto set = [item](int role, const QVariant& value) {
        if (item->data(role) != value) item->setData(role, value);
    };
    const Thumbnail thumbnail = m_thumbnails->thumbnail(snapshot.key, snapshot.fractal);
    const Snapshot* marked = m_snapshots->marked();
    const Snapshot* looked = m_look->shown();
    const bool isMarked = marked && marked->key == snapshot.key;
    const bool isShown =
        looked ? looked->key == snapshot.key : m_snapshots->present() == std::optional(snapshot.key);
    if (item->data(Qt::DecorationRole).value<QPixmap>().cacheKey() != thumbnail.pixmap.cacheKey())
        item->setData(Qt::DecorationRole, thumbnail.pixmap);
    set(SnapshotDelegate::StateRole, int(thumbnail.state));
    set(SnapshotDelegate::MarkedRole, isMarked);
    set(SnapshotDelegate::ShownRole, isShown);
    set(Qt::DisplayRole, snapshot.name);
    QStringList said{snapshot.name};
    if (isShown) said << tr("shown on the canvas");
    if (isMarked) said << tr("the one to compare with");
    set(Qt::AccessibleTextRole, said.join(QStringLiteral(", ")));
    set(Qt::ToolTipRole, tooltipText(snapshot.name));
}

void SnapshotsPanel::showContextMenu(const QPoint& position) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    if (m_list->itemAt(position)) {
        menu->addActions({m_restore, m_compare}); // for the selected snapshot
        menu->addSeparator();
        menu->addActions({m_rename, m_add, m_remove});
        menu->addSeparator();
    }
    if (const QString removed = m_snapshots->removed(); !removed.isEmpty()) {
        m_bringBack->setText(tr("&Bring Back “%1”").arg(QString(removed).replace(u'&', QLatin1String("&&"))));
        menu->addAction(m_bringBack);
    }
    menu->addAction(m_take);
    menu->popup(m_list->viewport()->mapToGlobal(position));
}

void SnapshotsPanel::paintEmpty() {
    QPainter painter(m_list->viewport());
    painter.setPen(m_list->palette().color(QPalette::PlaceholderText));
    const QString keys = m_take->shortcut().toString(QKeySequence::NativeText);
    const QString compare = m_compare->shortcut().toString(QKeySequence::NativeText);
    painter.drawText(
        m_list->viewport()->rect().adjusted(12, 4, -12, -4), Qt::AlignCenter | Qt::TextWordWrap,
        m_snapshots->isPossible()
            ? tr("No snapshots of this fractal yet. Press %1 to keep its state, change it, and press %2 to "
                 "compare.")
                  .arg(keys, compare)
            : tr("An entry that could not be read has no snapshots."));
}

bool SnapshotsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint && m_list->count() == 0) {
        paintEmpty();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

bool SnapshotsPanel::event(QEvent* event) {
    if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal) {
        m_thumbnails->setSize(SnapshotDelegate::pictureSide, devicePixelRatioF());
        follow();
    }
    return QWidget::event(event);
}

} // namespace view
