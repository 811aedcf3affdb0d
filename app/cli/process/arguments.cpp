// SPDX-License-Identifier: MIT
#include "process/arguments.h"

#include "options/parser.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/files_read.h"
#include "process/input.h"
#include "process/messages.h"

#include "animation/frame_rate.h"
#include "attractor/colour/palette_library.h"
#include "io/file/save_file.h"
#include "io/palette/palette_reader.h"
#include "io/text/number.h"

#include <QColor>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cli {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const QString& wanted) {
    throw UsageError{tr("%1 “%2” is not valid: %3")
                         .arg(QString::fromStdString(option), QString::fromStdString(text), wanted)};
}

// The digits and their factor: 10 to a power, k, M, G or T. Exact, so not by way of a double.
std::optional<std::uint64_t> wholeNumber(const QString& text) {
    static const QRegularExpression form(
        QStringLiteral("^([0-9]*)(?:\\.([0-9]*))?(?:[eE]\\+?([0-9]{1,2})|([kKMGT]))?$"));
    const auto match = form.match(text.trimmed());
    QString digits = match.captured(1) + match.captured(2);
    if (!match.hasMatch() || digits.isEmpty()) return std::nullopt;
    const int unit = match.captured(4).isEmpty()
                         ? 0
                         : 3 * (1 + int(QStringLiteral("KMGT").indexOf(match.captured(4).toUpper())));
    qsizetype power = match.captured(3).toInt() + unit - match.captured(2).size();
    for (; power < 0 && digits.endsWith(u'0'); ++power)
        digits.chop(1);
    if (power < 0) return std::nullopt; // not an integer
    if (digits.isEmpty()) digits = QStringLiteral("0");
    bool good = false;
    const std::uint64_t number = (digits + QString(power, u'0')).toULongLong(&good);
    return good ? std::optional(number) : std::nullopt;
}

bool isLight(const attractor::Rgba& colour) {
    return 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue > 128;
}

} // namespace

std::vector<double> numbers(const QString& text) {
    std::vector<double> result;
    for (const QString& part : text.split(u',')) {
        const auto number = io::parseNumber(part);
        if (!number) return {};
        result.push_back(*number);
    }
    return result;
}

NumberList numbersArgument(const std::string&, const std::string& text) {
    return {text, numbers(QString::fromStdString(text))};
}

std::size_t choiceArgument(const std::string& option, const std::string& text,
                           const std::vector<std::string>& names) {
    const auto found = std::ranges::find(names, text);
    if (found != names.end()) return std::size_t(found - names.begin());
    const QString wanted = tr("it must be %1").arg(listed(names, tr("or")));
    const std::string meant = nearest(text, names);
    refuse(option, text,
           meant.empty() ? wanted + u'.'
                         : tr("%1. Did you mean %2?").arg(wanted, QString::fromStdString(meant)));
}

int integerArgument(const std::string& option, const std::string& text, int min, int max) {
    bool good = false;
    const int number = QString::fromStdString(text).toInt(&good);
    if (!good || number < min || number > max)
        refuse(option, text, tr("it must be a whole number from %1 to %2.").arg(min).arg(max));
    return number;
}

std::uint64_t countArgument(const std::string& option, const std::string& text, std::uint64_t min,
                            std::uint64_t max) {
    const auto number = wholeNumber(QString::fromStdString(text));
    if (!number || *number < min || *number > max)
        refuse(option, text,
               tr("it must be a whole number from %1 to %2, such as 250000, 1e6 or 2.5M.").arg(min).arg(max));
    return *number;
}

double numberArgument(const std::string& option, const std::string& text, double min, double max) {
    const auto number = io::parseNumber(QString::fromStdString(text));
    if (!number || !(*number >= min && *number <= max))
        refuse(option, text, tr("it must be a number from %1 to %2.").arg(min).arg(max, 0, 'f', 0));
    return *number;
}

std::string sizeText(const QSize& size) {
    const auto side = [](int pixels) { return pixels > 0 ? std::to_string(pixels) : std::string(); };
    return side(size.width()) + 'x' + side(size.height());
}

