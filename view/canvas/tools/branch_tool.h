// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/tools/maps_tool.h"

#include <deque>

namespace view {

// Selects the branch under the pointer, to a depth, and drags it by its image of the cage.
class BranchTool : public MapsTool {
    Q_OBJECT

public:
    static constexpr int maxDepth = 12;

    explicit BranchTool(CanvasScene& scene);

    int depth() const { return m_depth; } // symbols of the branch's address
    void setDepth(int depth);
    void setEdit(document::BranchEdit edit) { m_edit = edit; } // of the drags to come
    // The whole address of the point that was clicked, of which the branch is the beginning.
    const ifs::Word& address() const { return m_address; }

    double shareToShow(const std::function<const document::Fractal&(double)>& after) override;
    void press(const Pointer& pointer) override;
    void walk(int step) override;
    bool keyPress(const QKeyEvent& event) override;
    void start() override;
    void stop() override;

signals:
    void changed(); // depth or address

protected:
    HeldMaps hold(const CanvasPart& part) override;
    QString stepText(PolygonDrag::Mode mode, std::optional<std::size_t> corner) const override;
    Shown preview(const std::function<DragResult(double)>& resultAt) override;
    void pressed(const CanvasPart&, Qt::KeyboardModifiers) override {}
    void clicked(const CanvasPart& part, const Pointer& pointer) override;
    void ended() override;

private:
    void select(const ifs::Word& address);
    void selectAt(const QPointF& position);
    void follow(const document::Change& change);
    void ask();
    void say();

    int m_depth = 2;
    document::BranchEdit m_edit = document::BranchEdit::OwnMap;
    ifs::Word m_address;
    ifs::Word m_addressAtPress;
    std::shared_ptr<const document::Fractal> m_before; // as it was at the press, while something is held
    // What was selected before and after the latest drags, for undo and redo.
    struct Selected {
        std::weak_ptr<const document::Fractal> fractal;
        ifs::Word address;
    };
    std::deque<Selected> m_selected;
};

} // namespace view
