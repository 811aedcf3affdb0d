// SPDX-License-Identifier: MIT
#include "io/exports/export_task.h"

#include "document/text/text.h"
#include "io/exports/recipe_json.h"

#include <QCryptographicHash>
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace io {

namespace {

const QByteArray magic("barycage-export 1\n");
constexpr qsizetype maxHeader = 1 << 20;
constexpr double maxPlace = 1e15;

QString hashOf(const QByteArray& header, const QByteArray& entry) {
    return QString::fromLatin1(
        QCryptographicHash::hash(header + '\n' + entry, QCryptographicHash::Sha256).toHex());
}

} // namespace

QByteArray taskFile(const ExportTask& task) {
    QJsonObject header{{QStringLiteral("path"), task.path},
                       {QStringLiteral("name"), task.name},
                       {QStringLiteral("recipe"), recipeJson(task.recipe)},
                       {QStringLiteral("replace"), task.mayReplace},
                       {QStringLiteral("place"), double(task.place)},
                       {QStringLiteral("begun"), task.begun},
                       {QStringLiteral("failure"), task.failure}};
    header[QLatin1String("sha256")] =
        hashOf(QJsonDocument(header).toJson(QJsonDocument::Compact), task.entry);
    return magic + QJsonDocument(header).toJson(QJsonDocument::Compact) + '\n' + task.entry;
}

ReadTask taskIn(const QByteArray& bytes) {
    const ReadTask damaged{std::nullopt, Text::tr("It is damaged.")};
    if (!bytes.startsWith(magic)) return {std::nullopt, Text::tr("It is not an export of this program.")};
    const qsizetype end = bytes.indexOf('\n', magic.size());
    if (end < 0 || end - magic.size() > maxHeader) return damaged;
    QJsonObject header = QJsonDocument::fromJson(bytes.mid(magic.size(), end - magic.size())).object();
    ExportTask task;
    task.entry = bytes.mid(end + 1);
    const QString hash = header.take(QLatin1String("sha256")).toString();
    if (hash != hashOf(QJsonDocument(header).toJson(QJsonDocument::Compact), task.entry)) return damaged;
    task.path = header[QLatin1String("path")].toString();
    task.name = header[QLatin1String("name")].toString();
    task.mayReplace = header[QLatin1String("replace")].toBool();
    task.place = qint64(std::clamp(header[QLatin1String("place")].toDouble(), -maxPlace, maxPlace));
    task.begun = std::max(0, header[QLatin1String("begun")].toInt());
    task.failure = header[QLatin1String("failure")].toString();
    const std::optional<ExportRecipe> recipe = recipeIn(header[QLatin1String("recipe")].toObject());
    if (!recipe || !isUsable(*recipe))
        return {std::nullopt, Text::tr("Its settings are not supported by this version.")};
    task.recipe = *recipe;
    if (!QDir::isAbsolutePath(task.path) || task.path.contains(QChar::Null) ||
        !isNamedFor(task.recipe, task.path))
        return {std::nullopt, Text::tr("Its file name does not match its format.")};
    return {task, std::nullopt};
}

} // namespace io
