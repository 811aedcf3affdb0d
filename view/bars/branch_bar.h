// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_view.h"
#include "document/edits/live_edit.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;
class QStackedWidget;

namespace view {

class ElidedLabel;
class SpaceView;

// The options of the tools that take maps and branches: how deep a branch is and what changing
// it changes, and a slider that lets the selected maps swing about their roots.
class BranchBar : public QWidget {
    Q_OBJECT

public:
    BranchBar(document::Document* document, CanvasView* canvas, QWidget* parent = nullptr);

    // The window into space, whose selected maps swing about the line of sight; `hint` is shown beside it.
    void setSpace(SpaceView* space, const QString& hint);
    // Adds a second canvas. The bar speaks of the branch that was selected last.
    void setBeside(CanvasView* canvas);

    QSpinBox* depth() const { return m_depth; }
    QComboBox* edit() const { return m_edit; }
    QPushButton* putBackButton() const { return m_putBack; } // enabled while a branch is moved
    QSlider* swing() const { return m_swing; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeBranch();
    QWidget* makeSwing();
    void follow();
    void followChoice(CanvasView* canvas);
    // Passes the focus of a part that will be hidden or disabled to the canvas.
    void takeFocusFrom(const QWidget* part);
    void showRow(QWidget* row);
    CanvasView& chosenIn() const { return m_chosenIn ? *m_chosenIn : *m_canvas; }
    BranchChoice& choice() const;
    void putBack(); // restores the branch, if it is moved; else all branches
    using Swung = std::function<document::Fractal(double)>; // argument: angle in radians
    Swung swungInPlane();                                   // nullptr, with a message, if nothing can swing
    Swung swungInSpace();
    double shareToShow(const Swung& shareOf); // largest share that leaves an attractor
    void swingTo(int degrees);
    void endSwing();
    void giveUpSwing(); // ends the swing and ignores the slider until it is released
    void centre();

    document::Document* m_document;
    CanvasView* m_canvas;
    QPointer<CanvasView> m_chosenIn; // canvas of the latest selection
    ifs::Word m_seen;                // branch selected in the window's canvas
    ifs::Word m_seenBeside;          // branch selected in the second canvas
    QStackedWidget* m_rows = nullptr;
    QWidget* m_branchRow = nullptr;
    QWidget* m_swingRow = nullptr;
    QSpinBox* m_depth = nullptr;
    QLabel* m_address = nullptr;
    QComboBox* m_edit = nullptr;
    QPushButton* m_putBack = nullptr;
    QSlider* m_swing = nullptr;
    QLabel* m_angle = nullptr;
    ElidedLabel* m_swingHint = nullptr;
    QString m_hintInSpace;
    SpaceView* m_space = nullptr;
    document::LiveEdit m_swinging;
    QTimer m_pause;           // ends a swing by keyboard
    bool m_isGivenUp = false; // true while the slider is still held after giveUpSwing()
};

} // namespace view
