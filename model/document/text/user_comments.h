// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

// An entry's comments are the user's, apart from those in which it keeps what is not a part of the fractal:
// its fractal transformation and its saved views.
namespace document {

inline bool isKeptComment(const QString& comment) {
    return comment.trimmed().startsWith(QLatin1String("barycage:"));
}

inline QStringList userComments(QStringList comments) {
    comments.removeIf(isKeptComment);
    return comments;
}

} // namespace document
