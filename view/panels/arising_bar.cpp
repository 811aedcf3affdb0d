// SPDX-License-Identifier: MIT
#include "panels/arising_bar.h"

#include "arising.h"
#include "icon.h"
#include "panels/number_text.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStackedWidget>
#include <QToolButton>

#include <tuple>

namespace view {

namespace {

using Mode = Arising::Mode;

constexpr int fewLetters = 18; // of a count, in a narrow window

QString superscript(int n) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text;
    for (const QChar digit : QString::number(n))
        text += digits[digit.digitValue()];
    return text;
}

} // namespace

ArisingBar::ArisingBar(Arising* arising, QWidget* parent)
    : QWidget(parent),
      m_arising(arising),
      m_modes(new QButtonGroup(this)),
      m_pages(new QStackedWidget(this)) {
    setAccessibleName(tr("How the attractor arises"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    for (const auto& [mode, name, tip] :
         {std::tuple{Mode::Density, tr("Density"), tr("The invariant measure, refined while nothing moves")},
          std::tuple{Mode::Steps, tr("Steps Wⁿ"),
                     tr("The deterministic algorithm: all maps applied n times to the cage at rest")},
          std::tuple{
              Mode::ChaosGame, tr("Chaos Game"),
              tr("One point that jumps by maps drawn at random; the first 14 points are not plotted")}}) {
        auto* made = new QToolButton(this);
        made->setText(name);
        made->setToolTip(tip);
        made->setCheckable(true);
        made->setAutoRaise(true);
        m_modes->addButton(made, int(mode));
        layout->addWidget(made);
    }
    layout->addSpacing(12);
    m_pages->addWidget(new QWidget(this));
    m_pages->addWidget(makeSteps());
    m_pages->addWidget(makeChaosGame());
    layout->addWidget(m_pages, 1);
    connect(m_modes, &QButtonGroup::idClicked, this, [this](int mode) { m_arising->setMode(Mode(mode)); });
    connect(arising, &Arising::changed, this, &ArisingBar::follow);
    follow();
}

QToolButton* ArisingBar::button(const QString& iconName, const QString& text, const QString& tip) {
    auto* made = new QToolButton(this);
    made->setIcon(icon(iconName));
    made->setIconSize({18, 18});
    made->setAutoRaise(true);
    made->setAccessibleName(text);
    made->setToolTip(tip);
    return made;
}

QWidget* ArisingBar::makeSteps() {
    auto* page = new QWidget(this);
    m_steps = new QSlider(Qt::Horizontal, page);
    m_steps->setAccessibleName(tr("n: how often all maps are applied"));
    m_steps->setWhatsThis(tr("How often all maps are applied to the cage: 0 is the cage itself, and with "
                             "every step the picture comes closer to the attractor."));
    m_steps->setPageStep(1);
    m_steps->setTickPosition(QSlider::TicksBelow);
    m_steps->setTickInterval(1);
    m_steps->setMaximumWidth(360);
    m_copies = new QLabel(page);
    m_copies->setMinimumWidth(fewLetters * fontMetrics().averageCharWidth());
    auto* layout = new QHBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    layout->addWidget(m_steps, 1);
    layout->addWidget(m_copies);
    layout->addStretch();
    connect(m_steps, &QSlider::valueChanged, m_arising, &Arising::setStep);
    return page;
}

QWidget* ArisingBar::makeChaosGame() {
    auto* page = new QWidget(this);
    auto* again = button(QStringLiteral("restart"), tr("Begin Again"), tr("No points yet, and other dice"));
    auto* one = button(QStringLiteral("step"), tr("One Point"), tr("Plot one more point"));
    m_run = button(QStringLiteral("play"), tr("Start"), tr("Let points appear"));
    m_speed = new QComboBox(page);
    m_speed->setAccessibleName(tr("Points a second"));
    m_speed->setWhatsThis(tr("How many points the chaos game plots in a second."));
    for (const int speed : {1, 10, 100, 1'000, 10'000, 100'000})
        m_speed->addItem(tr("%1 a second").arg(groupedNumber(speed)), double(speed));
    m_speed->setCurrentIndex(m_speed->findData(m_arising->speed()));
    m_count = new QLabel(page);
    m_count->setMinimumWidth(fewLetters * fontMetrics().averageCharWidth());
    auto* layout = new QHBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(again);
    layout->addWidget(one);
    layout->addWidget(m_run);
    layout->addSpacing(8);
    layout->addWidget(m_speed);
    layout->addSpacing(12);
    layout->addWidget(m_count);
    layout->addStretch();
    connect(again, &QToolButton::clicked, m_arising, &Arising::startAgain);
    connect(one, &QToolButton::clicked, m_arising, &Arising::plotOne);
    connect(m_run, &QToolButton::clicked, this, [this] { m_arising->setRunning(!m_arising->isRunning()); });
    connect(m_speed, &QComboBox::activated, this,
            [this] { m_arising->setSpeed(m_speed->currentData().toDouble()); });
    return page;
}

void ArisingBar::follow() {
    const int mode = int(m_arising->mode());
    m_modes->button(mode)->setChecked(true);
    m_pages->setCurrentIndex(mode);
    {
        const QSignalBlocker quiet(m_steps);
        m_steps->setRange(0, m_arising->deepest());
        m_steps->setValue(m_arising->step());
    }
    const double copies = m_arising->copies();
    m_copies->setText(
        copies == 1
            ? tr("W%1: the cage itself").arg(superscript(m_arising->step()))
            : tr("W%1: %2 copies of the cage").arg(superscript(m_arising->step()), groupedNumber(copies)));
    const bool running = m_arising->isRunning();
    m_run->setIcon(icon(running ? QStringLiteral("pause") : QStringLiteral("play")));
    m_run->setAccessibleName(running ? tr("Pause") : tr("Start"));
    m_run->setToolTip(running ? tr("Stay at these points") : tr("Let points appear"));
    QString count = tr("%1 points").arg(groupedNumber(double(m_arising->points())));
    if (m_arising->points() == 1) count = tr("1 point");
    if (const auto map = m_arising->lastMap(); map && !running)
        count += tr(", the last by map %1").arg(*map + 1);
    if (m_arising->points() == 0 && !running) count = tr("no points yet: press ▶");
    m_count->setText(count);
}

} // namespace view
