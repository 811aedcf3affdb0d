// SPDX-License-Identifier: MIT
#include "panels/timeline/orbit_rows.h"

#include "widgets/choices.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_field.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>

#include <cmath>

namespace view {

namespace {

bool isAt(const ifs::Vector<3>& point, const ifs::Vector<3>& centre) {
    constexpr double roundOff = 1e-9;
    return (point - centre).norm() <= roundOff * (1 + centre.norm());
}

} // namespace

OrbitRows::OrbitRows(const document::Fractal& entry, std::size_t motion, QFormLayout* form, QObject* parent)
    : QObject(parent),
      m_place(document::orbitPlace(entry, motion).value_or(document::OrbitPlace())),
      m_isInSpace(document::space(entry) != nullptr),
      m_centre(document::orbitCentre(entry)) {
    if (m_isInSpace) addAxis(form);
    addPivot(form);
}

QDoubleSpinBox* OrbitRows::angleBox(double least, double most, double value) {
    auto* box = new NumberBox;
    box->setRange(least, most);
    box->setDecimals(2);
    box->setSingleStep(5);
    box->setSuffix(QStringLiteral("°"));
    box->setValue(value);
    connect(box, &QDoubleSpinBox::valueChanged, this, &OrbitRows::takeAxis);
    return box;
}

void OrbitRows::addAxis(QFormLayout* form) {
    const document::LeaningAxis leaning = document::leaningAxisOf(m_place.axis);
    m_axis = new QComboBox;
    for (const int axis : {0, 1, 2})
        addChoice(m_axis, QString(QChar(u"XYZ"[axis])), axis);
    chooseValue(m_axis, leaning.axis);
    m_axis->setAccessibleName(tr("Axis"));
    m_axis->setWhatsThis(tr("The axis that the camera goes round."));
    connect(m_axis, &QComboBox::currentIndexChanged, this, &OrbitRows::takeAxis);
    m_tilt = angleBox(0, 180, leaning.lean);
    m_tilt->setAccessibleName(tr("Tilt"));
    m_tilt->setWhatsThis(tr("How far the axis is tilted, like that of a globe. With 180° the camera goes "
                            "round the other way."));
    m_towards = angleBox(-180, 180, leaning.towards);
    m_towards->setAccessibleName(tr("Direction of the tilt"));
    m_towards->setWhatsThis(tr("Where the axis is tilted to: at 0° to the next one, X to Y, Y to Z and Z to "
                               "X, and at 90° to the one after that."));
    for (QWidget* field : std::initializer_list<QWidget*>{m_axis, m_tilt, m_towards})
        form->addRow(field->accessibleName() + u':', field);
}

void OrbitRows::addPivot(QFormLayout* form) {
    m_pivot = new QComboBox;
    addChoice(m_pivot, tr("Centre of the fractal"), Pivot::Centre);
    addChoice(m_pivot, tr("A point"), Pivot::Point);
    if (m_isInSpace) addChoice(m_pivot, tr("Middle of the view"), Pivot::Target);
    const bool isTarget = m_isInSpace && m_place.pivot == animation::OrbitPivot::Target;
    const bool isCentre = !isTarget && m_centre && isAt(m_place.centre, *m_centre);
    chooseValue(m_pivot, isTarget ? Pivot::Target : isCentre ? Pivot::Centre : Pivot::Point);
    m_pivot->setAccessibleName(tr("Pivot"));
    m_pivot->setWhatsThis(tr("What stays in its place while everything turns."));
    connect(m_pivot, &QComboBox::currentIndexChanged, this, &OrbitRows::takePivot);
    form->addRow(m_pivot->accessibleName() + u':', m_pivot);
    auto* point = new QWidget;
    auto* fields = new QHBoxLayout(point);
    fields->setContentsMargins({});
    for (std::size_t i = 0; i < (m_isInSpace ? 3 : 2); ++i) {
        m_point[i] = new NumberField;
        m_point[i]->setAccessibleName(tr("%1 of the pivot").arg(QChar(u"xyz"[i])));
        m_point[i]->setWhatsThis(tr("The point that stays in its place."));
        fields->addWidget(m_point[i]);
        const auto take = [this, i] {
            m_place.centre[Eigen::Index(i)] = m_point[i]->value();
            emit changed();
        };
        connect(m_point[i], &NumberField::edited, this, take);
        connect(m_point[i], &NumberField::cancelled, this, take);
    }
    form->addRow(tr("Point") + u':', point);
    showPoint();
}

void OrbitRows::takeAxis() {
    m_place.axis = document::directionOf({chosenValue<int>(m_axis), m_tilt->value(), m_towards->value()});
    emit changed();
}

void OrbitRows::takePivot() {
    const auto pivot = chosenValue<Pivot>(m_pivot);
    m_place.pivot = pivot == Pivot::Target ? animation::OrbitPivot::Target : animation::OrbitPivot::Centre;
    if (pivot == Pivot::Centre) m_place.centre = m_centre.value_or(m_place.centre);
    showPoint();
    emit changed();
}

void OrbitRows::showPoint() {
    for (std::size_t i = 0; i < m_point.size(); ++i) {
        if (m_point[i] == nullptr) continue;
        m_point[i]->setValue(m_place.centre[Eigen::Index(i)]);
        m_point[i]->setEnabled(chosenValue<Pivot>(m_pivot) == Pivot::Point);
    }
}

} // namespace view
