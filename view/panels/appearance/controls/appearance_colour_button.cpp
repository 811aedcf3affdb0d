// SPDX-License-Identifier: MIT
#include "panels/appearance/controls/appearance_colour_button.h"

#include <QColorDialog>
#include <QPainter>
#include <QPainterPath>

namespace view {

QColor toColour(const attractor::Rgba& colour) {
    return {colour.red, colour.green, colour.blue, colour.alpha};
}

attractor::Rgba toRgba(const QColor& colour) {
    const auto channel = [](int value) { return static_cast<std::uint8_t>(value); };
    return {channel(colour.red()), channel(colour.green()), channel(colour.blue()), channel(colour.alpha())};
}

ColourButton::ColourButton(const QString& name, Alpha alpha, QWidget* parent)
    : QToolButton(parent), m_alpha(alpha) {
    setAccessibleName(name);
    setWhatsThis(tr("Click to choose another colour."));
    setText(name);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::StrongFocus);
    setColour({});
    connect(this, &QToolButton::clicked, this, &ColourButton::choose);
}

void ColourButton::setColour(const attractor::Rgba& colour) {
    m_colour = colour;
    const QString code = toColour(colour).name();
    const QString shown = colour.alpha == 255 ? code
                          : colour.alpha == 0 ? tr("transparent")
                                              : tr("%1, %2 % opaque").arg(code).arg(colour.alpha * 100 / 255);
    setToolTip(QStringLiteral("%1: %2").arg(text(), shown));
    setAccessibleDescription(shown);
    update();
}

void ColourButton::choose() {
    const attractor::Rgba before = m_colour;
    QColorDialog dialog(toColour(before), this);
    dialog.setWindowTitle(text());
    dialog.setOption(QColorDialog::ShowAlphaChannel, m_alpha == Alpha::Adjustable);
    connect(&dialog, &QColorDialog::currentColorChanged, this,
            [this](const QColor& c) { emit tried(toRgba(c)); });
    const bool isAccepted = dialog.exec() == QDialog::Accepted;
    if (isAccepted && toRgba(dialog.selectedColor()) != before) {
        emit tried(toRgba(dialog.selectedColor()));
        emit accepted();
    } else {
        emit rejected();
    }
}

void ColourButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!isEnabled()) painter.setOpacity(0.4);
    const QRectF area = QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5);
    QPainterPath shape;
    shape.addRoundedRect(area, 3, 3);
    painter.save();
    painter.setClipPath(shape);
    if (m_colour.alpha < 255) {
        constexpr int tile = 5;
        painter.fillRect(area, Qt::white);
        for (int y = 0; y * tile < height(); ++y) {
            for (int x = y % 2; x * tile < width(); x += 2)
                painter.fillRect(x * tile, y * tile, tile, tile, QColor(200, 200, 200));
        }
    }
    painter.fillPath(shape, toColour(m_colour));
    painter.restore();
    QColor rim = palette().color(QPalette::WindowText);
    rim.setAlphaF(underMouse() && isEnabled() ? 0.7F : 0.35F);
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight), 2) : QPen(rim, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape);
}

} // namespace view
