// SPDX-License-Identifier: MIT
#include "bridges/extent_finder.h"

#include "document/space_geometry.h"
#include "io/file/background.h"

namespace view {

ExtentFinder::ExtentFinder(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document) {
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        if (change.parts & (Change::System | Change::Current | Change::File)) find();
    });
    connect(&m_finding, &QFutureWatcherBase::finished, this, [this] {
        if (document::isSpaceExtentKnown(m_document->fractal()))
            m_document->announceExtent();
        else if (m_sought != m_document->sharedFractal()) // it has changed meanwhile
            find();
    });
    find();
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
