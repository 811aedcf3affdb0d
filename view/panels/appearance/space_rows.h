// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"

#include <QObject>

class QComboBox;
class QFormLayout;

namespace view {

class AppearanceSlider;
class LightBall;

// The rows of the Appearance panel that entries in space have: look, colours of a solid, light and fog. Every
// control is live; one undo step per drag, run of keys or choice. Rows that the look has no use for are
// hidden.
class SpaceRows : public QObject {
    Q_OBJECT

public:
    // Adds its rows to the form, on the panel that is the parent.
    SpaceRows(QFormLayout* form, document::Document* document, QWidget* parent);

    void follow(); // shows the document's values

    QComboBox* look() const { return m_look; }
    QComboBox* colourBy() const { return m_colourBy; }
    LightBall* light() const { return m_light; }
    AppearanceSlider* fog() const { return m_fog; }

private:
    using Setting = std::function<void(attractor::SpaceAppearance&)>;
    void makeLook(QWidget* parent);
    void makeColours(QWidget* parent);
    void makeLight(QWidget* parent);
    void edit(const QString& text, const Setting& set);
    void preview(const QString& text, const Setting& set);

    QFormLayout* m_form;
    document::Document* m_document;
    document::LiveEdit m_edit;
    QComboBox* m_look = nullptr;
    QComboBox* m_colourBy = nullptr;
    LightBall* m_light = nullptr;
    AppearanceSlider* m_fog = nullptr;
    bool m_isShown = true;
};

} // namespace view
