// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"

#include "canvas/geometry/canvas_note.h"
#include "canvas/tools/map_gestures.h"
#include "document/branches/addresses.h"
#include "document/edits/maps/map_locks.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/space_map_handles.h"
#include "ifs/cage/map_handles.h"
#include "space/space_view.h"
#include "widgets/choices.h"
#include "widgets/numbers/number_box.h"
#include "widgets/text/elided_label.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStackedWidget>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace view {

namespace {

constexpr int maxAngle = 90;   // degrees in either direction
constexpr int minLetters = 18; // letters of the chosen branch, in a narrow window

} // namespace

BranchBar::BranchBar(document::Document* document, CanvasView* canvas, QWidget* parent)
    : QWidget(parent), m_document(document), m_canvas(canvas), m_swinging(document) {
    setAccessibleName(tr("Maps and branches"));
    m_rows = new QStackedWidget(this);
    m_branchRow = makeBranch();
    m_swingRow = makeSwing();
    m_rows->addWidget(m_branchRow);
    m_rows->addWidget(m_swingRow);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->addWidget(m_rows);
    connect(&choice(), &BranchChoice::changed, this, [this] { followChoice(m_canvas); });
    connect(canvas, &CanvasView::toolChanged, this, &BranchBar::follow);
    connect(canvas, &CanvasView::selectedMapsChanged, this, &BranchBar::endSwing);
    connect(document, &document::Document::changed, this, [this] {
        m_swinging.isOpen() ? follow() : centre(); // ended by another edit
    });
    follow();
}

void BranchBar::setSpace(SpaceView* space, const QString& hint) {
    m_space = space;
    m_hintInSpace = hint;
    connect(space, &SpaceView::mapHeld, this, &BranchBar::endSwing);
    connect(space, &SpaceView::mapsSelected, this, &BranchBar::endSwing);
    follow();
}

void BranchBar::setBeside(CanvasView* canvas) {
    connect(&canvas->tools().branchTool().choice(), &BranchChoice::changed, this,
            [this, canvas] { followChoice(canvas); });
    connect(&canvas->canvas().document(), &document::Document::changed, this, &BranchBar::follow);
}

void BranchBar::followChoice(CanvasView* canvas) {
    const ifs::Word& address = canvas->tools().branchTool().choice().address();
    ifs::Word& seen = canvas == m_canvas ? m_seen : m_seenBeside;
    const bool isAnother = std::exchange(seen, address) != address;
    if (address.empty() && m_chosenIn == canvas)
        m_chosenIn = m_canvas;
    else if (isAnother && !address.empty())
        m_chosenIn = canvas;
    follow();
}

QWidget* BranchBar::makeBranch() {
    auto* row = new QWidget(this);
    auto* depthLabel = new QLabel(tr("&Depth"), row);
    m_depth = new WholeNumberBox(row);
    m_depth->setRange(1, BranchChoice::maxDepth);
    m_depth->setAccessibleName(tr("Depth of the branch"));
    m_depth->setToolTip(
        tr("The number of maps in the address of the branch (Shift + wheel over the canvas)"));
    depthLabel->setBuddy(m_depth);
    m_address = new QLabel(row);
    m_address->setTextFormat(Qt::RichText);
    m_address->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_address->setToolTip(tr(
        "The address of the clicked point, outermost map first; the bold part is the address of the branch"));
    auto* editLabel = new QLabel(tr("Chan&ge"), row);
    m_edit = new QComboBox(row);
    using document::BranchEdit;
    addChoice(
        m_edit, tr("New map for this branch"), BranchEdit::OwnMap,
        tr("Gives this branch and each of its sibling branches a map of its own. The change appears again at "
           "all smaller scales."));
    addChoice(
        m_edit, tr("Last map of the address"), BranchEdit::LastMap,
        tr("The system keeps its number of maps. All branches that this map makes change in the same way."));
    addChoice(m_edit, tr("Only here"), BranchEdit::Display,
              tr("The code does not change. Only this branch is shown in another position; the "
                 "same change does not appear at other scales."));
    addChoice(m_edit, tr("Here and inside it"), BranchEdit::Inside,
              tr("The code does not change. This branch is shown in another position, and so is the same "
                 "branch inside it, again and again: a frond curls up. Nothing beside it changes."));
    m_edit->setAccessibleName(tr("What editing the branch changes"));
    for (QWidget* yields : {static_cast<QWidget*>(m_edit), static_cast<QWidget*>(m_address)})
        yields->setMinimumWidth(minLetters * fontMetrics().averageCharWidth());
    m_putBack = new QPushButton(row);
    QSizePolicy keepsItsRoom = m_putBack->sizePolicy(); // keeps the height of the row
    keepsItsRoom.setRetainSizeWhenHidden(true);
    m_putBack->setSizePolicy(keepsItsRoom);
    editLabel->setBuddy(m_edit);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(depthLabel);
    layout->addWidget(m_depth);
    layout->addSpacing(12);
    layout->addWidget(m_address);
    layout->addStretch();
    layout->addWidget(editLabel);
    layout->addWidget(m_edit);
    layout->addWidget(m_putBack);
    connect(m_putBack, &QPushButton::clicked, this, &BranchBar::putBack);
    connect(m_depth, &QSpinBox::valueChanged, &choice(), &BranchChoice::setDepth);
    connect(m_edit, &QComboBox::currentIndexChanged, this, [this] {
        choice().setEdit(chosenValue<BranchEdit>(m_edit));
        m_edit->setWhatsThis(m_edit->currentData(Qt::ToolTipRole).toString());
    });
    m_edit->setToolTip(tr("What changes in the code when you drag the branch"));
    m_edit->setWhatsThis(m_edit->currentData(Qt::ToolTipRole).toString());
    return row;
}

