// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QAbstractScrollArea;

namespace view {

// Space pressed and released on a canvas, without a drag in between: a held Space pans.
class SpaceTap : public QObject {
    Q_OBJECT

public:
    explicit SpaceTap(QAbstractScrollArea* canvas); // owned by `canvas`

signals:
    void tapped();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool m_isDown = false;
};

} // namespace view
