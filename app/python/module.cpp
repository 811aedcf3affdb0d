// SPDX-License-Identifier: MIT
#include "python/bindings.h"

#include "attractor/request/pixel_version.h"

PYBIND11_MODULE(_core, core) {
    core.attr("pixel_version") = attractor::pixelVersion;
    python::bindEntries(core);
    python::bindPictures(core);
    python::bindFacts(core);
    python::bindChanges(core);
    python::bindPages(core);
}
