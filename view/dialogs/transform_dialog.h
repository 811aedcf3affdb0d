// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"
#include "document/edits/transform_edits.h"

#include <QDialog>

#include <array>
#include <optional>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace view {

class NumberField;

// The whole fractal rotated, scaled, sheared, reflected and translated by typed values, as placement or as
// new code; in space rotated about an axis, scaled and translated. Shown live while the dialog is open; OK
// leaves one undo step, Cancel none.
class TransformDialog : public QDialog {
    Q_OBJECT

public:
    explicit TransformDialog(document::Document* document, QWidget* parent = nullptr);

    enum class Mode { Place, Rewrite };
    enum class AxisChoice { X, Y, Z, Typed };
    void setMode(Mode mode);
    Mode mode() const;

    // Values by dimension: Shear and Mirror belong to the plane; those with a z, and the axis of the
    // rotation, to space.
    enum Value {
        Rotation,
        ScaleX,
        ScaleY,
        ScaleZ,
        Shear,
        ShiftX,
        ShiftY,
        ShiftZ,
        AboutX,
        AboutY,
        AboutZ,
        Mirror,
        AxisX,
        AxisY,
        AxisZ,
        ValueCount
    };
    NumberField* field(Value value) const { return m_fields[value]; } // nullptr: other dimension
    QCheckBox* reflect() const { return m_reflect; }                  // nullptr in space
    QComboBox* about() const { return m_about; }
    QComboBox* axis() const { return m_axis; } // nullptr in the plane
    QString problem() const; // reason why the transformation is impossible; empty if it is possible
    document::Transformation transformation() const;
    document::SpaceTransformation spaceTransformation() const;

    void accept() override;
    void reject() override;

private:
    NumberField* addField(Value value, const QString& name, double start, double step);
    void addRows(QFormLayout* form);
    void addSpaceRows(QFormLayout* form);
    QWidget* makeSameScale();
    QWidget* makeAbout();
    QWidget* makeMode();
    QWidget* makeReflection();
    QWidget* makeAxis();
    void follow(Value edited); // updates the fields that depend on an edited one
    void chooseAbout();
    void chooseAxis();
    double value(Value which) const;
    ifs::Vector<3> vector(Value x) const; // vector from three fields
    template <int Dim> ifs::AffineMap<Dim> map() const;
    template <int Dim> std::optional<ifs::Vector<Dim>> chosenPoint() const;
    template <int Dim> QString problemIn() const;
    template <int Dim> void preview();
    void showLive();
    void startAgain();

    document::Document* m_document;
    document::LiveEdit m_edit;
    int m_dimension;
    std::array<NumberField*, ValueCount> m_fields{};
    QCheckBox* m_reflect = nullptr;
    QCheckBox* m_sameScale = nullptr;
    QComboBox* m_about = nullptr;
    QComboBox* m_axis = nullptr;
    QButtonGroup* m_mode = nullptr;
    QLabel* m_problem = nullptr;
    QPushButton* m_ok = nullptr;
};

} // namespace view
