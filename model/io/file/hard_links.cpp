// SPDX-License-Identifier: MIT
#include "io/file/hard_links.h"

#include "io/file/native_path.h"

#include <QByteArray>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <system_error>

namespace io {

namespace fs = std::filesystem;

int otherNames(const QString& path) {
    const fs::path file(nativeName(path).toStdString());
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return 0;
    const std::uintmax_t names = fs::hard_link_count(file, error);
    if (error || names < 2) return 0;
    return int(std::min<std::uintmax_t>(names - 1, std::numeric_limits<int>::max()));
}

} // namespace io
