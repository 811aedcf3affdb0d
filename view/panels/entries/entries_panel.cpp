// SPDX-License-Identifier: MIT
#include "panels/entries/entries_panel.h"

#include "desktop/clipboard.h"
#include "dialogs/paste_table_dialog.h"
#include "document/edits/entries_edits.h"
#include "document/tops/partner_names.h"
#include "io/file/background.h"
#include "panels/entries/entries_comment_dialog.h"
#include "panels/entries/entries_delegate.h"
#include "panels/entries/entries_filter.h"
#include "panels/entries/entries_list.h"
#include "panels/entries/entries_model.h"
#include "widgets/background/wait_for.h"
#include "widgets/flat_buttons.h"
#include "widgets/focus_shortcuts.h"
#include "widgets/icon.h"
#include "widgets/thumbnails.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace view {

using document::Entry;
using document::EntryId;

namespace {

constexpr int lowest =
    64; // pixels of the list; on small screens with large letters the picture needs the rest
constexpr qsizetype maxAtOnce = 1000; // entries that get ids and names while the window waits

bool isReadable(const Entry& entry) {
    return document::dimension(*entry.fractal) != 0;
}

QString quotedName(const Entry& entry) {
    return QStringLiteral("“%1”").arg(entry.fractal->name);
}

EntryId idBehind(const document::FractalFile& file, EntryId id) {
    const qsizetype next = document::indexOf(file, id) + 1;
    return next > 0 && next < file.entries.size() ? file.entries[next].id : EntryId::None;
}

EntryId idInFrontOf(const document::FractalFile& file, EntryId id) {
    const qsizetype index = id == EntryId::None ? file.entries.size() : document::indexOf(file, id);
    return index > 0 ? file.entries[index - 1].id : EntryId::None;
}

} // namespace

EntriesPanel::EntriesPanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_thumbnails(new Thumbnails(this)),
      m_model(new EntriesModel(document, m_thumbnails, this)),
      m_filtered(new EntriesFilter(this)),
      m_filter(new QLineEdit(this)),
      m_list(new EntriesList([this](const QList<EntryId>& ids) { return entriesMimeData(entriesOf(ids)); },
                             this)),
      m_typing(document) {
    setAccessibleName(tr("Entries of the file"));
    m_filter->setAccessibleName(tr("Filter entries by name"));
    m_filter->setWhatsThis(tr("Shows only the entries whose names contain these letters."));
    m_filter->setPlaceholderText(tr("Filter by name"));
    m_filter->setStatusTip(tr("Show only the entries whose name contains this text."));
    m_filter->setClearButtonEnabled(true);
    m_filter->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    createList();
    createActions();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(m_filter);
    layout->addWidget(m_list, 1);
    layout->addWidget(
        buttonBar({m_add, m_duplicate, m_remove, m_rename, m_comment, m_up, m_down}, m_up, this));

    connect(m_filter, &QLineEdit::textChanged, this, &EntriesPanel::filter);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        if (change.parts & document::Change::File) m_filter->clear();
        if (!change.live) showCurrent();
    });
    updateThumbnailSize();
    showCurrent();
}

EntriesPanel::~EntriesPanel() {
    hide(); // ends the typing of a name, while there is still a panel to be asked
}

void EntriesPanel::createList() {
    m_filtered->setSourceModel(m_model);
    m_list->setModel(m_filtered);
    m_list->setMinimumHeight(lowest);
    m_list->setAccessibleName(tr("Entries"));
    m_list->setWhatsThis(
        tr("The fractals in the file. Click one to edit it, drag it to move it, press F2 to rename it."));
    m_list->setEmptyText(tr("This file contains no entries. Add one, or paste the text of an .ifs file."));
    const auto idOf = [](const QModelIndex& index) {
        return static_cast<EntryId>(index.data(EntriesModel::IdRole).toUInt());
    };
    auto* delegate = new EntriesDelegate(
        [this, idOf](const QModelIndex& index, const QString& name) {
            return nameProblem(m_document->file(), idOf(index), name);
        },
        m_list);
    m_list->setItemDelegate(delegate);
    connect(delegate, &EntriesDelegate::nameTyped, this,
            [this, idOf](const QModelIndex& index, const QString& name) { previewName(idOf(index), name); });
    connect(delegate, &EntriesDelegate::typingEnded, this, [this] { m_typing.cancel(); });
    connect(m_model, &EntriesModel::refused, this, &EntriesPanel::message);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &EntriesPanel::makeCurrent);
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &EntriesPanel::updateActions);
    connect(m_list, &EntriesList::entriesDropped, this, &EntriesPanel::moveEntries);
    connect(m_list, &EntriesList::dataDropped, this, [this](const QMimeData& mimeData, EntryId before) {
        // Runs after the drop: questions may follow, and the source of the drag waits.
        QMetaObject::invokeMethod(
            this,
            [this, text = entriesTextIn(mimeData), after = idInFrontOf(m_document->file(), before)] {
                insertFrom(text, after);
            },
            Qt::QueuedConnection);
    });
    connect(m_list, &QWidget::customContextMenuRequested, this, &EntriesPanel::showContextMenu);
}

