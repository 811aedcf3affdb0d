// SPDX-License-Identifier: MIT
#include "animate_arguments.h"
#include "arguments.h"
#include "commands.h"
#include "input.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "usage_error.h"
#include "video_output.h"

#include "document/animated_fractal.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/picture/png_check.h"
#include "io/picture/png_system.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QRegularExpression>

#include <algorithm>
#include <memory>

namespace cli {

namespace {

struct EncodeArguments {
    std::string pattern;
    std::string output;
    std::optional<std::string> rate;
    Verbosity verbosity;

    io::VideoFormat format = io::VideoFormat::Mp4; // of the output
    std::optional<animation::FrameRate> framesPerSecond;
};

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

void check(EncodeArguments& arguments) {
    const QString pattern = fileNameOf(arguments.pattern);
    if (QFileInfo(pattern).suffix().toLower() != u"png")
        throw UsageError{tr("The pictures are .png files with a name such as NAME.####.png, and “%1” is not.")
                             .arg(pattern)};
    checkPattern(pattern);
    const QString output = fileNameOf(arguments.output);
    const auto format = io::videoFormat(QFileInfo(output).suffix());
    if (!format)
        throw UsageError{tr("The video can be written as .mp4, .webm, .mkv, .gif, .webp or .apng, and “%1” "
                            "is none of them.")
                             .arg(output)};
    arguments.format = *format;
    if (arguments.rate) arguments.framesPerSecond = rateArgument("--fps", *arguments.rate);
}

// The numbers of the files there are, ascending.
std::vector<int> numbersThere(const QString& pattern) {
    const QFileInfo info(pattern);
    const QString name = info.fileName();
    const qsizetype first = name.indexOf(u'#');
    const qsizetype width = name.count(u'#');
    const QRegularExpression form(QStringLiteral("^%1([0-9]{%2,9})%3$")
                                      .arg(QRegularExpression::escape(name.first(first)),
                                           QString::number(width),
                                           QRegularExpression::escape(name.sliced(first + width))));
    std::vector<int> numbers;
    for (const QString& file : info.dir().entryList(QDir::Files | QDir::Hidden)) {
        const auto match = form.match(file);
        const QString digits = match.captured(1);
        const bool isPadded = digits.size() > width && digits.startsWith(u'0'); // another sequence's
        if (match.hasMatch() && !isPadded) numbers.push_back(digits.toInt());
    }
    std::ranges::sort(numbers);
    return numbers;
}

// "3, 7-9 and 12"; the first few.
QString listed(const std::vector<int>& numbers) {
    constexpr qsizetype maxRuns = 8;
    QStringList runs;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
            ++end;
        runs << (end == i + 1 ? QString::number(numbers[i])
                              : QStringLiteral("%1-%2").arg(numbers[i]).arg(numbers[end - 1]));
        i = end;
    }
    if (runs.size() > maxRuns) runs = runs.first(maxRuns) << QStringLiteral("…");
    return runs.join(QStringLiteral(", "));
}

std::vector<int> missingAmong(const std::vector<int>& numbers) {
    constexpr std::size_t enough = 10'000;
    std::vector<int> missing;
    for (std::size_t i = 1; i < numbers.size(); ++i)
        for (int number = numbers[i - 1] + 1; number < numbers[i] && missing.size() < enough; ++number)
            missing.push_back(number);
    return missing;
}

class EncodeSession {
public:
    EncodeSession(const EncodeArguments& arguments, ProgressMode mode)
        : m_arguments(arguments), m_pattern(fileNameOf(arguments.pattern)), m_bar(mode) {}

    ExitStatus run() {
        m_numbers = numbersThere(m_pattern);
        if (m_numbers.empty()) {
            reportError(m_pattern, tr("There are no pictures with this name."));
            return ExitStatus::CannotReadOrWrite;
        }
        if (const auto missing = missingAmong(m_numbers); !missing.empty()) {
            reportError(m_pattern,
                        tr("Pictures are missing between the first and the last one: %1. Draw them "
                           "first; animate draws only those that are missing.")
                            .arg(listed(missing)));
            return ExitStatus::InputProblems;
        }
        if (const auto damage = io::pngDamage(pathOf(0))) {
            reportError(pathOf(0), *damage);
            return ExitStatus::InputProblems;
        }
        m_size = QImageReader(pathOf(0), "png").size();
        for (int index = 1; index < int(m_numbers.size()); ++index) // rather than after all that come before
            if (const auto obstacle = obstacleOf(pathOf(index))) {
                reportError(pathOf(index), *obstacle);
                return ExitStatus::InputProblems;
            }
        const QString output = fileNameOf(m_arguments.output);
        VideoSource source;
        source.count = int(m_numbers.size());
        source.settings = settings();
        if (const io::Failure obstacle = io::videoObstacle(source.settings)) {
            reportError(output, *obstacle);
            return ExitStatus::CannotReadOrWrite;
        }
        source.frame = [this](int index, const io::VideoWriter::Progress&) { return read(index); };
        return writeVideo(output, std::move(source), m_bar, m_interrupt);
    }

private:
    QString pathOf(int index) const { return numbered(m_pattern, m_numbers[std::size_t(index)]); }

