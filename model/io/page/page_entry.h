// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/report/json_writer.h"

// An entry as web pages hold it: app/web/page/types.d.ts says what each member is.
namespace io {

// Initial view of an entry on web pages: the share of the picture that stays free on each side, and the
// camera in space.
constexpr double pageMargin = 0.09;
constexpr double pageAzimuth = 30, pageElevation = 20; // degrees

// The view of an entry in space is fitted to a square. Animations and partners are left out.
void writePageEntry(JsonWriter& json, const document::Fractal& fractal);

} // namespace io
