// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QByteArray>

#include <vector>

namespace io {

// Colours as designers list them: #264653 #2a9d8f …, alone, in quotation marks, in JSON, CSS or a program; or
// six hexadecimal digits each, with nothing else but separators, a comment at the beginning of a line, or the
// address of a page that ends in them (coolors.co/264653-2a9d8f). Two colours at least and 4096 at most; none
// where the text is anything else.
std::vector<attractor::Rgba> hexColours(const QByteArray& text);

} // namespace io
