// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/tools/branch_choice.h"
#include "canvas/tools/maps_tool.h"

namespace view {

// Selects the branch under the pointer, to a depth, and drags it by its image of the cage.
class BranchTool : public MapsTool {
    Q_OBJECT

public:
    explicit BranchTool(CanvasScene& scene);

    // The chosen branch, shared with the window into space.
    BranchChoice& choice() { return m_choice; }

    double shareToShow(const std::function<const document::Fractal&(double)>& after) override;
    void press(const Pointer& pointer) override;
    bool walk(int step) override;
    bool keyPress(const QKeyEvent& event) override;
    void start() override;
    void stop() override;

protected:
    HeldMaps hold(const CanvasPart& part) override;
    QString stepText(DragMode mode, std::optional<std::size_t> corner) const override {
        return m_choice.stepText(mode, corner);
    }
    Shown preview(const std::function<DragResult(double)>& resultAt) override;
    void pressed(const CanvasPart&, Qt::KeyboardModifiers) override {}
    void clicked(const CanvasPart& part, const Pointer& pointer) override;
    void abandoned() override;
    void ended() override;

private:
    void showChoice();
    bool selectAt(const QPointF& position); // false if no branch is there
    void ask();
    void say();

    BranchChoice m_choice;
};

} // namespace view
