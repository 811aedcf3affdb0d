// SPDX-License-Identifier: MIT
#include "io/video/libav/library.h"

#include <QLibrary>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#ifdef Q_OS_LINUX
#include <dlfcn.h>
#endif

namespace io::libav {

namespace {

struct Files {
    QLibrary util{QStringLiteral("avutil"), LIBAVUTIL_VERSION_MAJOR};
    QLibrary codec{QStringLiteral("avcodec"), LIBAVCODEC_VERSION_MAJOR};
    QLibrary format{QStringLiteral("avformat"), LIBAVFORMAT_VERSION_MAJOR};
    QLibrary filter{QStringLiteral("avfilter"), LIBAVFILTER_VERSION_MAJOR};
    QLibrary scale{QStringLiteral("swscale"), LIBSWSCALE_VERSION_MAJOR};
};

// nullopt when a library or a function is missing.
std::optional<Library> loaded() {
    Files files;
    Library library;
    bool isComplete = true;
#define BARYCAGE_LIBAV_RESOLVE(from, name)                                                                   \
    library.name = reinterpret_cast<decltype(&::name)>(files.from.resolve(#name));                           \
    isComplete = isComplete && library.name != nullptr;
    BARYCAGE_LIBAV_FUNCTIONS(BARYCAGE_LIBAV_RESOLVE)
#undef BARYCAGE_LIBAV_RESOLVE
    return isComplete ? std::optional(library) : std::nullopt;
}

const std::optional<Library>& known() {
    static const std::optional<Library> library = loaded(); // loaded until the end of the program
    return library;
}

} // namespace

bool isInstalled() {
    return known().has_value();
}

// The reason why loading failed: a library that exists may find no memory, or be damaged.
QString loadingError() {
#ifdef Q_OS_LINUX
    constexpr std::pair<const char*, int> names[] = {{"avutil", LIBAVUTIL_VERSION_MAJOR},
                                                     {"swscale", LIBSWSCALE_VERSION_MAJOR},
                                                     {"avcodec", LIBAVCODEC_VERSION_MAJOR},
                                                     {"avformat", LIBAVFORMAT_VERSION_MAJOR},
                                                     {"avfilter", LIBAVFILTER_VERSION_MAJOR}};
    const QString missing = QString::fromLocal8Bit(std::strerror(ENOENT));
    for (const auto& [name, version] : names) {
        const QByteArray file = QByteArray("lib") + name + ".so." + QByteArray::number(version);
        // Remains loaded, like those before it.
        if (::dlopen(file.constData(), RTLD_LAZY) != nullptr) continue;
        const char* const error = ::dlerror();
        const QString text = QString::fromLocal8Bit(error ? error : "");
        return text.contains(missing) ? QString() : text;
    }
#endif
    return {};
}

const Library& library() {
    return *known();
}

} // namespace io::libav
