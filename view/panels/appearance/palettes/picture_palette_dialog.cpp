// SPDX-License-Identifier: MIT
#include "panels/appearance/palettes/picture_palette_dialog.h"

#include "attractor/colour/picture_palette.h"
#include "widgets/numbers/number_box.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace view {

namespace {

constexpr int maxSide = 512;   // pixels of the side that are evaluated
constexpr double shortest = 3; // pixels; a shorter line is a click
constexpr int usualColours = 6;

attractor::Rgba rgba(QRgb pixel) {
    return {std::uint8_t(qRed(pixel)), std::uint8_t(qGreen(pixel)), std::uint8_t(qBlue(pixel)),
            std::uint8_t(qAlpha(pixel))};
}

std::vector<attractor::Rgba> pixelsOf(const QImage& picture) {
    std::vector<attractor::Rgba> pixels;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            pixels.push_back(rgba(picture.pixel(x, y)));
    return pixels;
}

std::vector<attractor::Rgba> pixelsOn(const QImage& picture, const QLineF& line) {
    std::vector<attractor::Rgba> pixels;
    const int count = std::max(2, int(std::ceil(line.length())) + 1);
    for (int k = 0; k < count; ++k) {
        const QPointF at = line.pointAt(double(k) / (count - 1));
        pixels.push_back(rgba(picture.pixel(std::clamp(int(at.x()), 0, picture.width() - 1),
                                            std::clamp(int(at.y()), 0, picture.height() - 1))));
    }
    return pixels;
}

} // namespace

LinePicture::LinePicture(const QImage& picture, QWidget* parent) : QWidget(parent), m_picture(picture) {
    setCursor(Qt::CrossCursor);
    setMinimumSize(160, 120);
    setAccessibleName(tr("Picture"));
    setToolTip(tr("Drag a line to take only the colours along it; click to take all"));
}

QSize LinePicture::sizeHint() const {
    return m_picture.size().scaled(480, 360, Qt::KeepAspectRatio);
}

QRectF LinePicture::shown() const {
    const QSizeF size = QSizeF(m_picture.size()).scaled(this->size(), Qt::KeepAspectRatio);
    return {(width() - size.width()) / 2, (height() - size.height()) / 2, size.width(), size.height()};
}

QPointF LinePicture::pixelAt(const QPointF& position) const {
    const QRectF area = shown();
    return {std::clamp((position.x() - area.x()) / area.width(), 0.0, 1.0) * m_picture.width(),
            std::clamp((position.y() - area.y()) / area.height(), 0.0, 1.0) * m_picture.height()};
}

void LinePicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF area = shown();
    painter.drawImage(area, m_picture);
    if (!m_line) return;
    const double scale = area.width() / m_picture.width();
    const QLineF line(area.topLeft() + m_line->p1() * scale, area.topLeft() + m_line->p2() * scale);
    for (const auto& [colour, width] :
         {std::pair(QColor(0, 0, 0, 200), 5.0), std::pair(QColor(Qt::white), 2.0)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(line);
    }
}

void LinePicture::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const QPointF at = pixelAt(event->position());
    m_line = QLineF(at, at);
}

void LinePicture::mouseMoveEvent(QMouseEvent* event) {
    if (!m_line || !event->buttons().testFlag(Qt::LeftButton)) return;
    m_line->setP2(pixelAt(event->position()));
    update();
    if (m_line->length() >= shortest) emit lineDrawn();
}

void LinePicture::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_line) return;
    if (m_line->length() < shortest) m_line.reset();
    update();
    emit lineDrawn();
}

PicturePaletteDialog::PicturePaletteDialog(const QImage& picture, QWidget* parent)
    : QDialog(parent),
      m_picture(std::max(picture.width(), picture.height()) > maxSide
                    ? picture.scaled(maxSide, maxSide, Qt::KeepAspectRatio, Qt::SmoothTransformation)
                    : picture),
      m_canvas(new LinePicture(m_picture, this)),
      m_colours(new WholeNumberBox(this)) {
    setWindowTitle(tr("Palette from Picture"));
    setWhatsThis(tr("Makes a palette of the colours of a picture, or of those along a line in it."));
    m_colours->setRange(2, int(attractor::maxPictureColours));
    m_colours->setValue(usualColours);
    m_colours->setAccessibleName(tr("Colours"));
    m_colours->setToolTip(tr("How many colours the palette has"));
    auto* hint = new QLabel(tr("Drag a line to take only the colours along it."), this);
    hint->setWordWrap(true);
    auto* label = new QLabel(tr("&Colours:"), this);
    label->setBuddy(m_colours);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_colours);
    row->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_canvas, 1);
    layout->addWidget(hint);
    layout->addLayout(row);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_colours, &QSpinBox::valueChanged, this, &PicturePaletteDialog::take);
    connect(m_canvas, &LinePicture::lineDrawn, this, &PicturePaletteDialog::take);
    take();
}

void PicturePaletteDialog::take() {
    const auto count = std::size_t(m_colours->value());
    m_palette = m_canvas->line() ? attractor::paletteAlongLine(pixelsOn(m_picture, *m_canvas->line()), count)
                                 : attractor::paletteOfPicture(pixelsOf(m_picture), count);
    emit tried(m_palette);
}

} // namespace view
