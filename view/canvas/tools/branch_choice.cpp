// SPDX-License-Identifier: MIT
#include "canvas/tools/branch_choice.h"

#include "document/branches/addresses.h"
#include "document/edits/maps/map_locks.h"
#include "document/edits/timeline/keyed_maps.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace view {

namespace {

constexpr std::size_t maxChosen = 200; // a hundred drags
constexpr int notch = 120;             // eighths of a degree in a notch of the wheel

// The branch chosen in that fractal; empty if it is not known.
ifs::Word knownIn(const auto& chosen, const std::shared_ptr<const document::Fractal>& fractal) {
    const auto known =
        std::ranges::find_if(chosen, [&](const auto& each) { return each.fractal.lock() == fractal; });
    return known == chosen.end() ? ifs::Word() : known->address;
}

} // namespace

BranchChoice::BranchChoice(document::Document& document) : m_document(document) {
    connect(&document, &document::Document::changed, this, &BranchChoice::follow);
}

void BranchChoice::follow(const document::Change& change) {
    using document::Change;
    const bool isAnother = change.parts & (Change::Current | Change::File);
    if (isAnother) m_before.reset(); // the drag has ended together with its entry
    if (!(isAnother || change.parts & Change::System) || m_before) return;
    if (change.parts & Change::Time && !isAnother) return; // same maps in other places
    const ifs::Word known = knownIn(m_chosen, m_document.sharedFractal());
    if (known.empty() && m_address.empty()) return;
    choose(known);
    emit announced();
}

ifs::Word BranchChoice::branch() const {
    ifs::Word word = m_address;
    word.resize(std::min(word.size(), std::size_t(m_depth)));
    return word;
}

void BranchChoice::choose(const ifs::Word& address) {
    m_address = address;
    emit changed();
}

void BranchChoice::setDepth(int depth) {
    depth = std::clamp(depth, 1, maxDepth);
    if (std::exchange(m_depth, depth) == depth || m_before) return;
    emit changed();
    emit announced();
}

void BranchChoice::setEdit(document::BranchEdit edit) {
    if (std::exchange(m_edit, edit) != edit) emit changed();
}

void BranchChoice::turnDepth(int angle) {
    m_turned += angle;
    setDepth(m_depth + m_turned / notch);
    m_turned %= notch;
}

bool BranchChoice::pressDepthKey(int key) {
    const bool deeper = key == Qt::Key_PageDown;
    if (!deeper && key != Qt::Key_PageUp) return false;
    setDepth(m_depth + (deeper ? 1 : -1));
    return true;
}

QString BranchChoice::prompt() const {
    return m_address.empty() ? tr("Click a point of the attractor to select its branch.") : QString();
}

QString BranchChoice::stepText(DragMode mode, std::optional<std::size_t> corner) const {
    const QString name = document::addressText(branch(), maxDepth);
    if (mode == DragMode::Rotate) return tr("Rotate branch %1").arg(name);
    if (mode == DragMode::Scale) return tr("Scale branch %1").arg(name);
    return corner ? tr("Move corner %1 of branch %2").arg(*corner + 1).arg(name)
                  : tr("Move branch %1").arg(name);
}

QString BranchChoice::text() const {
    return m_address.empty() ? QString() : tr("Branch %1").arg(document::addressText(branch(), maxDepth));
}

QString BranchChoice::obstacle() const {
    const ifs::Word word = branch();
    if (word.empty() || document::keepsCode(m_edit)) return {};
    const bool divides = m_edit == document::BranchEdit::OwnMap && word.size() > 1;
    if (const QString obstacle = document::branchAsMapObstacle(m_document.entryFractal());
        divides && !obstacle.isEmpty())
        return obstacle;
    const bool isFirst = m_edit == document::BranchEdit::OwnMap;
    return document::lockObstacle(m_document.fractal(),
                                  std::vector{std::size_t(isFirst ? word.front() : word.back())});
}

void BranchChoice::beginDrag() {
    if (m_before) return choose(m_addressAtPress);
    m_before = m_document.sharedFractal();
    m_addressAtPress = m_address;
}

// The branch that becomes a map of its own is the first map.
void BranchChoice::showDragged(bool hasMoved) {
    if (!m_before) return;
    const bool isConverted = m_edit == document::BranchEdit::OwnMap && hasMoved &&
                             std::min(m_addressAtPress.size(), std::size_t(m_depth)) > 1;
    choose(isConverted ? ifs::Word{0} : m_addressAtPress);
}

void BranchChoice::cancelDrag() {
    const auto before = std::exchange(m_before, nullptr);
    if (!before) return;
    const auto now = m_document.sharedFractal();
    choose(*now == *before ? m_addressAtPress : knownIn(m_chosen, now)); // undo may have ended the drag
}

QString BranchChoice::endDrag() {
    if (!m_before || m_document.fractal() == *m_before) {
        cancelDrag();
        return {};
    }
    const auto before = std::exchange(m_before, nullptr);
    m_chosen.push_front({m_document.sharedFractal(), m_address});
    m_chosen.push_front({before, m_addressAtPress});
    if (m_chosen.size() > maxChosen) m_chosen.resize(maxChosen);
    if (m_address == m_addressAtPress) return {};
    return tr("This branch is now map 1. You can change it further in the table.");
}

} // namespace view
