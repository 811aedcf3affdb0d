// SPDX-License-Identifier: MIT
#include "process/same_file.h"

#include "io/file/native_path.h"

#include <filesystem>
#include <system_error>

namespace cli {

bool isStandardOutput(const QString& output) {
    return output == u"-";
}

QString fileBehind(const QString& input) {
    return input == u"-" ? QStringLiteral("/dev/stdin") : input;
}

bool isSameFile(const QString& a, const QString& b) {
    namespace fs = std::filesystem;
    std::error_code error;
    return fs::equivalent(io::nativeName(a).toStdString(), io::nativeName(b).toStdString(), error) && !error;
}

} // namespace cli
