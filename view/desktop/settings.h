// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>

#include <chrono>

// Settings kept between runs. The folder that holds them may be slow, or never answer: other threads read and
// write, in the order of the calls. To be called in the thread of the windows.
namespace view {

void store(const QString& key, const QVariant& value); // removes the key for an invalid value
// The value stored last; the last one known where there is no answer.
QVariant stored(const QString& key, const QVariant& otherwise = {});
// Waits until all of it is on the disk, but no longer than that; whether it is.
bool finishStoring(std::chrono::milliseconds patience = std::chrono::seconds(10));

// Tells the windows what store() did not return.
class StoringReport : public QObject {
    Q_OBJECT

signals:
    void cannotStore(const QString& sentence); // sent once per series of failures
};

StoringReport* storingReport();

} // namespace view
