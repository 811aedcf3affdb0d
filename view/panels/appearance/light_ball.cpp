// SPDX-License-Identifier: MIT
#include "panels/appearance/light_ball.h"

#include "attractor/light/solid_appearance.h"
#include "widgets/arrow_keys.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace view {

namespace {

constexpr int side = 88; // pixels
constexpr double margin = 4;
constexpr double degreesPerKey = 5;
constexpr double degree = std::numbers::pi / 180;
constexpr std::chrono::milliseconds runPause{600};

// A sphere of stone in that light, as Look::Stone shows it: half-Lambert, 40 % from the eye.
QImage litSphere(const attractor::ViewVector& lamp, int pixels) {
    QImage image(pixels, pixels, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) {
            const double right = 2 * (x + 0.5) / pixels - 1, up = 1 - 2 * (y + 0.5) / pixels;
            const double rest = 1 - right * right - up * up;
            if (rest <= 0) continue;
            const double towards = std::sqrt(rest);
            const double facing =
                right * double(lamp.right) + up * double(lamp.up) + towards * double(lamp.towards);
            const auto half = [](double cosine) { return (1 + cosine) / 2 * (1 + cosine) / 2; };
            const double light = 0.4 * half(towards) + 0.6 * half(facing);
            const auto channel = [&](double most) { return int(std::clamp(40 + most * light, 0.0, 255.0)); };
            image.setPixel(x, y, qRgb(channel(205), channel(196), channel(182)));
        }
    return image;
}

} // namespace

LightBall::LightBall(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName(tr("Direction of the light"));
    setToolTip(tr("Drag the light over the sphere, or use the arrow keys"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_settled.setSingleShot(true);
    m_settled.setInterval(runPause);
    connect(&m_settled, &QTimer::timeout, this, &LightBall::accepted);
    setDirection(m_azimuth, m_elevation);
}

QSize LightBall::sizeHint() const {
    return {side, side};
}

void LightBall::setDirection(double azimuth, double elevation) {
    m_azimuth = azimuth;
    m_elevation = elevation;
    setAccessibleDescription(
        tr("Azimuth %1°, elevation %2°").arg(azimuth, 0, 'g', 4).arg(elevation, 0, 'g', 4));
    update();
}

double LightBall::radius() const {
    return std::min(width(), height()) / 2.0 - margin;
}

QPointF LightBall::spot() const {
    const attractor::ViewVector lamp = attractor::lampAt(m_azimuth, m_elevation);
    return {double(lamp.right), double(lamp.up)};
}

void LightBall::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = QRectF(rect()).center();
    const double r = radius();
    const attractor::ViewVector lamp = attractor::lampAt(m_azimuth, m_elevation);
    const QRectF around(middle.x() - r, middle.y() - r, 2 * r, 2 * r);
    QPainterPath disc;
    disc.addEllipse(around);
    painter.save();
    if (!isEnabled()) painter.setOpacity(0.4);
    painter.setClipPath(disc);
    painter.drawImage(around, litSphere(lamp, std::max(1, int(2 * r * devicePixelRatioF()))));
    painter.restore();
    painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid),
                        hasFocus() ? 2.5 : 1.5));
    painter.drawEllipse(around);
    if (!isEnabled()) return;
    const QPointF at = middle + QPointF(spot().x() * r, -spot().y() * r);
    const bool isBehind = lamp.towards < 0;
    painter.setPen(QPen(QColor(32, 30, 26), 1.5));
    painter.setBrush(isBehind ? QBrush(Qt::NoBrush) : QBrush(QColor(255, 236, 170)));
    painter.drawEllipse(at, 5, 5);
}

void LightBall::offer(double azimuth, double elevation) {
    setDirection(azimuth, elevation);
    emit tried(azimuth, elevation);
}

// Beyond the rim the light stays on it.
void LightBall::dragTo(const QPointF& position) {
    QPointF at = (position - QRectF(rect()).center()) / radius();
    const double length = std::hypot(at.x(), at.y());
    if (length > 1) at /= length;
    const double up = -at.y();
    const double towards = std::sqrt(std::max(0.0, 1 - at.x() * at.x() - up * up));
    const auto whole = [](double angle) { return std::round(angle / degree); };
    offer(whole(std::atan2(at.x(), towards)), whole(std::asin(std::clamp(up, -1.0, 1.0))));
}

void LightBall::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    m_settled.stop();
    m_isDragging = true;
    dragTo(event->position());
}

void LightBall::mouseMoveEvent(QMouseEvent* event) {
    if (m_isDragging) dragTo(event->position());
}

void LightBall::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_isDragging) return;
    m_isDragging = false;
    emit accepted();
}

void LightBall::keyPressEvent(QKeyEvent* event) {
    const QPointF way = arrowDirection(event->key());
    if (event->key() == Qt::Key_Escape && (m_isDragging || m_settled.isActive())) {
        m_isDragging = false;
        m_settled.stop();
        emit rejected();
    } else if (way.isNull()) {
        QWidget::keyPressEvent(event);
    } else {
        offer(std::clamp(m_azimuth + degreesPerKey * way.x(), -180.0, 180.0),
              std::clamp(m_elevation - degreesPerKey * way.y(), -90.0, 90.0));
        m_settled.start();
    }
}

bool LightBall::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (!arrowDirection(key->key()).isNull() || (key->key() == Qt::Key_Escape && m_isDragging)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::FocusOut && m_settled.isActive()) {
        m_settled.stop();
        emit accepted();
    }
    return QWidget::event(event);
}

} // namespace view
