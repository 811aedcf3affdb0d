// SPDX-License-Identifier: MIT
#include "files/collection_commands.h"

#include "document/document.h"
#include "document/text/text.h"
#include "document/tops/partner_names.h"
#include "files/file_commands.h"
#include "files/open_file.h"
#include "panels/collection/collection_panel.h"

#include <memory>
#include <utility>

namespace {

using document::EntryId;
using Fractals = QList<document::Fractal>;

QList<document::Entry> entriesOf(const Fractals& fractals) {
    QList<document::Entry> entries(fractals.size());
    for (qsizetype i = 0; i < fractals.size(); ++i)
        entries[i].fractal = std::make_shared<const document::Fractal>(fractals[i]);
    return entries;
}

void start(const Fractals& fractals, const CollectionTarget& target) {
    document::FractalFile file = document::fileOf(fractals.front());
    file = document::inserted(std::move(file), entriesOf(fractals.mid(1)), EntryId::None).file;
    target.file->startFrom(std::move(file), EntryId::None);
    if (fractals.size() > 1) target.showTransformation();
}

// Adds in one undo step.
void add(const Fractals& fractals, const CollectionTarget& target) {
    document::Inserted added =
        document::insertedTogether(target.document->file(), entriesOf(fractals), EntryId::None);
    target.document->editFile(Text::tr("Add %1").arg(fractals.front().name), std::move(added.file),
                              added.ids.front());
    if (fractals.size() > 1) target.showTransformation();
}

// The entry that still is as the collection has it, under whatever name it was added; None: there is none.
EntryId untouchedCopy(const document::FractalFile& file, document::Fractal wanted) {
    for (const document::Entry& entry : file.entries) {
        wanted.name = entry.fractal->name;
        if (*entry.fractal == wanted) return entry.id;
    }
    return EntryId::None;
}

void choose(const Fractals& fractals, const CollectionTarget& target) {
    // Steps of a lesson name entries, which must stay.
    const bool isUnused = target.file->path().isEmpty() && target.document->undoStack()->count() == 0 &&
                          !target.commands->hasUnsavedLesson();
    if (isUnused) return start(fractals, target);
    const EntryId known =
        fractals.size() == 1 ? untouchedCopy(target.document->file(), fractals.front()) : EntryId::None;
    if (known == EntryId::None) return add(fractals, target);
    target.document->setCurrent(known);
}

} // namespace

void connectCollection(view::CollectionPanel* collection, const CollectionTarget& target) {
    using view::CollectionPanel;
    QObject::connect(collection, &CollectionPanel::openRequested, collection,
                     [target](const Fractals& fractals) {
                         if (target.commands->maybeSave()) start(fractals, target);
                     });
    QObject::connect(collection, &CollectionPanel::chosen, collection,
                     [target](const Fractals& fractals) { choose(fractals, target); });
    QObject::connect(collection, &CollectionPanel::addRequested, collection,
                     [target](const Fractals& fractals) { add(fractals, target); });
}
