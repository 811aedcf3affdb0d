// SPDX-License-Identifier: MIT
#include "panels/maps/symmetry_row.h"

#include "document/edits/maps/symmetry_edits.h"
#include "widgets/choices.h"
#include "widgets/document_undo.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_field.h"
#include "widgets/symmetry_groups.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

namespace view {

namespace {

using enum ifs::SymmetryGroup;

constexpr int usualOrder = 6;
// The kind of the steps that the order is changed in: those that follow each other closely are one.
constexpr int turnsOfOrder = 1936548206;

// Gives the symmetry of the fractal, in whichever dimension it is, to `change`.
template <class Change> void changeSymmetry(document::Fractal& fractal, const Change& change) {
    if (document::System2* system = document::system2(fractal))
        change(system->symmetry);
    else if (document::System3* solid = document::system3(fractal))
        change(solid->symmetry);
}

} // namespace

SymmetryRow::SymmetryRow(document::Document* document, QWidget* parent)
    : QWidget(parent), m_document(document), m_edit(document) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(makeChoice());
    m_place = makePlace();
    layout->addWidget(m_place);
    connect(m_groups, &QComboBox::activated, this,
            [this] { chooseGroup(chosenSymmetryGroup(m_groups), m_order->value()); });
    connect(m_order, &QSpinBox::valueChanged, this,
            [this](int order) { chooseGroup(chosenSymmetryGroup(m_groups), order, turnsOfOrder); });
    connect(m_expand, &QToolButton::clicked, this, &SymmetryRow::expand);
    connect(document, &document::Document::changed, this, &SymmetryRow::follow);
    follow();
}

QWidget* SymmetryRow::makeChoice() {
    auto* line = new QWidget(this);
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    auto* label = new QLabel(tr("Symmetry"), line);
    m_groups = new QComboBox(line);
    m_groups->setAccessibleName(tr("Symmetry"));
    m_groups->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_groups->setMinimumContentsLength(10);
    m_groups->setToolTip(tr("Repeat every map under a group of rotations or mirror images"));
    m_groups->setWhatsThis(
        tr("With a symmetry, each map of the list also acts rotated or mirrored about the "
           "centre, so the fractal is symmetric. The copies are not listed; Expand lists them. "
           "On the canvas, drag the handle of the centre."));
    label->setBuddy(m_groups);
    m_order = new WholeNumberBox(line);
    m_order->setAccessibleName(tr("Order of the symmetry"));
    m_order->setToolTip(tr("How many times the fractal repeats in a full turn"));
    m_order->setRange(ifs::minSymmetryOrder, ifs::maxSymmetryOrder);
    m_order->setValue(usualOrder);
    m_order->setKeyboardTracking(false);
    leaveUndoToDocument(m_order);
    m_expand = new QToolButton(line);
    m_expand->setText(tr("Expand"));
    m_expand->setAccessibleName(tr("Expand the symmetry"));
    m_expand->setAutoRaise(true);
    m_expand->setWhatsThis(tr("Writes the copies that the symmetry makes into the list, as maps of their "
                              "own, so that you can change them individually. The picture stays the same."));
    layout->addWidget(label);
    layout->addWidget(m_groups, 1);
    layout->addWidget(m_order);
    layout->addWidget(m_expand);
    return line;
}

NumberField* SymmetryRow::makeField(const QString& name, const QString& tip) {
    auto* field = new NumberField(this);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    connect(field, &NumberField::committed, this, [this] { m_edit.commit(); });
    connect(field, &NumberField::cancelled, this, [this] {
        m_edit.cancel();
        follow();
    });
    return field;
}

