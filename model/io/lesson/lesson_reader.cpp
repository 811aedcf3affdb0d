// SPDX-License-Identifier: MIT
#include "io/lesson/lesson_reader.h"

#include "document/text/text.h"
#include "io/lesson/lesson_words.h"
#include "io/text/number.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace io {

namespace {

using document::Lesson;
using document::LessonArea;
using document::LessonAtRest;
using document::LessonConstruction;
using document::LessonFit;
using document::LessonOrbit;
using document::LessonState;
using document::LessonStep;

constexpr qsizetype maxBytes = 4 << 20;
constexpr double maxNumber = 3.4e38;
constexpr double minTurn = 1e-6; // length of a quaternion
constexpr double minView = 1e-30;
constexpr double maxView = 1e30;
constexpr int maxProblems = 20;
constexpr int maxUnknown = 50; // lines in one place
constexpr int maxPanels = 20;
constexpr double maxSpeed = 1e6; // points per second

QStringList words(const QString& value) {
    return value.split(u' ', Qt::SkipEmptyParts);
}

QStringList items(const QString& value) {
    QStringList found;
    for (const QString& item : value.split(u',', Qt::SkipEmptyParts))
        if (const QString trimmed = item.trimmed(); !trimmed.isEmpty()) found << trimmed;
    return found;
}

// A number for each word; nullopt when one is no number.
std::optional<std::vector<double>> numbersIn(const QStringList& texts) {
    std::vector<double> values;
    for (const QString& text : texts) {
        const std::optional<double> value = parseNumber(text);
        if (!value || std::abs(*value) > maxNumber) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

template <class Value>
std::optional<Value> meaningOf(std::span<const LessonWord<Value>> words, const QString& text) {
    const auto found = std::ranges::find_if(words, [&](const auto& each) { return text == each.word; });
    return found == words.end() ? std::nullopt : std::optional(found->value);
}

bool isViewSize(double size) {
    return size >= minView && size <= maxView;
}

// Rotation of the plane: optionally "down", then optionally "rotation" and degrees, and nothing else.
std::optional<LessonFit> turnIn(QStringList texts) {
    LessonFit turn;
    if (texts.value(0) == QLatin1String("down")) {
        turn.yAxis = attractor::YAxis::Down;
        texts.removeFirst();
    }
    if (texts.isEmpty()) return turn;
    const auto degrees = numbersIn(texts.sliced(1));
    if (texts.front() != QLatin1String("rotation") || !degrees || degrees->size() != 1) return std::nullopt;
    turn.rotation = attractor::rotationOf(degrees->front());
    return turn;
}

bool readArea(const QStringList& texts, LessonState& state) {
    if (texts.size() < 4) return false;
    const auto values = numbersIn(texts.first(4));
    const auto turn = turnIn(texts.sliced(4));
    if (!values || !turn || !isViewSize((*values)[2]) || !isViewSize((*values)[3])) return false;
    const std::vector<double>& v = *values;
    state.view = LessonArea{{{v[0], v[1]}, v[3], turn->yAxis, turn->rotation}, v[2]};
    return true;
}

bool readOrbit(QStringList texts, LessonState& state) {
    const bool isFitted = !texts.isEmpty() && texts.back() == QLatin1String("fit");
    if (isFitted) texts.removeLast();
    const bool isPerspective = texts.size() == 10 && texts[8] == QLatin1String("perspective");
    const auto values = numbersIn(isPerspective ? texts.first(8) + texts.last(1) : texts);
    if (!values || values->size() != (isPerspective ? 9 : 8)) return false;
    const std::vector<double>& v = *values;
    LessonOrbit orbit;
    orbit.isFitted = isFitted;
    orbit.camera.target = {v[0], v[1], v[2]};
    const attractor::Orientation turn(v[6], v[3], v[4], v[5]);
    const double length = turn.norm();
    if (!std::isfinite(length) || length < minTurn || !isViewSize(v[7])) return false;
    orbit.camera.orientation = turn;
    if (std::abs(length - 1) > 1e-12) orbit.camera.orientation.normalize();
    orbit.camera.height = v[7];
    if (isPerspective) {
        if (v[8] < 1 || v[8] > 170) return false;
        orbit.camera.projection = attractor::OrbitCamera::Projection::Perspective;
        orbit.camera.fieldOfView = v[8];
    }
    state.view = orbit;
    return true;
}

bool readView(const QString& value, LessonState& state) {
    QStringList texts = words(value);
    if (texts.isEmpty()) return false;
    const QString kind = texts.takeFirst();
    if (kind == QLatin1String("fit")) {
        const auto turn = turnIn(texts);
        if (turn) state.view = *turn;
        return turn.has_value();
    }
    if (kind == QLatin1String("area")) return readArea(texts, state);
    return kind == QLatin1String("orbit") && readOrbit(texts, state);
}

bool readTool(const QString& value, LessonState& state) {
    const auto tool = meaningOf(lessonTools(), value);
    if (tool) state.tool = *tool;
    return tool.has_value();
}

bool readColour(const QString& value, LessonState& state) {
    state.colourBy = meaningOf(lessonColours(), value);
    return state.colourBy.has_value();
}

template <int Dim> bool readCorners(const QStringList& corners, LessonState& state) {
    std::vector<ifs::Vector<Dim>> vertices;
    for (const QString& corner : corners) {
        const auto values = numbersIn(words(corner));
        if (!values || values->size() != Dim) return false;
        vertices.push_back(Eigen::Map<const ifs::Vector<Dim>>(values->data()));
    }
    if (vertices.size() <= Dim || vertices.size() > document::maxLessonCorners) return false;
    state.cage = std::move(vertices);
    return true;
}

bool readCage(const QString& value, LessonState& state) {
    if (value == QLatin1String("rest")) {
        state.cage = LessonAtRest{};
        return true;
    }
    const QStringList corners = items(value);
    if (corners.isEmpty() || corners.size() > qsizetype(document::maxLessonCorners)) return false;
    return words(corners.front()).size() == 3 ? readCorners<3>(corners, state)
                                              : readCorners<2>(corners, state);
}

bool readOutlines(const QString& value, LessonState& state) {
    bool isGood = true;
    for (const QString& item : items(value)) {
        const QStringList texts = words(item);
        const auto outline = meaningOf(lessonOutlines(), texts.front());
        const bool hasDepth = outline == document::Outline::Cylinders && texts.size() == 2;
        if (!outline || (texts.size() > 1 && !hasDepth)) {
            isGood = false;
            continue;
        }
        if (hasDepth) {
            const int depth = texts.back().toInt();
            isGood = isGood && depth >= 1 && depth <= document::maxLessonCylinders;
            state.cylinderDepth = std::clamp(depth, 1, document::maxLessonCylinders);
        }
        state.outlines.insert(*outline);
    }
    return isGood;
}

bool readConstruction(const QString& value, LessonState& state) {
    using enum LessonConstruction::Mode;
    const QStringList texts = words(value);
    LessonConstruction construction;
    bool isNumber = false;
    const qulonglong count = texts.size() > 1 ? texts[1].toULongLong(&isNumber) : 0;
    if (texts.size() == 1 && texts[0] == QLatin1String("density")) {
        construction.mode = Density;
    } else if (isNumber && texts.size() == 2 && texts[0] == QLatin1String("steps") &&
               count <= document::maxLessonIterations) {
        construction.mode = Steps;
        construction.iterations = int(count);
    } else if (isNumber && (texts.size() == 2 || texts.size() == 4) &&
               texts[0] == QLatin1String("chaos-game") && count <= document::maxLessonPoints) {
        construction.mode = ChaosGame;
        construction.points = count;
        if (texts.size() == 4) {
            const auto speed = parseNumber(texts[3]);
            if (texts[2] != QLatin1String("speed") || !speed || *speed <= 0 || *speed > maxSpeed)
                return false;
            construction.speed = *speed;
        }
    } else {
        return false;
    }
    state.construction = construction;
    return true;
}

bool readFrame(const QString& value, LessonState& state) {
    state.moment = animation::parseMoment(value.toStdString());
    return state.moment.has_value();
}

bool setMarks(const QString& value, std::span<const LessonWord<bool LessonState::*>> marks, bool shown,
              LessonState& state) {
    bool isGood = true;
    for (const QString& item : items(value))
        if (const auto mark = meaningOf(marks, item))
            state.*(*mark) = shown;
        else
            isGood = false;
    return isGood;
}

bool readHidden(const QString& value, LessonState& state) {
    return setMarks(value, lessonMarks(), false, state);
}

bool readShown(const QString& value, LessonState& state) {
    return setMarks(value, lessonExtras(), true, state);
}

bool readPanels(const QString& value, LessonState& state) {
    static const QRegularExpression id(QStringLiteral("^[a-z][a-z-]{0,39}$"));
    bool isGood = true;
    state.panels.clear();
    for (const QString& item : items(value)) {
        const bool isNew =
            id.match(item).hasMatch() && state.panels.size() < maxPanels && !state.panels.contains(item);
        if (isNew) state.panels << item;
        isGood = isGood && isNew;
    }
    return isGood;
}

bool readEntry(const QString& value, LessonState& state) {
    state.entry = value;
    return true;
}

struct Setting {
    QLatin1String key;
    bool (*read)(const QString& value, LessonState& state); // false: value makes no sense, wholly or in part
};
constexpr Setting knownSettings[] = {
    {QLatin1String("entry"), readEntry},   {QLatin1String("view"), readView},
    {QLatin1String("tool"), readTool},     {QLatin1String("cage"), readCage},
    {QLatin1String("colour"), readColour}, {QLatin1String("outlines"), readOutlines},
    {QLatin1String("frame"), readFrame},   {QLatin1String("construction"), readConstruction},
    {QLatin1String("hide"), readHidden},   {QLatin1String("show"), readShown},
    {QLatin1String("panels"), readPanels},
};

class Reader {
public:
    LessonFile read(const QByteArray& bytes);

private:
    enum class Part { Head, Settings, Text };

    void take(const QString& line);
    void begin(const QString& title);
    bool takeSetting(const QString& line);
    void set(const QString& key, const QString& value);
    void setInHead(const QString& key, const QString& value);
    void keep(QStringList& unknown, const QString& line);
    void addText(const QString& line);
    void finishStep();
    void warn(const QString& sentence);
    void refuse(const QString& sentence);

    LessonFile m_file;
    Part m_part = Part::Head;
    QString m_text; // text of the step
    int m_line = 0;
    bool m_isLesson = false;
    bool m_isTextCut = false;
    bool m_isFull = false; // true: further steps are ignored
};

void Reader::warn(const QString& sentence) {
    if (m_file.problems.size() < maxProblems)
        m_file.problems << document::Problem{document::Problem::Severity::Warning, {}, m_line, 1, sentence};
}

void Reader::refuse(const QString& sentence) {
    m_file.lesson = {};
    m_file.problems = {{document::Problem::Severity::Error, {}, 0, 0, sentence}};
}

LessonFile Reader::read(const QByteArray& bytes) {
    if (bytes.size() > maxBytes) {
        refuse(Text::tr("The lesson is larger than 4 MB, which is the limit."));
        return m_file;
    }
    QString text = QString::fromUtf8(bytes);
    if (text.startsWith(QChar::ByteOrderMark)) text.remove(0, 1);
    text.replace(QLatin1String("\r\n"), QLatin1String("\n")).replace(u'\r', u'\n');
    for (const QStringView line : QStringView(text).split(u'\n')) {
        ++m_line;
        take(line.toString());
        if (m_isFull || (!m_isLesson && m_line > 20)) break;
    }
    finishStep();
    if (!m_isLesson)
        refuse(Text::tr("This is not a lesson: its first line does not begin with “lesson:”."));
    else if (m_file.lesson.steps.isEmpty())
        warn(Text::tr("The lesson has no steps."));
    return m_file;
}

void Reader::take(const QString& line) {
    const QString trimmed = line.trimmed();
    if (m_isLesson && line.startsWith(QLatin1String("##"))) return begin(trimmed.sliced(2));
    if (m_part == Part::Head) {
        if (!trimmed.isEmpty() && !takeSetting(trimmed) && m_isLesson)
            warn(Text::tr(
                "This line was ignored: settings look like “file: name.ifs”, and steps begin with “##”."));
        return;
    }
    if (m_part == Part::Settings && !trimmed.isEmpty() && takeSetting(trimmed)) return;
    m_part = Part::Text;
    addText(line);
}

void Reader::begin(const QString& title) {
    finishStep();
    if (m_file.lesson.steps.size() >= document::maxLessonSteps) {
        warn(Text::tr("The lesson has more than %1 steps; the others were ignored.")
                 .arg(document::maxLessonSteps));
        m_isFull = true;
        return;
    }
    m_file.lesson.steps << LessonStep{document::lessonLine(title), {}, {}, {}};
    m_part = Part::Settings;
}

void Reader::addText(const QString& line) {
    qsizetype slashes = 0;
    while (slashes < line.size() && line[slashes] == u'\\')
        ++slashes;
    const bool isQuoted = slashes > 0 && QStringView(line).sliced(slashes).startsWith(u"##");
    const qsizetype room = 2 * document::maxLessonText - m_text.size();
    m_isTextCut = m_isTextCut || line.size() > room;
    if (room > 0) m_text += (isQuoted ? line.sliced(1) : line).left(room) + u'\n';
}

void Reader::finishStep() {
    if (m_file.lesson.steps.isEmpty()) return;
    const QString all = document::lessonText(m_text, 2 * document::maxLessonText);
    QString& text = m_file.lesson.steps.back().text;
    text = document::lessonText(all);
    if (m_isTextCut || text.size() < all.size())
        warn(Text::tr("The text of step %1 is longer than %2 characters and was cut.")
                 .arg(m_file.lesson.steps.size())
                 .arg(document::maxLessonText));
    m_text.clear();
    m_isTextCut = false;
}

// "key: value" with a key of small letters; else it is text.
bool Reader::takeSetting(const QString& line) {
    static const QRegularExpression form(QStringLiteral("^([a-z][a-z-]{0,39}):(?:\\s+(.*))?$"));
    const auto match = form.match(line);
    if (!match.hasMatch()) return false;
    const QString key = match.captured(1);
    const QString value = document::lessonLine(match.captured(2), 10'000);
    if (!m_isLesson && key != QLatin1String("lesson")) return false;
    m_part == Part::Head ? setInHead(key, value) : set(key, value);
    return true;
}

void Reader::setInHead(const QString& key, const QString& value) {
    Lesson& lesson = m_file.lesson;
    if (key == QLatin1String("lesson")) {
        m_isLesson = true;
        lesson.title = value == QLatin1String("-") ? QString() : document::lessonLine(value);
    } else if (key != QLatin1String("file")) {
        keep(lesson.unknown, key + QLatin1String(": ") + value);
    } else if (document::isLessonFile(value)) {
        lesson.file = value;
    } else {
        warn(Text::tr("A lesson cannot refer to “%1”. It can refer to a file in its own folder, or to a .ifs "
                      "or .par file in another one.")
                 .arg(document::lessonLine(value)));
    }
}

void Reader::set(const QString& key, const QString& value) {
    LessonStep& step = m_file.lesson.steps.back();
    const auto known =
        std::ranges::find_if(knownSettings, [&](const Setting& each) { return key == each.key; });
    if (known == std::end(knownSettings)) return keep(step.unknown, key + QLatin1String(": ") + value);
    if (!known->read(value, step.state))
        warn(Text::tr("“%1: %2” was not understood.").arg(key, document::lessonLine(value, 80)));
}

void Reader::keep(QStringList& unknown, const QString& line) {
    warn(Text::tr("“%1” is unknown to this version and is kept.").arg(line.section(u':', 0, 0)));
    if (unknown.size() < maxUnknown) unknown << line.trimmed();
}

} // namespace

LessonFile readLesson(const QByteArray& bytes) {
    return Reader().read(bytes);
}

} // namespace io
