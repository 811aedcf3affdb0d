// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/threads/workers.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

namespace attractor {

// Numbered jobs for a team of threads. Every thread begins with a share of its own, a run of neighbouring
// jobs, and then helps with the others'. What a stop leaves undone stays for the next run().
class JobShares {
public:
    void reset(std::size_t jobs, const Workers& workers); // marks all jobs as open
    void clear() { m_next.clear(); }                      // removes all jobs
    bool left() const;
    // work(job, thread) for every job that is left, once; stopped, for some of them.
    void run(Workers& workers, const std::stop_token& stop,
             const std::function<void(std::size_t job, std::size_t thread)>& work);

private:
    std::size_t end(std::size_t share) const { return m_jobs * (share + 1) / m_next.size(); }

    std::size_t m_jobs = 0;
    std::vector<std::atomic<std::size_t>> m_next; // next job of each share
};

} // namespace attractor
