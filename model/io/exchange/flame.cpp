// SPDX-License-Identifier: MIT
#include "io/exchange/flame.h"

#include "document/edits/maps/symmetry_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"
#include "ifs/system/links.h"
#include "io/exchange/flame_colours.h"
#include "io/exchange/flame_repair.h"
#include "io/exchange/flame_symmetry.h"
#include "io/exchange/flame_times.h"
#include "io/exchange/flame_xform.h"
#include "io/text/coefficient.h"
#include "io/text/export_weights.h"
#include "io/text/number.h"
#include "io/text/xml_text.h"

#include <QHash>
#include <QSet>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace io {

namespace {

using document::Problem;

constexpr qsizetype maxXforms = 100'000; // per flame
constexpr qsizetype maxFlames = 200'000; // per file
constexpr qsizetype maxRefusals = 100;   // limit for separate messages

class Reader {
public:
    Reader(const QString& text, FlameAxis axis) : m_xml(text), m_axis(axis) {
        // Refuses entities, since a flame needs nothing from a document type.
        m_xml.setEntityExpansionLimit(0);
    }

    document::FractalFile read() {
        while (!m_xml.atEnd()) {
            m_xml.readNext();
            if (m_xml.isDTD()) {
                m_xml.raiseError(Text::tr("a flame file cannot contain a document type declaration"));
                break;
            }
            if (!m_xml.isStartElement() || m_xml.name() != u"flame") continue;
            if (m_file.entries.size() + m_refused >= maxFlames) {
                report(Problem::Severity::Error, {},
                       Text::tr("The file has more than %1 flames; the rest are ignored.").arg(maxFlames));
                break;
            }
            readFlame();
        }
        if (m_xml.hasError()) {
            QString reason = m_xml.errorString();
            if (reason.endsWith(u'.')) reason.chop(1);
            report(Problem::Severity::Error, {},
                   Text::tr("The XML cannot be read beyond this point: %1.").arg(reason));
        } else if (m_file.entries.isEmpty() && m_file.problems.isEmpty())
            report(Problem::Severity::Error, {}, Text::tr("The file contains no flames."));
        if (m_refused > maxRefusals)
            report(Problem::Severity::Error, {},
                   Text::tr("%1 flames in total are not systems of affine maps.").arg(m_refused));
        joinByTime(m_file, m_times);
        return std::move(m_file);
    }

private:
    void report(Problem::Severity severity, const QString& entry, const QString& message) {
        m_file.problems << Problem{severity, entry, int(m_xml.lineNumber()), int(m_xml.columnNumber()) + 1,
                                   message};
    }

    void refuse(const QString& name, const QString& sentence) {
        if (++m_refused <= maxRefusals) report(Problem::Severity::Error, name, sentence);
    }

    void remark(const QString& sentence) {
        if (m_remarks.size() < 10)
            m_remarks << Problem{Problem::Severity::Warning,
                                 {},
                                 int(m_xml.lineNumber()),
                                 int(m_xml.columnNumber()) + 1,
                                 sentence};
    }

