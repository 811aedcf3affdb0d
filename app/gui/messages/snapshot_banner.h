// SPDX-License-Identifier: MIT
#pragma once

#include "messages/message_banner.h"

namespace view {
class SnapshotLook;
class Snapshots;
} // namespace view

// While the canvas shows a snapshot: which one, at the top of the canvas, and the ways on.
class SnapshotBanner : public MessageBanner {
    Q_OBJECT

public:
    SnapshotBanner(QMainWindow* host, view::SnapshotLook* look, view::Snapshots* snapshots);

protected:
    QPoint topLeft() override;
};
