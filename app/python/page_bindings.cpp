// SPDX-License-Identifier: MIT
#include "python/bindings.h"

#include "notation/page/page_text.h"

#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace python {

void bindPages(pybind11::module_& core) {
    core.def("page_modules", [] { return notation::pageModules(); });
    core.def("worker_modules", &notation::workerModules);
    core.def("joined_script",
             [](const std::vector<std::string>& modules) { return notation::joinedScript(modules); });
    core.def("in_base85",
             [](const pybind11::bytes& bytes) { return notation::inBase85(std::string(bytes)); });
    core.def("plain_style", &notation::plainStyle);
    core.def("embedded", &notation::embedded);
    core.def("filled", &notation::filled);
}

} // namespace python
