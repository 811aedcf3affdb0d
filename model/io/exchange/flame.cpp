// SPDX-License-Identifier: MIT
#include "io/exchange/flame.h"

#include "document/edits/symmetry_edits.h"
#include "document/fractal_geometry.h"
#include "ifs/system/links.h"
#include "io/exchange/flame_colours.h"
#include "io/exchange/flame_symmetry.h"
#include "io/text/coefficient.h"
#include "io/text/export_weights.h"
#include "io/text/number.h"
#include "io/text/xml_text.h"

#include <QCoreApplication>
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

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

constexpr qsizetype maxXforms = 100'000; // per flame
constexpr qsizetype maxFlames = 200'000; // per file
constexpr qsizetype maxRefusals = 100;   // told one by one

QList<double> numbers(QStringView text, bool* ok) {
    QList<double> values;
    for (QStringView token : text.split(u' ', Qt::SkipEmptyParts))
        values << parseNumber(token).value_or(NAN);
    *ok = std::ranges::none_of(values, [](double value) { return std::isnan(value); });
    return values;
}

// "c00 c01 c10 c11 c20 c21": column by column.
std::optional<ifs::AffineMap<2>> affine(QStringView text) {
    bool ok = false;
    const QList<double> c = numbers(text, &ok);
    if (!ok || c.size() != 6) return std::nullopt;
    return ifs::affineMap(c[0], c[2], c[1], c[3], c[4], c[5]);
}

// What an xform's attributes say that is not one of its variations.
bool isPlainAttribute(QStringView name) {
    static const QStringList plain{QStringLiteral("weight"),
                                   QStringLiteral("color"),
                                   QStringLiteral("color_speed"),
                                   QStringLiteral("symmetry"),
                                   QStringLiteral("name"),
                                   QStringLiteral("animate"),
                                   QStringLiteral("enabled"),
                                   QStringLiteral("antialias_amount"),
                                   QStringLiteral("antialias_radius"),
                                   QStringLiteral("plotmode"),
                                   QStringLiteral("coefs"),
                                   QStringLiteral("post"),
                                   QStringLiteral("chaos"),
                                   QStringLiteral("opacity"),
                                   QStringLiteral("var_color"),
                                   QStringLiteral("color_type"),
                                   QStringLiteral("material"),
                                   QStringLiteral("material_speed"),
                                   QStringLiteral("mod_gamma"),
                                   QStringLiteral("mod_gamma_speed"),
                                   QStringLiteral("mod_contrast"),
                                   QStringLiteral("mod_contrast_speed"),
                                   QStringLiteral("mod_saturation"),
                                   QStringLiteral("mod_saturation_speed"),
                                   QStringLiteral("mod_hue"),
                                   QStringLiteral("mod_hue_speed"),
                                   QStringLiteral("dx"),
                                   QStringLiteral("dy")};
    return plain.contains(name);
}

struct Xform {
    ifs::AffineMap<2> coefs; // of x and y; the others are JWildfire's
    ifs::AffineMap<2> yz;
    ifs::AffineMap<2> zx; // from z and x to z and x as (x, z)
    ifs::AffineMap<2> post;
    double linear = 0;   // the amount of `linear`, which leaves z out
    double linear3D = 0; // the amount of `linear3D`
    double weight = 0;
    double opacity = 1;       // of its points
    bool standsStill = false; // in animations, as transforms do that stand for a symmetry
    QList<double> chaos;      // P_ij of its successors; 1 beyond the last
    QString refusal;          // why it is no row of an iterated function system; empty when it is one

    bool isLinked() const {
        return std::ranges::any_of(chaos, [](double link) { return link != 1; });
    }
    bool isSpatial() const { return !(yz == ifs::AffineMap<2>()) || !(zx == ifs::AffineMap<2>()); }

    ifs::AffineMap<2> inPlane() const {
        const double amount = linear + linear3D;
        return post * ifs::AffineMap<2>{amount * coefs.linear, amount * coefs.translation};
    }

    // docs/formats.md, "Flame XML".
    ifs::AffineMap<3> inSpace(bool keepsZ) const {
        const auto within = [](const ifs::AffineMap<2>& map, int first, int second) {
            ifs::AffineMap<3> result;
            const std::array<int, 2> axes{first, second};
            for (int i = 0; i < 2; ++i) {
                for (int k = 0; k < 2; ++k)
                    result.linear(axes[std::size_t(i)], axes[std::size_t(k)]) = map.linear(i, k);
                result.translation[axes[std::size_t(i)]] = map.translation[i];
            }
            return result;
        };
        const ifs::AffineMap<3> xy3 = within(coefs, 0, 1), yz3 = within(yz, 1, 2), zx3 = within(zx, 0, 2);
        const ifs::AffineMap<3> before{zx3.linear * yz3.linear * xy3.linear,
                                       xy3.translation + yz3.translation + zx3.translation};
        const double flat = linear + linear3D;
        const ifs::Vector<3> amounts(flat, flat, keepsZ ? flat : linear3D);
        return within(post, 0, 1) * ifs::AffineMap<3>{amounts.asDiagonal() * before.linear,
                                                      amounts.cwiseProduct(before.translation)};
    }
};

