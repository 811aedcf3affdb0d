// SPDX-License-Identifier: MIT
#include "lessons/lesson_state.h"

#include "bridges/analysis_bridge.h"
#include "bridges/construction.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/lesson/shown_step.h"
#include "document/text/text.h"
#include "stage/stage.h"

#include <algorithm>
#include <type_traits>

namespace {

using document::LessonArea;
using document::LessonAtRest;
using document::LessonCage;
using document::LessonConstruction;
using document::LessonFit;
using document::LessonOrbit;
using document::LessonState;
using document::LessonTool;
using document::Outline;
using Tool = view::CanvasView::Tool;

constexpr Outline outlines[] = {Outline::Box,         Outline::Hull,    Outline::Simplex,
                                Outline::FixedPoints, Outline::Ellipse, Outline::Cylinders};

template <int Dim> LessonCage cornersOf(const ifs::ControlCage<Dim>& cage) {
    if (cage.current == cage.rest) return LessonAtRest{};
    if (cage.current.size() > document::maxLessonCorners) return {};
    return cage.current;
}

LessonCage cageOf(const document::Fractal& fractal) {
    if (document::animationFacts(fractal)) return {}; // keys determine the camera
    if (const auto* cage = document::cage2(fractal)) return cornersOf(*cage);
    if (const auto* shape = document::space(fractal); shape && shape->cage) return cornersOf(*shape->cage);
    return document::dimension(fractal) == 0 ? LessonCage() : LessonAtRest{};
}

LessonConstruction constructionOf(const view::Construction& construction) {
    using enum LessonConstruction::Mode;
    LessonConstruction kept;
    switch (construction.mode()) {
    case view::Construction::Mode::Density:
        break;
    case view::Construction::Mode::Steps:
        kept.mode = Steps;
        kept.iterations = construction.step();
        break;
    case view::Construction::Mode::ChaosGame:
        kept.mode = ChaosGame;
        kept.points = construction.points();
        if (construction.isRunning()) kept.speed = construction.speed();
        break;
    }
    return kept;
}

QString showEntry(document::Document& document, const LessonState& state) {
    if (state.entry.isEmpty()) return {};
    const document::Entry* entry = document::entryOf(document.file(), state);
    if (!entry) return Text::tr("The file has no entry “%1”.").arg(state.entry);
    document.setCurrent(entry->id);
    return {};
}

QString showFractal(document::Document& document, const LessonState& state) {
    const document::Fractal& entry = document.entryFractal();
    if (document::dimension(entry) == 0) return {};
    if (document::animationFacts(entry)) document.setMoment(state.moment.value_or(animation::Moment()));
    document::ShownStep shown = document::withCageAndColours(state, entry);
    document.editEntry(Text::tr("Show a step of the lesson"), std::move(shown.fractal));
    return shown.fits ? QString()
                      : Text::tr("The cage of this entry does not have the same corners as in the lesson.");
}

void showConstruction(view::Construction& construction, const LessonConstruction& wanted) {
    using Mode = view::Construction::Mode;
    construction.setRunning(false);
    switch (wanted.mode) {
    case LessonConstruction::Mode::Density:
        construction.setMode(Mode::Density);
        break;
    case LessonConstruction::Mode::Steps:
        construction.setMode(Mode::Steps);
        construction.setStep(wanted.iterations);
        break;
    case LessonConstruction::Mode::ChaosGame:
        construction.setMode(Mode::ChaosGame);
        construction.setPoints(wanted.points);
        if (wanted.speed > 0) construction.setSpeed(wanted.speed);
        construction.setRunning(wanted.speed > 0);
        break;
    }
}

} // namespace

LessonState lessonState(const LessonParts& parts) {
    LessonState state;
    const document::Document& document = *parts.document;
    const document::Fractal& fractal = document.fractal();
    view::CanvasView& canvas = *parts.stage->plane();
    state.entry = document::lessonLine(fractal.name);
    if (parts.stage->showsSpace()) {
        const view::SpaceNavigation& space = parts.stage->space()->navigation();
        state.view = LessonOrbit{space.camera(), space.isFitted()};
    } else if (!canvas.navigation().isFitted() && canvas.camera().width > 0 && canvas.camera().height > 0) {
        state.view = document::areaOf(canvas.camera());
    } else {
        state.view = LessonFit{canvas.camera().yAxis, canvas.camera().rotation};
    }
    if (auto* orbit = std::get_if<LessonOrbit>(&state.view)) orbit->camera.size = {};
    if (canvas.tool() == Tool::Maps) state.tool = LessonTool::Maps;
    if (canvas.tool() == Tool::Branch) state.tool = LessonTool::Branch;
    state.cage = cageOf(document.entryFractal());
    if (document::plane(fractal)) state.colourBy = fractal.appearance.colourBy;
    if (document::animationFacts(document.entryFractal())) state.moment = document.moment();
    state.outlines = parts.analysis->outlined();
    state.cylinderDepth = parts.analysis->cylinderDepth();
    state.construction = constructionOf(*parts.construction);
    state.showsGrid = canvas.options().isGridVisible();
    state.showsAxes = canvas.options().areAxesVisible();
    state.showsCage = canvas.options().overlaysVisible();
    state.showsMapNumbers = canvas.options().areMapNumbersVisible();
    return state;
}

QString showLessonState(const LessonParts& parts, const LessonState& state) {
    parts.stage->cancelGesture();
    QStringList problems{showEntry(*parts.document, state)};
    if (problems.front().isEmpty()) problems << showFractal(*parts.document, state);
    view::CanvasView& canvas = *parts.stage->plane();
    canvas.setTool(state.tool == LessonTool::Maps     ? Tool::Maps
                   : state.tool == LessonTool::Branch ? Tool::Branch
                                                      : Tool::Cage);
    canvas.options().setGridVisible(state.showsGrid);
    canvas.options().setAxesVisible(state.showsAxes);
    canvas.options().setOverlaysVisible(state.showsCage);
    canvas.options().setMapNumbersVisible(state.showsMapNumbers);
    parts.analysis->setCylinderDepth(state.cylinderDepth);
    for (const Outline outline : outlines)
        parts.analysis->setOutlined(outline, state.outlines.contains(outline));
    showConstruction(*parts.construction, state.construction);
    showLessonView(parts, state);
    problems.removeAll(QString());
    return problems.join(u' ');
}

void showLessonView(const LessonParts& parts, const LessonState& state) {
    view::SpaceNavigation& space = parts.stage->space()->navigation();
    view::CanvasView& canvas = *parts.stage->plane();
    const auto* fit = std::get_if<LessonFit>(&state.view);
    const auto* area = std::get_if<LessonArea>(&state.view);
    const auto* orbit = std::get_if<LessonOrbit>(&state.view);
    if (fit && !parts.stage->showsSpace()) {
        attractor::Camera turned = canvas.camera();
        turned.yAxis = fit->yAxis;
        turned.rotation = fit->rotation;
        canvas.navigation().setCamera(turned);
        canvas.fit();
    } else if (area && !parts.stage->showsSpace()) {
        canvas.navigation().moveTo(
            document::cameraOf(*area, {canvas.viewport()->width(), canvas.viewport()->height()}));
    } else if (orbit && parts.stage->showsSpace()) {
        attractor::OrbitCamera camera = orbit->camera;
        camera.size = space.camera().size;
        space.moveTo(camera);
        if (orbit->isFitted) space.fit();
    } else {
        parts.stage->fit();
    }
}
