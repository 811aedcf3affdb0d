// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"
#include "document/edits/transform_edits.h"

#include <QDialog>

#include <array>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace view {

class NumberField;

// The whole fractal rotated, scaled, sheared, reflected and translated by typed values, as placement or as
// new code. Shown live while the dialog is open; OK leaves one undo step, Cancel none.
class TransformDialog : public QDialog {
    Q_OBJECT

public:
    explicit TransformDialog(document::Document* document, QWidget* parent = nullptr);

    enum class Mode { Place, Rewrite };
    void setMode(Mode mode);
    Mode mode() const;

    enum Value { Rotation, ScaleX, ScaleY, Shear, ShiftX, ShiftY, AboutX, AboutY, Axis, ValueCount };
    NumberField* field(Value value) const { return m_fields[value]; }
    QCheckBox* reflect() const { return m_reflect; }
    QComboBox* about() const { return m_about; }
    QString problem() const; // why the transformation cannot be made; empty when it can
    document::Transformation transformation() const;

    void accept() override;
    void reject() override;

private:
    NumberField* addField(Value value, const QString& name, double start, double step);
    QWidget* makeAbout();
    QWidget* makeMode();
    QWidget* makeReflection();
    void chooseAbout();
    void showLive();
    void startAgain();

    document::Document* m_document;
    document::LiveEdit m_edit;
    std::array<NumberField*, ValueCount> m_fields{};
    QCheckBox* m_reflect = nullptr;
    QCheckBox* m_sameScale = nullptr;
    QComboBox* m_about = nullptr;
    QButtonGroup* m_mode = nullptr;
    QLabel* m_problem = nullptr;
    QPushButton* m_ok = nullptr;
};

} // namespace view