bool areCoefficients(const ifs::AffineMap<3>& map) {
    return (map.linear.array().abs() <= maxCoefficient).all() &&
           (map.translation.array().abs() <= maxCoefficient).all();
}

// A part of the xform that JWildfire has for another plane of space.
bool isPartInSpace(QStringView name) {
    return name == u"yzCoefs" || name == u"zxCoefs";
}

// Its amounts of `linear` and `linear3D`, or the reason why it has other variations.
void readAmounts(const QXmlStreamAttributes& attributes, Xform& xform) {
    QString* refusal = &xform.refusal;
    for (const QXmlStreamAttribute& attribute : attributes) {
        const QStringView name = attribute.name();
        bool ok = false;
        const QList<double> values = numbers(attribute.value(), &ok);
        if (name == u"linear" || name == u"linear3D" || name == u"var1") {
            if (!ok || values.size() != 1)
                *refusal = Text::tr("the amount of “%1” is not a number").arg(name);
            else if (name != u"var1")
                (name == u"linear" ? xform.linear : xform.linear3D) += values.first();
            else if (values.first() == 0)
                xform.linear += 1; // the old form names the variation by its index; 0 is linear
            else
                *refusal = Text::tr("it uses a variation other than linear");
        } else if (name == u"var") {
            if (!ok || values.isEmpty() ||
                std::any_of(values.begin() + 1, values.end(), [](double v) { return v != 0; }))
                *refusal = Text::tr("it uses a variation other than linear");
            else
                xform.linear += values.first();
        } else if (name.endsWith(u"Post")) {
            if (const auto map = affine(attribute.value()); !map || !(*map == ifs::AffineMap<2>()))
                *refusal = Text::tr("it acts in space after its variations (“%1”)").arg(name);
        } else if (isPartInSpace(name)) {
            continue;
        } else if (!isPlainAttribute(name) && ok && values.size() == 1 && values.first() != 0) {
            *refusal = Text::tr("it uses the variation “%1”").arg(name);
        }
        if (!refusal->isEmpty()) return;
    }
}

// The identity where the attribute is missing.
ifs::AffineMap<2> part(const QXmlStreamAttributes& attributes, const char* name, QString* refusal) {
    if (!attributes.hasAttribute(QLatin1String(name))) return {};
    const auto map = affine(attributes.value(QLatin1String(name)));
    if (!map && refusal->isEmpty())
        *refusal = Text::tr("its “%1” is not six numbers").arg(QLatin1String(name));
    return map.value_or(ifs::AffineMap<2>());
}

bool isNumber(const QXmlStreamAttributes& attributes, const char* name, double value) {
    return parseNumber(attributes.value(QLatin1String(name))) == value;
}

Xform readXform(const QXmlStreamAttributes& attributes) {
    Xform xform;
    readAmounts(attributes, xform);
    if (!xform.refusal.isEmpty()) return xform;
    if (!attributes.hasAttribute(QLatin1String("coefs"))) {
        xform.refusal = Text::tr("its “%1” is not six numbers").arg(QStringLiteral("coefs"));
        return xform;
    }
    xform.coefs = part(attributes, "coefs", &xform.refusal);
    xform.yz = part(attributes, "yzCoefs", &xform.refusal);
    xform.zx = part(attributes, "zxCoefs", &xform.refusal);
    xform.post = part(attributes, "post", &xform.refusal);
    if (!xform.refusal.isEmpty()) return xform;
    if (!isCoefficient(xform.inPlane()) || !areCoefficients(xform.inSpace(true))) {
        xform.refusal =
            Text::tr("a number is too large for a coefficient (the largest absolute value is 3.4e38)");
        return xform;
    }
    xform.standsStill = isNumber(attributes, "animate", 0) || isNumber(attributes, "symmetry", 1);
    bool ok = false;
    xform.chaos = numbers(attributes.value(QLatin1String("chaos")), &ok);
    if (!ok || std::ranges::any_of(xform.chaos, [](double v) { return !(v >= 0); }))
        xform.refusal = Text::tr("its “chaos” is not a list of numbers from 0 upwards");
    xform.opacity = parseNumber(attributes.value(QLatin1String("opacity"))).value_or(1);
    if (xform.opacity == 0 || attributes.value(QLatin1String("plotmode")) == u"off") // as flam3
        xform.refusal = Text::tr("it is active but not drawn (opacity 0)");
    if (attributes.hasAttribute(QLatin1String("weight"))) {
        const auto weight = parseNumber(attributes.value(QLatin1String("weight")));
        if (!weight || !isCoefficient(*weight))
            xform.refusal = Text::tr("its weight is not a number");
        else
            xform.weight = *weight;
    }
    return xform;
}

