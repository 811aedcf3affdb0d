// SPDX-License-Identifier: MIT
#include "dialogs/transform_dialog.h"

#include "widgets/choices.h"
#include "widgets/numbers/number_field.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include <initializer_list>
#include <utility>

namespace view {

namespace {

enum class About { Origin, BoxMiddle, Mean, Typed };

constexpr std::array<double, TransformDialog::ValueCount> neutral{0, 1, 1, 1,  0, 0, 0, 0,
                                                                  0, 0, 0, 90, 0, 1, 0};

// Fields side by side, named x, y and z.
QWidget* row(std::initializer_list<NumberField*> fields) {
    auto* box = new QWidget;
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    const std::array names{TransformDialog::tr("x"), TransformDialog::tr("y"), TransformDialog::tr("z")};
    std::size_t k = 0;
    for (NumberField* field : fields) {
        auto* label = new QLabel(names[k++], box);
        label->setForegroundRole(QPalette::PlaceholderText);
        layout->addWidget(label);
        layout->addWidget(field, 1);
    }
    return box;
}

} // namespace

TransformDialog::TransformDialog(document::Document* document, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_edit(document),
      m_dimension(document::dimension(document->fractal()) == 3 ? 3 : 2) {
    setWindowTitle(tr("Transform"));
    setWhatsThis(tr("Reflects, shears, scales, rotates and translates the whole fractal by numbers."));
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setHorizontalSpacing(16);
    layout->addLayout(form);

    form->addRow(tr("Change:"), makeMode());
    form->addRow(tr("About:"), makeAbout());
    m_dimension == 2 ? addRows(form) : addSpaceRows(form);

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

    chooseAbout();
}

void TransformDialog::addRows(QFormLayout* form) {
    form->addRow(QString(), row({addField(AboutX, tr("x of the fixed point"), 0, 0.1),
                                 addField(AboutY, tr("y of the fixed point"), 0, 0.1)}));
    form->addRow(tr("Reflect:"), makeReflection());
    form->addRow(tr("Shear:"), addField(Shear, tr("Shear along x"), 0, 0.05));
    form->addRow(tr("Scale:"), row({addField(ScaleX, tr("Scale in x"), 1, 0.05),
                                    addField(ScaleY, tr("Scale in y"), 1, 0.05)}));
    form->addRow(QString(), makeSameScale());
    form->addRow(tr("Rotate °:"), addField(Rotation, tr("Rotation in degrees, counter-clockwise"), 0, 5));
    form->addRow(tr("Translate:"), row({addField(ShiftX, tr("Translation in x"), 0, 0.1),
                                        addField(ShiftY, tr("Translation in y"), 0, 0.1)}));
}

void TransformDialog::addSpaceRows(QFormLayout* form) {
    form->addRow(QString(), row({addField(AboutX, tr("x of the fixed point"), 0, 0.1),
                                 addField(AboutY, tr("y of the fixed point"), 0, 0.1),
                                 addField(AboutZ, tr("z of the fixed point"), 0, 0.1)}));
    form->addRow(tr("Scale:"), row({addField(ScaleX, tr("Scale in x"), 1, 0.05),
                                    addField(ScaleY, tr("Scale in y"), 1, 0.05),
                                    addField(ScaleZ, tr("Scale in z"), 1, 0.05)}));
    form->addRow(QString(), makeSameScale());
    form->addRow(tr("Axis:"), makeAxis());
    form->addRow(QString(), row({addField(AxisX, tr("x of the direction of the axis"), 0, 0.1),
                                 addField(AxisY, tr("y of the direction of the axis"), 1, 0.1),
                                 addField(AxisZ, tr("z of the direction of the axis"), 0, 0.1)}));
    form->addRow(tr("Rotate °:"),
                 addField(Rotation,
                          tr("Rotation in degrees, counter-clockwise as seen from the tip of the axis"), 0,
                          5));
    form->addRow(tr("Translate:"), row({addField(ShiftX, tr("Translation in x"), 0, 0.1),
                                        addField(ShiftY, tr("Translation in y"), 0, 0.1),
                                        addField(ShiftZ, tr("Translation in z"), 0, 0.1)}));
}

QWidget* TransformDialog::makeSameScale() {
    m_sameScale = new QCheckBox(m_dimension == 2 ? tr("Same in x and y") : tr("Same in x, y and z"), this);
    m_sameScale->setChecked(true);
    m_sameScale->setWhatsThis(m_dimension == 2 ? tr("Keeps the factor in y equal to that in x.")
                                               : tr("Keeps the factors in x, y and z equal."));
    connect(m_sameScale, &QCheckBox::toggled, this, [this](bool same) {
        if (same) follow(ScaleX);
        showLive();
    });
    return m_sameScale;
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
        m_edit.cancel(); // another kind of step
        showLive();
    });
    return box;
}

