// SPDX-License-Identifier: MIT
#include "panels/branch_bar.h"

#include "canvas/branch_tool.h"
#include "canvas/canvas_scene.h"
#include "document/addresses.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

namespace view {

namespace {

constexpr int farthest = 90;   // degrees either way
constexpr int fewLetters = 18; // of what is chosen, in a narrow window

} // namespace

BranchBar::BranchBar(document::Document* document, CanvasView* canvas, QWidget* parent)
    : QWidget(parent), m_document(document), m_canvas(canvas), m_swinging(document) {
    setAccessibleName(tr("Maps and branches"));
    m_branchRow = makeBranch();
    m_swingRow = makeSwing();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->addWidget(m_branchRow);
    layout->addWidget(m_swingRow);
    connect(canvas, &CanvasView::branchChanged, this, &BranchBar::follow);
    connect(canvas, &CanvasView::toolChanged, this, &BranchBar::follow);
    connect(canvas, &CanvasView::selectedMapsChanged, this, &BranchBar::endSwing);
    connect(document, &document::Document::changed, this, [this] {
        m_swinging.isOpen() ? follow() : centre(); // another edit has ended ours
    });
    follow();
}

QWidget* BranchBar::makeBranch() {
    auto* row = new QWidget(this);
    auto* depthLabel = new QLabel(tr("&Depth"), row);
    m_depth = new QSpinBox(row);
    m_depth->setRange(1, BranchTool::deepest);
    m_depth->setAccessibleName(tr("Depth of the branch"));
    m_depth->setToolTip(tr("How many maps of the address name the branch (Shift + wheel over the canvas)"));
    depthLabel->setBuddy(m_depth);
    m_address = new QLabel(row);
    m_address->setTextFormat(Qt::RichText);
    m_address->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_address->setToolTip(
        tr("The address of the point clicked, outermost map first; the branch is what is bold"));
    auto* editLabel = new QLabel(tr("Chan&ge"), row);
    m_edit = new QComboBox(row);
    m_edit->addItem(tr("this branch, as a map of its own"));
    m_edit->setItemData(
        0,
        tr("The system gets a map for this branch and one for every branch beside it. Its change is "
           "seen again at all smaller scales."),
        Qt::ToolTipRole);
    m_edit->addItem(tr("the last map of its address"));
    m_edit->setItemData(1, tr("The code keeps its maps. All branches that this map makes change alike."),
                        Qt::ToolTipRole);
    m_edit->addItem(tr("where it is shown, and it alone"));
    m_edit->setItemData(2,
                        tr("The code stays as it is. This branch is shown elsewhere, and nothing like it at "
                           "other scales."),
                        Qt::ToolTipRole);
    m_edit->setAccessibleName(tr("What changing the branch changes"));
    for (QWidget* yields : {static_cast<QWidget*>(m_edit), static_cast<QWidget*>(m_address)})
        yields->setMinimumWidth(fewLetters * fontMetrics().averageCharWidth());
    m_putBack = new QPushButton(row);
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
    connect(m_depth, &QSpinBox::valueChanged, m_canvas, &CanvasView::setBranchDepth);
    connect(m_edit, &QComboBox::currentIndexChanged, this, [this](int index) {
        constexpr std::array edits{document::BranchEdit::OwnMap, document::BranchEdit::LastMap,
                                   document::BranchEdit::Display};
        m_canvas->setBranchEdit(edits.at(std::size_t(index)));
        m_edit->setToolTip(m_edit->itemData(index, Qt::ToolTipRole).toString());
    });
    m_edit->setToolTip(m_edit->itemData(0, Qt::ToolTipRole).toString());
    return row;
}

QWidget* BranchBar::makeSwing() {
    auto* row = new QWidget(this);
    auto* label = new QLabel(tr("&Weave"), row);
    m_swing = new QSlider(Qt::Horizontal, row);
    m_swing->setRange(-farthest, farthest);
    m_swing->setPageStep(5);
    m_swing->setMaximumWidth(420);
    m_swing->setAccessibleName(tr("Angle by which the selected maps swing about their roots"));
    m_swing->setToolTip(tr("Lets the selected maps swing, each about the image of the lowest point of the "
                           "fractal; the slider goes back to the middle when it is let go"));
    m_swing->installEventFilter(this);
    label->setBuddy(m_swing);
    m_angle = new QLabel(row);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label);
    layout->addWidget(m_swing, 1);
    layout->addWidget(m_angle);
    layout->addStretch();
    connect(m_swing, &QSlider::valueChanged, this, &BranchBar::swingTo);
    connect(m_swing, &QSlider::sliderReleased, this, &BranchBar::endSwing);
    return row;
}

