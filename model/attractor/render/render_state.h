// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/fold.h"
#include "attractor/folds/prepared_request.h"
#include "attractor/request/render_request.h"
#include "attractor/threads/workers.h"

#include <memory>
#include <stop_token>

namespace attractor {

// State shared by Rendering and BandedRendering: a prepared request, the fold that draws it and its worker
// threads. Serves one request after the other and reuses its memory. Not thread-safe.
class RenderState {
public:
    void start(RenderRequest request); // must be followed by rewind()
    // Empties the picture; rows [firstRow, endRow) of pixels will be drawn.
    void rewind(int firstRow, int endRow);

    const PreparedRequest& prepared() const { return m_prepared; }
    const RenderRequest& request() const { return m_prepared.request(); }
    bool isDrawable() const { return m_isDrawable; }
    RenderNote note() const { return m_note; }
    Fold& fold() { return *m_fold; }
    const Fold& fold() const { return *m_fold; }

    // Forwards to the fold; where there is nothing to draw, all passes are complete.
    bool complete(const std::stop_token& stop) { return !m_isDrawable || m_fold->complete(stop); }
    bool finished() const { return !m_isDrawable || m_fold->finished(); }

private:
    RenderNote noteOfStart() const;

    PreparedRequest m_prepared;
    std::unique_ptr<Workers> m_workers;
    std::unique_ptr<Fold> m_fold;
    bool m_isDrawable = false;
    RenderNote m_note = RenderNote::None;
};

} // namespace attractor
