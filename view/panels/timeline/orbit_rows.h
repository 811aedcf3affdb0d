// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/timeline/orbit_edits.h"

#include <QObject>

#include <array>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace view {

class NumberField;

// The rows of a form that say where an orbit turns: in space the axis and its tilt, and the pivot.
class OrbitRows : public QObject {
    Q_OBJECT

public:
    // Adds the rows; `motion` of the entry is an orbit.
    OrbitRows(const document::Fractal& entry, std::size_t motion, QFormLayout* form, QObject* parent);

    const document::OrbitPlace& place() const { return m_place; }

    enum class Pivot { Centre, Point, Target };

signals:
    void changed();

private:
    void addAxis(QFormLayout* form);
    void addPivot(QFormLayout* form);
    QDoubleSpinBox* angleBox(double least, double most, double value);
    void takeAxis();
    void takePivot();
    void showPoint();

    document::OrbitPlace m_place;
    bool m_isInSpace;
    std::optional<ifs::Vector<3>> m_centre; // centre of the attractor
    QComboBox* m_axis = nullptr;
    QDoubleSpinBox* m_tilt = nullptr;
    QDoubleSpinBox* m_towards = nullptr;
    QComboBox* m_pivot = nullptr;
    std::array<NumberField*, 3> m_point{};
};

} // namespace view
