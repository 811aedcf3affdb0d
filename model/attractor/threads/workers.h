// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace attractor {

// A team of threads for one caller: run() executes work(0) … work(size − 1) at the same time, work(0) on the
// caller, and returns when all are done. Fewer than asked for where the system gives no more threads. What
// the work throws, as when memory is short, run() throws when all are done.
class Workers {
public:
    explicit Workers(std::size_t size);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    std::size_t size() const { return m_threads.size() + 1; }
    void run(const std::function<void(std::size_t)>& work);

private:
    void serve(std::size_t thread);
    void attempt(const std::function<void(std::size_t)>& work, std::size_t thread);

    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::condition_variable m_finished;
    const std::function<void(std::size_t)>* m_work = nullptr;
    std::size_t m_round = 0;
    std::size_t m_busy = 0;
    bool m_quit = false;
    std::exception_ptr m_thrown;         // first exception of this round
    std::vector<std::jthread> m_threads; // last member: the threads use the others
};

} // namespace attractor
