// SPDX-License-Identifier: MIT
#include "panels/timeline/timeline_panel.h"

#include "document/edits/entries_edits.h"
#include "document/edits/timeline/morph_edits.h"
#include "document/edits/timeline/motion_edits.h"
#include "io/file/background.h"
#include "panels/timeline/morph_dialog.h"
#include "panels/timeline/motion_page.h"
#include "panels/timeline/motion_preview.h"
#include "panels/timeline/track_view.h"
#include "panels/timeline/transport_bar.h"
#include "widgets/background/wait_for.h"
#include "widgets/icon.h"
#include "widgets/menus/menu_button.h"
#include "widgets/menus/menu_placeholder.h"
#include "widgets/menus/menu_text.h"
#include "widgets/text/tooltip_text.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr qsizetype maxListed = 60; // entries in a menu
constexpr double usualAspect = 16.0 / 9;
constexpr int previewLength = 24; // frames of a morph

constexpr const char* windNames[] = {
    QT_TRANSLATE_NOOP("view::TimelinePanel", "Breeze"),
    QT_TRANSLATE_NOOP("view::TimelinePanel", "Gusts"),
    QT_TRANSLATE_NOOP("view::TimelinePanel", "Storm"),
    QT_TRANSLATE_NOOP("view::TimelinePanel", "Under Water"),
    QT_TRANSLATE_NOOP("view::TimelinePanel", "Calm"),
    QT_TRANSLATE_NOOP("view::TimelinePanel", "Steady Sway"),
};

constexpr std::size_t usualWind = 1; // index of Gusts

auto windOf(std::size_t preset) {
    return [preset](const document::Fractal& entry, const std::stop_token& stop) {
        return document::withWind(entry, animation::swayPresets()[preset], stop);
    };
}

// The row of an addition: the motion, which is the last, or else the track that has new keys.
int addedRow(const Timeline& timeline, std::size_t motions, const std::vector<document::TrackKeys>& tracks) {
    if (timeline.motions().size() > motions) return timeline.rowCount() - 1;
    const auto [added, before] = std::ranges::mismatch(timeline.tracks(), tracks);
    return added == timeline.tracks().end() ? -1 : int(added - timeline.tracks().begin());
}

std::vector<document::KeyAt> keysOf(const document::TrackKeys& one) {
    std::vector<document::KeyAt> keys;
    for (const auto& key : one.keys)
        keys.push_back({one.track, key.frame});
    return keys;
}

// Scrolls sideways in a narrow window, and with large letters. Nothing is cut off below, not even then.
class MotionArea : public QScrollArea {
public:
    explicit MotionArea(QWidget* page) {
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setWidget(page);
    }

    QSize sizeHint() const override { return minimumSizeHint().expandedTo(widget()->sizeHint()); }
    QSize minimumSizeHint() const override {
        const int bar = horizontalScrollBar()->sizeHint().height();
        return {QScrollArea::minimumSizeHint().width(), widget()->minimumSizeHint().height() + bar};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }
};

} // namespace

TimelinePanel::TimelinePanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_timeline(document),
      m_motions(new QMenu(this)),
      m_winds(new QMenu(this)),
      m_entries(new QMenu(this)),
      m_zooming([this](std::optional<document::Fractal> zoom) { takeZoom(std::move(zoom)); }) {
    createMotions();
    auto* add = new MenuButton(this);
    add->setText(tr("Add Motion"));
    add->setToolTip(tr("Add a motion that needs no keys, or a morph to another entry"));
    add->setMenu(m_motions);
    m_motions->setTitle(tr("Add &Motion"));
    m_motions->setToolTipsVisible(true);
    m_tracks = new TrackView(&m_timeline);
    m_transport = new TransportBar(&m_timeline, add);
    m_page = new MotionPage(m_actions);
    std::vector<MotionPage::Make> motions;
    for (const Make& make : m_makes)
        motions.push_back([this, make]() -> std::optional<document::Fractal> {
            const document::Fractal& entry = m_document->entryFractal();
            return isPreviewed(entry) ? make(entry, {}) : std::nullopt;
        });
    m_page->setMotions(std::move(motions));
    m_pages = new QStackedWidget;
    m_pages->addWidget(new MotionArea(m_page));
    m_pages->addWidget(m_tracks);
    m_lost = new QLabel;
    m_lost->setWordWrap(true);
    m_lost->setMargin(4);
    m_lost->setAccessibleName(tr("Frame without an attractor"));
    m_lost->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_transport);
    column->addWidget(m_lost);
    column->addWidget(m_pages, 1);
    connect(m_page, &MotionPage::tableWanted, this, [this] {
        showTracks();
        m_tracks->setFocus();
        if (m_timeline.isTrack(m_timeline.row())) m_timeline.keys().set();
        m_tracks->reveal();
    });
    connect(&m_timeline, &Timeline::changed, this, &TimelinePanel::follow);
    connect(&m_timeline, &Timeline::message, this, &TimelinePanel::message);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        watch(change);
        if (change.parts & ~Change::Parts(Change::Time)) m_page->renew();
        if (!(change.parts & (Change::Current | Change::File))) return;
        m_wantsTracks = false;
        m_tracks->verticalScrollBar()->setValue(0); // rows of another entry
        follow();
    });
    connect(&m_watch, &AttractorWatch::changed, this, &TimelinePanel::showLost);
    m_watch.look(document->currentEntry().fractal);
    follow();
}

