// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace support {

/// Absolute path of a file or folder of the source tree, given relative to its top.
QString sourcePath(const QString& relative);

/// Absolute path of what was built, such as a program, given relative to the top of the build folder.
QString buildPath(const QString& relative);

/// Absolute path of one of the tests' own small files (tests/data), given by name; of their folder without
/// one.
QString testData(const QString& name = {});

} // namespace support
