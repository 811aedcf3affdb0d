// SPDX-License-Identifier: MIT
#include "space/four_views.h"

#include <QGridLayout>

#include <algorithm>
#include <utility>

namespace view {

FourViews::FourViews(document::Document* document, SolidBridge* bridge, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_bridge(bridge),
      m_main(new SpaceView(document, bridge, this)),
      m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(1);
    m_grid->addWidget(m_main, 0, 1);
    setFocusProxy(m_main);
    follow(m_main);
}

void FourViews::follow(SpaceView* view) {
    connect(view, &SpaceView::defined, this, &FourViews::defined);
    connect(view, &SpaceView::mapHeld, this, [this, view](std::size_t index) {
        for (SpaceView* each : all())
            each->holdMap(index, view->selectedIds());
    });
}

void FourViews::makeOthers() {
    const struct {
        attractor::Direction from;
        QString title;
        int row;
        int column;
    } views[] = {
        {directions::top, tr("Top"), 0, 0},
        {directions::front, tr("Front"), 1, 0},
        {directions::right, tr("Right"), 1, 1},
    };
    for (const auto& [from, title, row, column] : views) {
        auto* bridge = new SolidBridge(m_document);
        auto* view = new SpaceView(m_document, bridge, this);
        bridge->setParent(view); // destroyed together
        bridge->showInstead(m_instead);
        view->navigation().setUpAxis(m_up);
        view->fixDirection(from, title);
        view->setOverlaysVisible(m_areOverlaysVisible);
        view->setBranchChoice(m_branch);
        view->setTarget(m_target);
        view->holdMap(m_main->heldMap().value_or(0), m_main->selectedIds());
        view->setAllowsNoAttractor(m_allowsNoAttractor);
        view->showOutlines(m_outlines);
        connect(view, &SpaceView::pointerMoved, m_main, &SpaceView::pointerMoved);
        connect(view, &SpaceView::pointerLeft, m_main, &SpaceView::pointerLeft);
        connect(view, &SpaceView::message, m_main, &SpaceView::message);
        follow(view);
        connect(view, &SpaceView::mapHeld, m_main, &SpaceView::mapHeld); // sent after all views hold the map
        m_grid->addWidget(view, row, column);
        m_others.push_back(view);
    }
}

void FourViews::showFour(bool four) {
    if (four == m_areFourShown) return;
    m_areFourShown = four;
    cancelGesture();
    m_main->navigation().lendPerspective(four);
    if (four) {
        makeOthers();
    } else { // hidden views would still be drawn
        qDeleteAll(std::exchange(m_others, {}));
    }
    for (const int line : {0, 1}) { // equal sizes, whatever their hints
        m_grid->setRowStretch(line, four || line == 0 ? 1 : 0);
        m_grid->setColumnStretch(line, four || line == 1 ? 1 : 0);
    }
    if (!four) m_main->setFocus();
    emit fourShown(four);
}

std::vector<SpaceView*> FourViews::all() const {
    std::vector<SpaceView*> views = m_others;
    views.push_back(m_main);
    return views;
}

void FourViews::fit() {
    for (SpaceView* view : all())
        view->navigation().fit();
}

void FourViews::setOverlaysVisible(bool visible) {
    m_areOverlaysVisible = visible;
    for (SpaceView* view : all())
        view->setOverlaysVisible(visible);
}

void FourViews::setUpAxis(attractor::UpAxis up) {
    m_up = up;
    for (SpaceView* view : all())
        view->navigation().setUpAxis(up);
}

void FourViews::setTarget(SpaceView::Target target) {
    m_target = target;
    for (SpaceView* view : all())
        view->setTarget(target);
}

void FourViews::setBranchChoice(BranchChoice* choice) {
    m_branch = choice;
    for (SpaceView* view : all())
        view->setBranchChoice(choice);
}

void FourViews::setAllowsNoAttractor(bool allows) {
    m_allowsNoAttractor = allows;
    for (SpaceView* view : all())
        view->setAllowsNoAttractor(allows);
}

void FourViews::showOutlines(const std::vector<document::SpaceOutline>& shapes) {
    m_outlines = shapes;
    for (SpaceView* view : all())
        view->showOutlines(shapes);
}

void FourViews::showInstead(std::shared_ptr<const document::Fractal> fractal) {
    m_instead = std::move(fractal);
    m_bridge->showInstead(m_instead);
    for (SpaceView* view : m_others)
        view->findChild<SolidBridge*>(QString(), Qt::FindDirectChildrenOnly)->showInstead(m_instead);
}

void FourViews::setStereo(attractor::Stereo stereo) {
    m_main->setStereo(stereo);
}

bool FourViews::cancelGesture() {
    return std::ranges::count_if(all(), [](SpaceView* view) { return view->cancelGesture(); }) > 0;
}

} // namespace view
