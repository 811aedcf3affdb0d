// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "panels/collection/collection_filter.h"

#include <QDialog>
#include <QPersistentModelIndex>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QToolButton;

namespace view {

class CollectionGrid;
class CollectionModel;
class CollectionPictures;
class MovingPicture;
class Thumbnails;

// The collection over the whole window, in large pictures, by theme. Entries with an animation move under the
// pointer, and when they are selected.
class CollectionWindow : public QDialog {
    Q_OBJECT

public:
    static constexpr int pictureSide = 168; // device-independent pixels

    CollectionWindow(CollectionModel* collection, QWidget* parent);
    ~CollectionWindow() override;

signals:
    // The fractal, and behind it the partner of its fractal transformation.
    void chosen(const QList<document::Fractal>& fractals);
    void addRequested(const QList<document::Fractal>& fractals); // for the open file

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* createThemes();
    QWidget* createFoot();
    QWidget* createButtons();
    void fillThemes();
    void showPart();
    void search(const QString& words);
    void updateCurrent();
    void play(const QModelIndex& index); // index in the grid
    void use(void (CollectionWindow::*used)(const QList<document::Fractal>&));

    CollectionModel* m_collection;
    Thumbnails* m_thumbnails;
    CollectionPictures* m_pictures;
    CollectionGrid* m_grid;
    MovingPicture* m_moving;
    QPersistentModelIndex m_played;
    QLineEdit* m_search;
    QListWidget* m_themes = nullptr;
    QLabel* m_about = nullptr;
    QToolButton* m_favourite = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_add = nullptr;
};

} // namespace view
