// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/maps/maps_edits.h"

#include <QList>

#include <functional>

class QAction;
class QToolButton;
class QWidget;

namespace view {

// The button with the rules for weights, and its actions, that of the determinant rule first.
QToolButton* makeWeightsButton(const std::function<void(document::WeightRule)>& apply, QWidget* parent,
                               QList<QAction*>& actions);

} // namespace view