void EntriesPanel::createActions() {
    m_add = createAction(tr("&Add Entry"), tr("Add a Sierpiński triangle as a new entry."),
                         QStringLiteral("add"), {}, &EntriesPanel::addEntry);
    m_duplicate =
        createAction(tr("D&uplicate"), tr("Add a copy of each selected entry."), QStringLiteral("duplicate"),
                     {Qt::Key_Insert}, &EntriesPanel::duplicateSelected);
    m_remove = createAction(tr("De&lete"), tr("Delete the selected entries from the file."),
                            QStringLiteral("remove"), {QKeySequence::Delete}, &EntriesPanel::removeSelected);
    m_rename = createAction(tr("Re&name"), tr("Give the entry another name."), QStringLiteral("edit"),
                            {Qt::Key_F2}, &EntriesPanel::renameCurrent);
    m_comment = createAction(tr("Edit &Comment…"), tr("Edit the comment of the entry."),
                             QStringLiteral("note"), {}, &EntriesPanel::editComment);
    m_up = createAction(tr("Move &Up"), tr("Move the selected entries towards the top of the file."),
                        QStringLiteral("up"), {Qt::ALT | Qt::Key_Up}, &EntriesPanel::moveUp);
    m_down = createAction(tr("Move &Down"), tr("Move the selected entries towards the end of the file."),
                          QStringLiteral("down"), {Qt::ALT | Qt::Key_Down}, &EntriesPanel::moveDown);
    m_cut = createAction(tr("Cu&t"), tr("Move the selected entries to the clipboard."), QStringLiteral("cut"),
                         QKeySequence::keyBindings(QKeySequence::Cut), &EntriesPanel::cutSelected);
    m_copy = createAction(tr("&Copy"), tr("Copy the selected entries as .ifs text."), QStringLiteral("copy"),
                          QKeySequence::keyBindings(QKeySequence::Copy), &EntriesPanel::copySelected);
    m_paste = createAction(tr("&Paste"), tr("Paste entries from .ifs text after the current entry."),
                           QStringLiteral("paste"), QKeySequence::keyBindings(QKeySequence::Paste),
                           &EntriesPanel::paste);
    new FocusShortcuts(m_list);
}

QAction* EntriesPanel::createAction(const QString& text, const QString& statusTip, const QString& iconName,
                                    const QList<QKeySequence>& keys, Slot slot) {
    auto* action = new QAction(text, this);
    action->setStatusTip(statusTip);
    if (!iconName.isEmpty()) action->setIcon(icon(iconName));
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    const QString shortcut = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(shortcut.isEmpty() ? statusTip : QStringLiteral("%1 (%2)").arg(statusTip, shortcut));
    connect(action, &QAction::triggered, this, slot);
    m_list->addAction(action);
    return action;
}