    void readFlame() {
        const QString name = m_xml.attributes().value(QLatin1String("name")).toString();
        const auto time = parseNumber(m_xml.attributes().value(QLatin1String("time")));
        const bool keepsZ = m_xml.attributes().value(QLatin1String("preserve_z")) == u"1";
        std::vector<Xform> xforms;
        FlameColourReader colours;
        FlameSymmetryReader symmetry;
        colours.readFlame(m_xml.attributes());
        QString refusal;
        Xform final;
        final.linear = 1;
        m_remarks.clear();
        bool isInXform = false;
        // Skips nested elements, in which programs keep data of their own, such as earlier versions.
        for (int depth = 0; !m_xml.atEnd();) {
            m_xml.readNext();
            if (m_xml.isEndElement() && --depth < 0) break;
            if (!m_xml.isStartElement()) continue;
            if (++depth == 1) isInXform = m_xml.name() == u"xform";
            const bool isRead = depth == 1 || (depth == 2 && isInXform && m_xml.name() == u"motion");
            if (!isRead || !refusal.isEmpty()) continue;
            if (readColours(colours)) {
                if (m_xml.isEndElement()) --depth; // already read to its end
            } else if (m_xml.name() == u"xform")
                refusal = addXform(xforms, symmetry);
            else if (m_xml.name() == u"finalxform")
                refusal = readFinal(final);
            else if (m_xml.name() == u"symmetry")
                refusal = readSymmetry(symmetry);
            else if (m_xml.name() == u"motion")
                refusal = Text::tr("it has motion");
            else if (m_xml.name() == u"layer")
                refusal = Text::tr("it has layers");
            if (!refusal.isEmpty())
                refuse(name,
                       Text::tr("The flame “%1” is not a system of affine maps: %2.").arg(name, refusal));
        }
        if (m_xml.hasError() || !refusal.isEmpty()) return;
        const FlameSymmetryReader::Outcome found = symmetry.outcome();
        for (auto index = found.transforms.rbegin(); index != found.transforms.rend(); ++index)
            xforms.erase(xforms.begin() + std::ptrdiff_t(*index));
        colours.forgetXforms(found.transforms);
        refusal = finalObstacle(final, xforms, found.symmetry);
        if (!refusal.isEmpty())
            return refuse(name,
                          Text::tr("The flame “%1” is not a system of affine maps: %2.").arg(name, refusal));
        const std::size_t before = std::size_t(m_file.entries.size());
        addEntry({name, std::move(xforms), keepsZ, found.symmetry, final.inPlane()}, colours);
        if (std::size_t(m_file.entries.size()) > before) m_times.push_back(time);
    }

    // Returns true if the final xform leaves the plane unchanged.
    static bool isNoFinal(const Xform& final) { return final.inPlane() == ifs::AffineMap<2>(); }

    QString readFinal(Xform& final) const {
        const Xform read = readXform(m_xml.attributes());
        if (!read.refusal.isEmpty()) return Text::tr("final transform: %1").arg(read.refusal);
        if (!isNoFinal(final)) return Text::tr("it has several final transforms");
        if (read.isSpatial()) return Text::tr("it has a final transform in space");
        if (!ifs::inverse(read.inPlane())) return Text::tr("its final transform flattens the picture");
        final = read;
        return {};
    }

    static QString finalObstacle(const Xform& final, const std::vector<Xform>& xforms,
                                 const ifs::Symmetry<2>& symmetry) {
        if (isNoFinal(final)) return {};
        if (std::ranges::any_of(xforms, &Xform::isSpatial))
            return Text::tr("it has a final transform in space");
        return symmetry == ifs::Symmetry<2>() ? QString()
                                              : Text::tr("it has a final transform and a symmetry");
    }

    QString readSymmetry(FlameSymmetryReader& symmetry) const {
        bool ok = false;
        const int kind = m_xml.attributes().value(QLatin1String("kind")).trimmed().toInt(&ok);
        return ok && symmetry.readKind(kind)
                   ? QString()
                   : Text::tr("its symmetry is not of a kind from −%1 to %1").arg(ifs::maxSymmetryOrder);
    }

    // Reads an element of colours; false for others. An xform's colours are read, too, but return false.
    bool readColours(FlameColourReader& colours) {
        const QXmlStreamAttributes attributes = m_xml.attributes();
        if (m_xml.name() == u"xform")
            colours.readXform(attributes);
        else if (m_xml.name() == u"color")
            colours.readColour(attributes);
        else if (m_xml.name() == u"colors")
            colours.readColours(attributes.value(QLatin1String("data")).toString());
        else if (m_xml.name() == u"palette")
            colours.readPalette(m_xml.readElementText(QXmlStreamReader::SkipChildElements),
                                attributes.value(QLatin1String("format")) == u"RGBA" ? 4 : 3);
        else
            return false;
        return m_xml.name() != u"xform";
    }

