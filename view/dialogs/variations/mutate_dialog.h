// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/variations/variation_ring.h"
#include "document/document.h"
#include "document/variations/variations.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;
class QSpinBox;

namespace view {

class SheetMaker;

// Breeds the current fractal: its variations are around it, and the one that is chosen takes its place in the
// middle, with variations of its own. The line of descent leads back. What is in the middle at the end
// becomes the entry, in one step of the history.
class MutateDialog : public QDialog {
    Q_OBJECT

public:
    static constexpr int count = VariationRing::count;

    using FractalPointer = Thumbnails::FractalPointer;
    struct Generation {
        FractalPointer fractal;
        int seed = 1; // seed of its last sheet
        QPixmap seen; // picture of any size
    };
    struct Descent {
        std::vector<Generation> line; // entry first
        int middle = 0;
    };

    explicit MutateDialog(document::Document* document, QWidget* parent = nullptr);
    // Goes on with a descent that was left, if it is that of the entry as it is now.
    MutateDialog(document::Document* document, QWidget* parent, const Descent& left);
    ~MutateDialog() override;

    void accept() override; // makes the fractal in the middle the document's
    Descent descent() const { return {m_line, m_generation}; }

private:
    QLayout* createLine();
    QLayout* createControls();
    void addChanges(QFormLayout* form);
    void addPartners(QFormLayout* form);
    void addSeed(QFormLayout* form);
    document::Mutation mutation() const;

    void makeSheet(); // starts the sheet of the seed in the background
    void take(int child);
    void goTo(int generation);
    void startFrom(const Descent& left);
    void addToLine(int generation);
    void showChild(int child);
    void showParent();
    void showPartner();
    void showLine(quint64 key);
    void redraw(); // redraws in the present size
    void follow(); // updates buttons and the hint
    const FractalPointer& middle() const { return m_line[std::size_t(m_generation)].fractal; }

    document::Document* m_document;
    std::vector<Generation> m_line; // entry first
    int m_generation = 0;           // index of the generation in the middle
    SheetMaker* m_sheet;
    Thumbnails* m_large; // pictures of the middle
    Thumbnails* m_small; // pictures of the line and the partner
    QTimer m_resized;
    VariationRing* m_ring;
    QListWidget* m_descent = nullptr;
    QCheckBox* m_shape = nullptr;
    QCheckBox* m_colours = nullptr;
    QCheckBox* m_weights = nullptr;
    QSlider* m_strength = nullptr;
    QComboBox* m_partner = nullptr;
    QLabel* m_partnerPicture = nullptr;
    QSpinBox* m_seed = nullptr;
    QLabel* m_hint = nullptr;
    QPushButton* m_use = nullptr;
};

} // namespace view
