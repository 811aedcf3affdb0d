// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QString>

#include <cstddef>
#include <span>
#include <vector>

// Maps that are locked. A lock holds against whatever edits single maps: typing, drags, nudges, weaving,
// deleting, pasting over, arranging, fitting. What changes a system as a whole changes its locked maps, too.
// docs/decisions/0026.
namespace document {

bool isLocked(const Fractal& fractal, std::size_t index);

// Why these maps cannot be edited, as a sentence; empty where none of them is locked.
QString lockObstacle(const Fractal& fractal, std::span<const std::size_t> indices);
QString lockObstacle(const Fractal& fractal, const std::vector<int>& rows);

std::vector<ifs::MapId> lockedMaps(const Fractal& fractal); // in the order of the maps

// Edits of one undo step; the names are cut to what a name can be.
void lockMaps(Document& document, std::span<const ifs::MapId> maps, bool lock);
void renameMap(Document& document, std::size_t index, const QString& name);

// The labels of maps that stand for others after an edit: `made` has the label of `of`. A copy is there to be
// edited: it has the name, and a lock only where it is to keep it.
enum class CopyLock { Drop, Keep };
void copyLabel(const MapLabels& from, ifs::MapId of, MapLabels& to, ifs::MapId made, CopyLock lock);

} // namespace document
