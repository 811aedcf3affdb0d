// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"

#include <QWidget>

#include <array>

class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace view {

class NumberField;

// The group under which the attractor is symmetric, its centre and the angle of its mirrors. Every choice is
// one undo step.
class SymmetryRow : public QWidget {
    Q_OBJECT

public:
    explicit SymmetryRow(document::Document* document, QWidget* parent = nullptr);

    QComboBox* groups() const { return m_groups; }
    QSpinBox* order() const { return m_order; }
    NumberField* angle() const { return m_angle; }
    NumberField* centre(int coordinate) const { return m_centre.at(std::size_t(coordinate)); }
    QToolButton* expandButton() const { return m_expand; }

    void expand(); // lists the maps that the symmetry stands for

signals:
    void message(const QString& text); // a sentence for the status bar
    void groupChosen();                // sent because the size of the attractor may have changed

private:
    QWidget* makeChoice();
    QWidget* makePlace();
    NumberField* makeField(const QString& name, const QString& tip);
    void follow();
    void fillGroups(int dimension);
    template <int Dim> void showSymmetry(const ifs::Symmetry<Dim>& symmetry);
    // `kind`: see EditGesture::describe().
    void chooseGroup(ifs::SymmetryGroup group, int order, int kind = -1);

    document::Document* m_document;
    document::LiveEdit m_edit;
    QComboBox* m_groups;
    QSpinBox* m_order;
    QToolButton* m_expand;
    QWidget* m_place = nullptr;
    NumberField* m_angle = nullptr;
    QLabel* m_angleLabel = nullptr;
    std::array<NumberField*, 3> m_centre{};
    std::array<QLabel*, 3> m_centreLabels{};
    int m_dimension = 0; // dimension for which the groups are listed
};

} // namespace view
