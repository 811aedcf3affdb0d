// SPDX-License-Identifier: MIT
#include "python/interruptible.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>
#include <optional>
#include <thread>

namespace python {

void interruptibly(const std::function<void(const std::stop_token&)>& work) {
    constexpr std::chrono::milliseconds between{50}; // interval between two checks for signals
    std::packaged_task<void(std::stop_token)> task([&](const std::stop_token& stop) { work(stop); });
    std::future<void> done = task.get_future();
    std::optional<pybind11::error_already_set> interrupted;
    {
        std::stop_source stop;
        std::thread thread(std::move(task), stop.get_token());
        while (true) {
            std::future_status status{};
            {
                const pybind11::gil_scoped_release release;
                status = done.wait_for(interrupted ? std::chrono::hours(1) : between);
            }
            if (status == std::future_status::ready) break;
            if (!interrupted && PyErr_CheckSignals() != 0) {
                interrupted.emplace();
                stop.request_stop();
            }
        }
        thread.join();
    }
    if (interrupted) throw pybind11::error_already_set(*interrupted);
    done.get();
}

} // namespace python
