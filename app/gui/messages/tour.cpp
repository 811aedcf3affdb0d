// SPDX-License-Identifier: MIT
#include "messages/tour.h"

#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "desktop/shortcuts.h"
#include "dialogs/export/export_shell.h"
#include "document/fractal/fractal.h"
#include "document/moments/animated_fractal.h"
#include "ifs/system/affine_map.h"
#include "panels/maps/maps_panel.h"
#include "panels/timeline/timeline_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTimer>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace {

constexpr int gap = 3; // pixels between the frame and its target

// Action that completes a step.
enum class Deed { Drag, Squeeze, Undo, Open, Move, Export, GoOn, EditMap, ChooseBranch, Contract, End };

struct Step {
    Deed deed;
    std::optional<Panel> target; // nullopt: canvas
    const char* title;
    const char* text;
    int column = -1; // column of the table of maps that the step describes; −1: none
};

constexpr Step steps[] = {
    {Deed::Drag,
     {},
     QT_TRANSLATE_NOOP("Tour", "Drag"),
     QT_TRANSLATE_NOOP("Tour", "Drag a corner of the triangle: the whole picture follows.")},
    {Deed::Squeeze,
     {},
     QT_TRANSLATE_NOOP("Tour", "Squeeze"),
     QT_TRANSLATE_NOOP("Tour", "Push a corner onto the opposite side until the picture is flat, then pull it "
                               "open again.")},
    {Deed::Undo,
     {},
     QT_TRANSLATE_NOOP("Tour", "Undo"),
     QT_TRANSLATE_NOOP("Tour", "Press %1 to take back what you have just done.")},
    {Deed::Open, Panel::Collection, QT_TRANSLATE_NOOP("Tour", "Collection"),
     QT_TRANSLATE_NOOP("Tour", "Double-click a picture of the collection that you like.")},
    {Deed::Move, Panel::Timeline, QT_TRANSLATE_NOOP("Tour", "Wind"),
     QT_TRANSLATE_NOOP("Tour", "Press Wind in the timeline and watch the picture sway.")},
    {Deed::Export,
     {},
     QT_TRANSLATE_NOOP("Tour", "Export"),
     QT_TRANSLATE_NOOP("Tour", "Press %1 to save the picture for others.")},
    {Deed::GoOn,
     {},
     QT_TRANSLATE_NOOP("Tour", "That Is It"),
     QT_TRANSLATE_NOOP("Tour", "Three more steps show what the picture is made of.")},
    {Deed::EditMap, Panel::Maps, QT_TRANSLATE_NOOP("Tour", "Map"),
     QT_TRANSLATE_NOOP("Tour", "Each row is a map that makes one smaller copy of the whole: double-click a "
                               "number and type another.")},
    {Deed::ChooseBranch,
     {},
     QT_TRANSLATE_NOOP("Tour", "Address"),
     QT_TRANSLATE_NOOP("Tour", "Click a point: the maps that lead there are its address, and you hold the "
                               "branch that they make.")},
    {Deed::Contract, Panel::Maps, QT_TRANSLATE_NOOP("Tour", "Norm"),
     QT_TRANSLATE_NOOP("Tour",
                       "‖A‖ is how far a map stretches at most: change a number, and keep it below 1."),
     view::MapsModel::Contraction},
    {Deed::End,
     {},
     QT_TRANSLATE_NOOP("Tour", "That Is All"),
     QT_TRANSLATE_NOOP("Tour", "Now take whatever you like by its corners.")},
};
constexpr int stepCount = int(std::size(steps));
constexpr int last = stepCount - 1; // the card that only says goodbye

// Where something moves already, the timeline shows that instead of motions to choose from.
constexpr auto windOverTracks = QT_TRANSLATE_NOOP(
    "Tour", "In the timeline, choose Wind under Add Motion and watch the picture sway as well.");

// After the squeeze, one step back is the flat picture.
constexpr auto undoOnceMore = QT_TRANSLATE_NOOP("Tour", "Press %1 once more: the picture is still flat.");

