// SPDX-License-Identifier: MIT
#include "compare/compare_pane.h"

#include "bridges/extent_finder.h"
#include "bridges/render_bridge.h"
#include "bridges/solid_bridge.h"
#include "canvas/canvas_view.h"
#include "space/space_view.h"
#include "widgets/choices.h"
#include "widgets/flat_buttons.h"
#include "widgets/whats_this.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace view {

namespace {

using document::EntryId;

constexpr int fewLetters = 10; // letters of the combo box in a narrow window

} // namespace

ComparePane::ComparePane(document::Document* document, const RenderBridge* render, CanvasView* plane,
                         SpaceView* space, QWidget* parent)
    : QWidget(parent), m_document(document), m_render(render), m_plane(plane), m_space(space) {
    setAccessibleName(tr("Entry to compare with"));
    hide();
}

ComparePane::~ComparePane() {
    if (m_partner && m_document) m_document->setBeside(EntryId::None);
    delete m_otherPlane; // destroyed before the document
    delete m_otherSpace;
    delete m_otherRender;
    delete m_otherSolid;
}

EntryId ComparePane::entry() const {
    return m_partner ? m_partner->id() : EntryId::None;
}

bool ComparePane::areViewsLinked() const {
    return m_link && m_link->isChecked();
}

void ComparePane::setViewsLinked(bool linked) {
    if (m_link && m_link->isEnabled()) m_link->setChecked(linked);
}

void ComparePane::setCompared(bool compared) {
    if (std::exchange(m_isCompared, compared) == compared) return;
    if (compared && !m_partner) create();
    setVisible(compared);
    if (compared)
        refresh();
    else
        changeTo(EntryId::None); // stops drawing it
}

void ComparePane::create() {
    m_partner = std::make_unique<document::PartnerDocument>(m_document);
    document::Document* other = &m_partner->document();
    m_otherRender = new RenderBridge(other, this);
    m_otherRender->setQuality(m_render->quality());
    connect(m_render, &RenderBridge::qualityChanged, m_otherRender, &RenderBridge::setQuality);
    m_otherSolid = new SolidBridge(other, this);
    new ExtentFinder(other, m_otherSolid); // finds the extent, which handles need
    m_views = new QStackedWidget(this);
    m_otherPlane = new CanvasView(other, m_otherRender, m_views);
    m_otherSpace = new SpaceView(other, m_otherSolid, m_views);
    m_otherPlane->setAccessibleName(tr("Canvas of the entry to compare with"));
    m_otherSpace->setAccessibleName(m_otherPlane->accessibleName());
    m_nothing =
        new QLabel(tr("There is no other entry in this file. Add or duplicate one to compare it."), this);
    m_nothing->setWordWrap(true);
    m_nothing->setAlignment(Qt::AlignCenter);
    m_nothing->setMargin(16);
    m_nothing->setForegroundRole(QPalette::PlaceholderText);
    for (QWidget* each : std::initializer_list<QWidget*>{m_otherPlane, m_otherSpace, m_nothing})
        m_views->addWidget(each);
    createHeader();
    setWhatsThis(tr("Another entry of the file beside the current one, to compare the two."));
    explainByTips(this);
    followTools();
    followViews();
    setAllowsNoAttractor(m_allowsNoAttractor);
    setTrackball(m_isTrackball);
    m_lastCurrent = m_document->currentId();
    connect(m_document, &document::Document::changed, this, &ComparePane::follow);
    connect(m_partner.get(), &document::PartnerDocument::partnerChanged, this, &ComparePane::showEntry);
    connect(other, &document::Document::changed, this, [this](const document::Change& change) {
        if (change.parts & (document::Change::System | document::Change::File)) showEntry();
    });
    emit created(m_otherPlane);
}

void ComparePane::createHeader() {
    m_entries = new QComboBox(this);
    m_entries->setAccessibleName(tr("Entry to compare with"));
    m_entries->setToolTip(tr("The entry that is shown beside the current one"));
    m_entries->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_entries->setMinimumContentsLength(fewLetters);
    m_link = flatButton(QString(), tr("Link Views"), {}, this);
    m_link->setObjectName(QStringLiteral("link-views"));
    m_link->setCheckable(true);
    m_link->setToolTip(tr("Pan and zoom both together, at the same position and scale"));
    auto* close = flatButton(QStringLiteral("close"), tr("Close"), tr("Show the current entry alone"), this);
    close->setObjectName(QStringLiteral("close"));
    auto* header = new QHBoxLayout;
    header->setContentsMargins(8, 4, 8, 4);
    header->addWidget(m_entries, 1);
    header->addWidget(m_link);
    header->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(header);
    layout->addWidget(m_views, 1);
    connect(m_entries, &QComboBox::activated, this, [this] { setEntry(chosenValue<EntryId>(m_entries)); });
    connect(close, &QToolButton::clicked, this, &ComparePane::closeRequested);
    connect(m_link, &QToolButton::toggled, this, [this](bool on) {
        if (!on) return;
        linkPlanes(m_plane, m_otherPlane);
        linkSpaces(m_space, m_otherSpace);
    });
}

