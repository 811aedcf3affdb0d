// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/maps/maps_edits.h"

#include <QObject>
#include <QString>

#include <vector>

class QWidget;

namespace view {

// Maps on their way to the clipboard and back, as rows of a table.
class MapsClipboard : public QObject {
    Q_OBJECT

public:
    MapsClipboard(document::Document* document, QWidget* window);

    bool copy(const document::Rows& rows) const; // false if there is nothing to copy
    void paste(const document::Rows& rows);      // replaces these rows; none: adds maps

signals:
    void pasted(const std::vector<ifs::MapId>& maps); // maps to select
    void message(const QString& text);

private:
    void pasteInPlane(const document::Rows& rows);
    void pasteInSpace(const document::Rows& rows);
    void finish(const document::Rows& rows, int count, document::MapsEdit edit, const QString& remark);
    void say(const document::Rows& rows, int count, const QString& remark = {});

    document::Document* m_document;
    QWidget* m_window;
};

} // namespace view