    QString addXform(std::vector<Xform>& xforms, FlameSymmetryReader& symmetry) {
        if (qsizetype(xforms.size()) >= maxXforms)
            return Text::tr("it has more than %1 transforms").arg(maxXforms);
        const Xform xform = readXform(m_xml.attributes());
        if (!xform.refusal.isEmpty())
            return Text::tr("transform %1: %2").arg(xforms.size() + 1).arg(xform.refusal);
        if (const auto sentence = weightRemark(xforms.size() + 1, xform.weight)) remark(*sentence);
        if (xform.opacity != 1)
            remark(Text::tr("Transform %1 has opacity %2; its points are drawn in full.")
                       .arg(xforms.size() + 1)
                       .arg(xform.opacity));
        if (xform.standsStill && !xform.isSpatial()) {
            const ifs::AffineMap<2> map = xform.inPlane();
            symmetry.addTransform(xforms.size(), m_axis == FlameAxis::Flipped ? ifs::flipped(map) : map);
        }
        xforms.push_back(xform);
        return {};
    }

    static QString linkObstacle(const std::vector<Xform>& xforms) {
        constexpr std::size_t maxLinked = 256;
        if (std::ranges::none_of(xforms, &Xform::isLinked)) return {};
        if (xforms.size() > maxLinked)
            return Text::tr("it links more than %1 transforms by “chaos”").arg(maxLinked);
        if (std::ranges::any_of(xforms, &Xform::isSpatial))
            return Text::tr("it links transforms in space by “chaos”");
        return {};
    }

    static ifs::MapId idOf(std::size_t index) { return static_cast<ifs::MapId>(index + 1); }

    // Rows of the matrix, one entry for each transform; missing entries are 1.
    static void link(document::System2& system, const std::vector<Xform>& xforms) {
        const std::size_t n = xforms.size();
        std::vector<double> matrix;
        for (const Xform& xform : xforms)
            for (std::size_t j = 0; j < n; ++j)
                matrix.push_back(j < std::size_t(xform.chaos.size()) ? xform.chaos[qsizetype(j)] : 1);
        ifs::setLinks(system, matrix);
    }

    document::Shape<2> planeOf(const std::vector<Xform>& xforms, const ifs::AffineMap<2>& final) const {
        document::Shape<2> shape;
        const bool isMoved = !(final == ifs::AffineMap<2>());
        for (std::size_t i = 0; i < xforms.size(); ++i) {
            ifs::AffineMap<2> map = xforms[i].inPlane();
            if (isMoved) map = final * map * *ifs::inverse(final);
            shape.system.maps.push_back({.id = idOf(i),
                                         .map = m_axis == FlameAxis::Flipped ? ifs::flipped(map) : map,
                                         .weight = xforms[i].weight});
        }
        if (std::ranges::any_of(xforms, &Xform::isLinked)) link(shape.system, xforms);
        return shape;
    }

    document::Shape<3> spaceOf(const std::vector<Xform>& xforms, bool keepsZ) const {
        const ifs::Vector<3> up(1, m_axis == FlameAxis::Flipped ? -1 : 1, 1);
        document::Shape<3> shape;
        for (std::size_t i = 0; i < xforms.size(); ++i) {
            const ifs::AffineMap<3> map = xforms[i].inSpace(keepsZ);
            shape.system.maps.push_back(
                {.id = idOf(i),
                 .map = {up.asDiagonal() * map.linear * up.asDiagonal(), up.cwiseProduct(map.translation)},
                 .weight = xforms[i].weight});
        }
        return shape;
    }

    // Parts of a flame that are needed after all of it has been read.
    struct Flame {
        QString name;
        std::vector<Xform> xforms; // xforms that are maps
        bool keepsZ = false;
        ifs::Symmetry<2> symmetry;
        ifs::AffineMap<2> final; // F; the attractor of F w F⁻¹ is F(A)
    };

