// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

class QSlider;

namespace view {

class NumberField;

// A number on a slider with its field. One drag, one run of wheel or arrow steps, or the
// typing in the field is one edit: tried() while it lasts, then accepted() or rejected().
class AppearanceSlider : public QWidget {
    Q_OBJECT

public:
    enum class Scale {
        Logarithmic, // slider over [min, max], 0 < min; field for any number > 0
        Linear,      // slider over [min, max]; field for any number, or any ≥ 0 if min is 0
        Bounded,     // slider and field over [min, max]
    };
    AppearanceSlider(const QString& name, double min, double max, Scale scale, QWidget* parent = nullptr);

    void setRange(double min, double max); // must be followed by a new value
    void setValue(double value);
    // Sets the help for the number: in a few words, and in more of them.
    void explain(const QString& toolTip, const QString& whatsThis);
    QSlider* slider() const { return m_slider; }
    NumberField* field() const { return m_field; }

signals:
    void tried(double value);
    void accepted();
    void rejected();

private:
    int positionOf(double value) const;
    double valueAt(int position) const;
    void slide(int position);

    double m_min;
    double m_max;
    Scale m_scale;
    QSlider* m_slider;
    NumberField* m_field;
    QTimer m_settled; // ends a run of steps made without holding the slider
};

} // namespace view