QWidget* TransformDialog::makeAbout() {
    m_about = new QComboBox(this);
    m_about->setAccessibleName(tr("Fixed point"));
    m_about->setWhatsThis(
        tr("The point about which the fractal is rotated, scaled and reflected; it stays where it is."));
    addChoice(m_about, tr("the origin"), About::Origin);
    addChoice(m_about, tr("the centre of the picture’s box"), About::BoxMiddle);
    addChoice(m_about, tr("the mean of the invariant measure"), About::Mean);
    addChoice(m_about, tr("a point of your choice"), About::Typed);
    const document::Fractal& fractal = m_document->fractal();
    const bool hasBox = m_dimension == 2 ? document::middleOfBox<2>(fractal).has_value()
                                         : document::middleOfBox<3>(fractal).has_value();
    chooseValue(m_about, hasBox ? About::BoxMiddle : About::Origin);
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
        addField(Mirror, tr("Angle of the mirror line in degrees: 0 is horizontal, 90 vertical"), 90, 5);
    axis->setEnabled(false);
    layout->addWidget(m_reflect);
    layout->addWidget(axis, 1);
    connect(m_reflect, &QCheckBox::toggled, this, [this, axis](bool on) {
        axis->setEnabled(on);
        showLive();
    });
    return box;
}

QWidget* TransformDialog::makeAxis() {
    m_axis = new QComboBox(this);
    m_axis->setAccessibleName(tr("Axis of the rotation"));
    m_axis->setWhatsThis(tr("The axis of the rotation; it passes through the fixed point."));
    addChoice(m_axis, tr("the x axis"), AxisChoice::X);
    addChoice(m_axis, tr("the y axis"), AxisChoice::Y);
    addChoice(m_axis, tr("the z axis"), AxisChoice::Z);
    addChoice(m_axis, tr("a direction of your choice"), AxisChoice::Typed);
    chooseValue(m_axis, AxisChoice::Y);
    connect(m_axis, &QComboBox::activated, this, &TransformDialog::chooseAxis);
    return m_axis;
}

NumberField* TransformDialog::addField(Value value, const QString& name, double start, double step) {
    auto* field = new NumberField(this);
    field->setAccessibleName(name);
    field->setToolTip(name);
    if (value == Rotation || value == Mirror) field->setDegrees();
    field->setStep(step);
    field->setValue(start);
    m_fields[value] = field;
    const auto take = [this, value] {
        follow(value);
        showLive();
    };
    connect(field, &NumberField::edited, this, take);
    connect(field, &NumberField::cancelled, this, take);
    return field;
}

void TransformDialog::follow(Value edited) {
    const NumberField* from = m_fields[edited];
    if (m_sameScale && m_sameScale->isChecked() && edited >= ScaleX && edited <= ScaleZ)
        for (const Value other : {ScaleX, ScaleY, ScaleZ})
            if (other != edited && m_fields[other])
                m_fields[other]->setValue(from->value(), from->typedText());
    if (edited >= AboutX && edited <= AboutZ) chooseValue(m_about, About::Typed);
    if (edited >= AxisX && edited <= AxisZ) chooseValue(m_axis, AxisChoice::Typed);
}

TransformDialog::Mode TransformDialog::mode() const {
    return static_cast<Mode>(m_mode->checkedId());
}

void TransformDialog::setMode(Mode mode) {
    m_mode->button(static_cast<int>(mode))->setChecked(true);
}

template <int Dim> std::optional<ifs::Vector<Dim>> TransformDialog::chosenPoint() const {
    const document::Fractal& before = m_edit.before();
    switch (chosenValue<About>(m_about)) {
    case About::Origin:
        return ifs::Vector<Dim>::Zero();
    case About::BoxMiddle:
        return document::middleOfBox<Dim>(before);
    case About::Mean:
        return document::displayedMean<Dim>(before);
    case About::Typed:
        break;
    }
    return std::nullopt;
}

