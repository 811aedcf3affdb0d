// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QImage>
#include <QWidget>

class QToolButton;

namespace view {

class ColourButton;
class GradientStrip;
class NumberField;

// Edits a palette: stops on a strip, their colours and positions, reversed, distributed, loaded from and
// saved to files of other programs. Reports like the strip does.
class GradientEditor : public QWidget {
    Q_OBJECT

public:
    explicit GradientEditor(QWidget* parent = nullptr);

    void setGradient(const attractor::Palette& gradient);
    GradientStrip* strip() const { return m_strip; }
    ColourButton* colour() const { return m_colour; }
    NumberField* position() const { return m_position; }

    void reverse();
    void distribute();
    // Asks which, when the file holds several; of a picture, its colours.
    void load(const QString& path);
    void save(const QString& path); // .gpl file

signals:
    void tried(const QString& what, const attractor::Palette& gradient);
    void accepted();
    void rejected();
    void message(const QString& sentence); // outcome for a file

private:
    void connectEditors(); // connects the editors of the strip and of the selected stop
    void showSelected();
    void apply(const QString& what, const attractor::Palette& gradient);
    void chooseAndLoad();
    void chooseAndSave();
    void takeFrom(const QImage& picture); // colours of the whole picture, or along a line
    void chooseAmong(const std::vector<attractor::Palette>& palettes);

    GradientStrip* m_strip;
    ColourButton* m_colour;
    NumberField* m_position;
    QToolButton* m_remove;
};

} // namespace view
