// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/timeline/morph_edits.h"
#include "widgets/thumbnails.h"

#include <QDialog>
#include <QFutureWatcher>

class QComboBox;
class QLabel;
class QPushButton;

namespace view {

class MorphLines;

// Asks what the current fractal becomes, and shows which map becomes which, with some moments of the morph
// below. Pairs can be pinned; each pin solves the transport anew, in the background.
class MorphDialog : public QDialog {
    Q_OBJECT

public:
    MorphDialog(const document::Document& document, int length, QWidget* parent = nullptr);
    ~MorphDialog() override;

    MorphLines* lines() const { return m_lines; }
    QComboBox* target() const { return m_target; }
    bool isSolved() const { return m_outcome.fractal.has_value(); }
    const document::Fractal& morph() const { return *m_outcome.fractal; } // requires a solution
    QString targetName() const;

private:
    using FractalPointer = Thumbnails::FractalPointer;

    void createControls();
    void createMoments();
    FractalPointer chosenFractal() const; // null: empty list
    void takeTarget();
    void solve();
    void takeOutcome();
    void showMoments();

    const FractalPointer m_from;
    const int m_length;
    QFutureWatcher<document::MorphOutcome> m_solving;
    document::MorphOutcome m_outcome;
    std::vector<FractalPointer> m_moments;
    Thumbnails* m_thumbnails;
    quint64 m_solved = 0; // number of solutions, part of the keys of the pictures
    QComboBox* m_target = nullptr;
    MorphLines* m_lines = nullptr;
    QLabel* m_sentence = nullptr;
    std::vector<QLabel*> m_pictures;
    QPushButton* m_add = nullptr;
    QPushButton* m_clear = nullptr;
};

// Why there is no morph.
QString morphObstacle(document::MorphFlaw flaw);

} // namespace view
