// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "widgets/thumbnails.h"

#include <QDialog>
#include <QFutureWatcher>

#include <vector>

class QListWidget;
class QPushButton;
class QSlider;
class QSpinBox;

namespace view {

// A sheet of variations of the current fractal, or of systems made by chance, to pick one from. What is
// picked is one step of the history.
class MutateDialog : public QDialog {
    Q_OBJECT

public:
    enum class Source {
        Current, // variations of the current entry, which the one picked replaces
        Chance,  // the one picked is added to the file
    };
    static constexpr int count = 12;

    MutateDialog(document::Document* document, Source source, QWidget* parent = nullptr);
    ~MutateDialog() override;

    void accept() override; // makes the chosen one the document's

private:
    using FractalPointer = Thumbnails::FractalPointer;

    void createControls();
    void makeAll(); // from the seed, beside the window
    void take(int index);
    void varyChosen();
    void showPicture(int index);
    int chosen() const; // −1: none
    void updateButtons();

    document::Document* m_document;
    const Source m_source;
    FractalPointer m_parent; // that is varied
    std::vector<FractalPointer> m_fractals;
    QFutureWatcher<FractalPointer> m_making;
    Thumbnails* m_thumbnails;
    QListWidget* m_grid = nullptr;
    QSlider* m_strength = nullptr;
    QSpinBox* m_seed = nullptr;
    QPushButton* m_use = nullptr;
    QPushButton* m_vary = nullptr;
};

} // namespace view
