// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"
#include "canvas/canvas_view.h"
#include "document/fractal.h"

#include <QWidget>

class QLabel;

// One quiet line: where the pointer is, whether there is an attractor, what was drawn.
class StatusLine : public QWidget {
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
};
