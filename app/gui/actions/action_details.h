// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string_view>

// Details of an action that its tip leaves out: how it is used, what it changes and what it leaves. By the id
// of the action; empty for an action of which its tip says all.
QString actionDetails(std::string_view id);
