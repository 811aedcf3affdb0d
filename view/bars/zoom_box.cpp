// SPDX-License-Identifier: MIT
#include "bars/zoom_box.h"

#include "canvas/canvas_view.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_field.h"
#include "widgets/text/tooltip_text.h"

#include <QAbstractItemView>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double maxPlain = 1e6; // per cent; greater values are shorter as powers of ten
constexpr double minGrouped = 1e4;
constexpr double fitted = 0; // replacement for a factor

const NumberRange positive{0.0, std::nullopt, NumberRange::Ends::Open};

// Digits may stand in groups, as they are shown.
QString percentIn(QString text) {
    text.removeIf([](QChar letter) { return letter == u'%' || letter.isSpace(); });
    return text;
}

} // namespace

ZoomBox::ZoomBox(CanvasView* canvas, QWidget* parent) : QComboBox(parent), m_canvas(canvas) {
    setEditable(true);
    setInsertPolicy(NoInsert);
    setCompleter(nullptr);
    setAccessibleName(tr("Zoom"));
    setToolTip(tr("Zoom in percent: 100 % shows a unit of the plane as 100 pixels; type another value, "
                  "or choose one"));
    setWhatsThis(tr("Zoom in percent: at 100 %, one unit of the plane is 100 pixels long. Type a number, or "
                    "choose a value, a saved view, or Fit, which shows the whole attractor."));
    addChoice(this, tr("Fit"), fitted);
    for (const double factor : {0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0, 1000.0})
        addChoice(this, textOf(factor), factor);
    m_factors = count();
    setMinimumContentsLength(11);
    lineEdit()->installEventFilter(this);
    setFrame(false);
    setViews({});
    connect(this, &QComboBox::activated, this, &ZoomBox::choose);
    connect(lineEdit(), &QLineEdit::returnPressed, this, &ZoomBox::takeText);
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { showProblem({}); });
    connect(lineEdit(), &QLineEdit::editingFinished, this, &ZoomBox::showZoom);
    connect(&canvas->navigation(), &CanvasNavigation::cameraChanged, this, &ZoomBox::showZoom);
    showZoom();
}

void ZoomBox::setViews(const QStringList& names) {
    const QSignalBlocker blocker(this);
    while (count() > m_factors)
        removeItem(count() - 1);
    if (!names.isEmpty()) insertSeparator(count());
    for (const QString& name : names)
        addChoice(this, name, name);
    constexpr int widest = 240; // pixels
    view()->setMinimumWidth(std::min(view()->sizeHintForColumn(0) + 24, widest));
    showZoom();
}

QString ZoomBox::textOf(double factor) {
    const double percent = 100 * factor;
    const double rounded = QString::number(percent, 'g', percent < 1000 ? 3 : 4).toDouble();
    if (rounded >= maxPlain || percent < 0.01) return tr("%1 %").arg(QString::number(percent, 'g', 3));
    return tr("%1 %").arg(rounded < minGrouped ? shortNumber(rounded) : groupedNumber(rounded));
}

void ZoomBox::choose(int index) {
    const QVariant choice = itemData(index);
    if (choice.userType() == QMetaType::QString)
        emit viewChosen(choice.toString());
    else if (choice == fitted)
        m_canvas->fit();
    else if (choice.isValid())
        m_canvas->navigation().setZoom(choice.toDouble());
    m_canvas->setFocus();
    showZoom();
}

// Takes a text with or without the percent sign.
void ZoomBox::takeText() {
    const QString text = percentIn(lineEdit()->text());
    if (const QString reason = numberProblem(text, positive); !reason.isEmpty()) return showProblem(reason);
    m_canvas->navigation().setZoom(*typedNumber(text) / 100);
    m_canvas->setFocus();
    showZoom();
}

// Esc drops the typed text, and so does whatever takes the focus.
bool ZoomBox::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    const bool isEscape = isKey && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (isEscape && event->type() == QEvent::ShortcutOverride) event->accept();
    const bool isLeft = event->type() == QEvent::FocusOut &&
                        static_cast<const QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason;
    if (isLeft || (isEscape && event->type() == QEvent::KeyPress)) {
        lineEdit()->setModified(false);
        showZoom();
    }
    if (!isEscape || event->type() != QEvent::KeyPress) return QComboBox::eventFilter(watched, event);
    m_canvas->setFocus();
    return true;
}

void ZoomBox::showProblem(const QString& reason) {
    if (reason.isEmpty() && accessibleDescription().isEmpty()) return;
    setAccessibleDescription(reason);
    QPalette colours;
    if (!reason.isEmpty()) colours.setColor(QPalette::Text, problemColour(palette()));
    lineEdit()->setPalette(colours);
    if (!reason.isEmpty() && isVisible())
        QToolTip::showText(mapToGlobal(QPoint()), tooltipText(reason), this);
}

void ZoomBox::showZoom() {
    if (lineEdit()->hasFocus() && lineEdit()->isModified()) return; // still being typed
    showProblem({});
    const QSignalBlocker blocker(this);
    setCurrentIndex(-1);
    lineEdit()->setText(textOf(m_canvas->navigation().zoom()));
}

} // namespace view
