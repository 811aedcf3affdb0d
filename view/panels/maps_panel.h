// SPDX-License-Identifier: MIT
#pragma once

#include "panels/maps_edits.h"
#include "panels/maps_model.h"

#include <QWidget>

#include <map>
#include <utility>

class QAction;
class QLabel;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace view {

class MapShapeEditor;
class MapsRowHeader;

// The table of maps with everything that is done to it, and below it the selected map as rotation, scale and
// shear.
class MapsPanel : public QWidget {
    Q_OBJECT

public:
    explicit MapsPanel(document::Document* document, QWidget* parent = nullptr);

    QTableView* table() const { return m_table; }
    MapsModel* model() const { return m_model; }
    std::vector<ifs::MapId> selectedMaps() const;
    void selectMaps(const std::vector<ifs::MapId>& ids);

    void addMap();
    void duplicateMaps();
    void deleteMaps();
    void moveMapsUp();
    void moveMapsDown();
    void copyMaps() const;
    void pasteMaps(); // in place of the selected rows
    void appendPasted();
    void applyWeights(WeightRule rule);
    void bake();

    enum class Columns { Code, Facts, Effective };
    void showColumns(Columns group, bool shown);
    void reveal(int column); // in sight, with the others of its group where it was hidden

signals:
    void message(const QString& text); // a sentence for the status bar
    void selectionChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction* action(const QString& text, const QString& icon, const QString& shortcut, const QString& tip,
                    void (MapsPanel::*slot)());
    QToolButton* button(QAction* action);
    void makeActions();
    QWidget* makeEditBar();
    QWidget* makeColumnBar();
    QWidget* makeTable();
    QWidget* makeNotice();
    QToolButton* columnToggle(const QString& text, const QString& tip, Columns group, bool shown);
    static std::pair<int, int> columnsOf(Columns group); // the first and the last one
    QToolButton* weightsButton();

    void follow(const document::Change& change);
    void updateActions();
    void updateNotice();
    void fitColumns();
    void widenColumns();
    int widthOf(int column) const;
    void applyEdit(const QString& text, MapsEdit edit);
    void paste(const Rows& rows);
    void sayPasted(const Rows& rows, int count, const QString& remark = {});
    void moveRowTo(int from, int to);
    void moveSelection(int before);
    void chooseColour(const QModelIndex& index);
    Rows selectedRows() const;
    Rows rowsOf(const std::vector<ifs::MapId>& ids) const;
    void keepSelection();
    void restoreSelection();
    void selectRows(Rows rows); // the first becomes the current one

    document::Document* m_document;
    MapsModel* m_model;
    QTableView* m_table;
    MapsRowHeader* m_rowHeader;
    MapShapeEditor* m_shape;
    QStackedWidget* m_pages;
    QWidget* m_bars;
    QLabel* m_notice;
    QToolButton* m_noticeAdd;
    QAction* m_add;
    QAction* m_duplicate;
    QAction* m_delete;
    QAction* m_up;
    QAction* m_down;
    QAction* m_copy;
    QAction* m_paste;
    QAction* m_append;
    QAction* m_bake;
    QList<QAction*> m_weightActions;
    std::map<Columns, QToolButton*> m_columnToggles;
    std::vector<ifs::MapId> m_kept; // selected before the model was reset
    int m_keptColumn = MapsModel::A;
    bool m_hasFitColumns = false;
};

} // namespace view
