// SPDX-License-Identifier: MIT
#include "panels/appearance/palettes/gradient_preview.h"

#include "panels/appearance/controls/appearance_colour_button.h"
#include "panels/appearance/palettes/palette_titles.h"
#include "widgets/choices.h"

#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

constexpr QSize rowSize(88, 14);

} // namespace

QPixmap gradientPixmap(const attractor::Palette& palette, const QSize& size, qreal pixelRatio) {
    const QSize pixels = size * pixelRatio;
    QImage row(pixels.width(), 1, QImage::Format_ARGB32);
    for (int x = 0; x < pixels.width(); ++x)
        row.setPixelColor(x, 0, toColour(attractor::colourAt(palette, (x + 0.5) / pixels.width())));
    QPixmap pixmap(pixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath shape;
    shape.addRoundedRect(QRectF(QPointF(0.5, 0.5), QSizeF(pixels) - QSizeF(1, 1)), 2 * pixelRatio,
                         2 * pixelRatio);
    painter.setClipPath(shape);
    painter.drawImage(QRect(QPoint(0, 0), pixels), row);
    painter.setClipping(false);
    painter.setPen(QPen(QColor(128, 128, 128, 140), pixelRatio));
    painter.drawPath(shape);
    painter.end();
    pixmap.setDevicePixelRatio(pixelRatio);
    return pixmap;
}

GradientChooser::GradientChooser(QWidget* parent) : QComboBox(parent) {
    setIconSize(rowSize);
    // The long name of a file would widen the panel.
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(6);
    for (const attractor::Palette& palette : attractor::builtInPalettes())
        add(palette, paletteTitle(palette));
    m_builtIn = count();
    connect(this, &QComboBox::activated, this,
            [this] { emit chosen(chosenValue<attractor::Palette>(this)); });
}

void GradientChooser::add(const attractor::Palette& palette, const QString& name) {
    QIcon icon;
    for (const qreal ratio : {1.0, 2.0})
        icon.addPixmap(gradientPixmap(palette, rowSize, ratio));
    addChoice(this, name, palette);
    setItemIcon(count() - 1, icon);
}

void GradientChooser::showPalette(const attractor::Palette& palette) {
    if (chooseValue(this, palette)) return;
    if (count() > m_builtIn) removeItem(m_builtIn);
    const QString name = paletteTitle(palette);
    if (isOfLibrary(palette))
        add(palette, name);
    else
        add(palette, name.isEmpty() ? tr("of this fractal") : tr("%1 (of this fractal)").arg(name));
    setCurrentIndex(count() - 1);
}

} // namespace view
