// SPDX-License-Identifier: MIT
#pragma once

#include "space/space_view.h"

#include <QWidget>

#include <vector>

class QGridLayout;

namespace view {

// The window into space, alone or as one of four: from the top, from the front and from the right beside the
// view that orbits, which is then in perspective unless the user chooses otherwise. What is dragged in one
// moves in all.
class FourViews : public QWidget {
    Q_OBJECT

public:
    FourViews(document::Document* document, SolidBridge* bridge, QWidget* parent = nullptr);

    SpaceView* main() const { return m_main; } // view that orbits
    // top, front, right; empty while the main one is alone
    const std::vector<SpaceView*>& others() const { return m_others; }
    bool areFourShown() const { return m_areFourShown; }
    void showFour(bool four);

    // Operations on all views that are shown:
    void fit();
    void setOverlaysVisible(bool visible);
    void setUpAxis(attractor::UpAxis up);
    void setTarget(SpaceView::Target target);
    void setBranchChoice(BranchChoice* choice);
    void setAllowsNoAttractor(bool allows);
    void showOutlines(const std::vector<document::SpaceOutline>& shapes);
    bool cancelGesture();
    void showInstead(std::shared_ptr<const document::Fractal> fractal); // see SolidBridge
    void setStereo(attractor::Stereo stereo);                           // stereo mode of the view that orbits
    attractor::Stereo stereo() const { return m_main->navigation().stereo(); }

signals:
    void fourShown(bool four);
    void defined(); // sent by any view; see SpaceView

private:
    void makeOthers();
    void follow(SpaceView* view);
    std::vector<SpaceView*> all() const;

    document::Document* m_document;
    SolidBridge* m_bridge; // bridge of the main view
    SpaceView* m_main;
    QGridLayout* m_grid;
    std::vector<SpaceView*> m_others; // also the parents of their bridges
    // State for views that are made later.
    bool m_areOverlaysVisible = true;
    attractor::UpAxis m_up = attractor::UpAxis::Y;
    bool m_allowsNoAttractor = false;
    BranchChoice* m_branch = nullptr;
    SpaceView::Target m_target = SpaceView::Target::Cage;
    std::vector<document::SpaceOutline> m_outlines;
    std::shared_ptr<const document::Fractal> m_instead;
    bool m_areFourShown = false;
};

} // namespace view
