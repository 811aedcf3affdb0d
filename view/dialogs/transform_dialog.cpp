// SPDX-License-Identifier: MIT
#include "dialogs/transform_dialog.h"

#include "widgets/number_field.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace view {

namespace {

enum class About { Origin, BoxMiddle, Mean, Typed };

// Two fields side by side, named x and y.
QWidget* pair(NumberField* x, NumberField* y) {
    auto* box = new QWidget;
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    for (NumberField* field : {x, y}) {
        auto* label = new QLabel(field == x ? TransformDialog::tr("x") : TransformDialog::tr("y"), box);
        label->setForegroundRole(QPalette::PlaceholderText);
        layout->addWidget(label);
        layout->addWidget(field, 1);
    }
    return box;
}

} // namespace

TransformDialog::TransformDialog(document::Document* document, QWidget* parent)
    : QDialog(parent), m_document(document), m_edit(document) {
    setWindowTitle(tr("Transform"));
    setWhatsThis(tr("Reflects, shears, scales, rotates and translates the whole fractal by numbers."));
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setHorizontalSpacing(16);
    layout->addLayout(form);

    form->addRow(tr("Change:"), makeMode());
    form->addRow(tr("About:"), makeAbout());
    form->addRow(QString(), pair(addField(AboutX, tr("x of the fixed point"), 0, 0.1),
                                 addField(AboutY, tr("y of the fixed point"), 0, 0.1)));
    form->addRow(tr("Reflect:"), makeReflection());
    form->addRow(tr("Shear:"), addField(Shear, tr("Shear along x"), 0, 0.05));
    form->addRow(tr("Scale:"), pair(addField(ScaleX, tr("Scale in x"), 1, 0.05),
                                    addField(ScaleY, tr("Scale in y"), 1, 0.05)));
    m_sameScale = new QCheckBox(tr("Same in x and y"), this);
    m_sameScale->setChecked(true);
    m_sameScale->setWhatsThis(tr("Keeps the factor in y equal to that in x."));
    form->addRow(QString(), m_sameScale);
    form->addRow(tr("Rotate °:"), addField(Rotation, tr("Rotation in degrees, counter-clockwise"), 0, 5));
    form->addRow(tr("Translate:"), pair(addField(ShiftX, tr("Translation in x"), 0, 0.1),
                                        addField(ShiftY, tr("Translation in y"), 0, 0.1)));

    auto* order = new QLabel(tr("Applied in this order, from top to bottom."), this);
    order->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(order);
    m_problem = new QLabel(this);
    m_problem->setWordWrap(true);
    m_problem->setAccessibleName(tr("Problem"));
    layout->addWidget(m_problem);
    layout->addStretch();

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    auto* again = buttons->addButton(tr("Reset"), QDialogButtonBox::ResetRole);
    again->setToolTip(tr("Reset all values to what they were when the dialog opened"));
    again->setAutoDefault(false);
    connect(again, &QPushButton::clicked, this, &TransformDialog::startAgain);
    connect(buttons, &QDialogButtonBox::accepted, this, &TransformDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &TransformDialog::reject);
    layout->addWidget(buttons);

    connect(m_sameScale, &QCheckBox::toggled, this, [this](bool same) {
        if (same) m_fields[ScaleY]->setValue(m_fields[ScaleX]->value(), m_fields[ScaleX]->typedText());
        showLive();
    });
    chooseAbout();
}

QWidget* TransformDialog::makeMode() {
    auto* box = new QWidget(this);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    m_mode = new QButtonGroup(this);
    auto* place = new QRadioButton(tr("Place the picture"), box);
    place->setToolTip(tr("The cage moves; the code does not change"));
    auto* rewrite = new QRadioButton(tr("Rewrite the code"), box);
    rewrite->setToolTip(tr("Every map w becomes T∘w∘T⁻¹; the cage follows"));
    m_mode->addButton(place, static_cast<int>(Mode::Place));
    m_mode->addButton(rewrite, static_cast<int>(Mode::Rewrite));
    place->setChecked(true);
    layout->addWidget(place);
    layout->addWidget(rewrite);
    layout->addStretch();
    connect(m_mode, &QButtonGroup::idToggled, this, [this](int, bool on) {
        if (!on) return;
        m_edit.cancel(); // as the other kind of step
        showLive();
    });
    return box;
}

QWidget* TransformDialog::makeAbout() {
    m_about = new QComboBox(this);
    m_about->setAccessibleName(tr("Fixed point"));
    m_about->setWhatsThis(
        tr("The point about which the fractal is rotated, scaled and reflected; it stays where it is."));
    m_about->addItem(tr("the origin"), static_cast<int>(About::Origin));
    m_about->addItem(tr("the centre of the picture’s box"), static_cast<int>(About::BoxMiddle));
    m_about->addItem(tr("the mean of the invariant measure"), static_cast<int>(About::Mean));
    m_about->addItem(tr("a point of your choice"), static_cast<int>(About::Typed));
    const bool hasBox = middleOfBox(m_document->fractal()).has_value();
    m_about->setCurrentIndex(hasBox ? 1 : 0);
    connect(m_about, &QComboBox::activated, this, &TransformDialog::chooseAbout);
    return m_about;
}

