// SPDX-License-Identifier: MIT
#include "widgets/text/elided_label.h"

#include <QPainter>
#include <QStyle>
#include <QTextLayout>

namespace view {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setLines(int most) {
    m_most = most;
    updateGeometry();
}

bool ElidedLabel::isCut() const {
    return fontMetrics().horizontalAdvance(lines().last()) > contentsRect().width();
}

QStringList ElidedLabel::lines() const {
    QStringList lines;
    QTextLayout layout(text(), font());
    layout.beginLayout();
    int begin = 0;
    while (lines.size() + 1 < m_most) {
        QTextLine line = layout.createLine();
        if (!line.isValid()) break;
        line.setLineWidth(contentsRect().width());
        if (line.textStart() + line.textLength() >= text().size()) break;
        lines << text().mid(begin, line.textLength()).trimmed();
        begin += line.textLength();
    }
    layout.endLayout();
    return lines << text().mid(begin);
}

QSize ElidedLabel::withHeight(QSize size) const {
    const QMargins margins = contentsMargins();
    if (m_most > 1) size.setHeight(fontMetrics().lineSpacing() * m_most + margins.top() + margins.bottom());
    return size;
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const QStringList shown = lines();
    QRect room = contentsRect();
    if (shown.size() > 1) {
        const int height = fontMetrics().lineSpacing();
        room = {room.left(), room.center().y() + 1 - height * int(shown.size()) / 2, room.width(), height};
    }
    for (const QString& line : shown) {
        style()->drawItemText(&painter, room, int(alignment()), palette(), isEnabled(),
                              fontMetrics().elidedText(line, Qt::ElideRight, room.width()), foregroundRole());
        room.translate(0, room.height());
    }
}

} // namespace view