// Results for another entry are dropped.
void TimelinePanel::watch(const document::Change& change) {
    using document::Change;
    const bool isAnother = change.parts & (Change::Current | Change::File);
    if (isAnother) m_watch.look(nullptr);
    if (isAnother || !change.live) m_watch.look(m_document->currentEntry().fractal);
}

void TimelinePanel::showLost() {
    m_lost->setText(m_watch.sentence());
    m_lost->setVisible(m_watch.lost().has_value());
    m_tracks->setFlawedFrames(m_watch.lostFrames());
}

bool TimelinePanel::showsTracks() const {
    return m_pages->currentWidget() == m_tracks;
}

void TimelinePanel::showTracks() {
    m_wantsTracks = true;
    follow();
}

void TimelinePanel::follow() {
    const bool hadFocus = m_page->isAncestorOf(focusWidget()) && m_page->isVisible();
    m_pages->setCurrentIndex(m_timeline.isEmpty() && !m_wantsTracks ? 0 : 1);
    if (hadFocus && showsTracks()) m_tracks->setFocus();
    for (QAction* action : m_actions)
        action->setEnabled(m_timeline.rowCount() > 0);
    offerZoom();
}

void TimelinePanel::takeZoom(std::optional<document::Fractal> zoom) {
    m_zoom = std::move(zoom);
    m_cannotZoom = !m_zoom;
    offerZoom();
    if (m_zoom) m_page->renew();
}

// Offers the zoom unless it is known that there is none.
void TimelinePanel::offerZoom() {
    const bool cannot = m_cannotZoom && m_zoomed == m_document->currentEntry().fractal;
    const QString tip =
        cannot ? tr("No map makes a scaled copy of the fractal that is clear of the others.")
               : tr("The view moves into a small copy of the whole; the last frame matches the first.");
    m_zoomAction->setEnabled(!cannot && m_timeline.rowCount() > 0);
    m_zoomAction->setToolTip(tip);
    m_zoomAction->setStatusTip(tip);
}

QAction* TimelinePanel::addMotion(const char* iconName, const QString& name, const QString& tip) {
    auto* action = new QAction(icon(QLatin1String(iconName)), name, this);
    action->setObjectName(QLatin1String(iconName));
    action->setToolTip(tip);
    action->setStatusTip(tip);
    action->setWhatsThis(tip + u' ' + tr("It is one step of the history."));
    m_actions << action;
    m_motions->addAction(action);
    return action;
}

