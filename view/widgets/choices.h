// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QString>
#include <QVariant>

#include <type_traits>

/// @file
/// Lists to choose from. A row holds the value that it stands for, so that nothing depends on where in the
/// list it is.

namespace view {

template <class Value> QVariant choiceData(const Value& value) {
    if constexpr (std::is_enum_v<Value>)
        return int(value);
    else
        return QVariant::fromValue(value);
}

template <class Value>
void addChoice(QComboBox* box, const QString& text, const Value& value, const QString& tip = {}) {
    box->addItem(text, choiceData(value));
    if (!tip.isEmpty()) box->setItemData(box->count() - 1, tip, Qt::ToolTipRole);
}

// The value of the current row; Value() where that has none, or there is no row.
template <class Value> Value chosenValue(const QComboBox* box) {
    if constexpr (std::is_enum_v<Value>)
        return Value(box->currentData().toInt());
    else
        return box->currentData().template value<Value>();
}

// Makes the row of a value the current one; where no row has it, none is and the answer is false.
template <class Value> bool chooseValue(QComboBox* box, const Value& value) {
    box->setCurrentIndex(box->findData(choiceData(value)));
    return box->currentIndex() >= 0;
}

} // namespace view
