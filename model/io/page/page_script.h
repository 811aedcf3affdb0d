// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

// The parts of a web page that are the same in all of them, from app/web.
namespace io {

// The file of this name, such as page.css or engine.wasm.gz.
QByteArray pagePart(const char* name);

// The modules of the page, and those of its worker, each as one script, and its style sheet, without indents.
QByteArray pageScript(bool isGallery);
QByteArray pageStyle();
QByteArray workerScript();

} // namespace io
