// SPDX-License-Identifier: MIT
#include "status_line.h"

#include "document/addresses.h"
#include "ifs/attractor_existence.h"

#include <QFontDatabase>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QStyle>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace {

constexpr std::chrono::seconds toRead{3};

QLabel* explained(QLabel* label, const QString& name, const QString& meaning) {
    label->setAccessibleName(name);
    label->setToolTip(meaning);
    return label;
}

QLabel* selectable(QLabel* label) {
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

// Fixed decimals, so that digits stay in place while the pointer moves.
QString fixed(double value, int decimals = 4) {
    const double unit = std::pow(10, -decimals);
    return QString::number(std::abs(value) < unit / 2 ? 0 : value, 'f', decimals); // no −0
}

QString count(std::uint64_t samples) {
    if (samples >= 1'000'000'000) return StatusLine::tr("%1 G points").arg(double(samples) / 1e9, 0, 'f', 1);
    if (samples >= 1'000'000)
        return StatusLine::tr("%1 M points").arg(double(samples) / 1e6, 0, 'f', samples < 10'000'000 ? 1 : 0);
    if (samples == 1) return StatusLine::tr("1 point");
    return StatusLine::tr("%1 points").arg(QLocale::c().toString(qulonglong(samples)));
}

// One line that ends in dots where there is no room for all of it.
class ReadOut : public QLabel {
protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const QRect room = contentsRect();
        style()->drawItemText(&painter, room, int(alignment()), palette(), isEnabled(),
                              fontMetrics().elidedText(text(), Qt::ElideRight, room.width()),
                              foregroundRole());
    }
};

QString verdictText(const ifs::Existence& existence) {
    const QString factor = QString::number(existence.contractivity, 'f', 4);
    switch (existence.verdict) {
    case ifs::Verdict::Hyperbolic:
        return StatusLine::tr("hyperbolic, s = %1").arg(factor);
    case ifs::Verdict::EventuallyContractive:
        return StatusLine::tr("eventually contractive, γ = %1 (words of %2 maps)")
            .arg(factor)
            .arg(existence.wordLength);
    case ifs::Verdict::None: {
        QStringList word;
        for (int symbol : existence.witness)
            word << QString::number(symbol + 1);
        if (word.size() == 1)
            return StatusLine::tr("no attractor: map %1 does not contract").arg(word.first());
        return StatusLine::tr("no attractor: the word %1 does not contract").arg(word.join(u' '));
    }
    case ifs::Verdict::Undecided:
        return StatusLine::tr("existence of an attractor undecided");
    case ifs::Verdict::Empty:
        return StatusLine::tr("no map takes part");
    }
    return {};
}

} // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent),
      m_pointer(explained(
          new ReadOut, tr("Pointer position"),
          tr("World and barycentric coordinates of the pointer; the address of the point of the attractor "
             "under it, outermost map first, and the fixed point of its branch"))),
      m_verdict(explained(selectable(new QLabel), tr("Verdict"),
                          tr("Whether the system has an attractor, and the factor by which it contracts"))),
      m_frame(explained(selectable(new QLabel), tr("Picture"),
                        tr("Points drawn so far and the time of the last pass"))) {
    QFont digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    digits.setPointSizeF(font().pointSizeF() * 0.95);
    m_pointer->setFont(digits);
    m_frame->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setSizeGripEnabled(false);
    setContentsMargins(8, 0, 8, 0);
    m_frame->setContentsMargins(12, 0, 0, 0);
    m_pointer->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long address needs no window
    addWidget(m_pointer, 1);
    addPermanentWidget(m_verdict);
    addPermanentWidget(m_frame);
    connect(this, &QStatusBar::messageChanged, this, [this] { m_toRead.setRemainingTime(toRead); });
}

void StatusLine::showPointer(const view::PointerPosition& position) {
    if (m_toRead.hasExpired()) clearMessage(); // what was said gives way once it could be read
    QString text = QStringLiteral("x %1  y %2").arg(fixed(position.world.x()), fixed(position.world.y()));
    if (position.barycentric) {
        QStringList coordinates;
        for (double coordinate : *position.barycentric)
            coordinates << fixed(coordinate, 3);
        text += tr("  barycentric (%1)").arg(coordinates.join(QStringLiteral(", ")));
    }
    if (!position.address.empty()) {
        text += tr("  address %1").arg(document::addressText(position.address, 8));
        if (position.fixedPoint)
            text +=
                tr("  fixed point of %1 (%2, %3)")
                    .arg(document::addressText(position.address, position.fixedLength).remove(u'…').trimmed(),
                         fixed(position.fixedPoint->x()), fixed(position.fixedPoint->y()));
    }
    m_pointer->setText(text);
}

void StatusLine::clearPointer() {
    m_pointer->clear();
}

void StatusLine::showVerdict(const document::Fractal& fractal) {
    if (!document::system2(fractal)) m_frame->clear();  // nothing is drawn of it
    if (const auto* plane = document::system2(fractal)) // as displayed, which is what the analysis speaks of
        m_verdict->setText(verdictText(
            ifs::classify<2>(ifs::activeMaps(document::effectiveSystem(fractal).value_or(*plane)).maps)));
    else if (document::dimension(fractal) == 3)
        m_verdict->setText(tr("3D: not yet shown"));
    else
        m_verdict->setText(tr("this entry could not be read"));
}

void StatusLine::showFrame(const attractor::Frame& frame) {
    const QString time = tr("%1 ms").arg(frame.milliseconds, 0, 'f', 1);
    m_frame->setText(frame.samples > 0 ? tr("%1 · %2").arg(count(frame.samples), time) : time);
    m_frame->setMinimumWidth(std::max(m_frame->minimumWidth(), m_frame->sizeHint().width()));
}
