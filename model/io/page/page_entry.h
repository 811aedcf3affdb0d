// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/report/json_writer.h"

// An entry as web pages hold it: app/web/page/engine.js says what each member is.
namespace io {

// How web pages show an entry at first: with this share of the picture free on each side, and from here in
// space.
constexpr double pageMargin = 0.09;
constexpr double pageAzimuth = 30, pageElevation = 20; // degrees

// What it shows of an entry in space is fitted to a square. Animations and partners are left out.
void writePageEntry(JsonWriter& json, const document::Fractal& fractal);

} // namespace io
