// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/live_edit.h"

#include <QWidget>

#include <functional>

class QAction;
class QLineEdit;

namespace view {

class EntriesFilter;
class EntriesList;
class EntriesModel;
class Thumbnails;

// The entries of the open file: choose, add, remove, rename, reorder, duplicate, comment, copy and paste.
// Every edit is one step of the history.
class EntriesPanel : public QWidget {
    Q_OBJECT

public:
    explicit EntriesPanel(document::Document* document, QWidget* parent = nullptr);
    ~EntriesPanel() override;

public slots:
    void addEntry(); // adds a Sierpiński triangle behind the current entry
    void removeSelected();
    void duplicateSelected();
    void renameCurrent();
    void editComment();
    void moveUp();
    void moveDown();
    void cutSelected();
    void copySelected();
    void paste();

signals:
    void message(const QString& text); // whole sentence for the user
    void flamesPasted(const QList<document::EntryId>& ids);

protected:
    bool event(QEvent* event) override;

private:
    using Slot = void (EntriesPanel::*)();

    void createList();
    void createActions();
    void previewName(document::EntryId id, const QString& name);
    QAction* createAction(const QString& text, const QString& statusTip, const QString& iconName,
                          const QList<QKeySequence>& keys, Slot slot);
    void showContextMenu(const QPoint& position);
    void updateActions();
    void updateThumbnailSize();
    void filter(const QString& text);
    void showCurrent();
    void makeCurrent(const QModelIndex& index);

    QList<document::Entry> entriesOf(const QList<document::EntryId>& ids) const;
    // Returns the ids of the new entries.
    QList<document::EntryId> insertEntries(const QList<document::Entry>& entries, document::EntryId after,
                                           const QString& text);
    void insertFrom(const std::function<QByteArray()>& text, document::EntryId after);
    void moveEntries(const QList<document::EntryId>& ids, document::EntryId before);

    document::Document* m_document;
    Thumbnails* m_thumbnails;
    EntriesModel* m_model;
    EntriesFilter* m_filtered;
    QLineEdit* m_filter;
    EntriesList* m_list;
    bool m_filtering = false;
    document::LiveEdit m_typing; // unfinished name or comment, kept for recovery

    QAction* m_add = nullptr;
    QAction* m_duplicate = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_rename = nullptr;
    QAction* m_comment = nullptr;
    QAction* m_up = nullptr;
    QAction* m_down = nullptr;
    QAction* m_cut = nullptr;
    QAction* m_copy = nullptr;
    QAction* m_paste = nullptr;
};

} // namespace view
