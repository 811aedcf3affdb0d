// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;

namespace view {

class AppearanceSlider;

// The parameters of a system of the triangle or the square family, while the document holds one: one step of
// the history for each drag.
class FamilySliders : public QWidget {
    Q_OBJECT

public:
    explicit FamilySliders(document::Document* document, QWidget* parent = nullptr);

private:
    struct Row {
        QLabel* name;
        AppearanceSlider* slider;
    };
    void follow();
    void tryValue(std::size_t index, double value);

    document::Document* m_document;
    std::vector<Row> m_rows;
    std::optional<document::EditGesture> m_gesture;
};

} // namespace view
