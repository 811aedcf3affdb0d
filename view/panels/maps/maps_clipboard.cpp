// SPDX-License-Identifier: MIT
#include "panels/maps/maps_clipboard.h"

#include "desktop/clipboard.h"
#include "dialogs/paste_table_dialog.h"
#include "document/edits/maps/map_locks.h"
#include "document/maps/map_names.h"
#include "document/text/text.h"
#include "io/file/background.h"
#include "io/text/cumulative_weights.h"
#include "widgets/background/wait_for.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace view {

namespace {

template <int Dim>
CopiedMaps copied(const ifs::IteratedFunctionSystem<Dim>& system, const document::MapLabels& labels,
                  const document::Rows& rows) {
    CopiedMaps maps;
    for (const int row : rows) {
        const ifs::WeightedMap<Dim>& map = system.maps[std::size_t(row)];
        if constexpr (Dim == 2)
            maps.plane.push_back(map);
        else
            maps.space.push_back(map);
        maps.names << labels.of(map.id).name;
    }
    return maps;
}

// Rows of 12 or 13 numbers, as in an entry of an .ifs file.
std::vector<ifs::WeightedMap<3>> spaceMapsIn(const QString& text) {
    const FoundEntries found =
        entriesIn(text.contains(u'{') ? text.toUtf8() : "pasted (3D) {\n" + text.toUtf8() + "\n}\n");
    for (const document::Entry& entry : found.entries)
        if (const document::System3* solid = document::system3(*entry.fractal)) return solid->maps;
    return {};
}

// Remarks on weights that may be running sums.
template <int Dim> QString remarkOnSums(const std::vector<ifs::WeightedMap<Dim>>& maps) {
    std::vector<std::optional<double>> weights;
    for (const ifs::WeightedMap<Dim>& map : maps)
        weights.push_back(map.weight);
    return io::cumulativeRemark(weights).value_or(QString());
}

void giveNames(document::MapsEdit& edit, const QStringList& names) {
    for (std::size_t i = 0; i < edit.touched.size() && qsizetype(i) < names.size(); ++i) {
        if (names[qsizetype(i)].isEmpty()) continue;
        document::MapLabel label = edit.fractal.mapLabels.of(edit.touched[i]);
        label.name = names[qsizetype(i)];
        edit.fractal.mapLabels.set(edit.touched[i], std::move(label));
    }
}

} // namespace

MapsClipboard::MapsClipboard(document::Document* document, QWidget* window)
    : QObject(window), m_document(document), m_window(window) {}

bool MapsClipboard::copy(const document::Rows& rows) const {
    const document::Fractal& fractal = m_document->fractal();
    if (rows.empty() || document::dimension(fractal) == 0) return false;
    CopiedMaps maps = document::plane(fractal) ? copied(*document::system2(fractal), fractal.mapLabels, rows)
                                               : copied(*document::system3(fractal), fractal.mapLabels, rows);
    QGuiApplication::clipboard()->setMimeData(mapsMimeData(std::move(maps)).release());
    return true;
}

void MapsClipboard::paste(const document::Rows& rows) {
    if (const QString locked = document::lockObstacle(m_document->fractal(), rows); !locked.isEmpty())
        return emit message(locked);
    if (document::plane(m_document->fractal()))
        pasteInPlane(rows);
    else if (document::space(m_document->fractal()))
        pasteInSpace(rows);
}

void MapsClipboard::pasteInPlane(const document::Rows& rows) {
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    QString text;
    QStringList names;
    QString remark;
    FoundMaps found;
    if (const CopiedMaps* ours = data ? ourMaps(*data) : nullptr) {
        if (ours->plane.empty())
            return emit message(tr("Nothing was pasted: the copied maps are of a system in space."));
        found.table.rows = ours->plane;
        names = ours->names;
    } else {
        text = data ? data->text() : QString();
        const bool areOurs = data && holdsOurMaps(*data);
        auto reading = io::inBackground<FoundMaps>(
            [text, areOurs](QPromise<FoundMaps>& promise) { promise.addResult(mapsIn(text, areOurs)); });
        if (!waitFor(QFuture<void>(reading), Text::tr("Reading the pasted text…"), m_window)) return;
        found = reading.takeResult();
        if (!found.table.isCumulative) remark = remarkOnSums<2>(found.table.rows);
    }
    const io::Table& table = found.table;
    if (found.isOrderOpen) {
        auto* dialog = new PasteTableDialog(m_document, rows, found.text, m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &PasteTableDialog::pasted, this,
                [this, rows, dialog](const std::vector<ifs::MapId>& touched) {
                    emit pasted(touched);
                    say(rows, dialog->count());
                });
        dialog->open();
        return;
    }
    for (const auto& problem : table.problems) {
        if (problem.severity != document::Problem::Severity::Error) continue;
        return emit message(problem.line > 0 ? Text::tr("Nothing was pasted. Line %1 of the clipboard: %2")
                                                   .arg(problem.line)
                                                   .arg(problem.message)
                                             : Text::tr("Nothing was pasted. %1").arg(problem.message));
    }
    if (table.rows.empty())
        return emit message(
            Text::tr("Nothing was pasted: the clipboard contains no rows of 6 or 7 numbers."));
    document::MapsEdit edit = withMapsPasted(m_document->fractal(), rows, table.rows);
    giveNames(edit, names);
    finish(rows, int(table.rows.size()), std::move(edit),
           table.problems.isEmpty() ? remark : table.problems.front().message);
}

void MapsClipboard::pasteInSpace(const document::Rows& rows) {
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    CopiedMaps maps;
    QString remark;
    if (const CopiedMaps* ours = data ? ourMaps(*data) : nullptr) {
        maps = *ours;
        if (maps.space.empty())
            return emit message(tr("Nothing was pasted: the copied maps are of a system in the plane."));
    } else {
        auto reading = io::inBackground<CopiedMaps>(
            [text = data ? data->text() : QString()](QPromise<CopiedMaps>& promise) {
                promise.addResult(CopiedMaps{{}, spaceMapsIn(text), {}});
            });
        if (!waitFor(QFuture<void>(reading), Text::tr("Reading the pasted text…"), m_window)) return;
        maps = reading.takeResult();
        remark = remarkOnSums<3>(maps.space);
    }
    if (maps.space.empty())
        return emit message(tr("Nothing was pasted: the clipboard contains no rows of 12 or 13 numbers."));
    document::MapsEdit edit = withMapsPasted(m_document->fractal(), rows, maps.space);
    giveNames(edit, maps.names);
    finish(rows, int(maps.space.size()), std::move(edit), remark);
}

void MapsClipboard::finish(const document::Rows& rows, int count, document::MapsEdit edit,
                           const QString& remark) {
    m_document->edit(count == 1 ? Text::tr("Paste a map") : Text::tr("Paste %1 maps").arg(count),
                     std::move(edit.fractal));
    emit pasted(edit.touched);
    say(rows, count, remark);
}

void MapsClipboard::say(const document::Rows& rows, int count, const QString& remark) {
    const QString text = rows.empty()
                             ? Text::tr("%n maps added.", nullptr, count)
                             : Text::tr("The selected maps were replaced; %n maps pasted.", nullptr, count);
    emit message(remark.isEmpty() ? text : text + u' ' + remark);
}

} // namespace view
