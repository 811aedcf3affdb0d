// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/file/embedded_system.h"

#include <QByteArray>
#include <QByteArrayView>
#include <QString>

// Entries in links: behind “barycage:”, or behind the “#” of the address of a web page, stands the text of
// the entry, deflated without a header, in Base64 for URLs. Browsers send nothing of that to a server.
// docs/formats.md, “Links”; app/web/page/link.js does the same in pages.
namespace io {

constexpr qsizetype maxLinkedText = 1'000'000; // bytes

// Why there is no link to the entry, in a sentence; empty where there may be one.
QString linkObstacle(const document::Fractal& fractal);
// A link that begins with “barycage:”, or that its text is too long for one.
struct WrittenLink {
    QByteArray link;
    Failure failure;
};
WrittenLink linkOf(const document::Fractal& fractal);

// Returns true if this text is a link and nothing else, complete or not. Line ends, which mail programs
// insert, are part of it.
bool looksLikeLink(QByteArrayView text);
// The text in a possible link. No more than the limit is ever unpacked.
EmbeddedSystem readLink(QByteArrayView link);

} // namespace io
