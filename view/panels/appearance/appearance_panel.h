// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace view {

class ColourButton;
class GradientChooser;
class GradientEditor;
class NumberRows;
class SliceRows;
class SpaceRows;

// Colours of the attractor, and in space also its light. Every control is live; one undo step per drag,
// dialog or typed number.
class AppearancePanel : public QWidget {
    Q_OBJECT

public:
    explicit AppearancePanel(document::Document* document, QWidget* parent = nullptr);

    QComboBox* colourBy() const { return m_colourBy; }
    GradientChooser* gradient() const { return m_gradient; }
    GradientEditor* gradientEditor() const { return m_editor; }
    QToolButton* editGradient() const { return m_editGradient; }
    QToolButton* browsePalettes() const { return m_browsePalettes; }
    NumberRows* numbers() const { return m_numbers; }
    QCheckBox* transparent() const { return m_transparent; }
    SpaceRows* space() const { return m_space; }
    SliceRows* slice() const { return m_slice; }
    QComboBox* supersampling() const { return m_supersampling; }
    void resetToDefault();

signals:
    void message(const QString& sentence);

private:
    using Setting = std::function<void(attractor::Appearance&)>;
    void makeColourRows(QFormLayout* form);
    void makeGradientRows(QFormLayout* form);
    void makeGradientEditor(QFormLayout* form);
    void choosePalette(); // choice among all palettes of the program
    void makeToneRows(QFormLayout* form);
    void makeMapColours(QFormLayout* form);
    ColourButton* colourButton(const QString& name, attractor::Rgba attractor::Appearance::*member);
    void follow(const document::Change& change);
    // Groups of settings that affect the picture shown.
    struct Uses {
        bool colourBy = false; // densities only
        bool palette = false;
        bool plain = false;
        bool mapColours = false;
        bool tone = false;
        bool isPlane = true;

        friend bool operator==(const Uses&, const Uses&) = default;
    };
    Uses uses() const;
    void showUses();
    void showMapColours();
    void preview(const QString& text, const Setting& set);
    void edit(const QString& text, const Setting& set);

    document::Document* m_document;
    document::LiveEdit m_edit;
    QFormLayout* m_form;
    SpaceRows* m_space;
    SliceRows* m_slice;
    std::optional<Uses> m_shownUses; // rows as laid out, because a new layout is slow in a drag
    QHBoxLayout* m_gradientRow;
    QComboBox* m_colourBy;
    GradientChooser* m_gradient;
    QLabel* m_gradientLabel;
    QToolButton* m_browsePalettes;
    QToolButton* m_editGradient;
    GradientEditor* m_editor;
    ColourButton* m_plain;
    QLabel* m_plainLabel;
    ColourButton* m_background;
    QCheckBox* m_transparent;
    NumberRows* m_numbers;
    QComboBox* m_supersampling;
    QLabel* m_mapColoursLabel;
    QWidget* m_mapColours;
    QGridLayout* m_mapColoursGrid;
    std::vector<ColourButton*> m_mapButtons;
    QToolButton* m_reset;
};

} // namespace view