// Where the user has closed the panel of the step.
constexpr auto panelIsClosed =
    QT_TRANSLATE_NOOP("Tour", "Open the panel %1 again: it is under View › Panels.");

// The text of a step, with the keys that its user has for the deed.
QString sentence(Deed deed, const QString& text) {
    if (deed == Deed::Undo) return text.arg(view::toPress(QStringLiteral("undo"), QKeySequence::Undo));
    if (deed == Deed::Export)
        return text.arg(view::toPress(QStringLiteral("export-picture"), Qt::CTRL | Qt::Key_E));
    return text;
}

// A frame that lets every click through.
class Mark : public QWidget {
public:
    explicit Mark(QWidget* parent) : QWidget(parent) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
        setFocusPolicy(Qt::NoFocus);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 6, 6);
    }
};

} // namespace

void Tour::start(QMainWindow* window, document::Document* document, const Panels& panels) {
    for (Tour* old : window->findChildren<Tour*>(Qt::FindDirectChildrenOnly)) {
        old->bringBack();
        delete old;
    }
    window->activateWindow();
    (new Tour(window, document, panels))->showStep(0);
}

Tour::Tour(QMainWindow* host, document::Document* document, const Panels& panels)
    : MessageBanner(host),
      m_document(document),
      m_panels(panels),
      m_mark(new Mark(host)),
      m_progress(new QLabel(this)),
      m_title(createTitle()),
      m_text(new QLabel(this)),
      m_back(new QPushButton(tr("&Back"), this)),
      m_next(new QPushButton(this)),
      m_close(new QPushButton(this)) {
    setObjectName(QStringLiteral("tour"));
    setAccessibleName(tr("Tour"));
    m_progress->setObjectName(QStringLiteral("progress"));
    m_back->setObjectName(QStringLiteral("back"));
    m_close->setObjectName(QStringLiteral("close"));
    m_text->setWordWrap(true);
    m_progress->setForegroundRole(QPalette::PlaceholderText);

    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_progress);
    QBoxLayout* buttons = createButtons();
    buttons->addWidget(m_close);
    buttons->addStretch();
    buttons->addWidget(m_back);
    buttons->addWidget(m_next);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin - 2, margin, margin - 2);
    layout->setSpacing(10);
    layout->addLayout(head);
    layout->addWidget(m_text);
    layout->addLayout(buttons);

    connect(m_back, &QPushButton::clicked, this, [this] { showStep(m_step - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] {
        if (m_step < last)
            showStep(m_step + 1);
        else
            close();
    });
    connect(m_close, &QPushButton::clicked, this, &QWidget::close);
    connectDeeds();
    follow(host->centralWidget()); // whose room the timeline takes
    for (const Step& step : steps)
        if (const QDockWidget* dock = step.target ? m_panels.dock(*step.target) : nullptr)
            connect(dock, &QDockWidget::visibilityChanged, this, &Tour::tellStep,
                    Qt::ConnectionType(Qt::QueuedConnection | Qt::UniqueConnection));
    if (const auto* canvas = host->findChild<view::CanvasView*>())
        m_found = {canvas->tool(), canvas->options().overlaysVisible()};
}

void Tour::connectDeeds() {
    connect(m_document, &document::Document::changed, this, &Tour::followDocument);
    m_index = m_document->undoStack()->index();
    connect(m_document->undoStack(), &QUndoStack::indexChanged, this, [this](int index) {
        const bool isBack = index < std::exchange(m_index, index);
        if (!isBack || steps[m_step].deed != Deed::Undo) return;
        m_hasUndone = true;
        isFlat() ? tellStep() : done(m_step);
    });
    const auto step = [this](Deed deed) {
        if (steps[m_step].deed == deed) done(m_step);
    };
    if (const auto* exporting = host()->findChild<QAction*>(QStringLiteral("export-picture")))
        connect(exporting, &QAction::triggered, this, &Tour::followExports);
    if (auto* canvas = host()->findChild<view::CanvasView*>()) {
        view::BranchChoice& choice = canvas->tools().branchTool().choice();
        connect(&choice, &view::BranchChoice::changed, this, [step, &choice] {
            if (!choice.branch().empty()) step(Deed::ChooseBranch);
        });
    }
}

