// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>
#include <QString>

#include <cstdint>

class QWidget;

namespace view {

// A warning about the demands of a picture on the machine, if they would surprise: from 500 million pixels or
// 8 GB of memory on. Empty for a smaller one.
QString largeExportSentence(const QSize& pixels, std::uint64_t memory);

// Asks before such a picture is begun. True: it is not so large, or the user wants it.
bool confirmLargeExport(QWidget* parent, const QSize& pixels, std::uint64_t memory);

} // namespace view
