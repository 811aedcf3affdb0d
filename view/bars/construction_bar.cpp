// SPDX-License-Identifier: MIT
#include "bars/construction_bar.h"

#include "bars/die.h"
#include "bars/start_shape_box.h"
#include "bridges/construction.h"
#include "widgets/choices.h"
#include "widgets/flat_buttons.h"
#include "widgets/icon.h"
#include "widgets/numbers/number_text.h"
#include "widgets/text/elided_label.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QStackedWidget>
#include <QToolButton>

#include <tuple>

namespace view {

namespace {

using Mode = Construction::Mode;

constexpr int fewLetters = 8;   // letters of a count, in a narrow window
constexpr double readable = 10; // jumps per second at which each can be seen

QString superscript(int n) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text;
    for (const QChar digit : QString::number(n))
        text += digits[digit.digitValue()];
    return text;
}

QString digits(double value) {
    return QString::number(value, 'g', 3);
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
          std::tuple{Mode::Steps, tr("Step by Step"),
                     tr("All maps at once, applied n times to the cage or another shape (Wⁿ)")},
          std::tuple{
              Mode::ChaosGame, tr("Chaos Game"),
              tr("One point that jumps by maps chosen at random; the first 14 points are not plotted")}}) {
        auto* made = new QToolButton(this);
        made->setText(name);
        made->setToolTip(tip);
        made->setCheckable(true);
        made->setAutoRaise(true);
        made->setMinimumWidth(fewLetters * fontMetrics().averageCharWidth()); // its words are elided
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
    m_steps->setWhatsThis(tr("How many times all maps are applied: 0 is the starting shape, and with every "
                             "step the picture gets closer to the attractor. Each image has the colour "
                             "of its outermost map."));
    m_steps->setPageStep(1);
    m_steps->setTickPosition(QSlider::TicksBelow);
    m_steps->setTickInterval(1);
    m_steps->setMaximumWidth(240);
    m_start = new StartShapeBox(&m_construction->steps(), page);
    m_facts = new ElidedLabel(page);
    m_facts->setMinimumWidth(fewLetters * fontMetrics().averageCharWidth());
    auto* layout = new QHBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    layout->addWidget(m_start);
    layout->addWidget(m_steps, 1);
    layout->addWidget(m_facts, 2);
    connect(m_steps, &QSlider::valueChanged, m_construction, &Construction::setStep);
    return page;
}

