// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QCoreApplication;

namespace view {

// The wheel changes sliders, spin boxes, combo boxes and tab bars only while they have the focus, which it
// gives to no widget at all. Over any other one it scrolls what the widget stands in. For all widgets of the
// application, as long as this lives.
class WheelNeedsFocus : public QObject {
public:
    explicit WheelNeedsFocus(QCoreApplication* application);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace view
