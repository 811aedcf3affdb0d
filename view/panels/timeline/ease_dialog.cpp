// SPDX-License-Identifier: MIT
#include "panels/timeline/ease_dialog.h"

#include "widgets/numbers/number_box.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr double plotMargin = 12;
constexpr double handleRadius = 5;

animation::Ease asCurve(const animation::Ease& ease) {
    using Kind = animation::Ease::Kind;
    switch (ease.kind) {
    case Kind::Cubic:
        return ease;
    case Kind::In:
        return animation::cubicEase(0.42, 0, 1, 1);
    case Kind::Out:
        return animation::cubicEase(0, 0, 0.58, 1);
    case Kind::Both:
        return animation::cubicEase(0.42, 0, 0.58, 1);
    case Kind::Hold:
    case Kind::Linear:
    case Kind::Smooth:
        break;
    }
    return animation::cubicEase(0.25, 0.25, 0.75, 0.75);
}

} // namespace

EaseCurve::EaseCurve(QWidget* parent) : QWidget(parent) {
    setMinimumSize(140, 140);
    setCursor(Qt::CrossCursor);
}

void EaseCurve::setEase(const animation::Ease& ease) {
    m_ease = ease;
    update();
}

QRectF EaseCurve::square() const {
    const double side = std::min(width(), height()) - 2 * plotMargin;
    return {(width() - side) / 2, (height() - side) / 2, side, side};
}

QPointF EaseCurve::at(double x, double y) const {
    const QRectF inside = square();
    return {inside.left() + x * inside.width(), inside.bottom() - y * inside.height()};
}

QPointF EaseCurve::handle(int index) const {
    return index == 0 ? at(m_ease.x1, m_ease.y1) : at(m_ease.x2, m_ease.y2);
}

void EaseCurve::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::WindowText);
    const QColor accent = palette().color(QPalette::Highlight);
    QColor faint = ink;
    faint.setAlphaF(0.25F);
    painter.fillRect(square(), palette().color(QPalette::Base));
    painter.setPen(QPen(faint, 1));
    painter.drawRect(square());
    painter.drawLine(at(0, 0), at(1, 1));
    painter.drawLine(at(0, 0), handle(0));
    painter.drawLine(at(1, 1), handle(1));
    QPainterPath curve(at(0, 0));
    curve.cubicTo(handle(0), handle(1), at(1, 1));
    painter.setPen(QPen(ink, 2));
    painter.drawPath(curve);
    painter.setPen(QPen(ink, 1));
    painter.setBrush(accent);
    for (const int index : {0, 1})
        painter.drawEllipse(handle(index), handleRadius, handleRadius);
}

void EaseCurve::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const auto away = [&](int index) { return (event->position() - handle(index)).manhattanLength(); };
    m_held = away(0) <= away(1) ? 0 : 1;
    dragTo(event->position());
}

void EaseCurve::mouseMoveEvent(QMouseEvent* event) {
    if (m_held) dragTo(event->position());
}

void EaseCurve::mouseReleaseEvent(QMouseEvent*) {
    m_held.reset();
}

void EaseCurve::dragTo(const QPointF& point) {
    const QRectF inside = square();
    const double x = (point.x() - inside.left()) / inside.width();
    const double y = (inside.bottom() - point.y()) / inside.height();
    m_ease = *m_held == 0 ? animation::cubicEase(x, y, m_ease.x2, m_ease.y2)
                          : animation::cubicEase(m_ease.x1, m_ease.y1, x, y);
    update();
    emit changed();
}

EaseDialog::EaseDialog(const animation::Ease& ease, QWidget* parent)
    : QDialog(parent), m_curve(new EaseCurve(this)) {
    setWindowTitle(tr("Custom Ease"));
    m_curve->setEase(asCurve(ease));
    m_curve->setAccessibleName(tr("Curve: time to the right, progress upwards"));
    m_curve->setWhatsThis(tr("How the motion to the next key progresses over time. Drag the two handles."));
    const QString names[] = {tr("Time of the first handle"), tr("Progress of the first handle"),
                             tr("Time of the second handle"), tr("Progress of the second handle")};
    auto* grid = new QGridLayout;
    grid->addWidget(new QLabel(tr("Time")), 0, 1);
    grid->addWidget(new QLabel(tr("Progress")), 0, 2);
    grid->addWidget(new QLabel(tr("First handle:")), 1, 0);
    grid->addWidget(new QLabel(tr("Second handle:")), 2, 0);
    for (int i = 0; i < 4; ++i) {
        m_numbers[i] = new NumberBox;
        m_numbers[i]->setRange(0, 1);
        m_numbers[i]->setDecimals(3);
        m_numbers[i]->setSingleStep(0.05);
        m_numbers[i]->setKeyboardTracking(false);
        m_numbers[i]->setAccessibleName(names[i]);
        m_numbers[i]->setWhatsThis(tr("A number from 0 to 1. A curve that would be too steep is flattened."));
        grid->addWidget(m_numbers[i], 1 + i / 2, 1 + i % 2);
        connect(m_numbers[i], &QDoubleSpinBox::valueChanged, this, &EaseDialog::takeNumbers);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_curve, &EaseCurve::changed, this, &EaseDialog::showNumbers);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_curve, 1);
    column->addLayout(grid);
    column->addWidget(buttons);
    showNumbers();
}

void EaseDialog::showNumbers() {
    const animation::Ease& ease = m_curve->ease();
    const double values[] = {ease.x1, ease.y1, ease.x2, ease.y2};
    for (int i = 0; i < 4; ++i) {
        const QSignalBlocker blocker(m_numbers[i]);
        m_numbers[i]->setValue(values[i]);
    }
}

void EaseDialog::takeNumbers() {
    m_curve->setEase(animation::cubicEase(m_numbers[0]->value(), m_numbers[1]->value(), m_numbers[2]->value(),
                                          m_numbers[3]->value()));
    showNumbers();
}

} // namespace view
