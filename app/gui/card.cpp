// SPDX-License-Identifier: MIT
#include "card.h"

#include <QAccessible>
#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>

#include <algorithm>

Card::Card(QMainWindow* host) : QFrame(host), m_host(host) {
    setAttribute(Qt::WA_DeleteOnClose);
    m_settling.setSingleShot(true);
    m_settling.setInterval(0);
    connect(&m_settling, &QTimer::timeout, this, &Card::place);
    follow(host);
}

QLabel* Card::createTitle() {
    auto* title = new QLabel(this);
    QFont bold = font();
    bold.setBold(true);
    bold.setPointSizeF(bold.pointSizeF() * 1.15);
    title->setFont(bold);
    return title;
}

QBoxLayout* Card::createButtons() {
    m_buttons = new QBoxLayout(QBoxLayout::LeftToRight);
    return m_buttons;
}

void Card::follow(QWidget* widget) {
    widget->installEventFilter(this);
}

void Card::unfollow(QWidget* widget) {
    widget->removeEventFilter(this);
}

void Card::appear(const QString& announcement) {
    show();
    m_settling.start();
    setAccessibleDescription(announcement);
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

QRect Card::room() const {
    const QWidget* canvas = m_host->centralWidget();
    return {canvas->mapTo(m_host, QPoint()), canvas->size()};
}

QPoint Card::corner() {
    return {room().left() + margin, room().bottom() - noteRoom - height()};
}

void Card::place() {
    const int width = std::min(cardWidth, room().width() - 2 * margin);
    if (m_buttons) {
        m_buttons->setDirection(QBoxLayout::LeftToRight);
        if (m_buttons->minimumSize().width() > width - 2 * margin)
            m_buttons->setDirection(QBoxLayout::TopToBottom);
    }
    setFixedWidth(width);
    resize(width, std::max(heightForWidth(width), minimumSizeHint().height()));
    const QPoint at = corner();
    move(std::max(0, at.x()), std::max(0, at.y()));
    raise();
}

bool Card::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
        m_settling.start();
        break;
    default:
        break;
    }
    return QFrame::eventFilter(watched, event);
}

void Card::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange) m_settling.start();
}

void Card::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QFrame::keyPressEvent(event);
}

void Card::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
}
