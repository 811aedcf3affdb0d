// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

// An entry's comments are the user's, apart from those that store a fractal transformation and saved views.
namespace document {

inline bool isKeptComment(const QString& comment) {
    return comment.trimmed().startsWith(QLatin1String("barycage:"));
}

inline QStringList userComments(QStringList comments) {
    comments.removeIf(isKeptComment);
    return comments;
}

} // namespace document
