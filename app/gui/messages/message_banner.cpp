// SPDX-License-Identifier: MIT
#include "messages/message_banner.h"

#include "canvas/canvas_view.h"

#include <QAccessible>
#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace {

// The least width of the buttons side by side, whatever the direction of their layout is.
int widthOfRow(const QBoxLayout& buttons) {
    int width = 0, count = 0;
    for (int i = 0; i < buttons.count(); ++i)
        if (const QLayoutItem* item = buttons.itemAt(i); !item->isEmpty()) {
            width += item->minimumSize().width();
            ++count;
        }
    return width + std::max(0, count - 1) * std::max(0, buttons.spacing());
}

} // namespace

MessageBanner::MessageBanner(QMainWindow* host) : QFrame(host), m_host(host) {
    setAttribute(Qt::WA_DeleteOnClose);
    m_geometryTimer.setSingleShot(true);
    m_geometryTimer.setInterval(0);
    connect(&m_geometryTimer, &QTimer::timeout, this, &MessageBanner::layOut);
    follow(host);
}

QLabel* MessageBanner::createTitle(const QString& text) {
    auto* title = new QLabel(this);
    QFont bold = font();
    bold.setBold(true);
    bold.setPointSizeF(bold.pointSizeF() * 1.15);
    title->setFont(bold);
    title->setTextFormat(Qt::PlainText); // the title quotes names
    title->setText(text);
    return title;
}

QBoxLayout* MessageBanner::createButtons() {
    m_buttons = new QBoxLayout(QBoxLayout::LeftToRight);
    return m_buttons;
}

void MessageBanner::lay(QLabel* title, const QString& text, QWidget* first, QWidget* last) {
    QBoxLayout* buttons = createButtons();
    buttons->addWidget(first);
    buttons->addStretch();
    buttons->addWidget(last);
    const int above = text.isEmpty() ? margin - 4 : margin - 2;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, above, margin, above);
    layout->addWidget(title);
    if (!text.isEmpty()) {
        auto* label = new QLabel(this);
        label->setTextFormat(Qt::PlainText); // the text quotes names
        label->setText(text);
        label->setWordWrap(true);
        layout->addWidget(label);
    }
    layout->addLayout(buttons);
}

void MessageBanner::follow(QWidget* widget) {
    widget->installEventFilter(this);
}

void MessageBanner::unfollow(QWidget* widget) {
    widget->removeEventFilter(this);
}

void MessageBanner::appear(const QString& announcement) {
    show();
    m_geometryTimer.start();
    setAccessibleDescription(announcement);
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

QRect MessageBanner::canvasRect() const {
    const QWidget* canvas = m_host->centralWidget();
    return {canvas->mapTo(m_host, QPoint()), canvas->size()};
}

QPoint MessageBanner::topLeft() {
    return {canvasRect().left() + margin, canvasRect().bottom() - hintHeight - height()};
}

int MessageBanner::widest() const {
    constexpr int usualDpi = 96;
    return usualWidth * std::max(logicalDpiX(), usualDpi) / usualDpi;
}

int MessageBanner::widthFor(int room) const {
    return std::min(widest(), room);
}

void MessageBanner::layOut() {
    const int width = widthFor(canvasRect().width() - 2 * margin);
    if (m_buttons) {
        // Set where it changes only: every change is followed by another call of this.
        const bool isRow = widthOfRow(*m_buttons) <= width - 2 * margin;
        const auto direction = isRow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
        if (m_buttons->direction() != direction) m_buttons->setDirection(direction);
    }
    setFixedWidth(width);
    resize(width, std::max(heightForWidth(width), minimumSizeHint().height()));
    const QPoint automatic = topLeft();
    moveInside(m_chosen.value_or(automatic));
    raise();
    tellCanvas();
}

void MessageBanner::moveInside(const QPoint& corner) {
    const QSize room = m_host->size() - size();
    move(std::clamp(corner.x(), 0, std::max(0, room.width())),
         std::clamp(corner.y(), 0, std::max(0, room.height())));
}

void MessageBanner::mousePressEvent(QMouseEvent* event) {
    m_grip = event->position().toPoint();
}

void MessageBanner::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton)) return;
    moveInside(mapTo(m_host, event->position().toPoint()) - m_grip);
    m_chosen = pos();
    tellCanvas();
}

void MessageBanner::placeSoon() {
    m_geometryTimer.start();
}

void MessageBanner::tellCanvas() {
    for (auto* canvas : m_host->findChildren<view::CanvasView*>())
        canvas->setCovered(isVisible() ? QRect(canvas->viewport()->mapFrom(m_host, pos()), size()) : QRect());
}

void MessageBanner::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    tellCanvas();
}

bool MessageBanner::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
        m_geometryTimer.start();
        break;
    default:
        break;
    }
    return QFrame::eventFilter(watched, event);
}

void MessageBanner::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange) m_geometryTimer.start();
}

void MessageBanner::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QFrame::keyPressEvent(event);
}

void MessageBanner::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
}
