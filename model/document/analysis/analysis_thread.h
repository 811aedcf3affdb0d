// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis/analysis.h"

#include <functional>
#include <memory>

namespace document {

// A worker thread of low priority around Analyser, so that no frame waits for an analysis. The newest request
// wins; each is announced when its quick part is known and again when it is complete.
class AnalysisThread {
public:
    // `ready` is called on the worker thread, never again before newest() has been called since.
    explicit AnalysisThread(std::function<void()> ready);
    ~AnalysisThread(); // stops and joins

    AnalysisThread(const AnalysisThread&) = delete;
    AnalysisThread& operator=(const AnalysisThread&) = delete;

    enum class Haste {
        Now,    // abandons work under way
        InTurn, // lets work under way finish, unless it takes long
    };
    // Thread-safe, never waits. The fractal must be a system.
    void submit(AnalysisRequest request, Haste haste);
    void cancel(); // drops waiting requests and abandons work under way

    // Thread-safe; nullptr before the first. The revision tells to which request it belongs.
    std::shared_ptr<const Analysis> newest();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace document
