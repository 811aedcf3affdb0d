// SPDX-License-Identifier: MIT
#include "panels/collage/collage_panel.h"

#include "canvas/canvas_view.h"
#include "desktop/settings.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/collage_edits.h"
#include "document/edits/entries_edits.h"
#include "document/edits/maps/map_locks.h"
#include "panels/collage/collage_layer.h"
#include "panels/collage/suggestion_list.h"
#include "panels/collage/target_box.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QStringList>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

using Task = FitBox::Task;
using document::Compared;

constexpr int progressInterval = 100; // milliseconds
// Head start of the picture in a drag, before the numbers are measured.
constexpr int pictureFirst = 8;
constexpr qsizetype maxLocksNamed = 6; // names on the button, which is no wider than the panel

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

QString moreKey() {
    return QStringLiteral("collage/more");
}

QString textOf(Task task) {
    switch (task) {
    case Task::Suggest:
        return CollagePanel::tr("Use Suggestion");
    case Task::RefineMaps:
        return CollagePanel::tr("Refine Maps");
    case Task::RefineAttractor:
        return CollagePanel::tr("Refine Attractor");
    case Task::FitWeights:
        return CollagePanel::tr("Fit Weights");
    case Task::FitCage:
        return CollagePanel::tr("Fit Cage");
    case Task::AddMap:
        break;
    }
    return CollagePanel::tr("Add Map");
}

// A new entry in the colours of this one, named after the target.
document::Fractal suggested(const document::Fractal& entry, const QString& target,
                            const collage::Suggestion& suggestion, const document::PicturePlace& place) {
    document::Fractal made;
    made.name = QFileInfo(target).completeBaseName();
    if (made.name.isEmpty()) made.name = entry.name;
    made.appearance = entry.appearance;
    return document::withSuggestion(std::move(made), suggestion, place);
}

} // namespace

