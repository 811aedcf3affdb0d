// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

#include <vector>

// The parts of a web page that are the same in all of them, from app/web.
namespace io {

// The file of this name, such as page.css or engine.wasm.gz.
QByteArray pagePart(const char* name);

// The modules of the page, and those of its worker: each list becomes one script, without what belongs to
// modules and to people, in one scope, so that no two of them may declare the same name. The extra one, if it
// is given, is for a gallery or a lesson. At the end stands what else is to be run.
std::vector<const char*> pageModules(const char* extra);
std::vector<const char*> workerModules();
QByteArray joinedScript(const std::vector<const char*>& modules, const QByteArray& end = {});

QByteArray pageStyle(); // CSS without indents

} // namespace io