QWidget* ConstructionBar::makeChaosGame() {
    auto* page = new QWidget(this);
    auto* again = flatButton(QStringLiteral("restart"), tr("Restart"),
                             tr("Clear the points and start with new random numbers"), this);
    auto* one = flatButton(QStringLiteral("step"), tr("One Jump"), tr("Roll the die once and jump"), this);
    m_run = flatButton(QStringLiteral("play"), tr("Play"), tr("Plot points continuously"), this);
    m_speed = new QComboBox(page);
    m_speed->setAccessibleName(tr("Jumps per second"));
    m_speed->setWhatsThis(tr("How many jumps the chaos game makes per second. At up to ten per second, the "
                             "die shows each map that is rolled."));
    for (const int speed : {1, 10, 100, 1'000, 10'000, 100'000})
        addChoice(m_speed, tr("%1/s", "jumps per second").arg(groupedNumber(speed)), double(speed));
    m_speed->setMinimumWidth(fewLetters * fontMetrics().averageCharWidth());
    chooseValue(m_speed, m_construction->speed());
    m_die = new Die(page);
    m_count = new ElidedLabel(page);
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
    layout->addWidget(m_die);
    layout->addSpacing(8);
    layout->addWidget(m_count, 1);
    connect(again, &QToolButton::clicked, m_construction, &Construction::startAgain);
    connect(one, &QToolButton::clicked, m_construction, &Construction::jumpOnce);
    connect(m_run, &QToolButton::clicked, this,
            [this] { m_construction->setRunning(!m_construction->isRunning()); });
    connect(m_speed, &QComboBox::activated, this,
            [this] { m_construction->setSpeed(chosenValue<double>(m_speed)); });
    return page;
}

void ConstructionBar::follow() {
    const int mode = int(m_construction->mode());
    m_modes->button(mode)->setChecked(true);
    m_pages->setCurrentIndex(mode);
    followSteps();
    followChaosGame();
}

void ConstructionBar::followSteps() {
    {
        const QSignalBlocker quiet(m_steps);
        m_steps->setRange(0, m_construction->deepest());
        m_steps->setValue(m_construction->step());
    }
    const double copies = m_construction->copies();
    const QString step = superscript(m_construction->step());
    const bool isCage = m_construction->steps().start() == StepsBridge::Start::Cage;
    QStringList facts;
    if (copies == 1)
        facts << (isCage ? tr("W%1: the cage itself").arg(step) : tr("W%1: the start").arg(step));
    else
        facts << (isCage ? tr("W%1: %2 copies of the cage") : tr("W%1: %2 copies"))
                     .arg(step, groupedNumber(copies));
    facts << distanceText();
    facts.removeAll(QString());
    m_facts->setText(facts.join(QStringLiteral(" · ")));
    QString tip = tr("The Hausdorff distance from the picture to the attractor A, and its upper bound");
    if (const auto& distance = m_construction->steps().distance(); distance && distance->distance)
        tip =
            tr("The Hausdorff distance from Wⁿ(B) to the attractor A, measured on cells of side %1. It is at "
               "most sⁿ times the distance from the start B to A, where s = %2 is the largest contraction "
               "factor of the maps.")
                .arg(digits(distance->cell), roundedNumber(distance->contraction, maxDecimals));
    m_facts->setToolTip(m_facts->text() + QStringLiteral("\n\n") + tip); // full text for narrow windows
    m_facts->setWhatsThis(tip);
}

QString ConstructionBar::distanceText() const {
    const StepsBridge& steps = m_construction->steps();
    if (!steps.flaw().isEmpty()) return steps.flaw();
    const auto& distance = steps.distance();
    if (!distance) return {};
    if (!(distance->contraction < 1))
        return tr("no bound: a map has the contraction factor %1")
            .arg(roundedNumber(distance->contraction, maxDecimals));
    if (!distance->distance) return {};
    const double resolution = 2 * distance->cell; // limit below which cells tell nothing apart
    if (*distance->bound < resolution) return tr("distance to A at most %1").arg(digits(*distance->bound));
    if (*distance->distance < resolution)
        return tr("distance to A < %1, at most %2").arg(digits(resolution), digits(*distance->bound));
    return tr("distance to A ≈ %1, at most %2").arg(digits(*distance->distance), digits(*distance->bound));
}

void ConstructionBar::followChaosGame() {
    if (const int speed = m_speed->findData(m_construction->speed()); speed >= 0)
        m_speed->setCurrentIndex(speed);
    const bool running = m_construction->isRunning();
    m_run->setIcon(icon(running ? QStringLiteral("pause") : QStringLiteral("play")));
    m_run->setAccessibleName(running ? tr("Pause") : tr("Play"));
    m_run->setToolTip(running ? tr("Stop at these points") : tr("Plot points continuously"));
    const auto map = running && m_construction->speed() > readable ? std::nullopt : m_construction->lastMap();
    m_die->setFaces(m_construction->faces());
    m_die->setFallen(map);
    const auto jumps = double(m_construction->jumps());
    const auto dropped = double(Construction::dropped);
    QString count = tr("%1 points").arg(groupedNumber(double(m_construction->points())));
    if (m_construction->points() == 1) count = tr("1 point");
    if (jumps > 0 && jumps <= dropped)
        count = tr("jump %1 of the %2 that are not plotted").arg(jumps).arg(dropped);
    if (map) count += tr(", the last by map %1").arg(*map + 1);
    if (jumps == 0 && !running) count = tr("no points yet: press Play (▶)");
    m_count->setText(count);
    m_count->setToolTip(count); // full text for narrow windows
}

} // namespace view
