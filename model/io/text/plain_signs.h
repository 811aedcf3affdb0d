// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace io {

// Returns true for a hyphen, a dash or a minus sign of any kind (‐ ‑ ‒ – — ― − ﹣ －), as typesetting
// programs put them before negative numbers.
bool isDash(QChar c);

// Narrow and fixed blanks, with which a sign is set apart from its digits.
bool isSettingBlank(QChar c);

// The text of numbers in the signs of a keyboard: dashes become "-", full-width digits and signs their plain
// forms, the fraction slash "/"; marks without a width and blanks between a sign and its digits vanish.
QString plainSigns(QString text);

} // namespace io
