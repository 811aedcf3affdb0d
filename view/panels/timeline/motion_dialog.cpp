// SPDX-License-Identifier: MIT
#include "panels/timeline/motion_dialog.h"

#include "document/edits/timeline/orbit_edits.h"
#include "document/moments/animated_fractal.h"
#include "panels/timeline/orbit_rows.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_text.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr double maxDegrees = 360;
constexpr double percent = 100;
constexpr double maxPercent = 99.9;

// Either way, but never none.
class TurnsBox : public WholeNumberBox {
public:
    void stepBy(int steps) override {
        const int wanted = value() + steps;
        const bool crosses = (value() < 0) != (wanted < 0) || wanted == 0;
        WholeNumberBox::stepBy(crosses ? steps + (steps > 0 ? 1 : -1) : steps);
    }

protected:
    QValidator::State validate(QString& text, int& position) const override {
        const QValidator::State state = WholeNumberBox::validate(text, position);
        return state == QValidator::Acceptable && valueFromText(text) == 0 ? QValidator::Intermediate : state;
    }
};

QDoubleSpinBox* strengthBox(double most, const QString& suffix, double step) {
    auto* box = new NumberBox;
    box->setRange(-most, most);
    box->setDecimals(2);
    box->setSingleStep(step);
    box->setSuffix(suffix);
    return box;
}

} // namespace

MotionDialog::MotionDialog(document::Document& document, std::size_t motion, const QString& name,
                           QWidget* parent)
    : QDialog(parent),
      m_entry(document.entryFractal()),
      m_motion(motion),
      m_numbers(document::motionNumbers(m_entry, motion)),
      m_gesture(document.beginGesture(tr("Change the motion “%1”").arg(name))) {
    setWindowTitle(tr("Motion: %1").arg(name));
    auto* form = new QFormLayout(this);
    int cycles = 0;
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        if (m_numbers[i].kind == document::MotionNumber::Kind::Cycles) ++cycles;
        QWidget* box = field(i, cycles);
        form->addRow(box->accessibleName() + u':', box);
    }
    if (document::orbitPlace(m_entry, motion)) {
        m_orbit = new OrbitRows(m_entry, motion, form, this);
        connect(m_orbit, &OrbitRows::changed, this, &MotionDialog::preview);
    }
    m_note = new QLabel(this);
    m_note->setWordWrap(true);
    m_note->setAccessibleName(tr("Limit of the strength"));
    m_note->hide();
    form->addRow(m_note);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this, [this] { m_gesture.commit(); });
    connect(this, &QDialog::rejected, this, [this] { m_gesture.cancel(); });
}

QWidget* MotionDialog::field(std::size_t index, int ordinal) {
    const document::MotionNumber& number = m_numbers[index];
    if (number.kind == document::MotionNumber::Kind::Degrees ||
        number.kind == document::MotionNumber::Kind::Share) {
        const bool isAngle = number.kind == document::MotionNumber::Kind::Degrees;
        const double unit = isAngle ? 1 : percent;
        auto* box = isAngle ? strengthBox(maxDegrees, QStringLiteral("°"), 0.5)
                            : strengthBox(maxPercent, QStringLiteral(" %"), 1);
        box->setValue(unit * number.value);
        box->setAccessibleName(tr("Strength"));
        box->setWhatsThis(isAngle ? tr("How far the branches swing at most, as an angle about their roots. A "
                                       "negative strength swings them the other way.")
                                  : tr("How much the maps swell and shrink at most. With a negative strength "
                                       "they shrink first."));
        connect(box, &QDoubleSpinBox::valueChanged, this,
                [this, index, unit](double value) { take(index, value / unit); });
        return box;
    }
    const bool isTurns = number.kind == document::MotionNumber::Kind::Turns;
    auto* box = isTurns ? new TurnsBox : new WholeNumberBox;
    box->setRange(isTurns ? -animation::maxCycles : 1, animation::maxCycles);
    box->setValue(int(number.value));
    const auto all =
        std::ranges::count(m_numbers, document::MotionNumber::Kind::Cycles, &document::MotionNumber::kind);
    box->setAccessibleName(isTurns   ? tr("Turns")
                           : all > 1 ? tr("Cycles of wave %1").arg(ordinal)
                                     : tr("Cycles"));
    box->setWhatsThis(
        isTurns ? tr("How many turns it makes during the animation. A negative number turns the other way.")
                : tr("How many times it moves back and forth during the animation."));
    connect(box, &QSpinBox::valueChanged, this, [this, index](int value) { take(index, value); });
    return box;
}

void MotionDialog::take(std::size_t index, double value) {
    m_numbers[index].value = value;
    preview();
}

void MotionDialog::preview() {
    m_gesture.previewEntry(changed());
    if (layout()->hasHeightForWidth())
        resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

document::Fractal MotionDialog::changed() const {
    document::Fractal wanted = document::withMotionNumbers(m_entry, m_motion, m_numbers);
    if (m_orbit) wanted = document::withOrbitPlace(std::move(wanted), m_motion, m_orbit->place());
    m_note->hide();
    const auto strength = std::ranges::find_if(m_numbers, [](const document::MotionNumber& number) {
        return number.kind == document::MotionNumber::Kind::Degrees ||
               number.kind == document::MotionNumber::Kind::Share;
    });
    if (strength == m_numbers.end()) return wanted;
    document::Fractal safe = document::withSafeStrength(wanted, m_motion);
    const double most =
        document::motionNumbers(safe, m_motion)[std::size_t(strength - m_numbers.begin())].value;
    // 0 if the attractor is lost even without this motion.
    if (most == strength->value || most == 0) return wanted;
    const QString limit = strength->kind == document::MotionNumber::Kind::Degrees
                              ? QStringLiteral("%1°").arg(shortNumber(most))
                              : QStringLiteral("%1 %").arg(shortNumber(percent * most));
    m_note->setText(tr("Only %1 is used: with more there would be no attractor at some moment.").arg(limit));
    m_note->show();
    return safe;
}

} // namespace view
