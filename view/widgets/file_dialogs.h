// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QWidget;

// The dialogs that ask for a file. They begin in the folder of the last time, unless told otherwise, and
// never in one that does not answer at once: the toolkit would read it in the thread of the window. An empty
// result: the user has cancelled.
namespace view {

// A name for a new file about something of this name, which may come from any file.
QString suggestedName(const QString& name, const QString& suffix);

// `suggestion` is such a name, or the path of a file. `asksToReplace` is false where the caller asks.
QString chooseFileToSave(QWidget* parent, const QString& title, const QString& suggestion,
                         const QString& filter, const QString& suffix, bool asksToReplace = true);
QString chooseFileToOpen(QWidget* parent, const QString& title, const QString& filter,
                         const QString& folder = {});
QString choosePictureToOpen(QWidget* parent, const QString& title); // decodable pictures
QString namesOfPictures();                                          // patterns for a filter: *.png *.jpg …
QString chooseFolder(QWidget* parent, const QString& title);

} // namespace view