// The tools of the window serve both.
void ComparePane::followTools() {
    const auto follow = [this](CanvasView::Tool tool) {
        if (tool == CanvasView::Tool::DefineTriangle) return;
        m_otherPlane->setTool(tool);
        m_otherSpace->setTarget(tool == CanvasView::Tool::Maps     ? SpaceView::Target::Maps
                                : tool == CanvasView::Tool::Branch ? SpaceView::Target::Branch
                                                                   : SpaceView::Target::Cage);
    };
    BranchChoice* branch = &m_plane->tools().branchTool().choice();
    BranchChoice* otherBranch = &m_otherPlane->tools().branchTool().choice();
    const auto have = [](BranchChoice* to, const BranchChoice* as) {
        to->setDepth(as->depth());
        to->setEdit(as->edit());
    };
    have(otherBranch, branch);
    connect(branch, &BranchChoice::changed, otherBranch, [=] { have(otherBranch, branch); });
    connect(otherBranch, &BranchChoice::changed, branch, [=] { have(branch, otherBranch); });
    m_otherSpace->setBranchChoice(otherBranch);
    follow(m_plane->tool());
    connect(m_plane, &CanvasView::toolChanged, this, follow);
    CanvasOptions& own = m_plane->options();
    CanvasOptions* other = &m_otherPlane->options();
    other->setGridVisible(own.isGridVisible());
    other->setAxesVisible(own.areAxesVisible());
    other->setOverlaysVisible(own.overlaysVisible());
    m_otherSpace->setOverlaysVisible(own.overlaysVisible());
    connect(&own, &CanvasOptions::gridVisibleChanged, other, &CanvasOptions::setGridVisible);
    connect(&own, &CanvasOptions::axesVisibleChanged, other, &CanvasOptions::setAxesVisible);
    connect(&own, &CanvasOptions::overlaysVisibleChanged, other, &CanvasOptions::setOverlaysVisible);
    connect(&own, &CanvasOptions::overlaysVisibleChanged, m_otherSpace, &SpaceView::setOverlaysVisible);
    connect(m_otherPlane, &CanvasView::message, this, &ComparePane::message);
    connect(m_otherSpace, &SpaceView::message, this, &ComparePane::message);
}

void ComparePane::followViews() {
    connect(&m_plane->navigation(), &CanvasNavigation::cameraChanged, this,
            [this] { linkPlanes(m_plane, m_otherPlane); });
    connect(&m_otherPlane->navigation(), &CanvasNavigation::cameraChanged, this,
            [this] { linkPlanes(m_otherPlane, m_plane); });
    standAlike();
    connect(&m_space->navigation(), &SpaceNavigation::changed, this, [this] {
        standAlike();
        linkSpaces(m_space, m_otherSpace);
    });
    connect(&m_otherSpace->navigation(), &SpaceNavigation::changed, this,
            [this] { linkSpaces(m_otherSpace, m_space); });
}

void ComparePane::setAllowsNoAttractor(bool allows) {
    m_allowsNoAttractor = allows;
    if (!m_partner) return;
    m_otherPlane->tools().setAllowsNoAttractor(allows);
    m_otherSpace->setAllowsNoAttractor(allows);
}

void ComparePane::setTrackball(bool on) {
    m_isTrackball = on;
    if (m_partner) m_otherSpace->navigation().setTrackball(on);
}

void ComparePane::standAlike() {
    const QScopedValueRollback<bool> linking(m_isLinking, true);
    m_otherSpace->navigation().setUpAxis(m_space->navigation().upAxis());
}

bool ComparePane::canLink() const {
    const int mine = document::dimension(m_document->fractal());
    return m_partner && mine != 0 && mine == document::dimension(m_partner->document().fractal());
}

// A canvas that is not shown yet has no place to look at.
void ComparePane::linkPlanes(CanvasView* from, CanvasView* to) {
    if (m_isLinking || !m_isCompared || !areViewsLinked() || !canLink() ||
        !document::plane(m_document->fractal()) || !from->isVisible() || !to->isVisible())
        return;
    const QScopedValueRollback<bool> linking(m_isLinking, true);
    attractor::Camera camera = from->camera();
    camera.width = to->camera().width;
    camera.height = to->camera().height;
    // True for a fitted view: a pending fit of the other entry has to be cancelled.
    const bool isToFit = to == m_otherPlane && to->navigation().isFitted();
    if (camera != to->camera() || isToFit) to->navigation().moveTo(camera);
}

