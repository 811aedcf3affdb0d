// SPDX-License-Identifier: MIT
#include "panels/timeline/transport_bar.h"

#include "animation/frame_rate.h"
#include "panels/timeline/timeline.h"
#include "widgets/choices.h"
#include "widgets/document_undo.h"
#include "widgets/flat_buttons.h"
#include "widgets/icon.h"
#include "widgets/numbers/number_box.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <chrono>
#include <optional>
#include <tuple>

namespace view {

namespace {

constexpr std::chrono::milliseconds countEvery{500};
constexpr const char* usualRates[] = {"12", "23.976", "24", "25", "29.97", "30", "50", "59.94", "60"};

QSpinBox* spinBox(const QString& name, const QString& explanation, int min, int max) {
    auto* box = new WholeNumberBox;
    box->setRange(min, max);
    box->setKeyboardTracking(false);
    leaveUndoToDocument(box);
    box->setAccessibleName(name);
    box->setToolTip(explanation);
    return box;
}

QLabel* labelled(const QString& text, QWidget* field, QHBoxLayout* row) {
    auto* label = new QLabel(text);
    label->setBuddy(field);
    row->addWidget(label);
    row->addWidget(field);
    row->addSpacing(8);
    return label;
}

// With a comma, as many keyboards have it.
std::optional<animation::FrameRate> typedRate(QString text) {
    return animation::parseRate(text.trimmed().replace(u',', u'.').toStdString());
}

QString shownRate(const animation::FrameRate& rate) {
    return QString::fromStdString(animation::rateText(rate));
}

} // namespace

TransportBar::TransportBar(Timeline* timeline, QWidget* last, QWidget* parent)
    : QWidget(parent),
      m_timeline(timeline),
      m_play(flatButton(QStringLiteral("play"), tr("Play"), tr("Play the animation"), this)),
      m_frame(spinBox(tr("Frame"), tr("The frame that is shown and edited"), 0, animation::maxLength)),
      m_length(spinBox(tr("Length"), tr("The length of the animation in frames"), 1, animation::maxLength)),
      m_rate(new QComboBox(this)),
      m_loop(new QComboBox(this)),
      m_pictures(new QLabel(this)) {
    auto* previous = flatButton(QStringLiteral("key-previous"), tr("Previous Key"),
                                tr("Move the playhead to the previous key"), this);
    auto* next =
        flatButton(QStringLiteral("key-next"), tr("Next Key"), tr("Move the playhead to the next key"), this);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    row->addWidget(previous);
    row->addWidget(m_play);
    row->addWidget(next);
    row->addSpacing(8);
    m_dispensable << m_pictures;
    m_dispensable << labelled(tr("Frame:"), m_frame, row) << labelled(tr("Length:"), m_length, row)
                  << labelled(tr("fps:"), m_rate, row) << labelled(tr("Loop:"), m_loop, row);
    m_dispensable << m_rate << m_length << m_loop << last;
    row->addWidget(m_pictures);
    row->addStretch(1);
    row->addWidget(last);
    QWidget* before = nullptr; // on the way of Tab, which goes as the fields are seen
    for (int i = 0; i < row->count(); ++i) {
        QWidget* part = row->itemAt(i)->widget();
        if (!part || part->focusPolicy() == Qt::NoFocus) continue;
        if (before) setTabOrder(before, part);
        before = part;
    }
    makeRate();
    makeFields();
    connect(previous, &QToolButton::clicked, timeline, [timeline] { timeline->stepToKey(-1); });
    connect(next, &QToolButton::clicked, timeline, [timeline] { timeline->stepToKey(1); });
    connect(m_play, &QToolButton::clicked, timeline,
            [timeline] { timeline->playback().setPlaying(!timeline->playback().isPlaying()); });
    connect(timeline, &Timeline::changed, this, &TransportBar::showAnimation);
    connect(timeline, &Timeline::frameChanged, this, &TransportBar::showFrame);
    connect(&timeline->playback(), &Playback::playingChanged, this, &TransportBar::showPlaying);
    m_count.setInterval(countEvery);
    connect(&m_count, &QTimer::timeout, this, &TransportBar::showRate);
    showAnimation();
    showFrame();
}

QSize TransportBar::minimumSizeHint() const {
    return {m_play->sizeHint().width() * 3 + m_frame->sizeHint().width() + 40, sizeHint().height()};
}

void TransportBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitInto(width());
}

void TransportBar::fitInto(int width) {
    for (QWidget* part : m_dispensable)
        part->show();
    for (QWidget* part : m_dispensable) {
        if (layout()->minimumSize().width() <= width) return;
        part->hide();
    }
}

