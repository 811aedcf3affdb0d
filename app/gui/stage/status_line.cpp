// SPDX-License-Identifier: MIT
#include "stage/status_line.h"

#include "canvas/geometry/coordinate_text.h"
#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/links/linked_existence.h"
#include "io/report/verdicts.h"
#include "widgets/numbers/number_text.h"
#include "widgets/text/elided_label.h"
#include "widgets/text/tooltip_text.h"

#include <QAccessible>
#include <QCoreApplication>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QStyleOption>
#include <QToolTip>
#include <QUndoStack>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

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
QString fixed(double value, int decimals) {
    const double unit = std::pow(10, -decimals);
    return QString::number(std::abs(value) < unit / 2 ? 0 : value, 'f', decimals); // avoids −0
}

QString count(std::uint64_t samples) {
    if (samples >= 1'000'000'000) return StatusLine::tr("%1 G points").arg(double(samples) / 1e9, 0, 'f', 1);
    if (samples >= 1'000'000)
        return StatusLine::tr("%1 M points").arg(double(samples) / 1e6, 0, 'f', samples < 10'000'000 ? 1 : 0);
    if (samples == 1) return StatusLine::tr("1 point");
    return StatusLine::tr("%1 points").arg(view::groupedNumber(double(samples)));
}

template <int Dim> QString verdictText(const ifs::ActiveMaps<Dim>& active) {
    const ifs::Existence existence = ifs::classifyLinked<Dim>(active);
    const QString verdict = io::verdictText(existence, active.index);
    return existence.exists() ? verdict : StatusLine::tr("attractor: %1").arg(verdict);
}

} // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent),
      m_pointer(
          explained(new view::ElidedLabel, tr("Pointer position"),
                    tr("Plane and barycentric coordinates of the pointer; the address of the point of the "
                       "attractor under it, outermost map first, and the fixed point of its branch"))),
      m_recovery(explained(
          new QLabel(tr("latest changes not yet kept for recovery")),
          tr("latest changes not yet kept for recovery"),
          tr("A crash would lose your latest changes: keeping them takes longer than two seconds, because "
             "the disk is slow or full or the file is very large. Save what you do not want to lose."))),
      m_rotation(explained(new QLabel, tr("Rotation of the view"),
                           tr("How far the view is turned, counter-clockwise; choose View, Rotate View, "
                              "Reset Rotation to return it to upright"))),
      m_verdict(explained(selectable(new QLabel), tr("Existence of an attractor"),
                          tr("Whether the system has an attractor, and its contraction factor"))),
      m_frame(explained(selectable(new QLabel), tr("Picture"),
                        tr("Points drawn so far and the time of the last pass"))) {
    QFont digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    digits.setPointSizeF(font().pointSizeF() * 0.95);
    m_pointer->setFont(digits);
    m_frame->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setSizeGripEnabled(false);
    setContentsMargins(8, 0, 8, 0);
    m_frame->setContentsMargins(12, 0, 0, 0);
    addWidget(m_pointer, 1);
    m_recovery->hide();
    addPermanentWidget(m_recovery);
    m_rotation->hide();
    addPermanentWidget(m_rotation);
    addPermanentWidget(m_verdict);
    addPermanentWidget(m_frame);
    connect(this, &QStatusBar::messageChanged, this, &StatusLine::noteMessage);
    QCoreApplication::instance()->installEventFilter(this);
}

void StatusLine::follow(document::Document& document) {
    connect(&document, &document::Document::changed, this,
            [this](const document::Change& change) { m_isLive = change.live; });
    connect(document.undoStack(), &QUndoStack::indexChanged, this, &StatusLine::takeStep);
}

void StatusLine::noteMessage() {
    m_toRead.setRemainingTime(toRead);
    m_isOfDrag = m_isLive;
    m_isNew = true;
    QMetaObject::invokeMethod(
        this, [this] { m_isNew = false; }, Qt::QueuedConnection);
}

// A step may be made before its message or after it.
void StatusLine::takeStep() {
    if (!m_isNew && !std::exchange(m_isOfDrag, false)) clearMessage();
}

// Sees keys before their receivers, so that messages about a key stay. Of a shortcut only the question
// whether somebody needs the key is seen; the parents of the widget are asked after it.
bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!isKey || !watched->isWidgetType() || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return QStatusBar::eventFilter(watched, event);
    const auto* widget = static_cast<QWidget*>(watched);
    const QWidget* focused = widget->window()->focusWidget();
    if (widget->window() == window() && (widget == focused || !focused)) clearMessage();
    return QStatusBar::eventFilter(watched, event);
}

QRect StatusLine::messageRoom() const {
    constexpr int inset = 6;
    int left = inset;
    int right = width() - inset;
    for (const QWidget* each : {m_recovery, m_rotation, m_verdict, m_frame}) {
        if (!each->isVisible()) continue;
        if (isRightToLeft())
            left = std::max(left, each->geometry().right() + inset);
        else
            right = std::min(right, each->geometry().left() - inset);
    }
    return {left, 0, std::max(0, right - left), height()};
}

