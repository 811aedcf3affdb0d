// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

struct MenuContext;

// Asks for a name and writes the entry, as it is shown, as a web page in which its cage can be dragged.
void exportWebPage(const MenuContext& context, const QString& folder);
