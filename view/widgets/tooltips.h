// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QCoreApplication;
class QWidget;

namespace view {

// The tip of a widget as rich text: its name, its shortcut and the sentence given to it. Empty for a widget
// without a sentence.
QString composedTip(const QWidget& widget);

// Shows these tips instead of the bare sentences, for all widgets of the application, as long as it lives.
class Tooltips : public QObject {
public:
    explicit Tooltips(QCoreApplication* application);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace view