void EntriesPanel::showContextMenu(const QPoint& position) {
    QMenu menu(this);
    menu.addActions({m_rename, m_comment, m_duplicate, m_remove});
    menu.addSeparator();
    menu.addActions({m_cut, m_copy, m_paste});
    menu.addSeparator();
    menu.addActions({m_up, m_down});
    menu.addSeparator();
    menu.addAction(m_add);
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

void EntriesPanel::addEntry() {
    Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(document::sierpinskiTriangle());
    if (insertEntries({entry}, m_document->currentId(), tr("Add an entry")).isEmpty()) return;
    m_list->setFocus();
    renameCurrent(); // at once: letters typed now are its name
}

void EntriesPanel::removeSelected() {
    const QList<EntryId> ids = m_list->selectedIds();
    if (ids.isEmpty()) return;
    const QList<Entry> entries = entriesOf(ids);
    const QString text = ids.size() == 1 ? tr("Delete %1").arg(quotedName(entries.front()))
                                         : tr("Delete %n entries", nullptr, static_cast<int>(ids.size()));
    m_document->editFile(text, removed(m_document->file(), ids));
}

void EntriesPanel::duplicateSelected() {
    const QList<EntryId> selected = m_list->selectedIds();
    QList<Entry> copies = entriesOf(selected);
    copies.removeIf([](const Entry& entry) { return !isReadable(entry); });
    if (copies.isEmpty()) {
        emit message(
            tr("An entry that could not be read cannot be duplicated: the copy would have the same name."));
        return;
    }
    const QString text = copies.size() == 1
                             ? tr("Duplicate %1").arg(quotedName(copies.front()))
                             : tr("Duplicate %n entries", nullptr, static_cast<int>(copies.size()));
    for (Entry& copy : copies) {
        copy.source.reset();
        copy.problems.clear();
    }
    insertEntries(copies, selected.last(), text);
}

void EntriesPanel::renameCurrent() {
    if (m_list->isEditing()) return; // such as by a double click on the button
    if (m_list->currentIndex().flags() & Qt::ItemIsEditable) m_list->edit(m_list->currentIndex());
}

void EntriesPanel::previewName(EntryId id, const QString& name) {
    if (m_document->currentId() != id) return;
    m_typing.preview(EntriesModel::tr("Rename “%1” to “%2”").arg(m_typing.before().name, name),
                     [&name](document::Fractal& fractal) { fractal.name = name; });
}

void EntriesPanel::editComment() {
    const EntryId id = m_document->currentId();
    const QList<Entry> entries = entriesOf({id});
    if (entries.isEmpty() || !isReadable(entries.front())) return;
    auto* dialog = new EntriesCommentDialog(*entries.front().fractal, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const QString text = tr("Edit the comment of %1").arg(quotedName(entries.front()));
    connect(dialog, &EntriesCommentDialog::edited, this, [this, dialog, id, text] {
        if (m_document->currentId() != id) return;
        m_typing.preview(text, [dialog](document::Fractal& fractal) { fractal = dialog->fractal(); });
    });
    connect(dialog, &QDialog::accepted, this, [this, dialog, id, text] {
        m_typing.cancel();
        m_document->editFile(text, replaced(m_document->file(), id, dialog->fractal()));
    });
    connect(dialog, &QDialog::rejected, this, [this] { m_typing.cancel(); });
    dialog->open();
}

void EntriesPanel::moveUp() {
    const QList<EntryId> ids = m_list->selectedIds();
    if (ids.isEmpty()) return;
    const int row = m_filtered->mapFromSource(m_model->indexOf(ids.first())).row();
    if (row > 0)
        moveEntries(ids,
                    static_cast<EntryId>(m_filtered->index(row - 1, 0).data(EntriesModel::IdRole).toUInt()));
}

void EntriesPanel::moveDown() {
    const QList<EntryId> ids = m_list->selectedIds();
    if (ids.isEmpty()) return;
    const int row = m_filtered->mapFromSource(m_model->indexOf(ids.last())).row();
    if (row + 1 >= m_filtered->rowCount()) return;
    const auto below =
        static_cast<EntryId>(m_filtered->index(row + 1, 0).data(EntriesModel::IdRole).toUInt());
    moveEntries(ids, idBehind(m_document->file(), below));
}

void EntriesPanel::cutSelected() {
    const QList<EntryId> ids = m_list->selectedIds();
    if (ids.isEmpty()) return;
    copySelected();
    const QString text = ids.size() == 1 ? tr("Cut %1").arg(quotedName(entriesOf(ids).front()))
                                         : tr("Cut %n entries", nullptr, static_cast<int>(ids.size()));
    m_document->editFile(text, removed(m_document->file(), ids));
}

void EntriesPanel::copySelected() {
    const QList<EntryId> ids = m_list->selectedIds();
    if (!ids.isEmpty()) QGuiApplication::clipboard()->setMimeData(entriesMimeData(entriesOf(ids)).release());
}

void EntriesPanel::paste() {
    const QMimeData* mimeData = QGuiApplication::clipboard()->mimeData();
    if (mimeData && holdsText(*mimeData))
        insertFrom(entriesTextIn(*mimeData), m_document->currentId());
    else
        emit message(tr("Nothing was pasted: there is no text on the clipboard."));
}

QList<Entry> EntriesPanel::entriesOf(const QList<EntryId>& ids) const {
    QList<EntryId> wanted = ids;
    std::sort(wanted.begin(), wanted.end()); // faster than a set for many entries
    QList<Entry> entries;
    entries.reserve(ids.size());
    for (const Entry& entry : m_document->file().entries)
        if (std::binary_search(wanted.cbegin(), wanted.cend(), entry.id)) entries.append(entry);
    return entries;
}

QList<EntryId> EntriesPanel::insertEntries(const QList<Entry>& entries, EntryId after, const QString& text) {
    document::Inserted result;
    const auto before = m_document->revision();
    if (m_document->file().entries.size() + entries.size() > maxAtOnce) {
        auto inserting = io::inBackground<document::Inserted>(
            [file = m_document->file(), entries, after](QPromise<document::Inserted>& promise) {
                promise.addResult(insertedTogether(file, entries, after));
            });
        if (!waitFor(QFuture<void>(inserting), tr("Adding entries…"), this)) return {};
        result = inserting.takeResult();
    }
    if (result.ids.isEmpty() || m_document->revision() != before) // the document was edited meanwhile
        result = insertedTogether(m_document->file(), entries, after);
    m_document->editFile(text, result.file, result.ids.front());
    const QString name = m_model->indexOf(result.ids.front()).data().toString();
    if (!name.contains(m_filter->text().trimmed(), Qt::CaseInsensitive)) m_filter->clear();
    m_list->select(result.ids);
    return result.ids;
}

void EntriesPanel::insertFrom(const std::function<QByteArray()>& text, EntryId after) {
    auto finding = io::inBackground<FoundEntries>(
        [text](QPromise<FoundEntries>& promise) { promise.addResult(entriesIn(text())); });
    if (!waitFor(QFuture<void>(finding), tr("Reading the pasted text…"), this)) return;
    FoundEntries found = finding.takeResult();
    if (found.entries.isEmpty()) {
        const QString why =
            found.problems.isEmpty() ? QString() : QLatin1Char(' ') + found.problems.front().message;
        emit message(tr("The pasted text contains no entry of an .ifs file.") + why);
        return;
    }
    const auto count = static_cast<int>(found.entries.size());
    const QList<EntryId> ids =
        insertEntries(found.entries, after,
                      count == 1 ? tr("Paste %1").arg(quotedName(found.entries.front()))
                                 : tr("Paste %n entries", nullptr, count));
    if (ids.isEmpty()) return;
    const auto unreadable = std::count_if(found.entries.cbegin(), found.entries.cend(),
                                          [](const Entry& entry) { return !isReadable(entry); });
    io::freeInBackground(std::exchange(found.entries, {}));
    if (unreadable > 0)
        emit message(tr("%n pasted entries could not be read; their text is kept unchanged.", nullptr,
                        static_cast<int>(unreadable)));
    if (found.areFlames) emit flamesPasted(ids);
    if (!found.table.isEmpty()) PasteTableDialog::askForColumns(m_document, found.table, this);
}

void EntriesPanel::moveEntries(const QList<EntryId>& ids, EntryId before) {
    const QList<Entry> entries = entriesOf(ids);
    if (entries.isEmpty()) return;
    const QString text = ids.size() == 1 ? tr("Move %1").arg(quotedName(entries.front()))
                                         : tr("Move %n entries", nullptr, static_cast<int>(ids.size()));
    m_document->editFile(text, moved(m_document->file(), ids, before));
    m_list->select(ids);
    m_list->scrollTo(m_list->currentIndex());
}

void EntriesPanel::filter(const QString& text) {
    {
        const QScopedValueRollback<bool> guard(m_filtering, true);
        m_filtered->setText(text.trimmed());
    }
    m_list->setEmptyText(
        text.isEmpty() ? tr("This file contains no entries. Add one, or paste the text of an .ifs file.")
                       : tr("No entry name contains “%1”.").arg(text.trimmed()));
    showCurrent();
}

// The row of the document's current entry; a selection that contains it stays.
void EntriesPanel::showCurrent() {
    const QScopedValueRollback<bool> guard(m_filtering, true);
    m_filtered->setShown(m_document->currentId());
    const QModelIndex row = m_filtered->mapFromSource(m_model->indexOf(m_document->currentId()));
    QItemSelectionModel* selection = m_list->selectionModel();
    if (!row.isValid())
        selection->clear();
    else if (!selection->isSelected(row))
        selection->setCurrentIndex(row, QItemSelectionModel::ClearAndSelect);
    else if (selection->currentIndex() != row)
        selection->setCurrentIndex(row, QItemSelectionModel::NoUpdate);
    updateActions();
}

void EntriesPanel::makeCurrent(const QModelIndex& index) {
    if (!m_filtering && !m_model->isSyncing() && index.isValid())
        m_document->setCurrent(static_cast<EntryId>(index.data(EntriesModel::IdRole).toUInt()));
}

void EntriesPanel::updateActions() {
    const bool any = m_list->selectionModel()->hasSelection();
    const bool editable = m_list->currentIndex().flags() & Qt::ItemIsEditable;
    for (QAction* action : {m_remove, m_duplicate, m_cut, m_copy, m_up, m_down})
        action->setEnabled(any);
    m_rename->setEnabled(editable);
    m_comment->setEnabled(editable);
}

void EntriesPanel::updateThumbnailSize() {
    m_thumbnails->setSize(EntriesDelegate::pictureSide, devicePixelRatioF());
    m_list->viewport()->update();
}

bool EntriesPanel::event(QEvent* event) {
    if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal) updateThumbnailSize();
    return QWidget::event(event);
}

} // namespace view
