// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/maps_tool.h"

namespace view {

// Selects the branch under the pointer, to a depth, and takes it by its image of the cage.
class BranchTool : public MapsTool {
    Q_OBJECT

public:
    static constexpr int deepest = 12;

    explicit BranchTool(CanvasScene* scene);

    int depth() const { return m_depth; } // symbols of the branch's address
    void setDepth(int depth);
    void setEdit(document::BranchEdit edit) { m_edit = edit; } // of the drags to come
    // The whole address of the point that was clicked, of which the branch is the beginning.
    const ifs::Word& address() const { return m_address; }

    void press(const Pointer& pointer) override;
    void walk(int step) override;
    bool keyPress(const QKeyEvent& event) override;
    void start() override;
    void stop() override;

signals:
    void changed(); // depth or address

protected:
    Taken take(const CanvasPart& part) override;
    QString stepText(PolygonDrag::Mode mode, std::optional<std::size_t> corner) const override;
    double preview(const std::function<DragResult(double)>& resultAt) override;
    void taken(const CanvasPart&, Qt::KeyboardModifiers) override {}
    void clicked(const CanvasPart& part, const Pointer& pointer) override;
    void ended() override;

private:
    void select(const ifs::Word& address);
    void selectAt(const QPointF& position);
    void follow(const document::Change& change);
    void ask();

    int m_depth = 2;
    document::BranchEdit m_edit = document::BranchEdit::OwnMap;
    ifs::Word m_address;
    ifs::Word m_addressAtPress;
    std::shared_ptr<const document::Fractal> m_before; // as it was at the press, while something is held
};

} // namespace view
