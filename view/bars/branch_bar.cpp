// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"

#include "document/addresses.h"
#include "document/edits/map_locks.h"
#include "document/fractal_geometry.h"
#include "widgets/number_box.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
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

namespace view {

namespace {

constexpr int maxAngle = 90;   // degrees either way
constexpr int minLetters = 18; // of what is chosen, in a narrow window

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
    connect(&canvas->tools().branchTool(), &BranchTool::changed, this, &BranchBar::follow);
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
    m_depth = new WholeNumberBox(row);
    m_depth->setRange(1, BranchTool::maxDepth);
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
    const auto add = [this](const QString& name, const QString& explanation) {
        m_edit->addItem(name);
        m_edit->setItemData(m_edit->count() - 1, explanation, Qt::ToolTipRole);
    };
    add(tr("New map for this branch"),
        tr("Gives this branch and each of its sibling branches a map of its own. The change appears again at "
           "all smaller scales."));
    add(tr("Last map of the address"),
        tr("The system keeps its number of maps. All branches that this map makes change in the same way."));
    add(tr("Only here"), tr("The code does not change. Only this branch is shown in another position; the "
                            "same change does not appear at other scales."));
    add(tr("Here and inside it"),
        tr("The code does not change. This branch is shown in another position, and so is the same branch "
           "inside it, again and again: a frond curls up. Nothing beside it changes."));
    m_edit->setAccessibleName(tr("What editing the branch changes"));
    for (QWidget* yields : {static_cast<QWidget*>(m_edit), static_cast<QWidget*>(m_address)})
        yields->setMinimumWidth(minLetters * fontMetrics().averageCharWidth());
    m_putBack = new QPushButton(row);
    QSizePolicy keepsItsRoom = m_putBack->sizePolicy(); // so that the height of the row stays
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
    connect(m_depth, &QSpinBox::valueChanged, &m_canvas->tools().branchTool(), &BranchTool::setDepth);
    connect(m_edit, &QComboBox::currentIndexChanged, this, [this](int index) {
        constexpr std::array edits{document::BranchEdit::OwnMap, document::BranchEdit::LastMap,
                                   document::BranchEdit::Display, document::BranchEdit::Inside};
        m_canvas->tools().branchTool().setEdit(edits.at(std::size_t(index)));
        m_edit->setWhatsThis(m_edit->itemData(index, Qt::ToolTipRole).toString());
    });
    m_edit->setToolTip(tr("What changes in the code when you drag the branch"));
    m_edit->setWhatsThis(m_edit->itemData(0, Qt::ToolTipRole).toString());
    return row;
}

QWidget* BranchBar::makeSwing() {
    auto* row = new QWidget(this);
    auto* label = new QLabel(tr("&Weave"), row);
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
    layout->addStretch();
    connect(m_swing, &QSlider::valueChanged, this, &BranchBar::swingTo);
    connect(m_swing, &QSlider::sliderReleased, this, &BranchBar::endSwing);
    return row;
}

void BranchBar::follow() {
    showRow(m_canvas->tool() == CanvasView::Tool::Maps ? m_swingRow : m_branchRow);
    const QSignalBlocker quiet(m_depth);
    m_depth->setValue(m_canvas->tools().branchTool().depth());
    const ifs::Word& address = m_canvas->tools().branchTool().address();
    const ifs::Word word = branch();
    const ifs::Word rest(address.begin() + std::ptrdiff_t(word.size()), address.end());
    m_address->setText(
        address.empty() ? tr("no branch selected")
                        : tr("branch <b>%1</b> %2")
                              .arg(document::addressText(word, word.size()), document::addressText(rest, 8)));
    const document::Fractal& fractal = m_document->fractal();
    const bool isMoved = document::isMoved(fractal, word);
    m_putBack->setText(isMoved ? tr("Put &Back") : tr("Put All &Back"));
    m_putBack->setToolTip(isMoved
                              ? tr("Shows the branch in its original position, given by its maps")
                              : tr("Shows all branches in their original positions, given by their maps"));
    const document::Shape<2>* shape = document::plane(fractal);
    const bool canPutBack = shape && !shape->moved.empty();
    if (!canPutBack) takeFocusFrom(m_putBack);
    m_putBack->setVisible(canPutBack);
    const std::size_t selected = m_canvas->selectedMaps().size();
    m_swing->setEnabled(selected > 0);
    m_angle->setText(tr("%1°").arg(m_swing->value()));
}

void BranchBar::takeFocusFrom(const QWidget* part) {
    const QWidget* focused = QApplication::focusWidget();
    if (focused && (part == focused || part->isAncestorOf(focused))) m_canvas->setFocus();
}

void BranchBar::showRow(QWidget* row) {
    if (row == m_rows->currentWidget()) return;
    takeFocusFrom(m_rows);
    m_rows->setCurrentWidget(row);
}

ifs::Word BranchBar::branch() const {
    ifs::Word word = m_canvas->tools().branchTool().address();
    word.resize(std::min(word.size(), std::size_t(m_canvas->tools().branchTool().depth())));
    return word;
}

void BranchBar::putBack() {
    const ifs::Word word = branch();
    document::Fractal fractal = m_document->fractal();
    const bool isMoved = document::isMoved(fractal, word);
    if (isMoved)
        fractal = document::withBranchPutBack(fractal, word);
    else if (document::Shape<2>* shape = document::plane(fractal))
        shape->moved.clear();
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
    std::vector<std::size_t> indices = m_canvas->canvas().selection().mapIndices();
    const QString locked = document::lockObstacle(before, indices);
    std::erase_if(indices, [&](std::size_t index) { return document::isLocked(before, index); });
    if (indices.empty()) {
        emit m_canvas->message(locked);
        return centre();
    }
    document::Fractal swung;
    const auto swing = [&](double angle) -> const document::Fractal& {
        return swung = handles.withMapsSwung(indices, *root, angle * std::numbers::pi / 180);
    };
    // Whole degrees, up to where the attractor would be lost.
    const double share = m_canvas->tools().mapsTool().shareToShow(
        [&](double part) -> const document::Fractal& { return swing(degrees * part); });
    degrees = int(degrees * share);
    m_swinging.preview(tr("Swing maps"), [&](document::Fractal& fractal) { fractal = swing(degrees); });
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
    if (watched == m_swing && event->type() == QEvent::FocusOut) endSwing();
    return QWidget::eventFilter(watched, event);
}

} // namespace view