QWidget* TransformDialog::makeReflection() {
    auto* box = new QWidget(this);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    m_reflect = new QCheckBox(tr("in the line at the angle (°)"), box);
    m_reflect->setAccessibleName(tr("Reflect"));
    m_reflect->setWhatsThis(
        tr("Reflects in a line through the fixed point; the angle is measured from the x axis."));
    NumberField* axis =
        addField(Axis, tr("Angle of the mirror line in degrees: 0 is horizontal, 90 vertical"), 90, 5);
    axis->setEnabled(false);
    layout->addWidget(m_reflect);
    layout->addWidget(axis, 1);
    connect(m_reflect, &QCheckBox::toggled, this, [this, axis](bool on) {
        axis->setEnabled(on);
        showLive();
    });
    return box;
}

NumberField* TransformDialog::addField(Value value, const QString& name, double start, double step) {
    auto* field = new NumberField(this);
    field->setAccessibleName(name);
    field->setToolTip(name);
    field->setStep(step);
    field->setValue(start);
    m_fields[value] = field;
    connect(field, &NumberField::edited, this, [this, value](double number) {
        const QString typed = m_fields[value]->typedText();
        if (m_sameScale->isChecked() && value == ScaleX) m_fields[ScaleY]->setValue(number, typed);
        if (m_sameScale->isChecked() && value == ScaleY) m_fields[ScaleX]->setValue(number, typed);
        if (value == AboutX || value == AboutY) m_about->setCurrentIndex(static_cast<int>(About::Typed));
        showLive();
    });
    return field;
}

TransformDialog::Mode TransformDialog::mode() const {
    return static_cast<Mode>(m_mode->checkedId());
}

void TransformDialog::setMode(Mode mode) {
    m_mode->button(static_cast<int>(mode))->setChecked(true);
}

void TransformDialog::chooseAbout() {
    const document::Fractal& before = m_edit.before();
    std::optional<ifs::Vector<2>> point;
    switch (static_cast<About>(m_about->currentData().toInt())) {
    case About::Origin:
        point = ifs::Vector<2>::Zero();
        break;
    case About::BoxMiddle:
        point = middleOfBox(before);
        break;
    case About::Mean:
        point = displayedMean(before);
        break;
    case About::Typed:
        m_fields[AboutX]->setFocus();
        return;
    }
    if (!point) { // no such point: leave the choice at what is shown
        m_about->setCurrentIndex(static_cast<int>(About::Typed));
        return;
    }
    m_fields[AboutX]->setValue(point->x());
    m_fields[AboutY]->setValue(point->y());
    showLive();
}

document::Transformation TransformDialog::transformation() const {
    const auto value = [this](Value which) { return m_fields[which]->value(); };
    return {m_reflect->isChecked(),
            value(Axis),
            value(Shear),
            value(ScaleX),
            value(ScaleY),
            value(Rotation),
            {value(ShiftX), value(ShiftY)},
            {value(AboutX), value(AboutY)}};
}

QString TransformDialog::problem() const {
    const document::Fractal& before = m_edit.before();
    if (document::dimension(before) != 2) return tr("This entry is not a system in the plane.");
    if (mode() == Mode::Rewrite && !rewritten(before, affineMap(transformation())))
        return tr("This transformation is too flat to be inverted, so it cannot be written into the code. "
                  "Choose other scales, or place the picture.");
    return {};
}

void TransformDialog::showLive() {
    const QString reason = problem();
    m_problem->setText(reason);
    m_ok->setEnabled(reason.isEmpty());
    if (!reason.isEmpty()) {
        m_edit.cancel();
        return;
    }
    const ifs::AffineMap<2> map = affineMap(transformation());
    m_edit.preview(mode() == Mode::Place ? tr("Transform the picture") : tr("Transform the code"),
                   [&](document::Fractal& fractal) {
                       if (map == ifs::AffineMap<2>{}) return;
                       if (mode() == Mode::Place)
                           fractal = placed(std::move(fractal), map);
                       else if (auto after = rewritten(fractal, map))
                           fractal = std::move(*after);
                   });
}

void TransformDialog::startAgain() {
    const std::array<double, ValueCount> start{0, 1, 1, 0, 0, 0, 0, 0, 90};
    for (int value = 0; value < ValueCount; ++value)
        m_fields[value]->setValue(start[static_cast<std::size_t>(value)]);
    m_reflect->setChecked(false);
    chooseAbout();
}

void TransformDialog::accept() {
    if (!problem().isEmpty()) return;
    m_edit.commit();
    QDialog::accept();
}

void TransformDialog::reject() {
    m_edit.cancel();
    QDialog::reject();
}

} // namespace view