class Reader {
public:
    Reader(const QString& text, FlameAxis axis) : m_xml(text), m_axis(axis) {
        // Nothing a flame needs is declared in a document type: an entity is refused, not expanded.
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
        const bool keepsZ = m_xml.attributes().value(QLatin1String("preserve_z")) == u"1";
        std::vector<Xform> xforms;
        FlameColourReader colours;
        FlameSymmetryReader symmetry;
        colours.readFlame(m_xml.attributes());
        QString refusal;
        m_remarks.clear();
        bool isInXform = false;
        // What is deeper than its children is what a program keeps, such as earlier versions.
        for (int depth = 0; !m_xml.atEnd();) {
            m_xml.readNext();
            if (m_xml.isEndElement() && --depth < 0) break;
            if (!m_xml.isStartElement()) continue;
            if (++depth == 1) isInXform = m_xml.name() == u"xform";
            const bool isRead = depth == 1 || (depth == 2 && isInXform && m_xml.name() == u"motion");
            if (!isRead || !refusal.isEmpty()) continue;
            if (readColours(colours)) {
                if (m_xml.isEndElement()) --depth; // read to its end
            } else if (m_xml.name() == u"xform")
                refusal = addXform(xforms, symmetry);
            else if (m_xml.name() == u"finalxform")
                refusal = Text::tr("it has a final transform");
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
        addEntry({name, std::move(xforms), keepsZ, found.symmetry}, colours);
    }

    QString readSymmetry(FlameSymmetryReader& symmetry) const {
        bool ok = false;
        const int kind = m_xml.attributes().value(QLatin1String("kind")).trimmed().toInt(&ok);
        return ok && symmetry.readKind(kind)
                   ? QString()
                   : Text::tr("its symmetry is not of a kind from −%1 to %1").arg(ifs::maxSymmetryOrder);
    }

    // Whether the element is one of colours alone; that of a transform is read and says false.
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

    // Rows of the matrix, each as long as there are transforms; what a row leaves out is 1.
    static void link(document::System2& system, const std::vector<Xform>& xforms) {
        const std::size_t n = xforms.size();
        std::vector<double> matrix;
        for (const Xform& xform : xforms)
            for (std::size_t j = 0; j < n; ++j)
                matrix.push_back(j < std::size_t(xform.chaos.size()) ? xform.chaos[qsizetype(j)] : 1);
        ifs::setLinks(system, matrix);
    }

    document::Shape<2> planeOf(const std::vector<Xform>& xforms) const {
        document::Shape<2> shape;
        for (std::size_t i = 0; i < xforms.size(); ++i) {
            const ifs::AffineMap<2> map = xforms[i].inPlane();
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

    // What is left of a flame when all of it has been read.
    struct Flame {
        QString name;
        std::vector<Xform> xforms; // that are maps
        bool keepsZ = false;
        ifs::Symmetry<2> symmetry;
    };

    void addEntry(const Flame& flame, const FlameColourReader& colours) {
        const auto& [name, xforms, keepsZ, symmetry] = flame;
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
        // What a collection has no place for in a name goes behind its brace.
        if (document::uniqueName({}, name) != name) fractal.headerComment = name;
        if (std::ranges::any_of(xforms, &Xform::isSpatial))
            fractal.shape = spaceOf(xforms, keepsZ);
        else
            fractal.shape = planeOf(xforms);
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

    // Whole, with a number where another flame has the name.
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
    QSet<QString> m_names;         // case-folded
    QHash<QString, int> m_numbers; // the one to try next behind a name
    document::Problems m_remarks;  // on the weights of the flame at hand
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

// As flam3 adds them: as likely as a map of weight 1, at rest in animations, and without a colour of their
// own.
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
    constexpr int side = 1000; // pixels of the frame that the flame's scale and centre speak of
    attractor::Camera camera;
    camera.width = camera.height = side;
    document::Fractal code = fractal;
    document::plane(code)->cage.reset(); // a flame holds the code; the placement is not part of it
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
    if (!xml.failure) return Reader(xml.text, axis).read();
    document::FractalFile file;
    file.problems << Problem{Problem::Severity::Error, {}, 0, 0, *xml.failure};
    return file;
}

bool looksLikeFlame(const QByteArray& bytes) {
    QByteArray head = bytes.left(4096);
    if (head.startsWith("\xef\xbb\xbf")) head.remove(0, 3);
    head = head.trimmed();
    if (!head.startsWith('<')) return false;
    if (head.contains("<flame") || head.contains("<Flames")) return true;
    QXmlStreamReader xml(bytes); // long comments may come first
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
