// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QColor>
#include <QToolButton>

namespace view {

QColor toColour(const attractor::Rgba& colour);
attractor::Rgba toRgba(const QColor& colour);

// A swatch that opens a colour dialog. What is tried in the dialog is reported live.
class ColourButton : public QToolButton {
    Q_OBJECT

public:
    enum class Alpha { Opaque, Adjustable };
    ColourButton(const QString& name, Alpha alpha, QWidget* parent = nullptr);

    const attractor::Rgba& colour() const { return m_colour; }
    void setColour(const attractor::Rgba& colour);

    QSize sizeHint() const override { return {34, 22}; }

signals:
    void tried(const attractor::Rgba& colour);
    void accepted();
    void rejected();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void choose();

    attractor::Rgba m_colour;
    Alpha m_alpha;
};

} // namespace view
