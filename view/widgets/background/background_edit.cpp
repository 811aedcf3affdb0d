// SPDX-License-Identifier: MIT
#include "widgets/background/background_edit.h"

#include "document/document.h"
#include "io/file/background.h"

#include <chrono>
#include <utility>

namespace view {

BackgroundEdit::BackgroundEdit(const document::Document* document, QObject* parent)
    : QObject(parent), m_document(document) {
    connect(&m_finding, &QFutureWatcherBase::finished, this, &BackgroundEdit::finish);
}

void BackgroundEdit::start(Find find, Take take) {
    constexpr std::chrono::milliseconds patience{50};
    m_take = std::move(take);
    m_finding.setFuture(io::inBackground<Found>(
        [find = std::move(find), fractal = m_document->sharedFractal()](QPromise<Found>& promise) {
            promise.addResult(Found{fractal, find(*fractal)});
        }));
    if (io::finishesWithin(patience, m_finding.future())) finish();
}

void BackgroundEdit::finish() {
    const Take take = std::exchange(m_take, nullptr);
    if (!take || m_finding.future().resultCount() == 0) return;
    if (const Found found = m_finding.result(); found.from == m_document->sharedFractal()) take(found.to);
}

} // namespace view