QSize pictureSizeArgument(const std::string& option, const std::string& text) {
    const QStringList parts = QString::fromStdString(text).toLower().split(u'x');
    bool good = parts.size() == 2 && (!parts[0].isEmpty() || !parts[1].isEmpty());
    int sides[2] = {0, 0};
    for (int i = 0; good && i < 2; ++i)
        if (!parts[i].isEmpty())
            sides[i] = parts[i].toInt(&good), good = good && sides[i] > 0 && sides[i] <= maxSide;
    if (!good)
        refuse(
            option, text,
            tr("it must be a width and a height of 1 to %1 pixels, such as 1200x900; 1200x and x900 keep the "
               "proportions of the picture.")
                .arg(maxSide));
    return {sides[0], sides[1]};
}

std::optional<QSizeF> paperSizeArgument(const std::string& option, const std::string& text) {
    constexpr double longest = 10'000; // millimetres
    static const QRegularExpression form(
        QStringLiteral("^(?:([0-9]+(?:\\.[0-9]+)?)mm)?x(?:([0-9]+(?:\\.[0-9]+)?)mm)?$"));
    const QString given = QString::fromStdString(text).toLower();
    if (!given.contains(QLatin1String("mm"))) return std::nullopt;
    const auto match = form.match(given);
    const auto isGood = [&](int side) {
        const double length = match.captured(side).toDouble();
        return match.captured(side).isEmpty() || (length >= 1 && length <= longest);
    };
    if (!match.hasMatch() || !isGood(1) || !isGood(2))
        refuse(
            option, text,
            tr("on paper it must be a width and a height of 1 to %1 mm, such as 58mmx40mm; 58mmx and x40mm "
               "keep the proportions of the picture.")
                .arg(longest, 0, 'f', 0));
    return QSizeF(match.captured(1).toDouble(), match.captured(2).toDouble());
}

QSize sizeArgument(const std::string& option, const std::string& text) {
    const QStringList parts = QString::fromStdString(text).toLower().split(u'x');
    bool good[2] = {false, false};
    QSize size;
    if (parts.size() == 2) size = {parts[0].toInt(&good[0]), parts[1].toInt(&good[1])};
    if (!good[0] || !good[1] || size.isEmpty() || size.width() > maxSide || size.height() > maxSide)
        refuse(option, text,
               tr("it must be a width and a height of 1 to %1 pixels, such as 240x180.").arg(maxSide));
    return size;
}

std::vector<ifs::Vector<2>> pointListArgument(const std::string& option, const std::string& text) {
    std::vector<ifs::Vector<2>> points;
    for (const QString& part : QString::fromStdString(text).simplified().split(u' ', Qt::SkipEmptyParts)) {
        const auto xy = numbers(part);
        if (xy.size() != 2) refuse(option, text, tr("it must be points, such as \"0,0 1,0 0.5,0.8\"."));
        points.emplace_back(xy[0], xy[1]);
    }
    if (points.empty()) refuse(option, text, tr("it must be points, such as \"0,0 1,0 0.5,0.8\"."));
    return points;
}

std::vector<ifs::Vector<2>> pointsArgument(const std::string& option, const std::string& text) {
    const std::vector<ifs::Vector<2>> points = pointListArgument(option, text);
    if (points.size() < 3)
        refuse(option, text, tr("it must be at least three points, such as \"0,0 1,0 0.5,0.8\"."));
    return points;
}

std::uint64_t wholeArgument(const std::string& option, const std::string& text) {
    return countArgument(option, text, 0, std::numeric_limits<std::uint64_t>::max());
}

double positiveArgument(const std::string& option, const std::string& text) {
    const auto number = io::parseNumber(QString::fromStdString(text));
    if (!number || !(*number > 0)) refuse(option, text, tr("it must be a positive number."));
    return *number;
}

std::chrono::duration<double> secondsArgument(const std::string& option, const std::string& text) {
    constexpr double maxSeconds = 1e6;
    const auto number = io::parseNumber(QString::fromStdString(text));
    if (!number || !(*number > 0 && *number <= maxSeconds))
        refuse(option, text, tr("it must be a number of seconds above 0, at most 1000000."));
    return std::chrono::duration<double>(*number);
}

double marginArgument(const std::string& option, const std::string& text) {
    const auto number = io::parseNumber(QString::fromStdString(text));
    if (!number || !(*number >= 0 && *number < 50))
        refuse(option, text, tr("it must be a percentage of the picture, from 0 to less than 50."));
    return *number;
}

