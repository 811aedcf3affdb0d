// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "io/file/save_file.h"

#include <QString>

/// What a new window shows: the maple, among the other entries of its file.
struct FirstPicture {
    document::FractalFile file;
    document::EntryId maple = document::EntryId::None;
};
FirstPicture firstPicture(); // /< no entries if the program's resources are missing

/// Draws the maple to a PNG file. Needs no display.
io::Failure drawFirstPicture(const QString& path);
