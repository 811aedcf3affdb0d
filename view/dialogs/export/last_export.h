// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

// Exports of one kind ("picture", "solid", "animation", …) begin as the last one was for which a file was
// chosen, also after a restart.
namespace view {

// Choices of the last export of a kind, in words of its dialog; empty before the first export.
struct LastExport {
    QString format;
    QString size;
    QString more{}; // further choices; empty: default
};

LastExport lastExport(const QString& kind);
void rememberExport(const QString& kind, const LastExport& last, const QString& path);

// The name in the folder of the last export, else in `otherwise`; alone without either.
QString suggestedPath(const QString& kind, const QString& name, const QString& otherwise = {});

} // namespace view
