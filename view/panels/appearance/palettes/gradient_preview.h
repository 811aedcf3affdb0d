// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QComboBox>
#include <QPixmap>

#include <vector>

namespace view {

// The palette from left to right, in a frame; `size` in device-independent pixels.
QPixmap gradientPixmap(const attractor::Palette& palette, const QSize& size, qreal pixelRatio);

// The built-in palettes, each shown as its gradient, and the present one when it is none of them.
class GradientChooser : public QComboBox {
    Q_OBJECT

public:
    explicit GradientChooser(QWidget* parent = nullptr);

    void showPalette(const attractor::Palette& palette);

signals:
    void chosen(const attractor::Palette& palette);

private:
    void add(const attractor::Palette& palette, const QString& name);

    int m_builtIn = 0; // number of palettes of the program
};

} // namespace view
