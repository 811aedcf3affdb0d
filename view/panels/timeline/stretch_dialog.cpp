// SPDX-License-Identifier: MIT
#include "panels/timeline/stretch_dialog.h"

#include "panels/timeline/timeline.h"
#include "widgets/numbers/number_box.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <utility>

namespace view {

namespace {

// The range from the first to the last of the selected keys; with fewer than two, the whole animation.
document::Stretch selectedRange(const Timeline& timeline) {
    document::Stretch range{0, timeline.timing().length, timeline.timing().length};
    const auto& keys = timeline.selected();
    if (keys.empty()) return range;
    const auto [first, last] = std::ranges::minmax(keys, {}, &document::KeyAt::frame);
    if (first.frame < last.frame) range = {first.frame, last.frame, last.frame};
    return range;
}

} // namespace

StretchDialog::StretchDialog(std::shared_ptr<const document::Fractal> entry,
                             const document::Stretch& proposed, QWidget* parent)
    : QDialog(parent),
      m_entry(std::move(entry)),
      m_from(frameBox(proposed.from, tr("From frame"), tr("Keys up to this frame stay where they are."))),
      m_to(frameBox(proposed.to, tr("To frame"),
                    tr("The end of the range. Later keys keep their distance to it."))),
      m_end(frameBox(proposed.end, tr("Ends at frame"),
                     tr("Where the range ends from now on: later for slower, earlier for faster."))),
      m_note(new QLabel(this)) {
    setWindowTitle(tr("Stretch Keys"));
    m_note->setWordWrap(true);
    m_note->setAccessibleName(tr("Note"));
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing()); // constant height
    m_note->setAlignment(Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_stretch = buttons->addButton(tr("&Stretch"), QDialogButtonBox::AcceptRole);
    m_stretch->setDefault(true);
    m_stretch->setWhatsThis(tr("Moves the keys of all tracks, in one step that you can undo."));
    auto* form = new QFormLayout(this);
    form->addRow(tr("&From frame:"), m_from);
    form->addRow(tr("&To frame:"), m_to);
    form->addRow(tr("&Ends at frame:"), m_end);
    form->addRow(m_note);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QSpinBox* box : {m_from, m_to, m_end})
        connect(box, &QSpinBox::valueChanged, this, &StretchDialog::check);
    m_end->setFocus();
    m_end->selectAll();
    check();
}

QSpinBox* StretchDialog::frameBox(int value, const QString& name, const QString& help) {
    auto* box = new WholeNumberBox(this);
    box->setRange(0, animation::maxLength);
    box->setValue(value);
    box->setAccessibleName(name);
    box->setWhatsThis(help);
    return box;
}

document::Stretch StretchDialog::stretch() const {
    return {m_from->value(), m_to->value(), m_end->value()};
}

void StretchDialog::check() {
    const document::Stretch wanted = stretch();
    const bool isRange = wanted.from < wanted.to && wanted.from < wanted.end;
    const bool isPossible = isRange && document::withKeysStretched(*m_entry, wanted);
    m_note->setText(!isRange ? tr("The range has to end after its first frame.")
                    : !isPossible
                        ? tr("Two keys would meet at one frame, or the animation would be too long.")
                        : QString());
    m_stretch->setEnabled(isPossible);
}

void askToStretch(Timeline& timeline, QWidget* parent) {
    const auto entry = timeline.document().currentEntry().fractal;
    auto* dialog = new StretchDialog(entry, selectedRange(timeline), parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QDialog::accepted, &timeline, [&timeline, dialog, entry] {
        document::Document& document = timeline.document();
        if (document.currentEntry().fractal != entry) return; // changed meanwhile
        if (auto after = document::withKeysStretched(*entry, dialog->stretch()))
            document.editEntry(StretchDialog::tr("Stretch keys"), *std::move(after));
    });
    dialog->open();
}

} // namespace view