void TransportBar::makeRate() {
    m_rate->setAccessibleName(tr("Frames per second"));
    m_rate->setToolTip(tr("The number of frames played per second"));
    m_rate->setWhatsThis(
        tr("The number of frames played per second: a number or a fraction, such as 24, 12.5 "
           "or 30000/1001. 29.97 stands for the latter, the rate of television."));
    m_rate->setEditable(true);
    m_rate->setInsertPolicy(QComboBox::NoInsert);
    m_rate->setCompleter(nullptr); // 2 is a rate, not the beginning of another one
    m_rate->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_rate->setMinimumContentsLength(6);
    for (const char* rate : usualRates)
        m_rate->addItem(QLatin1String(rate));
    leaveUndoToDocument(m_rate);
    connect(m_rate->lineEdit(), &QLineEdit::editingFinished, this, &TransportBar::takeRate);
    connect(m_rate, &QComboBox::activated, this, &TransportBar::takeRate);
    connect(m_rate->lineEdit(), &QLineEdit::textEdited, this, [this](const QString& text) {
        if (!m_hasComplained || !typedRate(text)) return;
        m_hasComplained = false;
        emit m_timeline->message({}); // the complaint is over
    });
}

void TransportBar::takeRate() {
    document::Timing timing = m_timeline->timing();
    const QString typed = m_rate->currentText().trimmed();
    if (typed == shownRate(timing.rate)) return;
    const auto rate = typedRate(typed);
    if (rate) {
        timing.rate = *rate;
        m_timeline->setTiming(tr("Frames per second: %1").arg(shownRate(*rate)), timing);
    }
    showAnimation();
    m_hasComplained = !rate;
    if (m_hasComplained)
        emit m_timeline->message(tr("“%1” is not a frame rate. Enter frames per second, above 0 and at most "
                                    "%2, such as 24, 29.97 or 30000/1001.")
                                     .arg(typed, QString::number(animation::maxRate)));
}

void TransportBar::makeFields() {
    m_loop->setAccessibleName(tr("Loop"));
    m_loop->setToolTip(tr("What happens after the last frame"));
    m_loop->setWhatsThis(tr("Off: the animation stops at its last frame. Cycle: it starts again from frame "
                            "0. There and Back: it runs backwards to the start."));
    for (const auto& [loop, name] : {std::tuple{animation::Loop::Off, tr("Off", "loop")},
                                     {animation::Loop::Cycle, tr("Cycle")},
                                     {animation::Loop::ThereAndBack, tr("There and Back")}})
        addChoice(m_loop, name, loop);
    m_pictures->setMinimumWidth(m_pictures->fontMetrics().horizontalAdvance(tr("%1 fps").arg(000.0)));
    m_pictures->setToolTip(tr("The number of frames drawn per second during playback"));
    connect(m_frame, &QSpinBox::valueChanged, m_timeline, &Timeline::setFrame);
    connect(m_length, &QSpinBox::valueChanged, this, [this](int length) {
        document::Timing timing = m_timeline->timing();
        timing.length = length;
        m_timeline->setTiming(tr("Length of the animation: %n frame(s)", nullptr, length), timing);
    });
    connect(m_loop, &QComboBox::activated, this, [this] {
        document::Timing timing = m_timeline->timing();
        timing.loop = chosenValue<animation::Loop>(m_loop);
        m_timeline->setTiming(tr("Loop: %1").arg(m_loop->currentText()), timing);
    });
}

void TransportBar::showAnimation() {
    const document::Timing& timing = m_timeline->timing();
    const QSignalBlocker quietFrame(m_frame), quietLength(m_length), quietRate(m_rate);
    m_frame->setMaximum(m_timeline->lastFrame());
    m_length->setValue(timing.length);
    m_rate->setCurrentText(shownRate(timing.rate));
    chooseValue(m_loop, timing.loop);
    setEnabled(m_timeline->rowCount() > 0);
}

void TransportBar::showFrame() {
    const QSignalBlocker quiet(m_frame);
    m_frame->setValue(m_timeline->frame());
}

void TransportBar::showPlaying(bool playing) {
    m_play->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    m_play->setAccessibleName(playing ? tr("Pause") : tr("Play"));
    m_play->setToolTip(playing ? tr("Stop at this frame") : tr("Play the animation"));
    if (playing)
        m_count.start();
    else
        m_count.stop();
    m_pictures->clear();
}

void TransportBar::showRate() {
    const double rate = m_timeline->playback().picturesPerSecond();
    if (rate > 0) m_pictures->setText(tr("%1 fps").arg(rate, 0, 'f', 1));
}

} // namespace view
