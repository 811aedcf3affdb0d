// SPDX-License-Identifier: MIT
#include "attractor/render/render_state.h"

#include "attractor/folds/make_fold.h"

#include <algorithm>

namespace attractor {

void RenderState::start(RenderRequest newRequest) {
    if (!m_fold || newRequest.algorithm != request().algorithm)
        m_fold = makeFold(newRequest.algorithm, m_prepared);
    m_prepared.set(std::move(newRequest));
    const auto threads = static_cast<std::size_t>(request().threads);
    if (!m_workers || m_workers->size() != threads) m_workers = std::make_unique<Workers>(threads);
    m_fold->start(*m_workers);
    m_isDrawable = m_prepared.isDrawable();
    m_note = noteOfStart();
}

void RenderState::rewind(int firstRow, int endRow) {
    const int side = m_prepared.cellsPerPixel();
    m_fold->rewind({std::max(0, m_prepared.projection().grid.width), firstRow * side,
                    std::max(firstRow, endRow) * side});
}

RenderNote RenderState::noteOfStart() const {
    if (m_prepared.system().note != RenderNote::None) return m_prepared.system().note;
    if (m_fold->note() != RenderNote::None) return m_fold->note();
    return m_prepared.viewNote();
}

} // namespace attractor
