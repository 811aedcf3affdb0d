// SPDX-License-Identifier: MIT
#include "bars/construction_bar.h"

#include "bridges/construction.h"
#include "widgets/flat_buttons.h"
#include "widgets/icon.h"
#include "widgets/number_text.h"

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

using Mode = Construction::Mode;

constexpr int fewLetters = 18; // of a count, in a narrow window

QString superscript(int n) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text;
    for (const QChar digit : QString::number(n))
        text += digits[digit.digitValue()];
    return text;
}

} // namespace

ConstructionBar::ConstructionBar(Construction* construction, QWidget* parent)
    : QWidget(parent),
      m_construction(construction),
      m_modes(new QButtonGroup(this)),
      m_pages(new QStackedWidget(this)) {
    setAccessibleName(tr("How the attractor is built"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    for (const auto& [mode, name, tip] :
         {std::tuple{Mode::Density, tr("Density"), tr("The invariant measure, refined while nothing moves")},
          std::tuple{Mode::Steps, tr("Steps Wⁿ"),
                     tr("The deterministic algorithm: all maps applied n times to the cage at rest")},
          std::tuple{
              Mode::ChaosGame, tr("Chaos Game"),
              tr("One point that jumps by maps chosen at random; the first 14 points are not plotted")}}) {
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
    connect(m_modes, &QButtonGroup::idClicked, this,
            [this](int mode) { m_construction->setMode(Mode(mode)); });
    connect(construction, &Construction::changed, this, &ConstructionBar::follow);
    follow();
}

QWidget* ConstructionBar::makeSteps() {
    auto* page = new QWidget(this);
    m_steps = new QSlider(Qt::Horizontal, page);
    m_steps->setAccessibleName(tr("n: how many times all maps are applied"));
    m_steps->setWhatsThis(tr("How many times all maps are applied to the cage: 0 is the cage itself, and "
                             "with every step the picture gets closer to the attractor."));
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
    connect(m_steps, &QSlider::valueChanged, m_construction, &Construction::setStep);
    return page;
}

QWidget* ConstructionBar::makeChaosGame() {
    auto* page = new QWidget(this);
    auto* again = flatButton(QStringLiteral("restart"), tr("Restart"),
                             tr("Clear the points and start with new random numbers"), this);
    auto* one = flatButton(QStringLiteral("step"), tr("One Point"), tr("Plot one more point"), this);
    m_run = flatButton(QStringLiteral("play"), tr("Play"), tr("Plot points continuously"), this);
    m_speed = new QComboBox(page);
    m_speed->setAccessibleName(tr("Points per second"));
    m_speed->setWhatsThis(tr("How many points the chaos game plots per second."));
    for (const int speed : {1, 10, 100, 1'000, 10'000, 100'000})
        m_speed->addItem(tr("%1 per second").arg(groupedNumber(speed)), double(speed));
    m_speed->setCurrentIndex(m_speed->findData(m_construction->speed()));
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
    connect(again, &QToolButton::clicked, m_construction, &Construction::startAgain);
    connect(one, &QToolButton::clicked, m_construction, &Construction::plotOne);
    connect(m_run, &QToolButton::clicked, this,
            [this] { m_construction->setRunning(!m_construction->isRunning()); });
    connect(m_speed, &QComboBox::activated, this,
            [this] { m_construction->setSpeed(m_speed->currentData().toDouble()); });
    return page;
}

void ConstructionBar::follow() {
    const int mode = int(m_construction->mode());
    m_modes->button(mode)->setChecked(true);
    m_pages->setCurrentIndex(mode);
    {
        const QSignalBlocker quiet(m_steps);
        m_steps->setRange(0, m_construction->deepest());
        m_steps->setValue(m_construction->step());
    }
    const double copies = m_construction->copies();
    m_copies->setText(copies == 1 ? tr("W%1: the cage itself").arg(superscript(m_construction->step()))
                                  : tr("W%1: %2 copies of the cage")
                                        .arg(superscript(m_construction->step()), groupedNumber(copies)));
    if (const int speed = m_speed->findData(m_construction->speed()); speed >= 0)
        m_speed->setCurrentIndex(speed);
    const bool running = m_construction->isRunning();
    m_run->setIcon(icon(running ? QStringLiteral("pause") : QStringLiteral("play")));
    m_run->setAccessibleName(running ? tr("Pause") : tr("Play"));
    m_run->setToolTip(running ? tr("Stop at these points") : tr("Plot points continuously"));
    QString count = tr("%1 points").arg(groupedNumber(double(m_construction->points())));
    if (m_construction->points() == 1) count = tr("1 point");
    if (const auto map = m_construction->lastMap(); map && !running)
        count += tr(", the last by map %1").arg(*map + 1);
    if (m_construction->points() == 0 && !running) count = tr("no points yet: press Play (▶)");
    m_count->setText(count);
}

} // namespace view
