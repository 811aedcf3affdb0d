// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance_fields.h"
#include "document/edits/live_edit.h"

#include <QObject>

#include <vector>

class QFormLayout;

namespace view {

class AppearanceSlider;

// The sliders of the *Appearance* panel, one for each of attractor::appearanceNumbers. They are live; one
// undo step per drag or typed number.
class NumberRows : public QObject {
    Q_OBJECT

public:
    NumberRows(QFormLayout* form, document::Document* document, QWidget* parent);

    AppearanceSlider* slider(double attractor::Appearance::*member) const;
    void follow(const attractor::Appearance& appearance);
    void setVisible(bool tones, bool shadow);

private:
    void showRows();
    void addRow(const attractor::AppearanceNumber& number, QWidget* parent);

    QFormLayout* m_form;
    document::LiveEdit m_edit;
    std::vector<AppearanceSlider*> m_sliders; // indexed like appearanceNumbers
    bool m_showsTones = true;
    bool m_showsShadow = true;
    bool m_hasShadow = false;
};

} // namespace view
