// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QPointer>

namespace document {

// A drag, or the typing in one cell: shows values live and leaves one undo step, or none.
// Opening a gesture while another is open commits the other first.
class EditGesture {
public:
    EditGesture(Document& document, const QString& text);
    ~EditGesture(); // cancels unless committed

    EditGesture(const EditGesture&) = delete;
    EditGesture& operator=(const EditGesture&) = delete;

    bool isOpen() const; // until commit, cancel, undo, or another edit ends it
    const Fractal& before() const {
        return *m_before;
    }                              // as it was when the gesture began; compute every step from it
    void preview(Fractal fractal); // shown at once, not in the history; ignored once the gesture has ended
    void commit();                 // one step; none when the fractal is as it was
    void cancel();                 // back to the beginning, exactly

private:
    friend class Document;
    QPointer<Document> m_document;
    QString m_text;
    std::shared_ptr<const Fractal> m_before;
    Change::Parts m_previewed; // what listeners have been told was live
};

} // namespace document
