// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QFutureWatcher>
#include <QObject>

#include <memory>

namespace view {

// Finds the extent of an entry in space with very many maps in the background, and has the document tell
// everybody when it is known: document::isSpaceExtentKnown(). Meanwhile its cage in force is not known.
class ExtentFinder : public QObject {
    Q_OBJECT

public:
    explicit ExtentFinder(document::Document* document, QObject* parent = nullptr);

private:
    void follow(const document::Change& change);
    void find();
    void announce();

    document::Document* m_document;
    std::shared_ptr<const document::Fractal> m_sought;
    QFutureWatcher<void> m_finding; // one run at a time; in a drag, for the newest maps
    bool m_isHeld = false;          // true within a gesture, which an announcement would seem to end
    bool m_isDue = false;
};

} // namespace view