QString StatusLine::shownMessage() const {
    return fontMetrics().elidedText(currentMessage(), Qt::ElideRight, messageRoom().width());
}

// Qt's own cuts a message off in the middle of a letter.
void StatusLine::paintEvent(QPaintEvent* event) {
    if (currentMessage().isEmpty()) return QStatusBar::paintEvent(event);
    QPainter painter(this);
    QStyleOption option;
    option.initFrom(this);
    style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
    style()->drawItemText(&painter, messageRoom(), int(Qt::AlignLeading | Qt::AlignVCenter), palette(),
                          isEnabled(), shownMessage(), QPalette::WindowText);
}

bool StatusLine::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && shownMessage() != currentMessage()) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (messageRoom().contains(help->pos()))
            QToolTip::showText(help->globalPos(), view::tooltipText(currentMessage()), this);
        return true;
    }
    return QStatusBar::event(event);
}

// Never becomes lower than it was: the picture would move.
void StatusLine::resizeEvent(QResizeEvent* event) {
    QStatusBar::resizeEvent(event);
    setMinimumHeight(std::max(minimumHeight(), height()));
}

void StatusLine::showPointer(const view::PointerPosition& position) {
    if (m_toRead.hasExpired()) clearMessage(); // gives way once it could be read
    const view::CoordinateText x(position.camera, 0), y(position.camera, 1);
    QString text = QStringLiteral("x %1  y %2").arg(x.text(position.world.x()), y.text(position.world.y()));
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
                         x.text(position.fixedPoint->x()), y.text(position.fixedPoint->y()));
    }
    m_pointer->setText(text);
}

void StatusLine::showSpacePointer(const view::SpacePosition& position) {
    if (m_toRead.hasExpired()) clearMessage();
    const ifs::Vector<3>& at = position.world;
    // Number of decimals that distinguish neighbouring pixels.
    const int decimals = std::clamp(int(std::ceil(-std::log10(position.unitsPerPixel))) + 1, 0, 15);
    QString text = QStringLiteral("x %1  y %2  z %3")
                       .arg(fixed(at.x(), decimals), fixed(at.y(), decimals), fixed(at.z(), decimals));
    if (position.barycentric) {
        QStringList coordinates;
        for (double coordinate : *position.barycentric)
            coordinates << fixed(coordinate, 3);
        text += tr("  barycentric (%1)").arg(coordinates.join(QStringLiteral(", ")));
    }
    if (!position.address.empty()) text += tr("  address %1").arg(document::addressText(position.address, 8));
    if (position.direction)
        text += tr("  azimuth %1°  elevation %2°")
                    .arg(fixed(position.direction->azimuth, 1), fixed(position.direction->elevation, 1));
    if (position.onAttractor) text += tr("  depth %1").arg(fixed(position.depth, decimals));
    const QString axis(QChar(u'X' + position.lock.axis));
    if (position.lock.kind == view::AxisLock::Kind::Axis) text += tr("  along %1").arg(axis);
    if (position.lock.kind == view::AxisLock::Kind::Plane) text += tr("  across %1").arg(axis);
    if (position.lock.kind == view::AxisLock::Kind::Normal) text += tr("  along the normal");
    m_pointer->setText(text);
}

void StatusLine::clearPointer() {
    m_pointer->clear();
}

void StatusLine::showVerdict(const document::Fractal& fractal) {
    if (!document::system2(fractal)) m_frame->clear(); // not drawn
    // Displayed system, which is what the analysis describes.
    if (const auto* plane = document::system2(fractal))
        m_verdict->setText(verdictText(ifs::activeMaps(document::effectiveSystem(fractal).value_or(*plane))));
    else if (const auto* space = document::system3(fractal))
        m_verdict->setText(verdictText(ifs::activeMaps(*space)));
    else
        m_verdict->setText(tr("this entry could not be read"));
}

void StatusLine::showTime(double milliseconds) {
    m_frame->setText(tr("%1 ms").arg(milliseconds, 0, 'f', 1));
}

void StatusLine::showFrame(const attractor::Frame& frame) {
    const QString time = tr("%1 ms").arg(frame.milliseconds, 0, 'f', 1);
    m_frame->setText(frame.samples > 0 ? tr("%1 · %2").arg(count(frame.samples), time) : time);
    m_frame->setMinimumWidth(std::max(m_frame->minimumWidth(), m_frame->sizeHint().width()));
}

void StatusLine::showRotation(double degrees) {
    m_rotation->setText(tr("rotated %1°").arg(view::shortNumber(std::round(degrees * 10) / 10)));
    m_rotation->setVisible(degrees != 0);
}

void StatusLine::showRecovery(bool isLate) {
    m_recovery->setVisible(isLate);
    if (!isLate) return;
    QAccessibleEvent event(m_recovery, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}