void ComparePane::linkSpaces(SpaceView* from, SpaceView* to) {
    if (m_isLinking || !m_isCompared || !areViewsLinked() || !canLink() ||
        !document::space(m_document->fractal()) || !from->isVisible() || !to->isVisible())
        return;
    const QScopedValueRollback<bool> linking(m_isLinking, true);
    const attractor::OrbitCamera own = to->navigation().camera();
    attractor::OrbitCamera camera = from->navigation().camera();
    if (camera.size.height <= 0 || own.size.height <= 0) return;
    camera.height *=
        double(own.size.height) / camera.size.height; // equal scale in windows of different heights
    camera.size = own.size;
    if (camera == own) return;
    to->navigation().moveTo(camera);
}

EntryId ComparePane::likelyEntry() const {
    const document::FractalFile& file = m_document->file();
    const EntryId current = m_document->currentId();
    if (m_lastCurrent != current && document::indexOf(file, m_lastCurrent) >= 0) return m_lastCurrent;
    const int mine = document::dimension(m_document->fractal());
    const qsizetype at = document::indexOf(file, current);
    const qsizetype count = file.entries.size();
    for (qsizetype step = 1; step < count; ++step) { // next entry of the same dimension
        const document::Entry& entry = file.entries[(at + step) % count];
        if (document::dimension(*entry.fractal) == mine) return entry.id;
    }
    return count > 1 ? file.entries[at == 0 ? 1 : 0].id : EntryId::None;
}

void ComparePane::setEntry(EntryId entry) {
    if (!m_partner || entry == m_document->currentId()) return;
    changeTo(entry);
}

void ComparePane::follow(const document::Change& change) {
    using document::Change;
    if (change.live || !m_isCompared) return;
    const bool isAnotherFile = change.parts & Change::File;
    if (change.parts & Change::Current && !isAnotherFile && !areViewsLinked()) {
        keepTurn(m_lastCurrent, *m_plane); // keeps the rotation, although it has been fitted again
        keepTurn(m_partner->id(), *m_otherPlane);
        turn(*m_plane, *m_document);
    }
    if (change.parts & (Change::Entries | Change::Name | Change::Current | Change::File)) refresh();
    if (!isAnotherFile) return;
    m_turns.clear();
    turn(*m_otherPlane, m_partner->document());
}

void ComparePane::keepTurn(EntryId entry, const CanvasView& canvas) {
    m_turns[entry] = canvas.camera().rotation;
}

// Each entry keeps the rotation of its view, whichever canvas shows it. Keys of a camera take precedence.
void ComparePane::turn(CanvasView& canvas, const document::Document& document) {
    const EntryId entry = &document == m_document ? m_document->currentId() : m_partner->id();
    attractor::Camera camera = canvas.camera();
    const auto kept = m_turns.find(entry);
    const double rotation = kept == m_turns.end() ? 0 : kept->second;
    if (camera.rotation == rotation || document.view()) return;
    const QScopedValueRollback<bool> linking(m_isLinking, true);
    camera.rotation = rotation;
    canvas.navigation().setCamera(camera);
    canvas.fit();
}

// The entry that becomes the current one changes places with the one that was.
void ComparePane::refresh() {
    const document::FractalFile& file = m_document->file();
    const EntryId current = m_document->currentId();
    EntryId wanted = m_partner->id();
    if (wanted == current || document::indexOf(file, wanted) < 0) wanted = likelyEntry();
    m_lastCurrent = current;
    const QSignalBlocker quiet(m_entries);
    m_entries->clear();
    for (const document::Entry& entry : file.entries)
        if (entry.id != current) addChoice(m_entries, entry.fractal->name, entry.id);
    m_entries->setEnabled(m_entries->count() > 0);
    changeTo(wanted);
}

// The canvas fits another entry into its view; the view of the window is not to follow that.
void ComparePane::changeTo(EntryId entry) {
    if (entry != m_partner->id()) {
        keepTurn(m_partner->id(), *m_otherPlane);
        const QScopedValueRollback<bool> linking(m_isLinking, true);
        m_partner->setPartner(entry);
        turn(*m_otherPlane, m_partner->document());
    }
    const QSignalBlocker quiet(m_entries);
    chooseValue(m_entries, m_partner->id());
    showEntry();
}

void ComparePane::showEntry() {
    const document::Fractal& fractal = m_partner->document().fractal();
    const bool isNothing = m_partner->id() == EntryId::None;
    m_document->setBeside(m_partner->id());
    QWidget* wanted = document::space(fractal) ? static_cast<QWidget*>(m_otherSpace) : m_otherPlane;
    m_views->setCurrentWidget(isNothing ? m_nothing : wanted);
    setFocusProxy(isNothing ? nullptr : wanted);
    const bool links = !isNothing && canLink();
    m_link->setEnabled(links);
    m_link->setToolTip(links || isNothing ? tr("Pan and zoom both together, at the same position and scale")
                                          : tr("An entry in the plane and one in space cannot share a view"));
    linkPlanes(m_plane, m_otherPlane);
    linkSpaces(m_space, m_otherSpace);
}

bool ComparePane::cancelGesture() {
    if (!m_isCompared) return false;
    return m_otherPlane->cancelGesture() || m_otherSpace->cancelGesture();
}

} // namespace view
