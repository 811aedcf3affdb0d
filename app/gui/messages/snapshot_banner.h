// SPDX-License-Identifier: MIT
#pragma once

#include "messages/message_banner.h"

namespace view {
class SnapshotLook;
class Snapshots;
} // namespace view

// Banner at the top of a canvas that shows a snapshot: names it, and offers the ways on.
class SnapshotBanner : public MessageBanner {
    Q_OBJECT

public:
    SnapshotBanner(QMainWindow* host, view::SnapshotLook* look, view::Snapshots* snapshots);

protected:
    QPoint topLeft() override;
};
