// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/maps/maps_edits.h"
#include "panels/maps/maps_model.h"

#include <QWidget>

#include <map>
#include <optional>
#include <utility>

class QAction;
class QLabel;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace view {

class BackgroundEdit;
class MapShapeEditor;
class MapThumbnails;
class MapsClipboard;
class MapsColumns;
class MapsRowHeader;
class MapsTable;
class SoloMap;

// The table of maps, of the plane or of space, with everything that is done to it, and below it the selected
// map as rotation, scale and shear.
class MapsPanel : public QWidget {
    Q_OBJECT

public:
    explicit MapsPanel(document::Document* document, QWidget* parent = nullptr);
    ~MapsPanel() override;

    QTableView* table() const;
    MapsModel* model() const { return m_model; }
    std::vector<ifs::MapId> selectedMaps() const;
    void selectMaps(const std::vector<ifs::MapId>& ids);

    void addMap();
    void duplicateMaps();
    void deleteMaps();
    void selectAllMaps();
    void renameMap(); // opens an editor for the name of the current map in the table
    void toggleLock();
    void toggleSolo();
    void moveMapsUp();
    void moveMapsDown();
    void cutMaps();
    void copyMaps() const;
    void pasteMaps(); // replaces the selected rows
    void appendPasted();
    void applyWeights(document::WeightRule rule);
    void bake();

    enum class Columns { Names, Code, Facts, Effective };
    void showColumns(Columns group, bool shown);
    void reveal(int column); // scrolls to the column and shows its group if hidden

signals:
    void message(const QString& text); // a sentence for the status bar
    void symmetryChosen();             // sent because the size of the attractor may have changed
    void selectionChanged();
    void mapPointed(ifs::MapId id);  // map at its row; None: none
    void soloChanged(ifs::MapId id); // map to show alone; None: all maps

private:
    QAction* action(const QString& text, const QString& icon, const QString& shortcut, const QString& tip,
                    void (MapsPanel::*slot)());
    QToolButton* button(QAction* action);
    void makeActions();
    void makeLayerActions();
    void showMenu(const QPoint& position);
    void followNames(const document::Change& change);
    QWidget* makeEditBar();
    QWidget* makeColumnBar();
    QWidget* makeTable();
    QWidget* makeNotice();
    QToolButton* columnToggle(const QString& text, const QString& tip, Columns group, bool shown);
    std::pair<int, int> columnsOf(Columns group) const; // first and last column of the group

    void follow(const document::Change& change);
    void hideColumns(Columns group, bool hidden);
    void updateActions();
    void updateNotice();
    void showDetails();
    void applyEdit(const QString& text, document::MapsEdit edit);
    void moveRowTo(int from, int to);
    void moveSelection(int before);
    void chooseColour(const QModelIndex& index);
    document::Rows selectedRows() const;
    void keepSelection();
    void restoreSelection();
    void followDimension();
    void selectRows(document::Rows rows); // makes the first row the current one

    document::Document* m_document;
    BackgroundEdit* m_weighing; // weights by dimension, which may take long
    MapsModel* m_model;
    MapsClipboard* m_clipboard;
    SoloMap* m_solo;
    MapThumbnails* m_thumbnails;
    MapsTable* m_table;
    MapsColumns* m_columns = nullptr;
    MapsRowHeader* m_rowHeader;
    QLabel* m_facts = nullptr; // facts about the current map
    MapShapeEditor* m_shape;
    QStackedWidget* m_pages;
    QWidget* m_bars;
    QLabel* m_notice;
    QToolButton* m_noticeAdd;
    QAction* m_add;
    QAction* m_duplicate;
    QAction* m_delete;
    QAction* m_rename;
    QAction* m_lock;
    QAction* m_alone;
    QAction* m_up;
    QAction* m_down;
    QAction* m_cut;
    QAction* m_copy;
    QAction* m_paste;
    QAction* m_append;
    QAction* m_bake;
    QList<QAction*> m_weightActions;
    std::map<Columns, QToolButton*> m_columnToggles;
    mutable std::optional<document::Rows> m_selectedRows; // cleared when the selection changes
    std::vector<ifs::MapId> m_kept;                       // selection before a reset of the model
    int m_keptColumn = MapsModel::A;
    int m_dimension = 0; // dimension of the maps that the columns are made for
};

} // namespace view