QWidget* BranchBar::makeSwing() {
    auto* row = new QWidget(this);
    auto* label = new QLabel(tr("S&wing"), row);
    m_swing = new QSlider(Qt::Horizontal, row);
    m_swing->setRange(-maxAngle, maxAngle);
    m_swing->setPageStep(5);
    m_swing->setMaximumWidth(420);
    m_swing->setAccessibleName(tr("Angle by which the selected maps swing about their roots"));
    m_swing->setToolTip(tr("Swings the selected maps, each about the image of the lowest point of the "
                           "fractal; the slider returns to the middle when you release it"));
    m_swing->installEventFilter(this);
    label->setBuddy(m_swing);
    m_angle = new QLabel(row);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label);
    layout->addWidget(m_swing, 1);
    layout->addWidget(m_angle);
    m_swingHint = new ElidedLabel(row);
    layout->addWidget(m_swingHint, 1);
    connect(m_swing, &QSlider::valueChanged, this, &BranchBar::swingTo);
    connect(m_swing, &QSlider::sliderReleased, this, &BranchBar::endSwing);
    m_pause.setSingleShot(true);
    m_pause.setInterval(1000);
    connect(&m_pause, &QTimer::timeout, this, &BranchBar::endSwing);
    return row;
}

void BranchBar::follow() {
    showRow(m_canvas->tool() == CanvasView::Tool::Maps ? m_swingRow : m_branchRow);
    const QSignalBlocker quiet(m_depth);
    const ifs::Word& address = choice().address();
    const auto known = int(std::min(address.size(), std::size_t(BranchChoice::maxDepth)));
    m_depth->setMaximum(address.empty() ? BranchChoice::maxDepth : known);
    m_depth->setValue(choice().depth()); // corrects an unknown depth
    const ifs::Word word = choice().branch();
    const ifs::Word rest(address.begin() + std::ptrdiff_t(word.size()), address.end());
    m_address->setText(
        address.empty() ? tr("no branch selected")
                        : tr("branch <b>%1</b> %2")
                              .arg(document::addressText(word, word.size()), document::addressText(rest, 8)));
    const document::Fractal& fractal = chosenIn().canvas().document().fractal();
    const bool isMoved = document::isMoved(fractal, word);
    m_putBack->setText(isMoved ? tr("Put &Back") : tr("Put All &Back"));
    m_putBack->setToolTip(isMoved
                              ? tr("Shows the branch in its original position, given by its maps")
                              : tr("Shows all branches in their original positions, given by their maps"));
    const document::Shape<2>* plane = document::plane(fractal);
    const document::Shape<3>* space = document::space(fractal);
    const bool canPutBack = (plane && !plane->moved.empty()) || (space && !space->moved.empty());
    if (!canPutBack) takeFocusFrom(m_putBack);
    m_putBack->setVisible(canPutBack);
    const bool isSpace = document::space(m_document->fractal());
    const bool isHeld = m_space && m_space->heldMap();
    const bool canSwing = isSpace ? isHeld : !m_canvas->selectedMaps().empty();
    if (!canSwing) takeFocusFrom(m_swing);
    m_swing->setEnabled(canSwing);
    m_swingHint->setText(isSpace ? m_hintInSpace : QString());
    m_swingHint->setToolTip(m_swingHint->text());
    m_angle->setText(tr("%1°").arg(m_swing->value()));
}

void BranchBar::takeFocusFrom(const QWidget* part) {
    const QWidget* focused = QApplication::focusWidget();
    if (!focused || (part != focused && !part->isAncestorOf(focused))) return;
    const bool isSeen = m_canvas->isVisible() || !m_space;
    (isSeen ? static_cast<QWidget*>(m_canvas) : m_space)->setFocus();
}

void BranchBar::showRow(QWidget* row) {
    if (row == m_rows->currentWidget()) return;
    takeFocusFrom(m_rows);
    m_rows->setCurrentWidget(row);
}

BranchChoice& BranchBar::choice() const {
    return chosenIn().tools().branchTool().choice();
}

void BranchBar::putBack() {
    const ifs::Word word = choice().branch();
    document::Document& document = chosenIn().canvas().document();
    document::Fractal fractal = document.fractal();
    const bool isMoved = document::isMoved(fractal, word);
    if (isMoved)
        fractal = document::withBranchPutBack(fractal, word);
    else if (document::Shape<2>* plane = document::plane(fractal))
        plane->moved.clear();
    else if (document::Shape<3>* space = document::space(fractal))
        space->moved.clear();
    document.edit(isMoved ? tr("Put branch %1 back").arg(document::addressText(word, word.size()))
                          : tr("Put all branches back"),
                  fractal);
}