    // Of the animation that the pictures carry, if they do.
    io::VideoSettings settings() const {
        io::VideoSettings settings;
        settings.format = m_arguments.format;
        settings.width = m_size.width();
        settings.height = m_size.height();
        const io::Loaded first = io::loadFile(pathOf(0));
        const io::EmbeddedSystem system = io::readPngSystem(first.bytes);
        const document::FractalFile file =
            system.failure ? document::FractalFile() : io::readFractint(system.text);
        if (!file.entries.isEmpty()) {
            const document::Fractal& entry = *file.entries.first().fractal;
            settings.systemText = system.text;
            settings.title = entry.name;
            if (const auto facts = document::animationFacts(entry)) {
                settings.rate = facts->rate;
                settings.repeats = facts->loop != animation::Loop::Off;
            }
        }
        if (m_arguments.framesPerSecond) settings.rate = *m_arguments.framesPerSecond;
        settings.isTransparent = isAnyTransparent();
        return settings;
    }

    // By their headers: whether pixels have an alpha channel.
    bool isAnyTransparent() const {
        for (int index = 0; index < int(m_numbers.size()); ++index) {
            const QImageReader reader(pathOf(index), "png");
            if (!reader.canRead()) return false; // what that is, is said when its turn comes
            const QImage::Format format = reader.imageFormat();
            if (QImage(1, 1, format).hasAlphaChannel()) return true;
        }
        return false;
    }

    std::optional<QString> obstacleOf(const QString& path) const {
        if (const auto damage = io::pngDamage(path)) return damage;
        const QSize size = QImageReader(path, "png").size();
        if (size == m_size) return std::nullopt;
        return tr("The picture has %1x%2 pixels, and the first one has %3x%4. All pictures of a video must "
                  "have the same size.")
            .arg(size.width())
            .arg(size.height())
            .arg(m_size.width())
            .arg(m_size.height());
    }

    QImage read(int index) {
        const QString path = pathOf(index);
        if (const auto obstacle = obstacleOf(path)) return refused(path, *obstacle); // by now
        QImageReader reader(path, "png");
        reader.setAllocationLimit(0); // the video takes pictures of this size
        const QImage image = reader.read();
        return image.isNull() ? refused(path, tr("The picture cannot be read: %1.").arg(reader.errorString()))
                              : image;
    }

    QImage refused(const QString& path, const QString& sentence) {
        m_bar.clear();
        reportError(path, sentence);
        return {};
    }

    const EncodeArguments& m_arguments;
    QString m_pattern;
    Interrupt m_interrupt;
    ProgressBar m_bar;
    std::vector<int> m_numbers; // of the pictures
    QSize m_size;
};

ExitStatus encode(EncodeArguments arguments) {
    const ProgressMode mode = applied(arguments.verbosity);
    check(arguments);
    return EncodeSession(arguments, mode).run();
}

} // namespace

Command encodeCommand(CLI::App& program) {
    auto arguments = std::make_shared<EncodeArguments>();
    CLI::App* command = program.add_subcommand("encode", "Make a video from numbered PNG pictures");
    command->footer("encode NAME.####.png -o OUT [OPTION]...");
    command
        ->add_option(
            "PICTURES", arguments->pattern,
            "Name of the pictures, all of the same size, such as NAME.####.png: #### stands for their "
            "numbers with leading zeros, without gaps")
        ->type_name("NAME.####.png")
        ->group("Files")
        ->required();
    command
        ->add_option("-o,--output", arguments->output,
                     "Video to write: .mp4, .webm, .mkv (lossless), .gif, .webp or .apng")
        ->type_name("OUT")
        ->group("Files")
        ->required();
    command->add_option("--fps", arguments->rate, "Frames per second, such as 24, 29.97 or 30000/1001")
        ->type_name("R")
        ->default_str("those of the animation in the pictures, else 24")
        ->group("Frames");
    addVerbosityOptions(*command, arguments->verbosity);
    return {command, [arguments] { return encode(*arguments); }};
}

} // namespace cli
