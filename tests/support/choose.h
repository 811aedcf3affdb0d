// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/choices.h"

#include <QComboBox>
#include <QTest>

namespace support {

// Chooses the row that holds a value, as a hand does. Ends the test program where no row does.
template <class Value> void choose(QComboBox* box, const Value& value) {
    if (!view::chooseValue(box, value))
        qFatal("%s has no row for the value", qPrintable(box->accessibleName()));
    emit box->activated(box->currentIndex());
}

} // namespace support
