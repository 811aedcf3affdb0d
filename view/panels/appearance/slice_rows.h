// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"

#include <QObject>

#include <array>

class QComboBox;
class QFormLayout;
class QWidget;

namespace view {

class AppearanceSlider;
class NumberField;

// The rows of the Appearance panel by which an entry in space is cut: the part to keep, the normal of the
// plane, its offset and, of a slice, its thickness, both in units of space. One undo step per drag or choice.
class SliceRows : public QObject {
    Q_OBJECT

public:
    // Adds its rows to the form, on the panel that is the parent.
    SliceRows(QFormLayout* form, document::Document* document, QWidget* parent);

    void follow(bool isLive); // shows the document's values; `isLive`: further changes follow

    enum class Kind { Whole, Half, Slice };
    enum class Across { X, Y, Z, Diagonal, Typed };
    QComboBox* kind() const { return m_kind; }
    QComboBox* direction() const { return m_direction; }
    AppearanceSlider* offset() const { return m_offset; }
    AppearanceSlider* thickness() const { return m_thickness; }

private:
    void makeRows(QFormLayout* form, QWidget* parent);
    void makeNormal(QFormLayout* form, QWidget* parent);
    void choose(Kind kind);
    void turnTo(const ifs::Vector<3>& normal, const QString& text);
    void editNormal(int axis, double value);
    void editClip(const QString& text, const std::function<void(attractor::SpaceClip&)>& change);
    void showExtent();

    QFormLayout* m_form;
    document::Document* m_document;
    document::LiveEdit m_edit;
    QComboBox* m_kind = nullptr;
    QComboBox* m_direction = nullptr;
    QWidget* m_normalBox = nullptr;
    std::array<NumberField*, 3> m_normal{};
    AppearanceSlider* m_offset = nullptr;
    AppearanceSlider* m_thickness = nullptr;
    bool m_isShown = true;
};

} // namespace view