// The dialog alone saves nothing.
void Tour::followExports() {
    const auto saved = [this] {
        if (steps[m_step].deed == Deed::Export) done(m_step);
    };
    for (const auto* dialog : host()->findChildren<view::ExportShell*>()) {
        connect(dialog, &view::ExportShell::exported, this, saved);
        connect(dialog, &view::ExportShell::queued, this, saved);
    }
}

// A gesture completes a step when it ends.
void Tour::followDocument(const document::Change& change) {
    using document::Change;
    const bool isHeld = change.parts & Change::Cage && !(change.parts & Change::Time);
    if (isHeld && isFlat()) m_wasFlat = true;
    if (change.live) {
        m_isDragging = m_isDragging || isHeld;
        return;
    }
    const bool wasDragged = std::exchange(m_isDragging, false);
    if (!(change.parts & Change::Time))
        QMetaObject::invokeMethod(this, &Tour::tellStep, Qt::QueuedConnection); // once all have followed
    const bool isOther = change.parts & (Change::Current | Change::File);
    const bool isEdited = change.parts & Change::System && !(change.parts & Change::Time) && !isOther;
    const bool isMade = [&] {
        switch (steps[m_step].deed) {
        case Deed::Drag:
            return isHeld && wasDragged && !isOther;
        case Deed::Squeeze:
            return isHeld && m_wasFlat && !isFlat() && !isOther;
        case Deed::Open:
            return isOther;
        case Deed::Move:
            return change.parts & Change::Animation &&
                   document::animationFacts(m_document->entryFractal()).has_value();
        case Deed::EditMap:
            return isEdited;
        case Deed::Contract:
            return isEdited && isContracting();
        default:
            return false;
        }
    }();
    if (isMade) done(m_step);
}

// Queued: the change that did it is still being told.
void Tour::done(int step) {
    QMetaObject::invokeMethod(
        this,
        [this, step] {
            if (m_step != step) return;
            showStep(step + 1);
        },
        Qt::QueuedConnection);
}

bool Tour::isFlat() const {
    constexpr double flat = 0.04; // share of the area of a square over the longest side
    const auto* canvas = host()->findChild<view::CanvasView*>();
    const auto& cage = canvas->canvas().handles().cage();
    if (!cage || cage->current.size() < 3) return false;
    double doubledArea = 0, longest = 0;
    const auto& corners = cage->current;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& a = corners[i];
        const auto& b = corners[(i + 1) % corners.size()];
        doubledArea += a.x() * b.y() - a.y() * b.x();
        longest = std::max(longest, (b - a).squaredNorm());
    }
    return std::abs(doubledArea) < 2 * flat * longest;
}

bool Tour::isContracting() const {
    const auto contracts = []<int Dim>(const ifs::IteratedFunctionSystem<Dim>* system) {
        return system != nullptr && std::ranges::all_of(system->maps, [](const ifs::WeightedMap<Dim>& each) {
                   return !each.enabled || ifs::spectralNorm<Dim>(each.map.linear) < 1;
               });
    };
    const document::Fractal& fractal = m_document->fractal();
    return contracts(document::system2(fractal)) || contracts(document::system3(fractal));
}

Tour::~Tour() {
    leaveStep();
    delete m_mark;
}

void Tour::leaveStep() {
    if (m_target) unfollow(m_target);
    m_target = nullptr;
}