    void addEntry(const Flame& flame, const FlameColourReader& colours) {
        const auto& [name, xforms, keepsZ, symmetry, final] = flame;
        if (xforms.empty()) {
            refuse(name, Text::tr("The flame “%1” has no transforms.").arg(name));
            return;
        }
        if (const QString obstacle = linkObstacle(xforms); !obstacle.isEmpty()) {
            refuse(name, Text::tr("The flame “%1” is not a system of affine maps: %2.").arg(name, obstacle));
            return;
        }
        document::Fractal fractal;
        fractal.name = nameOnce(name.isEmpty() ? QStringLiteral("flame") : name);
        // Names that a collection cannot hold become the comment behind the brace.
        if (document::uniqueName({}, name) != name) fractal.headerComment = name;
        if (std::ranges::any_of(xforms, &Xform::isSpatial))
            fractal.shape = spaceOf(xforms, keepsZ);
        else
            fractal.shape = planeOf(xforms, final);
        const QString crowded =
            document::symmetryObstacle(fractal, ifs::groupOrder(symmetry.group, symmetry.order));
        if (!crowded.isEmpty()) return refuse(name, crowded);
        if (auto* plane = document::plane(fractal)) plane->system.symmetry = symmetry;
        if (auto* space = document::space(fractal)) space->system.symmetry = ifs::lifted(symmetry);
        colours.applyTo(fractal);
        if (colours.namesForeignPalette())
            remark(Text::tr("The flame names a palette of another program by its number; its colours are "
                            "not in the file."));
        document::Entry entry;
        entry.id = static_cast<document::EntryId>(m_file.entries.size() + 1);
        for (Problem& remark : m_remarks)
            remark.entry = fractal.name;
        entry.problems = m_remarks;
        entry.fractal = std::make_shared<const document::Fractal>(std::move(fractal));
        m_file.entries << entry;
    }

    // Whole name, with a number if another flame has the same.
    QString nameOnce(const QString& name) {
        QString candidate = name;
        int& number = m_numbers[name.toCaseFolded()];
        for (number = std::max(number, 2); m_names.contains(candidate.toCaseFolded()); ++number)
            candidate = QStringLiteral("%1_%2").arg(name, QString::number(number));
        m_names.insert(candidate.toCaseFolded());
        return candidate;
    }

    QXmlStreamReader m_xml;
    FlameAxis m_axis;
    document::FractalFile m_file;
    std::vector<std::optional<double>> m_times; // times of all entries
    QSet<QString> m_names;                      // case-folded
    QHash<QString, int> m_numbers;              // next number to try behind each name
    document::Problems m_remarks;               // remarks on the weights of the current flame
    qsizetype m_refused = 0;
};

QString coefficientText(const ifs::AffineMap<2>& map) {
    QByteArrayList parts;
    for (double value : {map.linear(0, 0), map.linear(1, 0), map.linear(0, 1), map.linear(1, 1),
                         map.translation.x(), map.translation.y()})
        parts << formatNumber(value);
    return QString::fromLatin1(parts.join(' '));
}

QString chaosText(const std::vector<double>& matrix, std::size_t row, std::size_t size) {
    QByteArrayList parts;
    for (std::size_t j = 0; j < size; ++j)
        parts << formatNumber(matrix[row * size + j]);
    return QString::fromLatin1(parts.join(' '));
}

QString hexPalette(const FlameColours& colours) {
    QString text;
    for (std::size_t i = 0; i < flameColours; ++i) {
        const attractor::Rgba colour = colours.palette[i];
        if (i % 8 == 0) text += QLatin1String("\n      ");
        for (int channel : {colour.red, colour.green, colour.blue})
            text += QStringLiteral("%1").arg(channel, 2, 16, QLatin1Char('0')).toUpper();
    }
    return text + QLatin1String("\n    ");
}

// Writes the transforms as flam3 does: as likely as a map of weight 1, at rest in animations, and without a
// colour of their own.
void writeSymmetryTransforms(QXmlStreamWriter& xml, const ifs::Symmetry<2>& symmetry, FlameAxis axis) {
    for (const ifs::AffineMap<2>& map : symmetryTransforms(symmetry)) {
        xml.writeEmptyElement(QStringLiteral("xform"));
        for (const auto& [name, value] :
             {std::pair{"weight", "1"}, std::pair{"color", "0"}, std::pair{"color_speed", "0"},
              std::pair{"animate", "0"}, std::pair{"linear", "1"}})
            xml.writeAttribute(QLatin1String(name), QLatin1String(value));
        xml.writeAttribute(QStringLiteral("coefs"),
                           coefficientText(axis == FlameAxis::Flipped ? ifs::flipped(map) : map));
    }
}

void writeOne(QXmlStreamWriter& xml, const document::Fractal& fractal, const document::System2& system,
              FlameAxis axis) {
    constexpr int side = 1000; // pixels of the frame for the flame's scale and centre
    attractor::Camera camera;
    camera.width = camera.height = side;
    document::Fractal code = fractal;
    document::plane(code)->cage.reset(); // flames hold the code without a placement
    if (const auto box = document::displayedBox(code)) camera = attractor::fitted(camera, box->min, box->max);
    const double up = axis == FlameAxis::Flipped ? -1 : 1;

    xml.writeStartElement(QStringLiteral("flame"));
    xml.writeAttribute(QStringLiteral("name"), fractal.name);
    xml.writeAttribute(QStringLiteral("version"), QStringLiteral("Barycage"));
    xml.writeAttribute(QStringLiteral("size"), QStringLiteral("%1 %1").arg(side));
    xml.writeAttribute(QStringLiteral("center"), QString::fromLatin1(formatNumber(camera.centre.x()) + ' ' +
                                                                     formatNumber(up * camera.centre.y())));
    xml.writeAttribute(QStringLiteral("scale"), QString::fromLatin1(formatNumber(camera.pixelsPerUnit)));
    writeFlameLook(xml, fractal.appearance);

    if (const auto kind = flameKind(system.symmetry)) {
        xml.writeEmptyElement(QStringLiteral("symmetry"));
        xml.writeAttribute(QStringLiteral("kind"), QString::number(*kind));
    }
    const std::vector<double> weights = exportWeights(system);
    const FlameColours colours = flameColoursOf(fractal);
    const auto links = system.links.empty() ? std::vector<double>{} : ifs::linkMatrix(system);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const ifs::AffineMap<2>& map = system.maps[i].map;
        xml.writeEmptyElement(QStringLiteral("xform"));
        writeFlameName(xml, fractal, i);
        xml.writeAttribute(QStringLiteral("weight"), QString::fromLatin1(formatNumber(weights[i])));
        writeFlameColour(xml, colours, i);
        xml.writeAttribute(QStringLiteral("linear"), QStringLiteral("1"));
        xml.writeAttribute(QStringLiteral("coefs"),
                           coefficientText(axis == FlameAxis::Flipped ? ifs::flipped(map) : map));
        if (!system.links.empty())
            xml.writeAttribute(QStringLiteral("chaos"), chaosText(links, i, system.maps.size()));
    }
    writeSymmetryTransforms(xml, system.symmetry, axis);
    xml.writeStartElement(QStringLiteral("palette"));
    xml.writeAttribute(QStringLiteral("count"), QStringLiteral("256"));
    xml.writeAttribute(QStringLiteral("format"), QStringLiteral("RGB"));
    xml.writeCharacters(hexPalette(colours));
    xml.writeEndElement();
    xml.writeEndElement();
}

} // namespace

