// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>

// What is remembered between runs. The folder that holds it may be slow: another thread writes, in the order
// of the calls. To be called in the thread of the windows.
namespace view {

void store(const QString& key, const QVariant& value);               // an invalid value: forgotten
QVariant stored(const QString& key, const QVariant& otherwise = {}); // as it was stored last
void finishStoring();                                                // before the program ends

// Tells the windows what store() did not return.
class StoringReport : public QObject {
    Q_OBJECT

signals:
    void cannotStore(const QString& sentence); // once, until it is possible again
};

StoringReport* storingReport();

} // namespace view