QWidget* SymmetryRow::makePlace() {
    auto* line = new QWidget(this);
    auto* grid = new QGridLayout(line);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    int column = 0;
    const auto add = [&](const QString& text, NumberField* field) {
        auto* label = new QLabel(text, line);
        label->setForegroundRole(QPalette::PlaceholderText);
        label->setBuddy(field);
        grid->addWidget(label, 0, column);
        grid->addWidget(field, 1, column++);
        return label;
    };
    const std::array names{tr("Centre x"), tr("Centre y"), tr("Centre z")};
    const std::array accessible{tr("Centre of the symmetry, x"), tr("Centre of the symmetry, y"),
                                tr("Centre of the symmetry, z")};
    for (std::size_t i = 0; i < m_centre.size(); ++i) {
        m_centre[i] = makeField(accessible[i], tr("The point that the symmetry leaves unchanged"));
        m_centreLabels[i] = add(names[i], m_centre[i]);
        connect(m_centre[i], &NumberField::edited, this, [this, i](double value) {
            m_edit.preview(tr("Move the centre of the symmetry"), [&](document::Fractal& fractal) {
                changeSymmetry(fractal, [&](auto& symmetry) {
                    if (Eigen::Index(i) < symmetry.centre.size()) symmetry.centre[Eigen::Index(i)] = value;
                });
            });
        });
    }
    m_angle = makeField(tr("Angle of the mirror"), tr("Direction of a mirror, in degrees counter-clockwise"));
    m_angle->setDegrees();
    m_angle->setStep(1);
    m_angleLabel = add(tr("Angle °"), m_angle);
    connect(m_angle, &NumberField::edited, this, [this](double value) {
        m_edit.preview(tr("Turn the mirrors of the symmetry"), [&](document::Fractal& fractal) {
            changeSymmetry(fractal, [&](auto& symmetry) { symmetry.angle = value; });
        });
    });
    return line;
}

void SymmetryRow::fillGroups(int dimension) {
    if (dimension == m_dimension) return;
    m_dimension = dimension;
    fillSymmetryGroups(m_groups, dimension);
}

template <int Dim> void SymmetryRow::showSymmetry(const ifs::Symmetry<Dim>& symmetry) {
    const QSignalBlocker quietGroups(m_groups), quietOrder(m_order);
    chooseValue(m_groups, symmetry.group);
    m_order->setVisible(hasOrder(symmetry.group));
    if (hasOrder(symmetry.group)) m_order->setValue(symmetry.order);
    m_place->setVisible(symmetry.group != None);
    for (std::size_t i = 0; i < m_centre.size(); ++i) {
        m_centre[i]->setVisible(i < Dim);
        m_centreLabels[i]->setVisible(i < Dim);
        if (i < Dim) m_centre[i]->setValue(symmetry.centre[Eigen::Index(i)]);
    }
    m_angle->setVisible(hasMirrors(symmetry.group));
    m_angleLabel->setVisible(hasMirrors(symmetry.group));
    m_angle->setValue(symmetry.angle);
}

void SymmetryRow::follow() {
    const document::Fractal& fractal = m_document->fractal();
    const int dimension = document::dimension(fractal);
    setEnabled(dimension != 0);
    fillGroups(dimension);
    if (const document::System2* system = document::system2(fractal))
        showSymmetry(system->symmetry);
    else if (const document::System3* solid = document::system3(fractal))
        showSymmetry(solid->symmetry);
    else
        showSymmetry(ifs::Symmetry<2>{});
    const QString obstacle = document::expandObstacle(m_document->entryFractal());
    m_expand->setVisible(document::isSymmetric(fractal));
    m_expand->setEnabled(obstacle.isEmpty());
    m_expand->setToolTip(obstacle.isEmpty() ? tr("List the maps that the symmetry stands for") : obstacle);
    m_expand->setStatusTip(m_expand->toolTip());
}

void SymmetryRow::chooseGroup(ifs::SymmetryGroup group, int order, int kind) {
    m_edit.commit();
    if (!hasOrder(group)) order = 1;
    document::Fractal after = m_document->fractal();
    if (const QString obstacle = document::symmetryObstacle(after, ifs::groupOrder(group, order));
        !obstacle.isEmpty()) {
        follow(); // restores the former choice
        emit message(obstacle);
        return;
    }
    changeSymmetry(after, [&](auto& symmetry) {
        if (group == None)
            symmetry = {};
        else
            symmetry.group = group;
        symmetry.order = order;
        if (!hasMirrors(group)) symmetry.angle = 0;
    });
    m_edit.preview(
        group == None ? tr("Remove the symmetry") : tr("Set the symmetry"),
        [&](document::Fractal& fractal) { fractal = std::move(after); }, kind);
    m_edit.commit();
    follow();
    emit groupChosen();
}

void SymmetryRow::expand() {
    m_edit.commit();
    const document::Fractal& entry = m_document->entryFractal();
    if (const QString obstacle = document::expandObstacle(entry); !obstacle.isEmpty()) {
        emit message(obstacle);
        return;
    }
    m_document->editEntry(tr("Expand the symmetry"), document::expanded(entry));
}

} // namespace view
