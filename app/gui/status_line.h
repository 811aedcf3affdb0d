// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"
#include "canvas/canvas_view.h"
#include "document/fractal.h"

#include <QDeadlineTimer>
#include <QStatusBar>

class QLabel;

// One quiet line: where the pointer is or what was just said, whether there is an attractor, what was drawn.
class StatusLine : public QStatusBar {
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);

    void showPointer(const view::PointerPosition& position);
    void clearPointer();
    void showVerdict(const document::Fractal& fractal);
    void showFrame(const attractor::Frame& frame);

private:
    QLabel* m_pointer;
    QLabel* m_verdict;
    QLabel* m_frame;
    QDeadlineTimer m_toRead; // what was said last
};
