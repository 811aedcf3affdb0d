// SPDX-License-Identifier: MIT
#include "arguments.h"

#include "messages.h"
#include "usage_error.h"

#include "io/number.h"
#include "io/palette_reader.h"
#include "io/save_file.h"

#include <QColor>
#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

namespace cli {

namespace {

constexpr int largestSide = 1'000'000;

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

[[noreturn]] void refuse(const std::string& option, const std::string& text, const QString& wanted) {
    throw UsageError{tr("%1 “%2” is not understood: %3")
                         .arg(QString::fromStdString(option), QString::fromStdString(text), wanted)};
}

// Numbers between commas; empty when one of them is none.
std::vector<double> numbers(const QString& text) {
    std::vector<double> result;
    for (const QString& part : text.split(u',')) {
        const auto number = io::parseNumber(part);
        if (!number) return {};
        result.push_back(*number);
    }
    return result;
}

} // namespace

QSize sizeArgument(const std::string& option, const std::string& text) {
    const QStringList parts = QString::fromStdString(text).toLower().split(u'x');
    bool good[2] = {false, false};
    QSize size;
    if (parts.size() == 2) size = {parts[0].toInt(&good[0]), parts[1].toInt(&good[1])};
    if (!good[0] || !good[1] || size.isEmpty() || size.width() > largestSide || size.height() > largestSide)
        refuse(option, text, tr("it takes a width and a height in pixels, like 1200x900."));
    return size;
}

std::vector<ifs::Vector<2>> pointsArgument(const std::string& option, const std::string& text) {
    std::vector<ifs::Vector<2>> points;
    for (const QString& part : QString::fromStdString(text).simplified().split(u' ', Qt::SkipEmptyParts)) {
        const auto xy = numbers(part);
        if (xy.size() != 2) refuse(option, text, tr("it takes points like \"0,0 1,0 0.5,0.8\"."));
        points.emplace_back(xy[0], xy[1]);
    }
    if (points.size() < 3)
        refuse(option, text, tr("it takes at least three points, like \"0,0 1,0 0.5,0.8\"."));
    return points;
}

std::uint64_t wholeArgument(const std::string& option, const std::string& text) {
    bool good = false;
    const QString digits = QString::fromStdString(text);
    const std::uint64_t number = digits.startsWith(u'-') ? 0 : digits.toULongLong(&good);
    if (!good) refuse(option, text, tr("it takes a whole number from 0 to 18446744073709551615."));
    return number;
}

double positiveArgument(const std::string& option, const std::string& text) {
    const auto number = io::parseNumber(QString::fromStdString(text));
    if (!number || !(*number > 0)) refuse(option, text, tr("it takes a positive number."));
    return *number;
}

double marginArgument(const std::string& option, const std::string& text) {
    const auto number = io::parseNumber(QString::fromStdString(text));
    if (!number || !(*number >= 0 && *number < 50))
        refuse(option, text, tr("it takes per cent of the picture, from 0 to below 50."));
    return *number / 100;
}

attractor::Rgba colourArgument(const std::string& option, const std::string& text) {
    QString name = QString::fromStdString(text);
    if (name.startsWith(u'#') && name.size() == 9)
        name = u'#' + name.last(2) + name.sliced(1, 6); // #rrggbbaa, as our files have it; Qt: #aarrggbb
    const QColor colour(name);
    if (!colour.isValid() || (name.startsWith(u'#') && name.size() > 9))
        refuse(option, text, tr("it takes a colour like #0d1017, #0d101780 or white, or transparent."));
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()),
            std::uint8_t(colour.alpha())};
}

attractor::Palette paletteOfFile(const QString& path) {
    const io::Loaded loaded = io::loadFile(path);
    if (loaded.failure) throw InputError{path, *loaded.failure, ExitStatus::CannotReadOrWrite};
    io::PaletteFile file = io::readPalettes(loaded.bytes, QFileInfo(path).completeBaseName());
    if (file.palettes.empty()) throw InputError{path, file.problems.back().message};
    for (const document::Problem& problem : file.problems)
        report(problem, path);
    if (file.palettes.size() > 1)
        reportWarning(path, tr("The file holds %1 palettes; the first of them, “%2”, is taken.")
                                .arg(file.palettes.size())
                                .arg(QString::fromStdString(file.palettes.front().name)));
    return file.palettes.front();
}

attractor::Palette paletteArgument(const std::string& option, const std::string& text) {
    if (const attractor::Palette* palette = attractor::findPalette(text)) return *palette;
    const QString path = QString::fromStdString(text);
    const bool isFileName = path.contains(u'/') || !QFileInfo(path).suffix().isEmpty();
    if (isFileName || QFileInfo(path).isFile()) return paletteOfFile(path);
    QStringList names;
    for (const auto& palette : attractor::builtInPalettes())
        names << QString::fromStdString(palette.name);
    refuse(option, text,
           tr("the palettes are %1, or a .gpl, .ugr or .map file.").arg(names.join(QStringLiteral(", "))));
}

View viewArgument(const std::string& option, const std::string& text) {
    const auto values = numbers(QString::fromStdString(text));
    if (values.size() != 3 || !(values[2] > 0))
        refuse(option, text, tr("it takes the middle and a positive height, like \"0,1.5,10\"."));
    return {{values[0], values[1]}, values[2]};
}

} // namespace cli
