// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stop_token>

namespace python {

// Does the work in a thread of its own without the interpreter's lock, and asks it to stop when Ctrl+C is
// pressed, which is KeyboardInterrupt once it has stopped. What the work throws comes out here. Call with the
// lock.
void interruptibly(const std::function<void(const std::stop_token&)>& work);

} // namespace python
