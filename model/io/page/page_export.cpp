// SPDX-License-Identifier: MIT
#include "io/page/page_export.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/text/text.h"
#include "io/page/page_entry.h"
#include "io/page/page_script.h"
#include "io/picture/plane_export.h"
#include "io/picture/space_export.h"
#include "io/raster/jpeg_writer.h"
#include "io/report/json_writer.h"
#include "notation/page/page_text.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <new>
#include <span>
#include <string>
#include <utility>

namespace io {

namespace {

constexpr int stillWidth = 640, stillHeight = 480;     // pixels of the picture for readers without JavaScript
constexpr int stillQualities[] = {72, 60, 48, 36, 24}; // qualities to try until it is small enough
constexpr qsizetype stillBytes = 26'000;
constexpr std::uint64_t stillSamples = 4'000'000;

// The attractor and its cage.
attractor::Camera stillCamera(const document::Fractal& fractal) {
    attractor::Camera camera;
    camera.width = stillWidth;
    camera.height = stillHeight;
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    ifs::Vector<2> low = cage.current.front(), high = low;
    for (const ifs::Vector<2>& vertex : cage.current) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    if (const auto box = document::displayedBox(fractal)) {
        low = low.cwiseMin(box->min);
        high = high.cwiseMax(box->max);
    }
    return attractor::fitted(camera, low, high, pageMargin);
}

QImage stillInSpace(const document::Fractal& fractal) {
    attractor::OrbitCamera camera;
    camera.orientation = attractor::orbit(pageAzimuth, pageElevation);
    camera.size = {stillWidth, stillHeight};
    SpaceExport picture;
    picture.fractal = fractal;
    picture.request = document::spaceRequest(fractal, document::fittedTo(fractal, camera, pageMargin));
    picture.request.samples = stillSamples;
    return drawSpacePicture(picture).image;
}

QImage stillPicture(const document::Fractal& fractal) {
    if (document::space(fractal)) return stillInSpace(fractal);
    PlaneExport picture;
    picture.fractal = fractal;
    picture.request = document::renderRequest(fractal, stillCamera(fractal));
    picture.request.samples = stillSamples;
    return drawPicture(picture).image;
}

// Only memory can be missing.
QByteArray jpegOf(const QImage& image, int quality) {
    QBuffer file;
    file.open(QIODevice::WriteOnly);
    PictureFormat format;
    format.width = image.width();
    format.height = image.height();
    format.quality = quality;
    JpegWriter writer(file, format);
    const std::size_t width = std::size_t(image.width());
    for (int y = 0; y < image.height(); ++y)
        if (writer.writeRows(
                std::span(reinterpret_cast<const std::uint32_t*>(image.constScanLine(y)), width)))
            throw std::bad_alloc();
    if (writer.finish()) throw std::bad_alloc();
    return file.data();
}

// A JPEG in an address, on white where the picture is transparent. Single points make large files: a page of
// dust is no larger than one of a leaf.
QByteArray stillAddress(const document::Fractal& fractal) {
    const QImage drawn = stillPicture(fractal);
    QImage image(drawn.size(), QImage::Format_ARGB32_Premultiplied);
    if (drawn.isNull() || image.isNull()) throw std::bad_alloc();
    image.fill(Qt::white);
    QPainter(&image).drawImage(0, 0, drawn);
    QByteArray jpeg;
    for (const int quality : stillQualities)
        if (jpeg = jpegOf(image, quality); jpeg.size() <= stillBytes) break;
    return "data:image/jpeg;base64," + jpeg.toBase64();
}

void writeGallery(JsonWriter& json, const PageExport& page) {
    json.member("title", page.title);
    json.member("caption", page.caption);
    json.key("entries");
    json.beginArray();
    for (const auto& fractal : page.entries)
        writePageEntry(json, *fractal);
    json.endArray();
    if (page.steps.isEmpty()) return;
    json.key("steps");
    json.beginArray();
    for (const PageStep& step : page.steps) {
        json.beginObject();
        json.member("title", step.title);
        json.member("text", step.text);
        json.member("entry", int(step.entry));
        json.member("maps", step.holdsMaps);
        if (step.area) {
            const attractor::View& view = step.area->view;
            json.key("area");
            json.beginArray(JsonWriter::Layout::Inline);
            for (const double number : {view.centre.x(), view.centre.y(), step.area->width, view.height})
                json.value(number);
            json.endArray();
        }
        json.endObject();
    }
    json.endArray();
}

QByteArray embedded(const QByteArray& json) {
    return QByteArray::fromStdString(notation::embedded(json.toStdString()));
}

QByteArray contentOf(const PageExport& page) {
    JsonWriter json;
    json.beginObject();
    if (page.entries.isEmpty()) {
        json.key("entry");
        writePageEntry(json, page.fractal);
    } else {
        writeGallery(json, page);
    }
    json.member("show", QString::fromLatin1(ifs::nameOf(page.parts)));
    json.key("allow");
    json.beginArray(JsonWriter::Layout::Inline);
    if (page.allowsCage) json.value(QStringLiteral("cage"));
    if (page.allowsMaps) json.value(QStringLiteral("maps"));
    if (page.allowsCode) json.value(QStringLiteral("code"));
    json.endArray();
    json.member("language", page.language);
    json.member("points", double(page.points));
    json.endObject();
    return embedded(json.text());
}

QByteArray backgroundOf(const document::Fractal& fractal) {
    const attractor::Rgba colour =
        document::space(fractal) ? document::backgroundInSpace(fractal) : fractal.appearance.background;
    if (colour.alpha == 0) return "transparent";
    return "rgb(" + QByteArray::number(colour.red) + ' ' + QByteArray::number(colour.green) + ' ' +
           QByteArray::number(colour.blue) + " / " + QByteArray::number(colour.alpha * 100 / 255) + "%)";
}

QByteArray styleOf(const PageExport& page) {
    QByteArray style = QByteArray::fromStdString(
        notation::filled(notation::plainStyle(pagePart("page.css").toStdString()),
                         {{"background", backgroundOf(page.fractal).toStdString()}}));
    if (page.size) {
        const QByteArray width = QByteArray::number(page.size->width()),
                         height = QByteArray::number(page.size->height());
        style +=
            ":root { --figure-width: " + width + "px; --figure-ratio: " + width + " / " + height + "; }\n";
    }
    return style;
}

// The name of a text that may run, in a Content-Security-Policy.
QByteArray hashOf(const QByteArray& text) {
    return "sha256-" + QCryptographicHash::hash(text, QCryptographicHash::Sha256).toBase64();
}

// What the page can say: in its language, or in all from which the browser chooses.
QByteArray textsIn(const QString& language, const QJsonObject& all) {
    const QJsonObject texts = language.isEmpty() ? all : QJsonObject{{language, all[language]}};
    return embedded(QJsonDocument(texts).toJson(QJsonDocument::Compact));
}

// JSON that is the same in every encoding of a script: that of the article that loads it.
QByteArray inAscii(const QJsonObject& object) {
    QByteArray text;
    for (const QChar character : QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact))) {
        const ushort code = character.unicode();
        text += code < 128 ? QByteArray(1, char(code))
                           : "\\u" + QByteArray::number(code, 16).rightJustified(4, '0');
    }
    return text;
}

