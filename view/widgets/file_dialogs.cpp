// SPDX-License-Identifier: MIT
#include "widgets/file_dialogs.h"

#include "desktop/settings.h"
#include "document/text/file_names.h"
#include "document/text/text.h"
#include "io/file/slow_disk.h"
#include "io/picture/decoding/picture_decoder.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

namespace view {

namespace {

const QString lastFolder = QStringLiteral("dialogs/folder");

QString documents() {
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

// The first of these folders that is there and says so.
QString beginning(const QString& wanted) {
    for (const QString& folder : {wanted, stored(lastFolder).toString(), documents()})
        if (!folder.isEmpty() &&
            io::answerSoon([folder] { return QFileInfo(folder).isDir(); }).value_or(false))
            return folder;
    return QDir::homePath();
}

QString remembered(const QString& chosen) {
    if (!chosen.isEmpty()) store(lastFolder, QFileInfo(chosen).absolutePath());
    return chosen;
}

// A folder in which nothing can be written is none to begin in the next time.
QString rememberedToSave(const QString& chosen) {
    const QString folder = QFileInfo(chosen).absolutePath();
    const bool isWritable =
        io::answerSoon([folder] { return QFileInfo(folder).isWritable(); }).value_or(true);
    return isWritable ? remembered(chosen) : chosen;
}

} // namespace

QString suggestedName(const QString& name, const QString& suffix) {
    const QString ending = u'.' + suffix;
    return document::fileNamePart(name, document::maxFileName - ending.toUtf8().size()) + ending;
}

QString chooseFileToSave(QWidget* parent, const QString& title, const QString& suggestion,
                         const QString& filter, const QString& suffix, bool asksToReplace) {
    const QFileInfo suggested(suggestion);
    const QString folder = beginning(suggested.isAbsolute() ? suggested.path() : QString());
    QFileDialog dialog(parent, title, folder, filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOption(QFileDialog::DontConfirmOverwrite, !asksToReplace);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(suggested.fileName());
    if (dialog.exec() != QDialog::Accepted) return {};
    return rememberedToSave(dialog.selectedFiles().value(0));
}

QString chooseFileToOpen(QWidget* parent, const QString& title, const QString& filter,
                         const QString& folder) {
    return remembered(QFileDialog::getOpenFileName(parent, title, beginning(folder), filter));
}

QString choosePictureToOpen(QWidget* parent, const QString& title) {
    return chooseFileToOpen(parent, title, Text::tr("Pictures (%1);;All files (*)").arg(namesOfPictures()));
}

QString namesOfPictures() {
    return QStringLiteral("*.") + io::pictureSuffixes().join(QStringLiteral(" *."));
}

QString chooseFolder(QWidget* parent, const QString& title) {
    return QFileDialog::getExistingDirectory(parent, title, beginning({}));
}

} // namespace view
