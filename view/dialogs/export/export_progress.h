// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QProgressBar;

namespace view {

// Progress of an export and its remaining time. Hidden while there is none.
class ExportProgress : public QWidget {
    Q_OBJECT

public:
    explicit ExportProgress(QWidget* parent);

    void begin(const QString& firstStep = {}); // text until the remaining time can be estimated
    void setFraction(double fraction);         // 0 … 1
    void end();

private:
    QProgressBar* m_bar = nullptr;
    QLabel* m_left = nullptr; // remaining time
    QElapsedTimer m_clock;    // time since the work began
};

} // namespace view