void BranchBar::follow() {
    setShown(m_branchRow, m_canvas->tool() == CanvasView::Tool::Branch);
    setShown(m_swingRow, m_canvas->tool() == CanvasView::Tool::Maps);
    const QSignalBlocker quiet(m_depth);
    m_depth->setValue(m_canvas->branchDepth());
    const ifs::Word& address = m_canvas->branchAddress();
    const ifs::Word word = branch();
    const ifs::Word rest(address.begin() + std::ptrdiff_t(word.size()), address.end());
    m_address->setText(
        address.empty() ? tr("no branch selected")
                        : tr("branch <b>%1</b> %2")
                              .arg(document::addressText(word, word.size()), document::addressText(rest, 8)));
    const document::Fractal& fractal = m_document->fractal();
    const bool isMoved = document::isMoved(fractal, word);
    m_putBack->setText(isMoved ? tr("Put &Back") : tr("Put All &Back"));
    m_putBack->setToolTip(isMoved ? tr("Shows the branch where its maps put it")
                                  : tr("Shows every branch where its maps put it"));
    setShown(m_putBack, !fractal.moved.empty());
    const std::size_t selected = m_canvas->selectedMaps().size();
    m_swing->setEnabled(selected > 0);
    m_angle->setText(tr("%1°").arg(m_swing->value()));
}

void BranchBar::setShown(QWidget* part, bool visible) {
    const QWidget* focused = QApplication::focusWidget();
    if (!visible && focused && (part == focused || part->isAncestorOf(focused))) m_canvas->setFocus();
    part->setVisible(visible);
}

ifs::Word BranchBar::branch() const {
    ifs::Word word = m_canvas->branchAddress();
    word.resize(std::min(word.size(), std::size_t(m_canvas->branchDepth())));
    return word;
}

void BranchBar::putBack() {
    const ifs::Word word = branch();
    document::Fractal fractal = m_document->fractal();
    const bool isMoved = document::isMoved(fractal, word);
    if (isMoved)
        fractal = document::withBranchPutBack(fractal, word);
    else
        fractal.moved.clear();
    m_document->edit(isMoved ? tr("Put branch %1 back").arg(document::addressText(word, word.size()))
                             : tr("Put all branches back"),
                     fractal);
}

// Counted from where the slider left the middle.
void BranchBar::swingTo(int degrees) {
    const document::Fractal before = m_swinging.before();
    const auto root = document::root(before);
    if (!document::system2(before) || !root) return;
    const document::MapHandles handles(std::make_shared<const document::Fractal>(before),
                                       document::effectiveCage(before));
    const std::vector<std::size_t> places = m_canvas->canvas().selectedPlaces();
    const auto swung = [&](double angle) {
        return handles.withMapsSwung(places, *root, angle * std::numbers::pi / 180);
    };
    // Whole degrees, up to where the attractor would be lost.
    degrees = int(degrees * m_canvas->shareToShow([&](double share) { return swung(degrees * share); }));
    m_swinging.preview(tr("Let maps swing"), [&](document::Fractal& fractal) { fractal = swung(degrees); });
    const QSignalBlocker quiet(m_swing);
    m_swing->setValue(degrees);
    follow();
    // A wheel over it ends here; the canvas goes on saying why it stopped.
    if (!m_swing->isSliderDown() && !m_swing->hasFocus()) {
        m_swinging.commit();
        centre();
    }
}

void BranchBar::endSwing() {
    if (m_swinging.isOpen()) m_canvas->dismissStop();
    m_swinging.commit();
    centre();
}

void BranchBar::centre() {
    const QSignalBlocker quiet(m_swing);
    m_swing->setValue(0);
    follow();
}

bool BranchBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_swing && event->type() == QEvent::FocusOut) endSwing();
    return QWidget::eventFilter(watched, event);
}

} // namespace view
