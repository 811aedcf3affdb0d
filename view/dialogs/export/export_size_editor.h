// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;
class QToolButton;

namespace view {

// Width and height in pixels, millimetres or inches, the shape locked or free, and the resolution that ties
// them; screens and sheets of paper are chosen by name.
class ExportSizeEditor : public QWidget {
    Q_OBJECT

public:
    explicit ExportSizeEditor(const QSize& screen, QWidget* parent = nullptr);

    enum class Unit { Pixels, Millimetres, Inches }; // values are stored in the settings

    QSize pixels() const { return m_pixels; }
    void setPixels(const QSize& size); // exact size, even against the lock
    double dotsPerInch() const;
    bool isOnPaper() const; // true for millimetres and inches
    // The choice as a text for choose(): a size by the screen is that of another screen then.
    QString choice() const;
    void choose(const QString& choice); // ignores texts that are no choice
    void chooseLargestSheet();          // of paper
    void chooseMillimetres();           // the same size in them
    void setResolutionVisible(bool visible);

signals:
    void changed();

private:
    void addNamedSizes();
    void takeNamedSize();
    void turn();
    double unitInPixels() const;
    void showSize();
    void takeWidth(double width);
    void takeHeight(double height);
    QSize inShape(double factor) const; // size with the locked proportions, both sides within the limit

    QSize m_screen;
    QSize m_pixels;
    QSize m_locked; // size with the locked proportions
    QDoubleSpinBox* m_width;
    QDoubleSpinBox* m_height;
    QComboBox* m_unit;
    QComboBox* m_named;
    QToolButton* m_lock;
    QToolButton* m_turn;
    QSpinBox* m_resolution;
};

} // namespace view
