// SPDX-License-Identifier: MIT
#include "panels/timeline/ruler_marks.h"

#include "panels/timeline/key_mark.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double closest = 6; // pixels between ticks
constexpr int maxParts = 10;  // parts between two labels

double xOf(const RulerPlace& place, double frame) {
    return place.start + frame * place.scale;
}

// The width of the longest of all labels, wherever the ruler is scrolled to.
double labelWidth(const RulerPlace& place, const QFontMetricsF& metrics) {
    const auto& [rate, length, loop] = place.timing;
    const bool isSeconds = place.unit == RulerUnit::Seconds;
    const double last = isSeconds ? double(length) * rate.seconds / rate.frames : length;
    QString longest(QString::number(std::floor(last), 'f', 0).size(), u'0');
    if (isSeconds && rate.frames % rate.seconds != 0) longest += QStringLiteral(".00");
    return metrics.horizontalAdvance(longest) + metrics.horizontalAdvance(QStringLiteral("00"));
}

int labelStep(const RulerPlace& place, double width) {
    const double wanted = width / place.scale;
    int step = rulerStep(wanted, place.timing.rate, place.unit);
    for (double least = wanted; step < wanted;) // whole frames may be a little closer
        step = rulerStep(least *= 1.5, place.timing.rate, place.unit);
    return step;
}

int firstInSight(const RulerPlace& place, int step) {
    const double frame = (place.area.left() - place.start) / place.scale;
    return std::max(0, int(frame) / step * step);
}

// Frames from one tick to the next: as many in each step as are not too close.
int tickStep(const RulerPlace& place, int step) {
    for (int parts = maxParts; parts > 1; --parts)
        if (const int ticks = step / parts; step % parts == 0 && ticks * place.scale >= closest) return ticks;
    return step;
}

// Paints each column of pixels once, however many keys it has.
void paintKeyTicks(QPainter& painter, const RulerPlace& place,
                   const std::vector<document::TrackKeys>& tracks) {
    std::vector<bool> isMarked(std::size_t(std::max(0.0, place.area.width())) + 1);
    for (const document::TrackKeys& track : tracks)
        for (const auto& key : track.keys) {
            const double x = xOf(place, key.frame) - place.area.left();
            if (x >= 0 && x <= place.area.width()) isMarked[std::size_t(x)] = true;
        }
    for (std::size_t x = 0; x < isMarked.size(); ++x)
        if (isMarked[x])
            painter.fillRect(QRectF(place.area.left() + double(x) - 1, place.area.bottom() - 4, 2, 5),
                             painter.pen().color());
}

} // namespace

std::vector<RulerLabel> rulerLabels(const RulerPlace& place, const QFont& font) {
    const QFontMetricsF metrics(font);
    const double width = labelWidth(place, metrics);
    const int step = labelStep(place, width);
    std::vector<RulerLabel> labels;
    for (int frame = firstInSight(place, step); frame <= place.timing.length; frame += step) {
        const double x = xOf(place, frame);
        if (x - width / 2 > place.area.right()) break;
        const QString text = rulerText(frame, place.timing.rate, place.unit);
        const double half = metrics.horizontalAdvance(text) / 2 + 1;
        labels.push_back({frame, text, {x - half, place.area.top(), 2 * half, place.area.height() - 4}});
    }
    return labels;
}

void paintRulerMarks(QPainter& painter, const RulerPlace& place, const QRectF& covered,
                     const std::vector<document::TrackKeys>& tracks, const QPalette& palette) {
    const QColor ink = palette.color(QPalette::WindowText);
    const int step = labelStep(place, labelWidth(place, QFontMetricsF(painter.font())));
    const int ticks = tickStep(place, step);
    for (int frame = firstInSight(place, step); frame <= place.timing.length; frame += ticks) {
        const double x = xOf(place, frame), bottom = place.area.bottom();
        if (x > place.area.right()) break;
        painter.setPen(faded(ink, 0.35));
        painter.drawLine(QPointF(x, bottom - (frame % step == 0 ? 4 : 2)), QPointF(x, bottom));
    }
    painter.setPen(faded(ink, 0.75));
    for (const RulerLabel& label : rulerLabels(place, painter.font()))
        if (!label.room.intersects(covered)) painter.drawText(label.room, Qt::AlignCenter, label.text);
    painter.setPen(faded(ink, 0.85));
    paintKeyTicks(painter, place, tracks);
}

} // namespace view