void TransformDialog::chooseAbout() {
    if (chosenValue<About>(m_about) == About::Typed) {
        m_fields[AboutX]->setFocus();
        return;
    }
    const auto fill = [this](const auto& point) {
        if (!point) { // no such point: keeps the choice
            chooseValue(m_about, About::Typed);
            return false;
        }
        for (int k = 0; k < point->size(); ++k)
            m_fields[std::size_t(AboutX) + std::size_t(k)]->setValue((*point)[k]);
        return true;
    };
    if (m_dimension == 2 ? fill(chosenPoint<2>()) : fill(chosenPoint<3>())) showLive();
}

void TransformDialog::chooseAxis() {
    const auto choice = chosenValue<AxisChoice>(m_axis);
    if (choice == AxisChoice::Typed) {
        m_fields[AxisX]->setFocus();
        return;
    }
    for (int k = 0; k < 3; ++k)
        m_fields[std::size_t(AxisX) + std::size_t(k)]->setValue(k == static_cast<int>(choice) ? 1 : 0);
    showLive();
}

double TransformDialog::value(Value which) const {
    return m_fields[which] ? m_fields[which]->value() : neutral[which];
}

ifs::Vector<3> TransformDialog::vector(Value x) const {
    return {value(x), value(Value(x + 1)), value(Value(x + 2))};
}

document::Transformation TransformDialog::transformation() const {
    return {m_reflect && m_reflect->isChecked(),
            value(Mirror),
            value(Shear),
            value(ScaleX),
            value(ScaleY),
            value(Rotation),
            {value(ShiftX), value(ShiftY)},
            {value(AboutX), value(AboutY)}};
}

document::SpaceTransformation TransformDialog::spaceTransformation() const {
    return {vector(ScaleX), vector(AxisX), value(Rotation), vector(ShiftX), vector(AboutX)};
}

template <int Dim> ifs::AffineMap<Dim> TransformDialog::map() const {
    if constexpr (Dim == 2)
        return affineMap(transformation());
    else
        return affineMap(spaceTransformation());
}

template <int Dim> QString TransformDialog::problemIn() const {
    const document::Fractal& before = m_edit.before();
    if (document::dimension(before) != Dim)
        return Dim == 2 ? tr("This entry is not a system in the plane.")
                        : tr("This entry is not a system in space.");
    if constexpr (Dim == 3)
        if (value(Rotation) != 0 && vector(AxisX).isZero(0)) return tr("The axis has no direction.");
    if (mode() != Mode::Rewrite || document::rewritten(before, map<Dim>())) return {};
    if (Dim == 3 && ifs::inverse(map<Dim>()))
        return tr("The cage bends the picture, so only a transformation that scales alike in all directions "
                  "can be written into the code. Choose equal scales, or place the picture.");
    return tr("This transformation is too flat to be inverted, so it cannot be written into the code. "
              "Choose other scales, or place the picture.");
}

QString TransformDialog::problem() const {
    return m_dimension == 2 ? problemIn<2>() : problemIn<3>();
}

template <int Dim> void TransformDialog::preview() {
    const ifs::AffineMap<Dim> made = map<Dim>();
    m_edit.preview(mode() == Mode::Place ? tr("Transform the picture") : tr("Transform the code"),
                   [&](document::Fractal& fractal) {
                       if (made == ifs::AffineMap<Dim>{}) return;
                       if (mode() == Mode::Place)
                           fractal = document::placed(std::move(fractal), made);
                       else if (auto after = document::rewritten(fractal, made))
                           fractal = std::move(*after);
                   });
}

void TransformDialog::showLive() {
    const QString reason = problem();
    m_problem->setText(reason);
    m_ok->setEnabled(reason.isEmpty());
    if (!reason.isEmpty())
        m_edit.cancel();
    else
        m_dimension == 2 ? preview<2>() : preview<3>();
}

void TransformDialog::startAgain() {
    for (std::size_t value = 0; value < ValueCount; ++value)
        if (m_fields[value]) m_fields[value]->setValue(neutral[value]);
    if (m_reflect) m_reflect->setChecked(false);
    if (m_axis) chooseValue(m_axis, AxisChoice::Y);
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