CollagePanel::CollagePanel(document::Document* document, CanvasView* canvas, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_canvas(canvas),
      m_layer(new CollageLayer(document, canvas)),
      m_target(new TargetBox(document, this)),
      m_compared(new QComboBox(this)),
      m_numbers(new CollageNumbers(this)),
      m_fit(new FitBox(this)),
      m_refined(new QLabel(this)),
      m_shades(new QLabel(this)),
      m_suggestions(new SuggestionList(this)),
      m_more(new QWidget(this)),
      m_progressTimer(new QTimer(this)),
      m_liveTimer(new QTimer(this)),
      m_measuring(
          [this](std::optional<document::MeasuredFractal> measured) { showMeasured(std::move(measured)); }),
      m_fitting([this](std::optional<Result> result) { finish(std::move(result)); }) {
    setAccessibleName(tr("Collage"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(10);
    layout->addWidget(heading(tr("1. Choose a picture"), this));
    layout->addWidget(m_target);
    layout->addWidget(heading(tr("2. Ask for suggestions"), this));
    layout->addWidget(m_fit->start());
    layout->addWidget(heading(tr("3. Pick one"), this));
    layout->addWidget(m_suggestions);
    layout->addWidget(makeMoreButton());
    layout->addWidget(m_more);
    layout->addStretch();
    layMore();
    m_progressTimer->setInterval(progressInterval);
    m_liveTimer->setSingleShot(true);
    m_liveTimer->setTimerType(Qt::PreciseTimer);
    m_liveTimer->setInterval(pictureFirst);
    connectParts();
    updatePossible();
    showLocks();
}

QToolButton* CollagePanel::makeMoreButton() {
    auto* button = new QToolButton(this);
    button->setText(tr("More"));
    button->setAccessibleName(tr("More ways to trace"));
    button->setToolTip(tr("Show how the picture is read, the agreement, and what refines a suggestion"));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setAutoRaise(true);
    connect(button, &QToolButton::toggled, this, [this, button](bool on) {
        button->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        m_more->setVisible(on);
        store(moreKey(), on);
    });
    const bool isOpen = stored(moreKey(), false).toBool();
    button->setChecked(isOpen);
    button->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
    m_more->setVisible(isOpen);
    m_moreButton = button;
    return button;
}

void CollagePanel::showMore(bool shown) {
    m_moreButton->setChecked(shown);
}

void CollagePanel::layMore() {
    auto* layout = new QVBoxLayout(m_more);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    layout->addWidget(m_target->controls());
    auto* row = new QHBoxLayout;
    row->addWidget(heading(tr("Agreement"), this));
    addChoice(m_compared, tr("of the collage"), Agreement::OfCollage);
    addChoice(m_compared, tr("of the attractor"), Agreement::OfAttractor);
    addChoice(m_compared, tr("not shown"), Agreement::Hidden);
    m_compared->setAccessibleName(tr("Agreement"));
    m_compared->setToolTip(tr("Choose what the canvas compares with the target"));
    m_compared->setWhatsThis(
        tr("Compares the target with its images under the maps, or with the attractor. Agreement is "
           "grey, excess red, and missing parts blue."));
    row->addWidget(m_compared, 1);
    layout->addLayout(row);
    layout->addWidget(m_numbers);
    layout->addWidget(heading(tr("Fit"), this));
    layout->addWidget(m_fit);
    m_refined->setAccessibleName(tr("Result of refining"));
    m_refined->setToolTip(tr("What the last refinement has made of the distance and of the guarantee"));
    m_refined->setWordWrap(true);
    m_refined->hide();
    layout->addWidget(m_refined);
    m_shades->setAccessibleName(tr("Guarantee for the shades"));
    m_shades->setToolTip(tr("Moved by at most this distance on average, the shades of the attractor become "
                            "those of the picture"));
    m_shades->setWordWrap(true);
    m_shades->hide();
    layout->addWidget(m_shades);
}

CollagePanel::~CollagePanel() {
    delete m_layer;
}

// Leaves a view that the user has moved.
void CollagePanel::bringTargetIntoView() {
    const document::TracedPicture* traced = m_target->traced().get();
    std::optional<document::Box> box;
    if (traced) {
        const collage::Grid& grid = traced->target.grid;
        const ifs::Vector<2> corner(grid.left, grid.top);
        box = document::Box{corner - ifs::Vector<2>(0, grid.height * grid.cell),
                            corner + ifs::Vector<2>(grid.width * grid.cell, 0)};
    }
    m_canvas->navigation().setFittedToo(box);
    if (box && m_canvas->navigation().isFitted()) m_canvas->navigation().fit();
}

void CollagePanel::connectParts() {
    connect(m_document, &document::Document::changed, this, &CollagePanel::follow);
    connect(m_target, &TargetBox::opacityChanged, this, [this](int percent) {
        if (m_layer) m_layer->setOpacity100(percent);
    });
    connect(m_target, &TargetBox::tracedChanged, this, [this] {
        if (m_layer) m_layer->setTarget(m_target->traced());
        bringTargetIntoView();
        m_measured.reset();
        forgetResults();
        m_measuring.cancel(); // measures another target
        showSuggestions();
        if (m_running) {
            cancel();
            emit message(tr("Another picture is shown, so the search for the last one was cancelled."));
        }
        updatePossible();
        measure();
    });
    connect(m_compared, &QComboBox::currentIndexChanged, this, [this] {
        if (m_layer) m_layer->setAgreementVisible(chosenValue<Agreement>(m_compared) != Agreement::Hidden);
        measure();
    });
    connect(m_layer.data(), &CollageLayer::markClicked, this, [this] { run(Task::AddMap); });
    connect(m_fit, &FitBox::requested, this, &CollagePanel::run);
    connect(m_fit, &FitBox::lockRequested, this, &CollagePanel::lock);
    connect(m_fit, &FitBox::cancelled, this, &CollagePanel::cancel);
    connect(m_canvas, &CanvasView::selectedMapsChanged, this, &CollagePanel::showLocks);
    connect(m_suggestions, &SuggestionList::chosen, this, &CollagePanel::use);
    connect(m_liveTimer, &QTimer::timeout, this, [this] { measure(document::Detail::Live); });
    connect(m_progressTimer, &QTimer::timeout, this, [this] { m_fit->setProgress(m_progress->load()); });
}

bool CollagePanel::isSettled() const {
    return !m_target->isBusy() && !m_measuring.isBusy() && !m_liveTimer->isActive() && !m_running;
}

void CollagePanel::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::Current | Change::File)) {
        cancel();
        showSuggestions();
    }
    if (change.parts & Change::Name) showLocks();
    if (!(change.parts & (Change::System | Change::Cage | Change::Current | Change::File))) return;
    forgetResults();
    m_suggestions->highlight(m_document->fractal());
    if (change.live) {
        if (!m_liveTimer->isActive()) m_liveTimer->start();
    } else {
        updatePossible();
        showLocks();
        measure();
    }
}

// They wait where an entry without a picture is shown, and go when another picture comes.
void CollagePanel::showSuggestions() {
    const auto& traced = m_target->traced();
    const bool isTheirs = traced && m_suggestedFor && traced->mask == m_suggestedFor->mask &&
                          traced->place == m_suggestedFor->place;
    if (traced && !isTheirs) m_suggestions->forget();
    m_suggestions->setVisible(isTheirs && m_suggestions->count() > 0);
}

