// SPDX-License-Identifier: MIT
#include "messages/first_chips.h"

#include "canvas/canvas_view.h"

#include <QAction>
#include <QBoxLayout>
#include <QMainWindow>
#include <QPushButton>

#include <algorithm>

FirstChips::FirstChips(QMainWindow* host, const QList<Chip>& chips, int patience) : MessageBanner(host) {
    setObjectName(QStringLiteral("first-chips"));
    setAccessibleName(tr("What to try next"));
    QBoxLayout* row = createButtons();
    row->setSpacing(margin / 2);
    for (const Chip& chip : chips) {
        auto* button = new QPushButton(chip.action->icon(), chip.text, this);
        button->setObjectName(chip.action->objectName());
        button->setAutoDefault(false);
        button->setEnabled(chip.action->isEnabled());
        button->setToolTip(chip.action->statusTip());
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, action = chip.action, then = chip.then] {
            close();
            action->trigger();
            if (then) then();
        });
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, 0, margin, 0); // same width as the frame of a row of buttons
    layout->addLayout(row);
    m_away.setSingleShot(true);
    m_away.setInterval(patience);
    connect(&m_away, &QTimer::timeout, this, &QWidget::close);
    m_away.start();
    for (const QAction* action : host->findChildren<QAction*>())
        connect(action, &QAction::triggered, this, &QWidget::close);
    if (auto* canvas = host->findChild<view::CanvasView*>())
        connect(canvas, &view::CanvasView::toolChanged, this, &QWidget::close);
    appear(accessibleName());
}

int FirstChips::widthFor(int room) const {
    return std::min(room, layout()->sizeHint().width());
}

QPoint FirstChips::topLeft() {
    const QRect canvas = canvasRect();
    return {canvas.center().x() - width() / 2, canvas.bottom() - margin - height()};
}

// Whoever reads them has time.
void FirstChips::enterEvent(QEnterEvent* event) {
    m_away.stop();
    MessageBanner::enterEvent(event);
}

void FirstChips::leaveEvent(QEvent* event) {
    m_away.start();
    MessageBanner::leaveEvent(event);
}
