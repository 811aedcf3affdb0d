// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QFutureWatcher>
#include <QObject>

#include <functional>
#include <memory>
#include <optional>

namespace document {

class Document;

}

namespace view {

// A change of the entry that may take long to find, and is then found in the background: it is taken unless
// something else has been done since.
class BackgroundEdit : public QObject {
    Q_OBJECT

public:
    using Fractal = document::Fractal;
    using Find = std::function<std::optional<Fractal>(const Fractal&)>; // argument: the fractal with its cage
    using Take = std::function<void(std::optional<Fractal>)>;           // nullopt: no result

    explicit BackgroundEdit(const document::Document* document, QObject* parent = nullptr);

    // Waits for a moment in the window's thread: a result found by then is taken before this returns.
    void start(Find find, Take take);

private:
    struct Found {
        std::shared_ptr<const Fractal> from;
        std::optional<Fractal> to;
    };
    void finish();

    const document::Document* m_document;
    QFutureWatcher<Found> m_finding;
    Take m_take; // null once it has been called
};

} // namespace view
