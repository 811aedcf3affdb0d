// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis/analysis_thread.h"
#include "document/document.h"

#include <QObject>

#include <memory>
#include <set>

namespace view {

// The only place that knows both the document and the analysis thread. While anybody watches, every change of
// the picture becomes a request, and every result a signal in the GUI thread. What is outlined on the canvas
// is a state of the view: no part of the document, no undo.
class AnalysisBridge : public QObject {
    Q_OBJECT

public:
    explicit AnalysisBridge(document::Document* document, QObject* parent = nullptr);
    ~AnalysisBridge() override;

    // True while a panel shows the analysis; outlines on the canvas count by themselves.
    void setWatched(bool watched);
    void setOutlined(document::Outline kind, bool outlined);
    const std::set<document::Outline>& outlined() const { return m_outlined; }
    void setCylinderDepth(int symbols);
    int cylinderDepth() const { return m_cylinderDepth; }

    // nullptr while nothing is known of the entry in hand; otherwise the newest, perhaps of a moment ago.
    std::shared_ptr<const document::Analysis> analysis() const { return m_analysis; }
    bool isCurrent() const; // true if it is complete and shows the present picture

signals:
    void changed();
    void outlinesChosen(); // also for cylinders of another depth

private:
    void follow(const document::Change& change);
    void ask(document::AnalysisThread::Haste haste);
    void take();
    bool isWatched() const { return m_watched || !m_outlined.empty(); }

    document::Document* m_document;
    bool m_watched = false;
    std::set<document::Outline> m_outlined;
    int m_cylinderDepth = 1;
    bool m_isStale = true;            // true if the document has changed since the last request
    std::uint64_t m_requested = 0;    // revision of the newest request
    std::uint64_t m_firstOfEntry = 0; // first request for the present entry
    std::shared_ptr<const document::Analysis> m_analysis;
    std::unique_ptr<document::AnalysisThread> m_thread; // last member: its thread uses the others
};

} // namespace view
