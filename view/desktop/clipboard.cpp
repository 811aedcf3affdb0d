// SPDX-License-Identifier: MIT
#include "desktop/clipboard.h"

#include "document/text/text.h"
#include "io/collection_reader.h"
#include "io/file/background.h"
#include "io/fractint/entry_writer.h"
#include "io/table/listed_maps.h"
#include "io/table/table_reader.h"
#include "io/table/table_writer.h"

#include <QMetaType>
#include <QMimeData>

#include <functional>
#include <utility>

namespace view {
namespace {

const QString ifsType = QStringLiteral("application/x-fractint-ifs");
const QString mapsType = QStringLiteral("application/x-barycage-maps");

bool isReadable(const document::Entry& entry) {
    return document::dimension(*entry.fractal) != 0;
}

// Text that is written when somebody asks for it: that of a whole large file takes a while.
class LateText : public QMimeData {
public:
    LateText(QString type, std::function<QByteArray()> write)
        : m_type(std::move(type)), m_write(std::move(write)) {}
    ~LateText() override { io::freeInBackground(std::move(m_write)); }

    const std::function<QByteArray()>& write() const { return m_write; }

    QStringList formats() const override { return {m_type, QStringLiteral("text/plain")}; }

protected:
    QVariant retrieveData(const QString& mimeType, QMetaType type) const override {
        if (!formats().contains(mimeType)) return {};
        const QByteArray text = m_write();
        if (type == QMetaType::fromType<QString>()) return QString::fromUtf8(text);
        return text;
    }

private:
    QString m_type;
    std::function<QByteArray()> m_write;
};

// Rows alone are Fractint's in a file; on the clipboard they may come from anywhere.
bool areColumnsOpen(const io::Collection& collection, const QByteArray& text) {
    if (collection.isOrderAssumed) return true;
    if (collection.format != u"fractint" || collection.file.entries.isEmpty() || text.contains('{'))
        return false;
    return io::isOrderOpen(QString::fromUtf8(text));
}

} // namespace

QByteArray entriesText(const QList<document::Entry>& entries) {
    QByteArray text;
    for (const document::Entry& entry : entries) {
        if (!text.isEmpty() && !text.endsWith('\n')) text += '\n';
        if (isReadable(entry))
            text += io::writeEntry(*entry.fractal);
        else if (entry.source)
            text += entry.source->text;
    }
    return text;
}

namespace {

class EntriesMimeData : public LateText {
public:
    explicit EntriesMimeData(const QList<document::Entry>& entries)
        : LateText(ifsType, [entries] { return entriesText(entries); }) {}
};

class MapsMimeData : public LateText {
public:
    explicit MapsMimeData(CopiedMaps maps)
        : LateText(mapsType, [this] { return tableOf(m_maps); }), m_maps(std::move(maps)) {
        for (auto& map : m_maps.plane)
            map.id = ifs::MapId::None;
        for (auto& map : m_maps.space)
            map.id = ifs::MapId::None;
    }
    const CopiedMaps& maps() const { return m_maps; }

private:
    static QByteArray tableOf(const CopiedMaps& maps) {
        if (maps.space.empty()) return io::writeTable(maps.plane).toUtf8();
        const QByteArray table = io::writeTable(document::System3{maps.space}, io::TableSeparator::Tab);
        return table.sliced(table.indexOf('\n') + 1); // removes the header
    }

    CopiedMaps m_maps;
};

} // namespace

std::unique_ptr<QMimeData> entriesMimeData(const QList<document::Entry>& entries) {
    return std::make_unique<EntriesMimeData>(entries);
}

std::unique_ptr<QMimeData> mapsMimeData(CopiedMaps maps) {
    return std::make_unique<MapsMimeData>(std::move(maps));
}

FoundMaps mapsIn(const QString& text, bool areOurs) {
    if (areOurs) return {io::readTable(text, io::fractintColumns()), false, {}};
    const QString table = io::tableIn(text);
    FoundMaps found{io::readTable(table), io::isOrderOpen(table), table};
    const QList<io::ListedMaps> listed = table == text ? QList<io::ListedMaps>() : io::listedMaps(text);
    const QString unused = listed.isEmpty() ? QString() : io::unusedWeightsRemark(listed.first());
    if (!unused.isEmpty())
        found.table.problems.append({document::Problem::Severity::Warning, {}, 0, 0, unused});
    return found;
}

bool holdsOurMaps(const QMimeData& mimeData) {
    return mimeData.hasFormat(mapsType);
}

const CopiedMaps* ourMaps(const QMimeData& mimeData) {
    const auto* ours = dynamic_cast<const MapsMimeData*>(&mimeData);
    return ours ? &ours->maps() : nullptr;
}

FoundEntries entriesIn(const QByteArray& text) {
    const io::Collection collection =
        io::readCollection(text, Text::tr("pasted", "name of an entry made from a table"));
    FoundEntries found{{}, collection.file.problems};
    for (document::Entry entry : collection.file.entries) {
        if (isReadable(entry)) entry.source.reset();
        found.problems += entry.problems;
        if (!isReadable(entry) && !text.contains('{')) continue; // numbers alone, but not those of maps
        found.entries.append(std::move(entry));
    }
    found.areFlames = collection.format == u"flame";
    if (areColumnsOpen(collection, text)) found.table = io::tableIn(QString::fromUtf8(text));
    return found;
}

std::function<QByteArray()> entriesTextIn(const QMimeData& mimeData) {
    if (const auto* ours = dynamic_cast<const EntriesMimeData*>(&mimeData)) return ours->write();
    if (mimeData.hasFormat(ifsType)) return [text = mimeData.data(ifsType)] { return text; };
    return [text = mimeData.text()] { return text.toUtf8(); };
}

FoundEntries entriesIn(const QMimeData& mimeData) {
    return entriesIn(entriesTextIn(mimeData)());
}

bool holdsText(const QMimeData& mimeData) {
    return mimeData.hasFormat(ifsType) || !mimeData.text().trimmed().isEmpty();
}

bool mayHoldEntries(const QMimeData& mimeData) {
    // Excludes files, whose text is their path: opening them is not pasting.
    return mimeData.hasFormat(ifsType) || (mimeData.hasText() && !mimeData.hasUrls());
}

} // namespace view
