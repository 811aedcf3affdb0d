// SPDX-License-Identifier: MIT
#include "panels/appearance/controls/appearance_slider.h"

#include "widgets/numbers/number_field.h"

#include <QHBoxLayout>
#include <QSlider>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace view {

namespace {

constexpr int positions = 400;
constexpr std::chrono::milliseconds runPause{600};

} // namespace

AppearanceSlider::AppearanceSlider(const QString& name, double min, double max, Scale scale, QWidget* parent)
    : QWidget(parent),
      m_min(min),
      m_max(max),
      m_scale(scale),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_field(new NumberField(this)) {
    m_slider->setRange(0, positions);
    m_slider->setSingleStep(4);
    m_slider->setPageStep(40);
    m_slider->setFocusPolicy(Qt::StrongFocus);
    m_slider->setAccessibleName(name);
    m_slider->setWhatsThis(tr("Drag, or use the arrow keys. The field next to it shows the same value."));
    m_field->setAccessibleName(name);
    if (scale == Scale::Logarithmic)
        m_field->setRange({0.0, std::nullopt, NumberRange::Ends::Open});
    else if (scale == Scale::Bounded)
        m_field->setRange({min, max, NumberRange::Ends::Closed});
    else
        m_field->setRange(
            {min < 0 ? std::nullopt : std::optional(min), std::nullopt, NumberRange::Ends::Closed});
    m_field->setStep(0.1);
    m_field->setFixedWidth(m_field->minimumSizeHint().width() + 14);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_field);
    m_settled.setSingleShot(true);
    m_settled.setInterval(runPause);

    connect(m_slider, &QSlider::valueChanged, this, &AppearanceSlider::slide);
    connect(m_slider, &QSlider::sliderReleased, this, &AppearanceSlider::accepted);
    connect(&m_settled, &QTimer::timeout, this, &AppearanceSlider::accepted);
    connect(m_field, &NumberField::edited, this, &AppearanceSlider::tried);
    connect(m_field, &NumberField::committed, this, &AppearanceSlider::accepted);
    connect(m_field, &NumberField::cancelled, this, &AppearanceSlider::rejected);
}

void AppearanceSlider::setRange(double min, double max) {
    m_min = min;
    m_max = max > min ? max : min + 1;
    if (m_scale == Scale::Linear) m_field->setStep((m_max - m_min) / 100);
    if (m_scale == Scale::Bounded) m_field->setRange({m_min, m_max, NumberRange::Ends::Closed});
}

void AppearanceSlider::explain(const QString& toolTip, const QString& whatsThis) {
    setToolTip(toolTip);
    setWhatsThis(whatsThis);
    m_slider->setWhatsThis(whatsThis + u' ' + m_slider->whatsThis());
}

int AppearanceSlider::positionOf(double value) const {
    const double within = std::clamp(value, m_min, m_max);
    const double share = m_scale == Scale::Logarithmic ? std::log(within / m_min) / std::log(m_max / m_min)
                                                       : (within - m_min) / (m_max - m_min);
    return static_cast<int>(std::lround(share * positions));
}

double AppearanceSlider::valueAt(int position) const {
    const double share = static_cast<double>(position) / positions;
    const double value = m_scale == Scale::Logarithmic ? m_min * std::pow(m_max / m_min, share)
                                                       : m_min + share * (m_max - m_min);
    return QString::number(value, 'g', 3).toDouble(); // no more digits than a hand can set
}

void AppearanceSlider::setValue(double value) {
    m_field->setValue(value);
    if (valueAt(m_slider->value()) == value) return; // echo of the slider's own change
    const QSignalBlocker blocker(m_slider);
    m_slider->setValue(positionOf(value));
}

void AppearanceSlider::slide(int position) {
    if (m_slider->isSliderDown())
        m_settled.stop(); // a drag continues the run and ends by itself
    else
        m_settled.start();
    emit tried(valueAt(position));
}

} // namespace view
