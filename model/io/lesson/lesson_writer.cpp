// SPDX-License-Identifier: MIT
#include "io/lesson/lesson_writer.h"

#include "io/lesson/lesson_words.h"
#include "io/text/number.h"

#include <initializer_list>

namespace io {

namespace {

using document::LessonArea;
using document::LessonAtRest;
using document::LessonConstruction;
using document::LessonFit;
using document::LessonOrbit;
using document::LessonState;
using document::LessonStep;

template <class Value> QByteArray wordFor(std::span<const LessonWord<Value>> words, Value value) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return QByteArray(word.data(), word.size());
    return {};
}

QByteArray numbers(std::initializer_list<double> values) {
    QByteArrayList texts;
    for (const double value : values)
        texts << formatNumber(value);
    return texts.join(' ');
}

// Settings that say something, in a fixed order.
class Settings {
public:
    void add(const char* key, const QByteArray& value) {
        if (!value.isEmpty()) m_text += QByteArray(key) + ": " + value + '\n';
    }
    void add(const QStringList& lines) {
        for (const QString& line : lines)
            m_text += line.toUtf8() + '\n';
    }
    const QByteArray& text() const { return m_text; }

private:
    QByteArray m_text;
};

QByteArray turnOf(attractor::YAxis yAxis, double rotation) {
    QByteArray text;
    if (yAxis == attractor::YAxis::Down) text += " down";
    if (rotation != 0) text += " rotation " + numbers({attractor::degreesOf(rotation)});
    return text;
}

QByteArray viewOf(const LessonState& state) {
    if (const auto* area = std::get_if<LessonArea>(&state.view)) {
        const attractor::View& view = area->view;
        return "area " + numbers({view.centre.x(), view.centre.y(), area->width, view.height}) +
               turnOf(view.yAxis, view.rotation);
    }
    if (const auto* orbit = std::get_if<LessonOrbit>(&state.view)) {
        const attractor::OrbitCamera& camera = orbit->camera;
        const auto& turn = camera.orientation;
        QByteArray text = "orbit " + numbers({camera.target.x(), camera.target.y(), camera.target.z(),
                                              turn.x(), turn.y(), turn.z(), turn.w(), camera.height});
        if (camera.projection == attractor::OrbitCamera::Projection::Perspective)
            text += " perspective " + numbers({camera.fieldOfView});
        return orbit->isFitted ? text + " fit" : text;
    }
    const auto& fit = std::get<LessonFit>(state.view);
    return "fit" + turnOf(fit.yAxis, fit.rotation);
}

template <int Dim> QByteArray corners(const std::vector<ifs::Vector<Dim>>& vertices) {
    QByteArrayList texts;
    for (const auto& vertex : vertices) {
        QByteArrayList coordinates;
        for (const double x : vertex)
            coordinates << formatNumber(x);
        texts << coordinates.join(' ');
    }
    return texts.join(", ");
}

QByteArray cageOf(const LessonState& state) {
    if (std::holds_alternative<LessonAtRest>(state.cage)) return "rest";
    if (const auto* plane = std::get_if<std::vector<ifs::Vector<2>>>(&state.cage)) return corners<2>(*plane);
    if (const auto* space = std::get_if<std::vector<ifs::Vector<3>>>(&state.cage)) return corners<3>(*space);
    return {};
}

QByteArray outlinesOf(const LessonState& state) {
    QByteArrayList texts;
    for (const auto& [word, outline] : lessonOutlines()) {
        if (!state.outlines.contains(outline)) continue;
        QByteArray text(word.data(), word.size());
        if (outline == document::Outline::Cylinders) text += ' ' + QByteArray::number(state.cylinderDepth);
        texts << text;
    }
    return texts.join(", ");
}

QByteArray constructionOf(const LessonConstruction& construction) {
    using enum LessonConstruction::Mode;
    if (construction.mode == Steps) return "steps " + QByteArray::number(construction.iterations);
    if (construction.mode == Density) return {};
    QByteArray text = "chaos-game " + QByteArray::number(construction.points);
    if (construction.speed > 0) text += " speed " + formatNumber(construction.speed);
    return text;
}

QByteArray marksOf(const LessonState& state, std::span<const LessonWord<bool LessonState::*>> marks,
                   bool shown) {
    QByteArrayList texts;
    for (const auto& [word, mark] : marks)
        if (state.*mark == shown) texts << QByteArray(word.data(), word.size());
    return texts.join(", ");
}

QByteArray momentOf(const LessonState& state) {
    if (!state.moment) return {};
    QByteArray text = QByteArray::number(qint64(state.moment->numerator));
    if (state.moment->denominator != 1) text += '/' + QByteArray::number(qint64(state.moment->denominator));
    return text;
}

QByteArray settingsOf(const LessonStep& step) {
    const LessonState& state = step.state;
    Settings settings;
    settings.add("entry", state.entry.toUtf8());
    settings.add("view", viewOf(state));
    settings.add("tool", wordFor(lessonTools(), state.tool));
    settings.add("cage", cageOf(state));
    if (state.colourBy) settings.add("colour", wordFor(lessonColours(), *state.colourBy));
    settings.add("outlines", outlinesOf(state));
    settings.add("construction", constructionOf(state.construction));
    settings.add("frame", momentOf(state));
    settings.add("hide", marksOf(state, lessonMarks(), false));
    settings.add("show", marksOf(state, lessonExtras(), true));
    settings.add("panels", state.panels.join(QStringLiteral(", ")).toUtf8());
    settings.add(step.unknown);
    return settings.text();
}

// A line of text that looks like the title of a step is told apart by a backslash.
QByteArray textOf(const QString& text) {
    QStringList lines = text.split(u'\n');
    for (QString& line : lines) {
        qsizetype slashes = 0;
        while (slashes < line.size() && line[slashes] == u'\\')
            ++slashes;
        if (QStringView(line).sliced(slashes).startsWith(u"##")) line.prepend(u'\\');
    }
    return lines.join(u'\n').toUtf8();
}

} // namespace

QByteArray writeLesson(const document::Lesson& lesson) {
    Settings head;
    head.add("lesson", lesson.title.isEmpty() ? QByteArray("-") : lesson.title.toUtf8());
    head.add("file", lesson.file.toUtf8());
    head.add(lesson.unknown);
    QByteArray bytes = head.text();
    for (const LessonStep& step : lesson.steps) {
        bytes += "\n## " + step.title.toUtf8() + '\n' + settingsOf(step);
        if (!step.text.isEmpty()) bytes += '\n' + textOf(step.text) + '\n';
    }
    return bytes;
}

} // namespace io
