// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>

// Translates the sentences of functions that belong to no QObject: Text::tr("…").
struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};
