// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

// What an action does in more detail than its tip: how it is used, what it changes and what it leaves. By the
// name of its icon; empty for an action of which its tip says all.
QString actionDetails(const char* icon);