document::FractalFile readFlame(const QByteArray& bytes, FlameAxis axis) {
    const XmlText xml = xmlText(bytes);
    document::FractalFile file;
    if (!xml.failure) {
        RepairedFlames repaired = repairedFlames(xml.text);
        file = Reader(repaired.text, axis).read();
        file.problems = repaired.problems + file.problems;
        return file;
    }
    file.problems << Problem{Problem::Severity::Error, {}, 0, 0, *xml.failure};
    return file;
}

bool looksLikeFlame(const QByteArray& bytes) {
    QByteArray head = bytes.left(4096);
    if (head.startsWith("\xef\xbb\xbf")) head.remove(0, 3);
    head = head.trimmed();
    if (!head.startsWith('<')) return false;
    if (head.contains("<flame") || head.contains("<jwf-flame") || head.contains("<Flames")) return true;
    QXmlStreamReader xml(bytes); // accepts long comments before the first element
    return xml.readNextStartElement() && xml.name().startsWith(QLatin1String("flame"), Qt::CaseInsensitive);
}

QByteArray writeFlame(const QList<std::shared_ptr<const document::Fractal>>& fractals, FlameAxis axis) {
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.setAutoFormatting(true);
    xml.setAutoFormattingIndent(2);
    xml.writeStartElement(QStringLiteral("flames"));
    for (const auto& fractal : fractals)
        if (document::system2(*fractal)) {
            const document::Fractal held =
                flameHoldsSymmetry(*fractal) ? *fractal : document::expanded(*fractal);
            writeOne(xml, held, *document::system2(held), axis);
        }
    xml.writeEndElement();
    return bytes.trimmed() + '\n';
}

} // namespace io