void CollagePanel::measure(document::Detail detail) {
    m_liveTimer->stop();
    const auto& traced = m_target->traced();
    const QString obstacle = traced ? document::collageObstacle(m_document->fractal()) : QString();
    if (!traced || !obstacle.isEmpty()) {
        m_measuring.cancel();
        m_measured.reset();
        m_numbers->clear(obstacle);
        if (m_layer) m_layer->setMeasured(std::nullopt);
        return;
    }
    const auto compared = chosenValue<Agreement>(m_compared) == Agreement::OfAttractor
                              ? document::Compared::Attractor
                              : document::Compared::Collage;
    m_measuring.submit(
        [traced, compared, detail, fractal = m_document->sharedFractal()](const std::stop_token&) {
            return document::measured(*fractal, *traced, compared, detail);
        });
}

void CollagePanel::showMeasured(std::optional<document::MeasuredFractal> measured) {
    m_measured = std::move(measured);
    if (m_measured)
        m_numbers->show(*m_measured);
    else
        m_numbers->clear(tr("The maps do not contract, so there is no attractor to compare."));
    if (m_layer) m_layer->setMeasured(m_measured);
}

void CollagePanel::showRefinement(const Refinement& refinement) {
    const QString text = refinementText(refinement);
    m_refined->setText(text);
    m_refined->show();
    emit message(text);
}

// Drops results: they belong to other maps, another target or an earlier run.
void CollagePanel::forgetResults() {
    m_refined->hide();
    m_shades->hide();
}

void CollagePanel::showShadesBound(const std::optional<double>& pixels) {
    m_shades->setText(pixels
                          ? tr("On average, the shades of the attractor are guaranteed to lie within %1 px "
                               "of those of the picture.")
                                .arg(roundedNumber(*pixels, 2))
                          : tr("With these weights, the maps do not contract on average, so nothing is "
                               "guaranteed for the shades."));
    m_shades->show();
}

std::vector<ifs::MapId> CollagePanel::fixedMaps() const {
    std::vector<ifs::MapId> fixed = document::lockedMaps(m_document->fractal());
    const std::vector<ifs::MapId>& selected = m_canvas->selectedMaps();
    const document::System2* system = document::system2(m_document->fractal());
    if (m_fit->refinesSelectedOnly() && system)
        for (const auto& map : system->maps)
            if (std::ranges::count(selected, map.id) == 0) fixed.push_back(map.id);
    return fixed;
}

CollagePanel::Result CollagePanel::refined(std::optional<document::Fractal> after,
                                           const document::Fractal& before,
                                           const document::TracedPicture& traced, Compared compared) {
    Result result{{}, std::move(after)};
    if (!result.fractal) return result;
    auto was = document::measured(before, traced, compared),
         is = document::measured(*result.fractal, traced, compared);
    if (was && is) result.refinement = Refinement{compared, *std::move(was), *std::move(is)};
    return result;
}

CollagePanel::Work CollagePanel::workFor(Task task, const std::shared_ptr<const document::Fractal>& fractal) {
    const auto traced = m_target->traced();
    const document::CollageFitOptions options{m_fit->constraints(), fixedMaps()};
    switch (task) {
    case Task::Suggest:
        return [traced, search = m_fit->searchOptions(), progress = m_progress](const std::stop_token& stop) {
            const auto report = [progress](double share) { *progress = share; };
            return Result{collage::suggestions(traced->mask, search, report, stop).list, std::nullopt};
        };
    case Task::RefineMaps:
        return [=](const std::stop_token& stop) {
            return refined(document::withMapsRefined(*fractal, *traced, options, stop), *fractal, *traced,
                           Compared::Collage);
        };
    case Task::RefineAttractor:
        return [=](const std::stop_token& stop) {
            return refined(document::withAttractorRefined(*fractal, *traced, options, stop), *fractal,
                           *traced, Compared::Attractor);
        };
    case Task::FitWeights:
        return [=](const std::stop_token& stop) {
            auto fitted = document::withWeightsFitted(*fractal, *traced, stop);
            const auto bound = document::shadesBound(fitted ? *fitted : *fractal, *traced, stop);
            return Result{{}, std::move(fitted), bound};
        };
    case Task::FitCage:
        return [=, corners = m_fit->cageCorners()](const std::stop_token& stop) {
            return Result{{}, document::withCageFittedTo(*fractal, *traced, corners, stop)};
        };
    case Task::AddMap:
        break;
    }
    return [=, worst = m_measured ? m_measured->agreement.worst
                                  : ifs::Vector<2>(0, 0)](const std::stop_token& stop) {
        return Result{{}, document::withMapAdded(*fractal, *traced, worst, options.constraints, stop)};
    };
}

