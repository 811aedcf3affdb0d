// SPDX-License-Identifier: MIT
#include "dialogs/export/export_preview.h"

#include <QPainter>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace view {

namespace {

using namespace std::chrono_literals;

constexpr int margin = 1;       // pixels for the outline
constexpr double square = 8;    // pixels of the widget; side of a square of the chequer
constexpr int maxPixels = 2000; // pixels on a side, in windows of any size

// A chequerboard, by which paint programs show transparency, in light and dark windows.
void paintChequer(QPainter& painter, const QRect& area) {
    const QColor bright(255, 255, 255), shaded(204, 204, 204);
    painter.fillRect(area, bright);
    for (int row = 0; row * square < area.height(); ++row)
        for (int column = row % 2; column * square < area.width(); column += 2)
            painter.fillRect(QRectF(area.x() + column * square, area.y() + row * square, square, square) &
                                 QRectF(area),
                             shaded);
}

} // namespace

ExportPreview::ExportPreview(QWidget* parent)
    : QWidget(parent), m_work([this](const std::optional<Drawn>& drawn) {
          m_patience.stop();
          if (drawn) {
              m_picture = drawn->picture;
              m_shown = drawn->of;
          }
          update();
          if (drawn) emit this->drawn();
      }) {
    setAccessibleName(tr("Preview"));
    setToolTip(tr("What the file will show"));
    setWhatsThis(tr("The picture as it will be exported: its proportions and the section it shows. A "
                    "chequerboard marks transparent parts. The preview follows every field."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMinimumSize(160, 120);
    m_delay.setSingleShot(true);
    m_delay.setInterval(60ms);
    connect(&m_delay, &QTimer::timeout, this, &ExportPreview::draw);
    m_patience.setSingleShot(true);
    m_patience.setInterval(300ms);
    connect(&m_patience, &QTimer::timeout, this, qOverload<>(&QWidget::update));
}

QSize ExportPreview::sizeHint() const {
    return {360, 280};
}

void ExportPreview::show(const QSize& size, Drawing drawing) {
    m_size = size.expandedTo({1, 1});
    m_drawing = std::move(drawing);
    m_delay.start();
    update();
}

QRect ExportPreview::frame() const {
    const QRect room = rect().adjusted(margin, margin, -margin, -margin);
    const double factor =
        std::min(double(room.width()) / m_size.width(), double(room.height()) / m_size.height());
    const QSize size(std::max(1, int(std::lround(m_size.width() * factor))),
                     std::max(1, int(std::lround(m_size.height() * factor))));
    return {room.x() + (room.width() - size.width()) / 2, room.y() + (room.height() - size.height()) / 2,
            size.width(), size.height()};
}

void ExportPreview::draw() {
    if (!m_drawing || width() <= 2 * margin || height() <= 2 * margin) return;
    const QSize room =
        (QSizeF(frame().size()) * devicePixelRatioF()).toSize().boundedTo({maxPixels, maxPixels});
    const QSize pixels = room.boundedTo(m_size).expandedTo({1, 1});
    m_patience.start();
    m_work.submit([pixels, of = m_size, drawing = m_drawing](const std::stop_token& stop) {
        std::optional<QImage> picture = drawing(pixels, stop);
        return picture ? std::optional(Drawn{std::move(*picture), of}) : std::nullopt;
    });
}

void ExportPreview::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_delay.start();
}

void ExportPreview::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const QRect frame = this->frame();
    const bool isSameShape = !m_picture.isNull() && qint64(m_shown.width()) * m_size.height() ==
                                                        qint64(m_size.width()) * m_shown.height();
    if (isSameShape) {
        if (m_picture.hasAlphaChannel()) paintChequer(painter, frame);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(frame, m_picture);
    } else {
        painter.fillRect(frame, palette().color(QPalette::Base));
    }
    QColor outline = palette().color(QPalette::Text);
    outline.setAlpha(110);
    painter.setPen(outline);
    painter.drawRect(frame.adjusted(-1, -1, 0, 0));
    if (isSameShape || (m_work.isBusy() && m_patience.isActive())) return;
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     m_work.isBusy() || m_delay.isActive() || !m_drawing ? tr("Drawing the preview…")
                                                                         : tr("No preview"));
}

} // namespace view
