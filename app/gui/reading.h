// SPDX-License-Identifier: MIT
#pragma once

#include "io/collection_reader.h"
#include "io/save_file.h"

#include <QString>

class QWidget;

struct Reading {
    io::Loaded loaded;         // its failure says why there is nothing
    io::Collection collection; // when there is no failure
};

// Reads a file in a thread of its own. What takes longer than a moment shows a dialog over `window` (nullptr:
// over nothing), which can be cancelled; the events of all windows go on being handled meanwhile.
Reading readFile(const QString& path, QWidget* window);
