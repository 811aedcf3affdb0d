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

// A number times a power of ten, 5 × 10⁻¹ or 5·10^-1, as 5e-1; and the middle dot of 0·5 as a point.
QString withPowersOfTen(QString text);

} // namespace io
