// SPDX-License-Identifier: MIT
#pragma once

#include <QTest>

// QTRY_VERIFY and QTRY_COMPARE that wait for up to a minute and not five seconds: on a machine that is busy,
// what is waited for comes late. A test that passes waits no longer.
#undef QTRY_VERIFY
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, 60'000)
#undef QTRY_VERIFY2
#define QTRY_VERIFY2(condition, message) QTRY_VERIFY2_WITH_TIMEOUT(condition, message, 60'000)
#undef QTRY_COMPARE
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, 60'000)
