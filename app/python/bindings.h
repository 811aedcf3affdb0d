// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

// The extension barycage._core: what barycage/__init__.py is made of. Its functions take and return plain
// values and arrays; names, defaults and documentation are those of the Python sources.
namespace python {

void bindEntries(pybind11::module_& core);
void bindPictures(pybind11::module_& core);
void bindFacts(pybind11::module_& core);
void bindChanges(pybind11::module_& core);
void bindPages(pybind11::module_& core);

} // namespace python
