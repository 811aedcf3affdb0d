// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QDialog>
#include <QStringList>

class QCheckBox;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;
class QStandardItemModel;
class QToolButton;

namespace view {

class AppearanceSlider;
class PaletteFilter;

// The palettes that come with the program, to search and to try on the fractal; the selected one can be
// turned to other hues, shifted and reversed. Favourites are remembered in the settings.
class PaletteBrowser : public QDialog {
    Q_OBJECT

public:
    explicit PaletteBrowser(const attractor::Palette& present, QWidget* parent = nullptr);

    QLineEdit* search() const { return m_search; }
    QListView* list() const { return m_list; }
    QCheckBox* onlyFavourites() const { return m_onlyFavourites; }
    QToolButton* favourite() const { return m_favourite; }
    AppearanceSlider* hue() const { return m_hue.slider; }
    AppearanceSlider* shift() const { return m_shift.slider; }
    QCheckBox* reversed() const { return m_reversed; }

    bool hasChosen() const; // true if a palette of the list is selected
    attractor::Palette palette() const;
    QString title() const; // title of the selected row

signals:
    void tried(); // sent when palette() has changed

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    void createList();
    QLayout* createSearchRow();
    QLayout* createAdjustments();
    // A number that `slider` changes.
    struct Adjustment {
        AppearanceSlider* slider = nullptr;
        double value = 0;
        double kept = 0; // value that Esc in the field restores
    };
    void createSlider(Adjustment& adjustment, const QString& name, double min, double max);
    void showFavourite(int row); // row of the model
    void setFavourite(bool isFavourite);
    void chooseFound();
    void choose();
    void adjust();
    void paintPreview();
    int chosen() const; // row of the model; −1: none

    attractor::Palette m_present; // palette until one is selected
    std::vector<attractor::Palette> m_palettes;
    QStringList m_favourites; // English names
    QStandardItemModel* m_model;
    PaletteFilter* m_filtered;
    QLineEdit* m_search;
    QCheckBox* m_onlyFavourites;
    QListView* m_list;
    QLabel* m_whyEmpty;
    QLabel* m_preview;
    QToolButton* m_favourite;
    Adjustment m_hue;   // degrees
    Adjustment m_shift; // share of the length of the palette
    QCheckBox* m_reversed;
    QPushButton* m_use;
};

} // namespace view
