// SPDX-License-Identifier: MIT
#include "attractor/threads/workers.h"

#include <system_error>
#include <utility>

namespace attractor {

Workers::Workers(std::size_t size) {
    try {
        for (std::size_t thread = 1; thread < size; ++thread)
            m_threads.emplace_back([this, thread] { serve(thread); });
    } catch (const std::system_error&) {
        // No further threads: the existing ones do all the work.
    }
}

Workers::~Workers() {
    const std::lock_guard lock(m_mutex);
    m_quit = true;
    m_wake.notify_all();
}

void Workers::run(const std::function<void(std::size_t)>& work) {
    {
        const std::lock_guard lock(m_mutex);
        m_work = &work;
        m_busy = m_threads.size();
        ++m_round;
    }
    m_wake.notify_all();
    attempt(work, 0);
    std::unique_lock lock(m_mutex);
    m_finished.wait(lock, [this] { return m_busy == 0; });
    if (const std::exception_ptr thrown = std::exchange(m_thrown, nullptr)) std::rethrow_exception(thrown);
}

void Workers::attempt(const std::function<void(std::size_t)>& work, std::size_t thread) {
    try {
        work(thread);
    } catch (...) {
        const std::lock_guard lock(m_mutex);
        if (!m_thrown) m_thrown = std::current_exception();
    }
}

void Workers::serve(std::size_t thread) {
    std::size_t seen = 0;
    while (true) {
        const std::function<void(std::size_t)>* work = nullptr;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [&] { return m_quit || m_round != seen; });
            if (m_quit) return;
            seen = m_round;
            work = m_work;
        }
        attempt(*work, thread);
        const std::lock_guard lock(m_mutex);
        if (--m_busy == 0) m_finished.notify_one();
    }
}

} // namespace attractor
