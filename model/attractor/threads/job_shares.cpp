// SPDX-License-Identifier: MIT
#include "attractor/threads/job_shares.h"

#include <algorithm>

namespace attractor {

void JobShares::reset(std::size_t jobs, const Workers& workers) {
    m_jobs = jobs;
    m_next = std::vector<std::atomic<std::size_t>>(workers.size());
    for (std::size_t share = 1; share < m_next.size(); ++share)
        m_next[share] = end(share - 1);
}

bool JobShares::left() const {
    for (std::size_t share = 0; share < m_next.size(); ++share)
        if (m_next[share] < end(share)) return true;
    return false;
}

void JobShares::run(Workers& workers, const std::stop_token& stop,
                    const std::function<void(std::size_t, std::size_t)>& work) {
    if (!left()) return;
    workers.run([&](std::size_t thread) {
        for (std::size_t turn = 0; turn < m_next.size(); ++turn) {
            const std::size_t share = (thread + turn) % m_next.size();
            while (!stop.stop_requested()) {
                const std::size_t job = m_next[share].fetch_add(1);
                if (job >= end(share)) break;
                work(job, thread);
            }
        }
    });
    for (std::size_t share = 0; share < m_next.size(); ++share)
        m_next[share] = std::min(m_next[share].load(), end(share));
}

} // namespace attractor