BranchBar::Swung BranchBar::swungInPlane() {
    const document::Fractal& before = m_swinging.before();
    const auto root = document::root(before);
    if (!document::system2(before) || !root) return nullptr;
    std::vector<std::size_t> indices = m_canvas->canvas().selection().mapIndices();
    const QString locked = document::lockObstacle(before, indices);
    std::erase_if(indices, [&](std::size_t index) { return document::isLocked(before, index); });
    if (indices.empty()) {
        emit m_canvas->message(locked);
        return nullptr;
    }
    const document::MapHandles handles(std::make_shared<const document::Fractal>(before),
                                       document::effectiveCage(before));
    return [handles, indices, root = *root](double angle) {
        return handles.withMapsSwung(indices, root, angle);
    };
}

// Swings about the line of sight.
BranchBar::Swung BranchBar::swungInSpace() {
    const auto before = std::make_shared<const document::Fractal>(m_swinging.before());
    std::vector<std::size_t> indices = m_space ? m_space->selectedMaps() : std::vector<std::size_t>();
    if (indices.empty()) return nullptr;
    const QString locked = document::lockObstacle(*before, indices);
    std::erase_if(indices, [&](std::size_t index) { return document::isLocked(*before, index); });
    const attractor::Orientation turned = m_space->navigation().camera().orientation;
    const auto root = document::rootInSpace(*before, attractor::standing(m_space->navigation().upAxis()) *
                                                         ifs::Vector<3>::UnitY());
    const auto cage = document::knownSpaceCage(*before);
    const auto handles = cage ? std::optional(document::SpaceMapHandles(before, *cage)) : std::nullopt;
    if (indices.empty() || !root || !handles || !handles->canBeMoved()) {
        emit m_canvas->message(
            indices.empty() ? locked
                            : tr("Maps cannot swing while the cage is flat. First open or reset the cage."));
        return nullptr;
    }
    return [handles = *handles, indices, root = *root,
            axis = ifs::Vector<3>(turned * ifs::Vector<3>::UnitZ())](double angle) {
        return handles.withMapsSwung(indices, root, axis, angle);
    };
}

double BranchBar::shareToShow(const Swung& shareOf) {
    MapsTool& plane = m_canvas->tools().mapsTool();
    document::Fractal shown;
    const auto after = [&](double share) -> const document::Fractal& { return shown = shareOf(share); };
    if (document::plane(m_swinging.before())) return plane.shareToShow(after);
    if (plane.allowsNoAttractor()) return 1;
    const auto way = wayWithAttractor<3>(after);
    if (way.share < 1) {
        shown = shareOf(way.share);
        emit m_canvas->message(stopNote<3>(*document::system3(shown), way));
    }
    return way.share;
}

// Counted from where the slider left the middle.
void BranchBar::swingTo(int degrees) {
    if (m_isGivenUp) return centre();
    const Swung swung = document::space(m_swinging.before()) ? swungInSpace() : swungInPlane();
    if (!swung) return centre();
    constexpr double degree = std::numbers::pi / 180;
    // Whole degrees up to the loss of the attractor.
    degrees = int(degrees * shareToShow([&](double share) { return swung(degrees * share * degree); }));
    m_swinging.preview(tr("Swing maps"),
                       [&](document::Fractal& fractal) { fractal = swung(degrees * degree); });
    const QSignalBlocker quiet(m_swing);
    m_swing->setValue(degrees);
    follow();
    if (m_swing->isSliderDown()) return;
    // A wheel without the focus ends here. The canvas keeps the message about the stop.
    if (!m_swing->hasFocus()) {
        m_swinging.commit();
        centre();
        return;
    }
    m_pause.start();
}

void BranchBar::giveUpSwing() {
    m_pause.stop();
    m_isGivenUp = m_swing->isSliderDown();
    m_swinging.cancel();
    m_canvas->tools().mapsTool().dismissStop();
    centre();
}

void BranchBar::endSwing() {
    m_pause.stop();
    m_isGivenUp = false;
    if (m_swinging.isOpen()) m_canvas->tools().mapsTool().dismissStop();
    m_swinging.commit();
    centre();
}

void BranchBar::centre() {
    const QSignalBlocker quiet(m_swing);
    m_swing->setValue(0);
    follow();
}

bool BranchBar::eventFilter(QObject* watched, QEvent* event) {
    // True for a click beside the knob, which moves it without a hold.
    const bool isClicked = event->type() == QEvent::MouseButtonRelease && !m_swing->isSliderDown();
    if (watched == m_swing && (isClicked || event->type() == QEvent::FocusOut)) endSwing();
    // Undo ends the swing, and then undoes it.
    if (watched == m_swing && event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo))
        endSwing();
    // Esc would otherwise be a shortcut of the window.
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (watched == m_swing && isKey && m_swinging.isOpen() &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Cancel)) {
        event->accept();
        if (event->type() == QEvent::KeyPress) giveUpSwing();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace view