// Keeps the size of the longest step, so that the buttons stay under the pointer.
void Tour::keepSize() {
    const auto widthOf = [this](const QString& text) {
        return m_next->fontMetrics().horizontalAdvance(text);
    };
    m_next->setMinimumWidth(std::max({widthOf(tr("&Skip")), widthOf(tr("&Go On")), widthOf(tr("&Done"))}) +
                            2 * margin);
    int tallest = 0;
    const QRect column(0, 0, widthFor(canvasRect().width() - 2 * margin) - 2 * margin, 10'000);
    QStringList texts{tr(windOverTracks), sentence(Deed::Undo, tr(undoOnceMore)), tr(panelIsClosed)};
    for (const Step& each : steps)
        texts << sentence(each.deed, tr(each.text));
    for (const QString& text : texts) {
        const QRect needed = m_text->fontMetrics().boundingRect(column, Qt::TextWordWrap, text);
        tallest = std::max(tallest, needed.height());
    }
    m_text->setMinimumHeight(tallest + m_text->fontMetrics().lineSpacing());
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
}

void Tour::showPanel(QDockWidget* dock) {
    if (dock->isHidden()) m_found.hidden << dock;
    for (QDockWidget* other : host()->tabifiedDockWidgets(dock))
        if (!other->visibleRegion().isEmpty()) m_found.inFront << other;
    dock->show();
    dock->raise();
}

// The timeline stays with what moves.
void Tour::bringBack() {
    if (auto* canvas = host()->findChild<view::CanvasView*>()) {
        canvas->setTool(m_found.tool);
        canvas->options().setOverlaysVisible(m_found.areOverlaysVisible);
    }
    if (auto* maps = host()->findChild<view::MapsPanel*>(); maps && m_found.scrolled) {
        if (m_found.isColumnHidden) maps->showColumns(view::MapsPanel::Columns::Facts, false);
        maps->table()->horizontalScrollBar()->setValue(*m_found.scrolled);
    }
    for (const auto& dock : m_found.hidden)
        if (dock && (dock != m_panels.dock(::Panel::Timeline) ||
                     !document::animationFacts(m_document->entryFractal())))
            dock->hide();
    if (!m_found.inFront.isEmpty() && m_found.inFront.front()) m_found.inFront.front()->raise();
}

void Tour::closeEvent(QCloseEvent* event) {
    bringBack();
    MessageBanner::closeEvent(event);
}

void Tour::point(int step) {
    const std::optional<::Panel> panel = steps[step].target;
    auto* canvas = host()->findChild<view::CanvasView*>();
    if (panel) {
        m_target = m_panels.dock(*panel);
        showPanel(m_panels.dock(*panel));
    } else if (canvas) {
        using Tool = view::CanvasView::Tool;
        canvas->options().setOverlaysVisible(true);
        canvas->setTool(steps[step].deed == Deed::ChooseBranch ? Tool::Branch : Tool::Cage);
        m_target = canvas;
    }
    if (canvas) canvas->dismissHint();
    if (auto* maps = host()->findChild<view::MapsPanel*>(); maps && steps[step].column >= 0) {
        if (!m_found.scrolled) {
            m_found.scrolled = maps->table()->horizontalScrollBar()->value();
            m_found.isColumnHidden = maps->table()->isColumnHidden(steps[step].column);
        }
        QTimer::singleShot(0, maps, [maps, step] { maps->reveal(steps[step].column); });
    }
}

void Tour::showStep(int step) {
    leaveStep();
    m_step = step;
    m_wasFlat = m_hasUndone = false;
    const bool asks = step == rest; // whether to go on
    const bool isStep = !asks && step < last;
    m_title->setText(tr(steps[step].title));
    point(step);
    m_text->setText(textOf(step));
    if (m_target) follow(m_target.data());
    const bool isHand = step < handSteps;
    m_progress->setText(
        isStep ? tr("%1 of %2").arg(isHand ? step + 1 : step - rest).arg(isHand ? handSteps : last - rest - 1)
               : QString());
    m_back->setVisible(step > 0);
    keepSize();
    m_next->setObjectName(QLatin1String(asks ? "go-on" : step == last ? "done" : "skip"));
    m_next->setText(asks ? tr("&Go On") : step == last ? tr("&Done") : tr("&Skip"));
    m_close->setText(tr("Close"));
    m_close->setVisible(step < last);
    appear(m_text->text());
    if (m_target == host()->findChild<view::CanvasView*>()) m_target->setFocus(); // the hand is needed there
}

QString Tour::textOf(int step) const {
    if (isAtPanel() && m_target->isHidden()) return tr(panelIsClosed).arg(m_target->windowTitle());
    if (steps[step].deed == Deed::Undo && m_hasUndone && isFlat())
        return sentence(Deed::Undo, tr(undoOnceMore));
    const auto* timeline = host()->findChild<view::TimelinePanel*>();
    const bool isMoving = steps[step].deed == Deed::Move && timeline && timeline->showsTracks();
    return sentence(steps[step].deed, tr(isMoving ? windOverTracks : steps[step].text));
}

void Tour::tellStep() {
    if (!isVisible()) return;
    placeSoon();
    const QString text = textOf(m_step);
    if (m_text->text() == text) return;
    m_text->setText(text);
    appear(text);
}

// The number of handles of the cage that the banner would cover at that place; more where it would leave the
// canvas, and most where it would cover the panel that the step speaks of.
int Tour::coveredAt(const QPoint& place) const {
    constexpr int reach = 40; // of a corner, with the round handle beside it
    const QRect card = QRect(place, size());
    std::vector<QPoint> handles;
    if (const auto* canvas = host()->findChild<view::CanvasView*>(); canvas && canvas->isVisible())
        if (const auto& cage = canvas->canvas().handles().cage())
            for (const QPointF& corner : view::pixelsOf(canvas->camera(), cage->current))
                handles.push_back(canvas->viewport()->mapTo(host(), corner.toPoint()));
    const QRect around = card.adjusted(-reach, -reach, reach, reach);
    const auto covered =
        std::ranges::count_if(handles, [&](const QPoint& handle) { return around.contains(handle); });
    const auto all = std::ssize(handles) + 1;
    const auto outside = canvasRect().contains(card) ? 0 : all;
    const auto overPanel = isAtPanel() && card.intersects(pointed()) ? 2 * all : 0;
    return int(covered + outside + overPanel);
}

// Beside each other from the upper right corner on: there the notes of the canvas are not.
QPoint Tour::freePlace() const {
    const QRect room = canvasRect();
    const int left = room.left() + margin;
    const int right = room.right() - margin - width();
    const int top = room.top() + margin;
    const int bottom = room.bottom() - hintHeight - height();
    const int middle = room.center().x() - width() / 2;
    const int centre = room.center().y() - height() / 2;
    // Where the canvas has no room, those of the window.
    const int farRight = host()->width() - margin - width();
    const int low = host()->height() - margin - height();
    const std::array places{QPoint(right, top),     QPoint(left, top),     QPoint(left, bottom),
                            QPoint(right, bottom),  QPoint(right, centre), QPoint(left, centre),
                            QPoint(middle, bottom), QPoint(middle, top),   QPoint(farRight, top),
                            QPoint(margin, top),    QPoint(farRight, low), QPoint(margin, low)};
    return std::ranges::min(places, {}, [this](const QPoint& place) { return coveredAt(place); });
}

// Panels are covered before words are cut.
int Tour::widthFor(int room) const {
    const int least = std::min(3 * widest() / 4, host()->width() - 2 * margin);
    return std::clamp(room, least, std::max(least, widest()));
}

QRect Tour::pointed() const {
    return {m_target->mapTo(host(), QPoint()), m_target->size()};
}

bool Tour::isAtPanel() const {
    return m_target && m_target != host()->findChild<view::CanvasView*>();
}

// Keeps one place and one height for all steps while nothing of interest comes below it, so that the buttons
// stay under the pointer.
QPoint Tour::topLeft() {
    if (!m_target) return MessageBanner::topLeft();
    m_mark->setVisible(m_step != rest && m_step != last && !m_target->visibleRegion().isEmpty());
    m_mark->setGeometry(pointed().adjusted(-gap, -gap, gap, gap).intersected(host()->rect()));
    m_mark->raise();
    // Room without the bars, which may take some of its height.
    const std::array room{canvasRect().left(), canvasRect().width(), host()->height(), height()};
    if (std::exchange(m_room, room) != room || coveredAt(m_place) > 0) m_place = freePlace();
    return m_place;
}
