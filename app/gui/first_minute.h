// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/moment.h"
#include "document/document.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>

class FirstChips;
class QAction;
class QMainWindow;
namespace view {
class CanvasView;
class RenderBridge;
} // namespace view

// Introduction for a user who has never dragged anything: the first picture sways for two seconds and rests,
// a few words say what to do, and after the first drag three buttons say what to try next. The document knows
// nothing of the breeze.
class FirstMinute : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow* window;
        document::Document* document;
        view::CanvasView* canvas;
        view::RenderBridge* render;
        QAction* sway;
        QAction* variations;
        QAction* poster;
    };
    FirstMinute(const Parts& parts, QObject* parent);

    static bool isOver(); // true once the user has dragged a corner, in any run

    void invite(); // shows what to do
    void sway();   // sways the picture, then invites; with reduced motion, invites at once
    bool isSwaying() const { return m_tick.isActive(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void blow();
    void rest();
    void follow(const document::Change& change);
    void showChips();

    Parts m_parts;
    QTimer m_tick;
    QElapsedTimer m_clock;
    std::shared_ptr<const document::Fractal> m_windy; // picture as the sway shows it
    bool m_isDragging = false;
    QPointer<FirstChips> m_chips;
};
