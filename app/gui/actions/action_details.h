// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string_view>

// What an action does in more detail than its tip: how it is used, what it changes and what it leaves. By the
// id of the action; empty for an action of which its tip says all.
QString actionDetails(std::string_view id);
