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

bool isReplacedBy(const QString& output, const QString& input) {
    if (!isStandardOutput(output)) return isSameFile(output, input);
    namespace fs = std::filesystem;
    const QString behind = QStringLiteral("/dev/stdout");
    std::error_code error; // a terminal or a pipe may well be read and written
    return fs::is_regular_file(behind.toStdString(), error) && isSameFile(behind, input);
}

bool isSameFile(const QString& a, const QString& b) {
    namespace fs = std::filesystem;
    std::error_code error;
    return fs::equivalent(io::nativeName(a).toStdString(), io::nativeName(b).toStdString(), error) && !error;
}

} // namespace cli
