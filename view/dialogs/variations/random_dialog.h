// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/variations/random_systems.h"

#include <QDialog>
#include <QTimer>

class QComboBox;
class QGridLayout;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace view {

class SheetMaker;

// A sheet of systems made by chance, with as many maps and the symmetry that are asked for. The one picked is
// added to the file, in one step of the history.
class RandomDialog : public QDialog {
    Q_OBJECT

public:
    static constexpr int count = 12;

    explicit RandomDialog(document::Document* document, QWidget* parent = nullptr);
    ~RandomDialog() override;

    void accept() override; // adds the chosen fractal

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void createGrid();
    void createControls(QGridLayout* layout);
    void addSeed(QGridLayout* layout);
    document::RandomChoice choice() const;

    void chooseDimension();
    void chooseSymmetry();
    void makeSheet(); // starts the sheet of the seed in the background
    void showPicture(int index);
    void fitTiles();    // fits the tiles to the available room
    void redraw();      // redraws in the present size
    int chosen() const; // −1: none

    document::Document* m_document;
    SheetMaker* m_sheet;
    QTimer m_resized;
    QListWidget* m_grid;
    QComboBox* m_dimension;
    QComboBox* m_maps;
    QComboBox* m_groups;
    QSpinBox* m_order;
    QSpinBox* m_seed;
    QPushButton* m_add = nullptr;
};

} // namespace view
