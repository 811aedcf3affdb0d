// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

#include <string>
#include <vector>

// The parts of a web page that are the same in all of them, from app/web.
namespace io {

// The file of this name, such as page.css or engine.wasm.gz.
QByteArray pagePart(const std::string& name);

// notation::joinedScript() of the files of these names.
QByteArray joinedScript(const std::vector<std::string>& modules, const QByteArray& end = {});

} // namespace io
