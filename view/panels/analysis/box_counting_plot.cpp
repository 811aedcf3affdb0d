// SPDX-License-Identifier: MIT
#include "panels/analysis/box_counting_plot.h"

#include "widgets/numbers/number_text.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace view {

BoxCountingPlot::BoxCountingPlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Box-counting plot"));
    setToolTip(
        tr("The number of boxes that meet the attractor, against their fineness: log₂ N over k for boxes of "
           "side L·2⁻ᵏ, where L is the side of the square around the attractor. Hollow points are not used "
           "for the line: at those sizes, the size of the whole or of a cell affects the count."));
    setWhatsThis(toolTip());
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize BoxCountingPlot::sizeHint() const {
    return {220, 12 * fontMetrics().height()};
}

QSize BoxCountingPlot::minimumSizeHint() const {
    return {120, sizeHint().height()};
}

void BoxCountingPlot::setCounting(const std::optional<ifs::BoxCounting>& counting, bool isPending) {
    if (counting || !isPending) m_counting = counting;
    m_isPending = isPending;
    setVisible(m_counting.has_value());
    if (m_counting)
        setAccessibleDescription(tr("Slope %1 over %2 sizes")
                                     .arg(shortNumber(m_counting->fit.slope))
                                     .arg(m_counting->last - m_counting->first + 1));
    update();
}

QString BoxCountingPlot::table() const {
    QStringList lines;
    for (std::size_t k = 0; m_counting && k < m_counting->counts.size(); ++k)
        lines << fullNumber(std::ldexp(m_counting->side, -int(k))) + u'\t' +
                     QString::number(m_counting->counts[k]);
    return lines.join(u'\n');
}

void BoxCountingPlot::contextMenuEvent(QContextMenuEvent* event) {
    if (!m_counting) return;
    QMenu menu(this);
    menu.addAction(tr("Copy Sizes and Counts"), this,
                   [this] { QGuiApplication::clipboard()->setText(table()); });
    menu.exec(event->globalPos());
}

void BoxCountingPlot::paintEvent(QPaintEvent*) {
    if (!m_counting) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int line = fontMetrics().height();
    const int levels = int(m_counting->counts.size()) - 1;
    const auto log2 = [&](int k) { return std::log2(double(m_counting->counts[std::size_t(k)])); };
    const double most = std::max(1.0, std::ceil(log2(levels)));
    const int left = fontMetrics().horizontalAdvance(QStringLiteral("88")) + 8;
    const QRectF area(left, line + 4, width() - left - 8, height() - 3 * line - 8);
    const auto at = [&](double k, double logN) {
        return QPointF(area.left() + area.width() * k / levels, area.bottom() - area.height() * logN / most);
    };
    QColor text = palette().color(QPalette::WindowText);
    if (m_isPending) text.setAlphaF(0.5F);
    QColor quiet = text;
    quiet.setAlphaF(0.5F * text.alphaF() + 0.15F);
    QColor grid = text;
    grid.setAlphaF(0.12F);

    const int stride = most > 10 ? 5 : 2; // distance of marks, so that they stay apart
    painter.setPen(quiet);
    painter.drawText(QRectF(0, 0, width(), line), Qt::AlignLeft | Qt::AlignVCenter, tr("log₂ N"));
    for (int n = 0; n <= int(most); n += stride) {
        painter.setPen(grid);
        painter.drawLine(at(0, n), at(levels, n));
        painter.setPen(quiet);
        painter.drawText(QRectF(0, at(0, n).y() - line / 2.0, left - 6, line),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(n));
    }
    for (int k = 0; k <= levels; ++k)
        painter.drawText(QRectF(at(k, 0).x() - 15, area.bottom() + 3, 30, line), Qt::AlignCenter,
                         QString::number(k));
    painter.drawText(QRectF(area.left(), area.bottom() + 2 + line, area.width(), line), Qt::AlignCenter,
                     tr("k, boxes of side L·2⁻ᵏ"));

    QColor accent = palette().color(QPalette::Highlight);
    if (m_isPending) accent.setAlphaF(0.5F);
    const auto fitted = [&](double k) {
        return at(k, m_counting->fit.intercept / std::numbers::ln2 + m_counting->fit.slope * k);
    };
    painter.setPen(QPen(accent, 2));
    painter.drawLine(fitted(m_counting->first), fitted(m_counting->last));
    painter.setPen(text);
    painter.drawText(QRectF(area.left(), 0, area.width(), line), Qt::AlignRight | Qt::AlignVCenter,
                     tr("slope %1").arg(shortNumber(m_counting->fit.slope)));
    for (int k = 0; k <= levels; ++k) {
        const bool isUsed = k >= m_counting->first && k <= m_counting->last;
        painter.setPen(QPen(isUsed ? text : quiet, 1.2));
        painter.setBrush(isUsed ? text : palette().color(QPalette::Window));
        painter.drawEllipse(at(k, log2(k)), 2.8, 2.8);
    }
}

} // namespace view