void TimelinePanel::createMotions() {
    const auto apply = [this](QAction* action, const QString& text, const Make& make,
                              const QString& failure) {
        m_makes.push_back(make);
        connect(action, &QAction::triggered, this,
                [this, text, make, failure] { this->apply(text, make, failure); });
    };
    const QString noMaps = tr("There are no maps to move.");
    QAction* wind = addMotion("wind", tr("Wind"), tr("All branches sway about their roots."));
    wind->setMenu(m_winds);
    addWinds();
    apply(wind, tr("Wind: %1").arg(tr(windNames[usualWind])), windOf(usualWind), noMaps);
    apply(addMotion("turn", tr("Turn"), tr("Each map turns once in its place.")), tr("Turn the maps"),
          &document::withTurn, tr("No map can turn without losing the attractor."));
    m_makes.push_back([this](const document::Fractal& entry, const std::stop_token&) {
        return document::withOrbit(entry, m_timeline.vertical());
    });
    connect(addMotion("orbit", tr("Orbit"), tr("The whole picture turns once.")), &QAction::triggered, this,
            &TimelinePanel::orbit);
    apply(addMotion("breathe", tr("Breathe"), tr("The maps swell and shrink.")), tr("Breathe"),
          &document::withBreathing, noMaps);
    apply(
        addMotion("palette", tr("Palette Cycle"), tr("The colours run through the palette and back.")),
        tr("Cycle the palette"),
        [](const document::Fractal& entry, const std::stop_token&) {
            return document::withPaletteCycle(entry);
        },
        noMaps);
    m_zoomAction =
        addMotion("zoom-in", tr("Zoom In Endlessly"),
                  tr("The view moves into a small copy of the whole; the last frame matches the first."));
    m_makes.push_back([this](const document::Fractal&, const std::stop_token&) { return zoomOfEntry(); });
    connect(m_zoomAction, &QAction::triggered, this, &TimelinePanel::zoomEndlessly);
    QAction* morph = addMotion("morph", tr("Morph To"),
                               tr("The fractal becomes another entry of this file, and returns."));
    morph->setMenu(m_entries);
    morph->setProperty("isChoice", true);
    m_makes.push_back([this](const document::Fractal&, const std::stop_token&) { return morphToNext(); });
    connect(m_entries, &QMenu::aboutToShow, this, &TimelinePanel::listEntries);
    m_winds->setAccessibleName(tr("Wind"));
    m_entries->setAccessibleName(tr("Morph To"));
    m_entries->setToolTipsVisible(true);
}

void TimelinePanel::addWinds() {
    const auto presets = animation::swayPresets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const QString name = tr(windNames[i]);
        QAction* action = m_winds->addAction(name, this, [this, name, i] {
            apply(tr("Wind: %1").arg(name), windOf(i), tr("There are no maps to move."));
        });
        action->setWhatsThis(tr("All branches sway about their roots."));
    }
}

void TimelinePanel::orbit() {
    const ifs::Vector<3> axis = m_timeline.vertical();
    apply(
        tr("Orbit"),
        [axis](const document::Fractal& entry, const std::stop_token&) {
            return document::withOrbit(entry, axis);
        },
        tr("There are no maps to move."));
}

void TimelinePanel::zoomEndlessly() {
    const document::SeenCamera seen = m_timeline.camera();
    const auto* view = seen ? std::get_if<attractor::View>(&*seen) : nullptr;
    const attractor::YAxis yAxis = view ? view->yAxis : attractor::YAxis::Up;
    apply(
        tr("Zoom in endlessly"),
        [yAxis](const document::Fractal& entry, const std::stop_token& stop) {
            return document::withEndlessZoom(entry, usualAspect, yAxis, stop);
        },
        tr("No map makes a scaled copy of the fractal that is clear of the others."));
}

// Many maps take their time. What is begun for an entry is not written into another one.
void TimelinePanel::apply(const QString& text, const Make& make, const QString& failure) {
    const auto entry = m_document->currentEntry().fractal;
    std::stop_source stop;
    const auto work = io::inBackground<std::optional<document::Fractal>>(
        [entry, make, token = stop.get_token()](QPromise<std::optional<document::Fractal>>& promise) {
            promise.addResult(make(*entry, token));
        });
    if (!waitFor(QFuture<void>(work), tr("Trying the motion…"), window())) {
        stop.request_stop();
        return; // the window may have closed
    }
    if (m_document->currentEntry().fractal != entry) return;
    auto after = work.result();
    if (!after) return emit message(failure);
    const std::size_t motions = m_timeline.motions().size();
    const std::vector<document::TrackKeys> tracks = m_timeline.tracks();
    m_document->editEntry(text, std::move(*after));
    m_timeline.playback().seek(0);
    if (const int row = addedRow(m_timeline, motions, tracks); row >= 0) {
        m_timeline.setRow(row);
        if (m_timeline.isTrack(row)) m_timeline.select(keysOf(m_timeline.tracks()[std::size_t(row)]));
        m_tracks->reveal();
    }
    m_timeline.playback().setPlaying(true);
    emit motionAdded();
    // Queued until the panel has its size.
    QMetaObject::invokeMethod(m_tracks, &TrackView::reveal, Qt::QueuedConnection);
}