const QString& titleOf(const PageExport& page) {
    return page.entries.isEmpty() ? page.fractal.name : page.title;
}

// The engine that knows what the page shows, and no more.
std::string engineOf(const PageExport& page) {
    const auto isSolid = [](const auto& fractal) { return document::space(*fractal) != nullptr; };
    const auto moves = [](const auto& fractal) { return document::animationFacts(*fractal).has_value(); };
    std::string name = "engine";
    if (!document::space(page.fractal) && std::ranges::none_of(page.entries, isSolid)) name += "_plane";
    if (document::animationFacts(page.fractal) || std::ranges::any_of(page.entries, moves)) name += "_moving";
    return name + ".wasm.gz";
}

using Fields = std::map<std::string, std::string, std::less<>>;

// What stands in the template.
Fields fieldsOf(const PageExport& page) {
    const char* extra = !page.steps.isEmpty() ? "lesson.js" : page.entries.isEmpty() ? "" : "gallery.js";
    const QByteArray script = joinedScript(notation::pageModules(extra)), style = styleOf(page);
    const QByteArray engine = pagePart(engineOf(page));
    const QString language = page.language.isEmpty() ? QStringLiteral("en") : page.language;
    const QJsonObject texts = QJsonDocument::fromJson(pagePart("texts.json")).object();
    const std::pair<const char*, QByteArray> parts[]{
        {"language", language.toLatin1()},
        {"title", titleOf(page).toHtmlEscaped().toUtf8()},
        {"caption", page.caption.toHtmlEscaped().toUtf8()},
        {"plain", texts[language][u"plain"].toString().toUtf8()}, // where no script runs
        {"texts", textsIn(page.language, texts)},
        {"show", ifs::nameOf(page.parts)},
        {"style", style},
        {"style-hash", hashOf(style)},
        {"still", stillAddress(page.fractal)},
        {"content", contentOf(page)},
        {"engine", QByteArray::fromStdString(notation::inBase85(engine.toStdString()))},
        {"worker", joinedScript(notation::workerModules())},
        {"script", script},
        {"script-hash", hashOf(script)},
    };
    Fields fields;
    for (const auto& [name, text] : parts)
        fields.emplace(name, text.toStdString());
    return fields;
}

QByteArray filledPage(const Fields& fields) {
    return QByteArray::fromStdString(notation::filled(pagePart("page.html").toStdString(), fields));
}

} // namespace

QString pageObstacle(const document::Fractal& fractal) {
    const auto* system = document::system2(fractal);
    const auto* solid = document::system3(fractal);
    if (!system && !solid) return Text::tr("This entry is not an iterated function system.");
    constexpr std::size_t most = 2000;
    const std::size_t maps = system ? system->maps.size() : solid->maps.size();
    if (maps > most)
        return Text::tr("This entry has %1 maps; a web page can have at most %2.").arg(maps).arg(most);
    return {};
}

QByteArray pageOf(const PageExport& page) {
    return filledPage(fieldsOf(page));
}

QByteArray scriptOf(const PageExport& page) {
    Fields fields = fieldsOf(page);
    QJsonObject figures{{QStringLiteral("title"), titleOf(page)}};
    for (const char* shared : {"engine", "worker"}) // by all figures
        figures[QLatin1String(shared)] = QString::fromStdString(fields.extract(shared).mapped());
    figures[QStringLiteral("page")] = QString::fromUtf8(filledPage(fields));
    return joinedScript({"embed.js"}, "embed(" + inAscii(figures) + ");\n");
}

} // namespace io