void CollagePanel::run(Task task) {
    if (m_running || !m_target->traced()) return;
    // Suggestions, and a cage around the present fractal, need no comparable maps.
    if (task != Task::Suggest && task != Task::FitCage)
        if (const QString obstacle = document::collageObstacle(m_document->fractal()); !obstacle.isEmpty())
            return emit message(obstacle);
    forgetResults();
    m_progress = std::make_shared<std::atomic<double>>(task == Task::Suggest ? 0 : -1);
    m_running = Running{task, textOf(task), m_document->sharedFractal()};
    m_fit->setProgress(m_progress->load());
    m_progressTimer->start();
    m_fitting.submit([work = workFor(task, m_running->before)](const std::stop_token& stop) {
        return std::optional(work(stop));
    });
}

void CollagePanel::finish(std::optional<Result> result) {
    if (!m_running) return;
    const Running done = *std::move(m_running);
    m_running.reset();
    m_progressTimer->stop();
    m_fit->setProgress(std::nullopt);
    if (!result) return emit message(tr("There is not enough memory for this."));
    if (done.task == Task::Suggest) {
        std::vector<std::shared_ptr<const document::Fractal>> fractals;
        m_suggestedFor = m_target->traced();
        m_suggested = document::EntryId::None;
        for (const collage::Suggestion& one : result->suggestions)
            fractals.push_back(std::make_shared<const document::Fractal>(
                suggested(*done.before, m_target->name(), one, m_suggestedFor->place)));
        m_suggestions->show(result->suggestions, std::move(fractals));
        return emit message(
            tr("%n suggestions. Click one to use it.", nullptr, int(result->suggestions.size())));
    }
    if (!document::isSameSystem(*done.before, m_document->fractal()) ||
        !document::isCageAlike(*done.before, m_document->fractal()) ||
        document::lockedMaps(*done.before) != document::lockedMaps(m_document->fractal()))
        return emit message(tr("The fractal has changed meanwhile, so the result was not used."));
    if (result->fractal) {
        document::Fractal after = m_document->fractal();
        after.shape = result->fractal->shape;
        m_document->edit(done.text, std::move(after));
    } else {
        emit message(tr("No better agreement was found."));
    }
    if (result->refinement) showRefinement(*result->refinement);
    if (done.task == Task::FitWeights) showShadesBound(result->shadesBound);
}

void CollagePanel::cancel() {
    if (!m_running) return;
    m_fitting.cancel();
    m_running.reset();
    m_progressTimer->stop();
    m_fit->setProgress(std::nullopt);
}

// Uses an entry of its own, so that nothing is overwritten and nothing moves; another suggestion takes its
// place there.
void CollagePanel::use(int suggestion) {
    const std::shared_ptr<const document::Fractal>& chosen = m_suggestions->fractal(suggestion);
    if (m_suggested != document::EntryId::None && m_document->currentId() == m_suggested) {
        document::Fractal after = m_document->entryFractal();
        after.shape = chosen->shape;
        after.mapLabels = {};
        m_document->editEntry(textOf(Task::Suggest), std::move(after));
    } else {
        document::Entry entry;
        entry.fractal = chosen;
        document::Inserted added = document::inserted(m_document->file(), {entry}, m_document->currentId());
        m_suggested = added.ids.front();
        m_target->share(m_suggested);
        m_document->editFile(textOf(Task::Suggest), std::move(added.file), m_suggested);
    }
    m_canvas->navigation().fit();
}

void CollagePanel::lock(bool lock) {
    document::lockMaps(*m_document, m_canvas->selectedMaps(), lock);
}

void CollagePanel::showLocks() {
    QStringList names;
    const document::Fractal& fractal = m_document->fractal();
    const document::System2* system = document::system2(fractal);
    for (std::size_t i = 0; system && i < system->maps.size() && names.size() <= maxLocksNamed; ++i)
        if (document::isLocked(fractal, i)) names << QString::number(i + 1);
    if (names.size() > maxLocksNamed) names.back() = QStringLiteral("…");
    const std::vector<ifs::MapId>& selected = m_canvas->selectedMaps();
    const bool areLocked = !selected.empty() && std::ranges::all_of(selected, [&](ifs::MapId map) {
        return fractal.mapLabels.of(map).isLocked;
    });
    m_fit->setLocks(names.join(QStringLiteral(", ")), areLocked, !selected.empty());
}

void CollagePanel::updatePossible() {
    m_fit->setPossible(m_target->traced() && document::dimension(m_document->fractal()) == 2);
}

} // namespace view
