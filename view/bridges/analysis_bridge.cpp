// SPDX-License-Identifier: MIT
#include "bridges/analysis_bridge.h"

#include <algorithm>
#include <utility>

namespace view {

using Haste = document::AnalysisThread::Haste;

AnalysisBridge::AnalysisBridge(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document), m_thread(std::make_unique<document::AnalysisThread>([this] {
          QMetaObject::invokeMethod(this, &AnalysisBridge::take, Qt::QueuedConnection);
      })) {
    connect(document, &document::Document::changed, this, &AnalysisBridge::follow);
}

AnalysisBridge::~AnalysisBridge() = default;

bool AnalysisBridge::isCurrent() const {
    return m_analysis && m_analysis->isComplete && m_analysis->revision == m_requested && !m_isStale;
}

void AnalysisBridge::setWatched(bool watched) {
    if (watched == m_watched) return;
    m_watched = watched;
    if (m_isStale) ask(Haste::Now);
}

void AnalysisBridge::setOutlined(document::Outline kind, bool outlined) {
    if (outlined == m_outlined.contains(kind)) return;
    outlined ? void(m_outlined.insert(kind)) : void(m_outlined.erase(kind));
    ask(Haste::Now);
    emit outlinesChosen();
    if (m_outlined.empty()) emit changed(); // also for the case that nobody watches any more
}

void AnalysisBridge::setCylinderDepth(int symbols) {
    if (symbols == m_cylinderDepth) return;
    m_cylinderDepth = symbols;
    emit outlinesChosen();
    if (m_outlined.contains(document::Outline::Cylinders)) ask(Haste::Now);
}

void AnalysisBridge::follow(const document::Change& change) {
    using document::Change;
    using document::Outline;
    const bool usesMapColours =
        m_outlined.contains(Outline::FixedPoints) || m_outlined.contains(Outline::Cylinders);
    if (!(change.parts & (Change::System | Change::Cage | Change::Current | Change::File)) &&
        !(change.parts & Change::Appearance && usesMapColours))
        return;
    m_isStale = true;
    if (change.parts & (Change::Current | Change::File)) {
        m_firstOfEntry = m_requested + 1;
        m_analysis.reset();
        emit changed();
    }
    ask(change.live ? Haste::InTurn : Haste::Now);
}

void AnalysisBridge::ask(Haste haste) {
    if (document::dimension(m_document->fractal()) == 0) {
        m_thread->cancel();
        return;
    }
    if (!isWatched()) return;
    m_isStale = false;
    m_thread->submit({.fractal = m_document->sharedFractal(),
                      .outlines = m_outlined,
                      .cylinderDepth = m_cylinderDepth,
                      .revision = ++m_requested},
                     haste);
}

void AnalysisBridge::take() {
    auto analysis = m_thread->newest();
    if (!analysis || analysis == m_analysis || analysis->revision < m_firstOfEntry) return;
    m_analysis = std::move(analysis);
    emit changed();
}

} // namespace view