// The zoom, for the moving picture, and to know whether it can be offered. Finding the copy may take long:
// until it is found, there is no picture.
std::optional<document::Fractal> TimelinePanel::zoomOfEntry() {
    const auto& entry = m_document->currentEntry().fractal;
    if (m_zoomed == entry) return m_zoom;
    m_zoomed = entry;
    m_zoom.reset();
    m_cannotZoom = false;
    m_zooming.cancel();
    m_zooming.submit([entry](const std::stop_token& stop) {
        return document::withEndlessZoom(*entry, usualAspect, attractor::YAxis::Up, stop);
    });
    return std::nullopt;
}

// The next entry of the same dimension, for the moving picture.
std::optional<document::Fractal> TimelinePanel::morphToNext() const {
    constexpr std::size_t quick = 12; // number of maps whose morph takes no noticeable time
    const auto maps = [](const document::Fractal& fractal) {
        const auto* plane = document::plane(fractal);
        const auto* space = document::space(fractal);
        return plane ? plane->system.maps.size() : space ? space->system.maps.size() : 0;
    };
    const document::Fractal& entry = m_document->entryFractal();
    for (const document::Entry& other : m_document->file().entries) {
        if (other.id == m_document->currentId() ||
            document::dimension(*other.fractal) != document::dimension(entry) || maps(*other.fractal) == 0)
            continue;
        if (maps(entry) > quick || maps(*other.fractal) > quick) return std::nullopt;
        auto outcome = document::morphed(m_document->fractal(), *other.fractal, previewLength, {});
        if (!outcome.fractal) return std::nullopt;
        return document::withTiming(std::move(*outcome.fractal),
                                    {{}, previewLength, animation::Loop::ThereAndBack});
    }
    return std::nullopt;
}

void TimelinePanel::listEntries() {
    m_entries->clear();
    const int dimension = document::dimension(m_document->entryFractal());
    for (const document::Entry& entry : m_document->file().entries) {
        if (entry.id == m_document->currentId() || document::dimension(*entry.fractal) != dimension) continue;
        if (m_entries->actions().size() == maxListed) break;
        const QString& name = entry.fractal->name;
        QAction* action = m_entries->addAction(menuText(name, m_entries->fontMetrics()), this,
                                               [this, id = entry.id] { morphTo(id); });
        action->setToolTip(tooltipText(name));
    }
    if (m_entries->isEmpty()) {
        addPlaceholder(*m_entries, tr("This file has no other fractal of this dimension"));
        return;
    }
    m_entries->addSeparator();
    QAction* choose = m_entries->addAction(tr("Choose &Pairs…"), this, &TimelinePanel::choosePairs);
    choose->setWhatsThis(tr("Shows which map becomes which, and lets you pin pairs."));
}

void TimelinePanel::morphTo(document::EntryId id) {
    const document::FractalFile& file = m_document->file();
    const qsizetype index = document::indexOf(file, id);
    if (index < 0) return;
    const auto entry = m_document->currentEntry().fractal;
    const auto work = io::inBackground<document::MorphOutcome>(
        [from = m_document->sharedFractal(), to = file.entries.at(index).fractal,
         length = m_timeline.timing().length](QPromise<document::MorphOutcome>& promise) {
            promise.addResult(document::morphed(*from, *to, length, {}));
        });
    const QString name = file.entries.at(index).fractal->name;
    if (!waitFor(QFuture<void>(work), tr("Pairing the maps…"), window())) return;
    if (m_document->currentEntry().fractal != entry) return;
    auto outcome = work.result();
    if (!outcome.fractal) return emit message(morphObstacle(outcome.flaw));
    addMorph(std::move(*outcome.fractal), name);
}

void TimelinePanel::choosePairs() {
    auto* dialog = new MorphDialog(*m_document, m_timeline.timing().length, window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (dialog->isSolved()) addMorph(dialog->morph(), dialog->targetName());
    });
    dialog->open();
}

// The morph is an entry of its own, behind the one that it begins with.
void TimelinePanel::addMorph(document::Fractal morph, const QString& name) {
    const document::Timing timing = m_timeline.timing();
    const int length = document::timingOf(morph).length;
    document::Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(
        document::withTiming(std::move(morph), {timing.rate, length, animation::Loop::ThereAndBack}));
    document::Inserted added = document::inserted(m_document->file(), {entry}, m_document->currentId());
    m_document->editFile(tr("Morph to %1").arg(name), std::move(added.file), added.ids.front());
    m_timeline.playback().setPlaying(true);
    emit motionAdded();
}

} // namespace view
