// SPDX-License-Identifier: MIT
#include "animate/animate_arguments.h"
#include "animate/video_output.h"
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/files_read.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/picture_suffixes.h"
#include "process/progress_bar.h"

#include "animation/keys/moment.h"
#include "document/moments/animated_fractal.h"
#include "io/animation/frame_drawing.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/picture/decoding/picture_decoder.h"
#include "io/picture/png/png_check.h"
#include "io/picture/png/png_system.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>

namespace cli {

namespace {

struct EncodeArguments {
    std::string pattern;
    std::string output;
    std::optional<std::vector<FileRange>> ranges; // nullopt: all frames of the animation
    std::optional<animation::FrameRate> framesPerSecond;
    bool dryRun = false;
    Verbosity verbosity;

    io::VideoFormat format = io::VideoFormat::Mp4; // format of the output
};

void check(EncodeArguments& arguments) {
    const QString pattern = fileNameOf(arguments.pattern);
    if (QFileInfo(pattern).suffix().toLower() != u"png")
        throw UsageError{tr("The pictures are .png files with a name such as NAME.####.png, and “%1” is not.")
                             .arg(pattern)};
    checkPattern(pattern);
    const QString output = fileNameOf(arguments.output);
    const auto format = io::videoFormat(QFileInfo(output).suffix());
    if (!format)
        throw UsageError{tr("The video can be written as %1, and “%2” is none of them.")
                             .arg(namedVideos(tr("or")), output)};
    arguments.format = *format;
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
        const bool isPadded = digits.size() > width && digits.startsWith(u'0'); // belongs to another sequence
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

// Numbers from the first to the last, but no more than can be told apart from a wrong name.
std::vector<int> withoutGaps(const std::vector<int>& numbers) {
    constexpr int enough = 1'000'000;
    std::vector<int> all;
    const int last = std::min(numbers.back(), numbers.front() + enough);
    for (int number = numbers.front(); number <= last; ++number)
        all.push_back(number);
    return all;
}

// Marks in a picture, if there are any: its animation, and the number that its file had.
struct Marks {
    QByteArray animation;
    int number = 0;
};

struct Looked {
    std::optional<QString> damage;
    Marks marks;
    QSize size{};
    bool isDeep = false; // true for 16 bits per channel
    bool hasOpacity = false;
    bool isUnreadable = false;
};

Looked lookedAt(const QString& path) {
    const io::CheckedPng picture = io::checkedPng(path);
    Looked looked{picture.damage,      {}, picture.size, picture.bitsPerChannel > 8, picture.hasOpacity,
                  picture.isUnreadable};
    Marks& marks = looked.marks;
    const auto animation = picture.texts.find(io::animationRequestKeyword);
    if (animation != picture.texts.end()) marks.animation = animation->second;
    const auto number = picture.texts.find(io::frameNumberKeyword);
    if (number != picture.texts.end()) marks.number = number->second.toInt();
    return looked;
}

class EncodeSession {
public:
    EncodeSession(const EncodeArguments& arguments, ProgressMode mode)
        : m_arguments(arguments), m_pattern(fileNameOf(arguments.pattern)), m_bar(mode) {}

    ExitStatus run() {
        const std::vector<int> there = numbersThere(m_pattern);
        if (there.empty()) {
            reportError(m_pattern, tr("There are no pictures with this name."));
            return ExitStatus::CannotReadOrWrite;
        }
        learnFromNewest(there);
        if (m_obstacle) {
            reportError(m_pattern, *m_obstacle);
            return ExitStatus::CannotReadOrWrite;
        }
        if (const ExitStatus status = chooseFrom(there); status != ExitStatus::Done) return status;
        m_size = m_looked[numberOf(0)].size;
        if (m_looked[numberOf(0)].isDeep)
            reportWarning(m_pattern,
                          tr("The pictures have 16 bits per channel, of which the video keeps 8."));
        for (int index = 0; index < int(m_numbers.size()); ++index) // before the first picture is encoded
            if (const auto obstacle = obstacleOf(m_looked[numberOf(index)])) {
                reportError(pathOf(index), *obstacle);
                return statusOf(m_looked[numberOf(index)]);
            }
        for (int index = 0; index < int(m_numbers.size()); ++index)
            if (const auto stranger = strangerAmong(m_looked[numberOf(index)].marks, index)) {
                reportError(pathOf(index), *stranger);
                return ExitStatus::InputProblems;
            }
        const QString output = fileNameOf(m_arguments.output);
        for (int index = 0; index < int(m_numbers.size()); ++index)
            noteRead(pathOf(index));
        refuseToReplaceInput(output);
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
    int numberOf(int index) const { return m_numbers[std::size_t(index)]; }
    QString pathOf(int index) const { return numbered(m_pattern, numberOf(index)); }

    // Chooses the pictures of the video. Every picture that was asked for must be there.
    ExitStatus chooseFrom(const std::vector<int>& there) {
        const int count = m_facts ? animation::frameCount(m_facts->loop, m_facts->length) : 0;
        if (m_arguments.ranges && !m_arguments.ranges->empty()) {
            int last = 1;
            for (const FileRange& range : *m_arguments.ranges)
                last = std::max(last, range.last);
            m_numbers = filesIn(*m_arguments.ranges, last);
        } else if (m_arguments.ranges) {
            m_numbers = filesIn({}, count);
            if (count == 0) {
                reportError(m_pattern,
                            tr("The pictures carry no animation that would say how many there are. "
                               "Give their numbers in --frames."));
                return ExitStatus::InputProblems;
            }
        } else {
            m_numbers = withoutGaps(there);
        }
        std::vector<int> missing;
        std::ranges::set_difference(m_numbers, there, std::back_inserter(missing));
        if (!missing.empty()) {
            reportError(m_pattern, tr("Pictures are missing: %1. Draw them first; animate draws only those "
                                      "that are missing.")
                                       .arg(listed(missing)));
            return ExitStatus::InputProblems;
        }
        std::vector<int> frames = m_numbers;
        for (int& frame : frames)
            frame -= m_offset;
        if (!m_arguments.ranges && count > 0 && int(frames.size()) < count)
            reportWarning(m_pattern, tr("The pictures are %1 of %2 frames of the animation: %3.")
                                         .arg(frames.size())
                                         .arg(count)
                                         .arg(listed(frames)));
        return ExitStatus::Done;
    }

    // Learns from the newest picture, because older ones may be left over from another animation. If no
    // picture has marks, the first one has the entry.
    void learnFromNewest(const std::vector<int>& there) {
        int source = there.front();
        QDateTime newest;
        for (const int number : there) {
            const QString path = numbered(m_pattern, number);
            m_looked[number] = lookedAt(path);
            const QDateTime written = QFileInfo(path).lastModified();
            if (m_looked[number].marks.animation.isEmpty() || (newest.isValid() && written <= newest))
                continue;
            newest = written;
            source = number;
        }
        m_animation = m_looked[source].marks.animation;
        m_newest = QFileInfo(numbered(m_pattern, source)).fileName();
        std::map<int, int> offsets; // number of pictures with each offset
        for (const auto& [number, looked] : m_looked)
            if (const Marks& marks = looked.marks; marks.number > 0 && marks.animation == m_animation)
                ++offsets[number - marks.number];
        if (!m_arguments.ranges && !offsets.empty())
            m_offset = std::ranges::max_element(offsets, {}, &std::pair<const int, int>::second)->first;
        m_obstacle = readEntry(numbered(m_pattern, source));
        if (m_looked[source].damage) m_obstacle.reset(); // reported only if the picture is needed
    }

    // Reads the entry that a picture carries, if any.
    io::Failure readEntry(const QString& path) {
        const io::Loaded first = io::loadFile(path);
        if (first.failure) return first.failure;
        const io::EmbeddedSystem system = io::readPngSystem(first.bytes);
        if (system.failure) return std::nullopt;
        const document::FractalFile file = io::readFractint(system.text);
        if (file.entries.isEmpty()) return std::nullopt;
        m_systemText = system.text;
        m_title = file.entries.first().fractal->name;
        m_facts = document::animationFacts(*file.entries.first().fractal);
        return std::nullopt;
    }

    io::VideoSettings settings() const {
        io::VideoSettings settings;
        settings.format = m_arguments.format;
        settings.width = m_size.width();
        settings.height = m_size.height();
        settings.systemText = m_systemText;
        settings.title = m_title;
        if (m_facts) {
            settings.rate = m_facts->rate;
            settings.repeats = m_facts->loop != animation::Loop::Off;
        }
        if (m_arguments.framesPerSecond) settings.rate = *m_arguments.framesPerSecond;
        settings.isTransparent = isAnyTransparent();
        return settings;
    }

    // Returns true if a header announces an alpha channel.
    bool isAnyTransparent() const {
        return std::ranges::any_of(m_numbers, [this](int number) { return m_looked.at(number).hasOpacity; });
    }

    std::optional<QString> obstacleOf(const Looked& looked) const {
        if (looked.damage) return looked.damage;
        const QSize& size = looked.size;
        if (size == m_size) return std::nullopt;
        return tr("The picture has %1x%2 pixels, and the first one has %3x%4. All pictures of a video must "
                  "have the same size.")
            .arg(size.width())
            .arg(size.height())
            .arg(m_size.width())
            .arg(m_size.height());
    }

    // A sentence about a picture that is marked as another frame than `index`. Unmarked pictures are
    // accepted.
    std::optional<QString> strangerAmong(const Marks& marks, int index) const {
        if (!marks.animation.isEmpty() && marks.animation != m_animation)
            return tr("The picture was drawn from another entry or with other options than the newest one, "
                      "“%1”. Draw the frames again, which replaces such pictures, and delete what is left "
                      "over, "
                      "or name the frames in --frames.")
                .arg(m_newest);
        const int expected = numberOf(index) - m_offset;
        if (marks.number == 0 || marks.number == expected) return std::nullopt;
        return tr("The picture is frame %1 of its animation. Here, frame %2 should be.")
            .arg(marks.number)
            .arg(expected);
    }

    QImage read(int index) {
        const QString path = pathOf(index);
        const Looked now = lookedAt(path); // the file may have changed by now
        if (const auto obstacle = obstacleOf(now)) refuse(path, *obstacle, statusOf(now));
        if (const auto stranger = strangerAmong(now.marks, index)) refuse(path, *stranger);
        const io::Loaded loaded = io::loadFile(path);
        if (loaded.failure) refuse(path, *loaded.failure, ExitStatus::CannotReadOrWrite);
        const io::DecodedPicture frame = io::decodedFrame(loaded.bytes, m_interrupt.token());
        if (frame.flaw && m_interrupt.token().stop_requested()) return {};
        if (frame.flaw) refuse(path, *frame.flaw);
        return frame.image;
    }

    static ExitStatus statusOf(const Looked& damaged) {
        return damaged.isUnreadable ? ExitStatus::CannotReadOrWrite : ExitStatus::InputProblems;
    }

    [[noreturn]] void refuse(const QString& path, const QString& sentence,
                             ExitStatus status = ExitStatus::InputProblems) {
        m_bar.clear();
        throw InputError{path, sentence, status};
    }

    const EncodeArguments& m_arguments;
    QString m_pattern;
    Interrupt m_interrupt;
    ProgressBar m_bar;
    std::vector<int> m_numbers; // numbers of the pictures
    // Data of the newest picture; m_offset is the difference between the numbers of files and of frames.
    std::map<int, Looked> m_looked; // all existing pictures, by number
    QString m_newest;
    QByteArray m_animation;
    int m_offset = 0;
    io::Failure m_obstacle; // reason why the contents of the pictures are unknown
    QByteArray m_systemText;
    QString m_title;
    std::optional<document::AnimationFacts> m_facts;
    QSize m_size;
};

ExitStatus encode(EncodeArguments arguments) {
    const ProgressMode mode = applied(arguments.verbosity);
    check(arguments);
    if (arguments.dryRun) return ExitStatus::Done;
    return EncodeSession(arguments, mode).run();
}

} // namespace

Command encodeCommand() {
    auto arguments = std::make_shared<EncodeArguments>();
    Command command("encode", "Make a video from numbered PNG pictures",
                    "encode NAME.####.png -o OUT [OPTION]...");
    command.more = "The pictures have one size and no gaps. If they contain an animation, so does the "
                   "video. The same frames give the same bytes as animate writes. A frame of another "
                   "animation, or one that was drawn with other options than the newest one, is refused.";
    const OptionGroup files = command.group("Files");
    files
        .argument("NAME.####.png", &arguments->pattern,
                  "Name of the pictures, all of the same size, such as NAME.####.png: #### stands for their "
                  "numbers with leading zeros, without gaps")
        .completedBy(Completion::Kind::Files, {"png"})
        .required();
    files
        .add("-o,--output", "OUT", &arguments->output,
             "Video to write: " + namedVideos(tr("or")).toStdString())
        .moreOf(describedVideos())
        .completedBy(Completion::Kind::Files, videoSuffixes())
        .fileName()
        .required();
    const OptionGroup frames = command.group("Frames");
    frames
        .add("--frames", "LIST|all", parsed(&arguments->ranges, rangesArgument),
             "Pictures to take, all of which must be there: their numbers, such as 1-240,300, or all "
             "frames of the animation that the pictures carry",
             "all that are there")
        .completedBy(Completion::Kind::Words, {"all"});
    frames.flag("--dry-run", &arguments->dryRun,
                "Report what is wrong with the options; look at no picture, and write nothing");
    frames.add("--fps", "R", parsed(&arguments->framesPerSecond, rateArgument),
               "Frames per second, such as 24, 29.97 or 30000/1001",
               "those of the animation in the pictures, else 24");
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return encode(*arguments); };
    return command;
}

} // namespace cli