attractor::Rgba colourArgument(const std::string& option, const std::string& text) {
    QString name = QString::fromStdString(text);
    if (name.startsWith(u'#') && name.size() == 9)
        name = u'#' + name.last(2) + name.sliced(1, 6); // #rrggbbaa, as in our files; Qt wants #aarrggbb
    const QColor colour(name);
    if (!colour.isValid() || (name.startsWith(u'#') && name.size() > 9))
        refuse(option, text, tr("it must be a colour, such as #0d1017, #0d101780 or white, or transparent."));
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()),
            std::uint8_t(colour.alpha())};
}

attractor::Palette paletteOfFile(const QString& path) {
    noteRead(path);
    const io::Loaded loaded = io::loadSource(path);
    if (loaded.failure) throw InputError{path, *loaded.failure, ExitStatus::CannotReadOrWrite};
    io::PaletteFile file = io::readPalettes(loaded.bytes, QFileInfo(path).completeBaseName());
    if (file.palettes.empty()) throw InputError{path, file.problems.back().message};
    for (const document::Problem& problem : file.problems)
        report(problem, path);
    if (file.palettes.size() > 1)
        reportWarning(path, tr("The file contains %1 palettes; using the first of them, “%2”.")
                                .arg(file.palettes.size())
                                .arg(QString::fromStdString(file.palettes.front().name)));
    return file.palettes.front();
}

attractor::Palette paletteArgument(const std::string& option, const std::string& text) {
    for (const auto find : {attractor::findPalette, attractor::findInLibrary})
        if (const attractor::Palette* palette = find(text)) return *palette;
    const QString path = fileNameOf(text);
    const bool isFileName = path.contains(u'/') || !QFileInfo(path).suffix().isEmpty();
    if (isFileName || QFileInfo(path).isFile()) return paletteOfFile(path);
    QStringList names;
    for (const auto& palette : attractor::builtInPalettes())
        names << QString::fromStdString(palette.name);
    refuse(option, text,
           tr("it must be %1, another palette that “render --list-palettes” names, or a .gpl, .ggr, .ugr or "
              ".map "
              "file.")
               .arg(names.join(QStringLiteral(", "))));
}

ColourMeaning meaningArgument(const std::string& option, const std::string& text) {
    ColourMeaning meaning{text, {}, ifs::named<attractor::SolidColour>(text)};
    const std::vector<std::string> words = wordsOf(coloursInPlane);
    if (!meaning.inSpace || std::ranges::find(words, text) != words.end())
        meaning.inPlane = coloursInPlane[choiceArgument(option, text, words)].value;
    return meaning;
}

void putOn(attractor::Appearance& appearance, const attractor::Rgba& background) {
    appearance.background = background;
    const bool isPaper = isLight(background) && background.alpha == 255;
    // Keeps the plain colour visible on paper.
    if (isPaper && isLight(appearance.plain)) appearance.plain = {20, 20, 20, 255};
}

animation::Moment momentArgument(const std::string& option, const std::string& text) {
    const auto moment = animation::parseMoment(text);
    if (!moment) refuse(option, text, tr("it must be a frame, counted from 0, such as 12, 12.5 or 25/2."));
    return *moment;
}

document::ShutterAngle shutterArgument(const std::string& option, const std::string& text) {
    constexpr double thousand = 1000;
    const auto degrees = io::parseNumber(QString::fromStdString(text));
    if (!degrees || !(*degrees >= 0 && *degrees * thousand <= document::maxShutterAngle))
        refuse(option, text,
               tr("it must be an angle from 0 to 360 degrees; 180 is half the time of a frame."));
    return document::ShutterAngle(std::lround(*degrees * thousand));
}

animation::FrameRate rateArgument(const std::string& option, const std::string& text) {
    const auto rate = animation::parseRate(text);
    if (!rate)
        refuse(
            option, text,
            tr("it must be frames per second, above 0 and at most 1000, such as 24, 29.97 or 30000/1001."));
    return *rate;
}

double rotationArgument(const std::string& option, const std::string& text) {
    constexpr double maxDegrees = 360;
    const auto degrees = io::parseNumber(QString::fromStdString(text));
    if (!degrees || !(std::abs(*degrees) <= maxDegrees))
        refuse(option, text, tr("it must be an angle from -360 to 360 degrees."));
    return *degrees;
}

attractor::View viewArgument(const std::string& option, const std::string& text) {
    const auto values = numbers(QString::fromStdString(text));
    if (values.size() != 3 || !(values[2] > 0))
        refuse(option, text, tr("it must be the centre and a positive height, such as \"0,1.5,10\"."));
    return {{values[0], values[1]}, values[2], attractor::YAxis::Up};
}

} // namespace cli
