// SPDX-License-Identifier: MIT
#include "bridges/extent_finder.h"

#include "document/fractal/space_geometry.h"
#include "io/file/background.h"

namespace view {

ExtentFinder::ExtentFinder(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document) {
    connect(document, &document::Document::changed, this, &ExtentFinder::follow);
    connect(&m_finding, &QFutureWatcherBase::finished, this, [this] {
        if (document::isSpaceExtentKnown(m_document->fractal()))
            announce();
        else if (m_sought != m_document->sharedFractal()) // changed meanwhile
            find();
    });
    find();
}

void ExtentFinder::follow(const document::Change& change) {
    using document::Change;
    m_isHeld = change.live && !(change.parts & Change::Time);
    if (change.parts & (Change::System | Change::Current | Change::File)) find();
    if (m_isDue && !m_isHeld) QMetaObject::invokeMethod(this, &ExtentFinder::announce, Qt::QueuedConnection);
}

void ExtentFinder::announce() {
    m_isDue = m_isHeld;
    if (!m_isHeld) m_document->announceExtent();
}

void ExtentFinder::find() {
    const auto fractal = m_document->sharedFractal();
    if (m_finding.isRunning() || document::isSpaceExtentKnown(*fractal)) return;
    m_sought = fractal;
    m_finding.setFuture(io::inBackground<void>([fractal](QPromise<void>&) {
        (void)fractal->supports.simplexInSpace(*document::system3(*fractal));
    }));
}

} // namespace view
