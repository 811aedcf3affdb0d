// SPDX-License-Identifier: MIT
#include "io/flame.h"

#include "document/unique_names.h"
#include "io/coefficient.h"
#include "io/number.h"
#include "io/written_weights.h"
#include "io/xml_text.h"

#include <QCoreApplication>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

#include <algorithm>
#include <cmath>
#include <optional>

namespace io {

namespace {

using document::Problem;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

constexpr qsizetype maxXforms = 100'000; // per flame
constexpr qsizetype maxFlames = 200'000; // per file
constexpr qsizetype mostRefusals = 100;  // told one by one

QList<double> numbers(QStringView text, bool* ok) {
    QList<double> values;
    *ok = true;
    for (QStringView token : text.split(u' ', Qt::SkipEmptyParts)) {
        const auto value = parseNumber(token);
        if (!value) {
            *ok = false;
            return {};
        }
        values << *value;
    }
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
    ifs::AffineMap<2> map;
    double weight = 0;
    QString refusal; // why it is no row of an iterated function system; empty when it is one
};

// The amount of `linear`, or the reason why the xform has other variations.
double linearAmount(const QXmlStreamAttributes& attributes, QString* refusal) {
    double amount = 0;
    for (const QXmlStreamAttribute& attribute : attributes) {
        const QStringView name = attribute.name();
        bool ok = false;
        const QList<double> values = numbers(attribute.value(), &ok);
        if (name == u"linear" || name == u"linear3D" || name == u"var1") {
            if (!ok || values.size() != 1)
                *refusal = Text::tr("the amount of “%1” is not a number").arg(name);
            else if (name != u"var1")
                amount += values.first();
            else if (values.first() == 0)
                amount += 1; // the old form names the variation by its index; 0 is linear
            else
                *refusal = Text::tr("it uses a variation other than linear");
        } else if (name == u"var") {
            if (!ok || values.isEmpty() ||
                std::any_of(values.begin() + 1, values.end(), [](double v) { return v != 0; }))
                *refusal = Text::tr("it uses a variation other than linear");
            else
                amount += values.first();
        } else if (name.endsWith(u"Coefs") || name.endsWith(u"Post")) {
            *refusal = Text::tr("it acts in space (“%1”)").arg(name);
        } else if (!isPlainAttribute(name) && ok && values.size() == 1 && values.first() != 0) {
            *refusal = Text::tr("it uses the variation “%1”").arg(name);
        }
        if (!refusal->isEmpty()) return 0;
    }
    return amount;
}

Xform readXform(const QXmlStreamAttributes& attributes) {
    Xform xform;
    const double amount = linearAmount(attributes, &xform.refusal);
    if (!xform.refusal.isEmpty()) return xform;
    const auto before = affine(attributes.value(QLatin1String("coefs")));
    if (!before) {
        xform.refusal = Text::tr("its “coefs” are not six numbers");
        return xform;
    }
    xform.map = {amount * before->linear, amount * before->translation};
    if (attributes.hasAttribute(QLatin1String("post"))) {
        const auto post = affine(attributes.value(QLatin1String("post")));
        if (!post) {
            xform.refusal = Text::tr("its “post” is not six numbers");
            return xform;
        }
        xform.map = *post * xform.map;
    }
    if (!isCoefficient(xform.map)) {
        xform.refusal = Text::tr("a number is larger than a coefficient can be (3.4e38 in size)");
        return xform;
    }
    bool ok = false;
    const QList<double> chaos = numbers(attributes.value(QLatin1String("chaos")), &ok);
    if (!ok || std::any_of(chaos.begin(), chaos.end(), [](double v) { return v != 1; }))
        xform.refusal = Text::tr("its “chaos” allows some successors only, which a list of maps cannot say");
    else if (const auto opacity = parseNumber(attributes.value(QLatin1String("opacity")));
             (opacity && *opacity == 0) || attributes.value(QLatin1String("plotmode")) == u"off") // as flam3
        xform.refusal = Text::tr("it takes part without being drawn (opacity 0)");
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
                m_xml.raiseError(Text::tr("a document type is not accepted in a flame file"));
                break;
            }
            if (!m_xml.isStartElement() || m_xml.name() != u"flame") continue;
            if (m_file.entries.size() + m_refused >= maxFlames) {
                report(Problem::Severity::Error, {},
                       Text::tr("The file has more than %1 flames; the rest is left out.").arg(maxFlames));
                break;
            }
            readFlame();
        }
        if (m_xml.hasError()) {
            QString reason = m_xml.errorString();
            if (reason.endsWith(u'.')) reason.chop(1);
            report(Problem::Severity::Error, {}, Text::tr("The XML ends here: %1.").arg(reason));
        } else if (m_file.entries.isEmpty() && m_file.problems.isEmpty())
            report(Problem::Severity::Error, {}, Text::tr("There is no flame in this file."));
        if (m_refused > mostRefusals)
            report(Problem::Severity::Error, {},
                   Text::tr("%1 flames in all are no systems of affine maps.").arg(m_refused));
        return std::move(m_file);
    }

private:
    void report(Problem::Severity severity, const QString& entry, const QString& message) {
        m_file.problems << Problem{severity, entry, int(m_xml.lineNumber()), int(m_xml.columnNumber()) + 1,
                                   message};
    }

    void refuse(const QString& name, const QString& sentence) {
        if (++m_refused <= mostRefusals) report(Problem::Severity::Error, name, sentence);
    }

    void readFlame() {
        const QString name = m_xml.attributes().value(QLatin1String("name")).toString();
        document::System2 system;
        QString refusal;
        m_remarks.clear();
        while (!m_xml.atEnd() && !(m_xml.isEndElement() && m_xml.name() == u"flame")) {
            m_xml.readNext();
            if (!m_xml.isStartElement() || !refusal.isEmpty()) continue;
            if (m_xml.name() == u"xform")
                refusal = addXform(system);
            else if (m_xml.name() == u"finalxform")
                refusal = Text::tr("it has a final transform");
            else if (m_xml.name() == u"symmetry")
                refusal = Text::tr("it adds a symmetry");
            else if (m_xml.name() == u"motion")
                refusal = Text::tr("it has motion");
            else if (m_xml.name() == u"layer")
                refusal = Text::tr("it has layers");
            if (!refusal.isEmpty())
                refuse(name,
                       Text::tr("The flame “%1” is not a system of affine maps: %2.").arg(name, refusal));
        }
        if (!m_xml.hasError() && refusal.isEmpty()) addEntry(name, std::move(system));
    }

    QString addXform(document::System2& system) {
        if (qsizetype(system.maps.size()) >= maxXforms)
            return Text::tr("it has more than %1 transforms").arg(maxXforms);
        const Xform xform = readXform(m_xml.attributes());
        if (!xform.refusal.isEmpty())
            return Text::tr("transform %1: %2").arg(system.maps.size() + 1).arg(xform.refusal);
        if (const auto remark = weightRemark(system.maps.size() + 1, xform.weight);
            remark && m_remarks.size() < 10)
            m_remarks << Problem{Problem::Severity::Warning,
                                 {},
                                 int(m_xml.lineNumber()),
                                 int(m_xml.columnNumber()) + 1,
                                 *remark};
        system.maps.push_back({.id = static_cast<ifs::MapId>(system.maps.size() + 1),
                               .map = m_axis == FlameAxis::Flipped ? flipped(xform.map) : xform.map,
                               .weight = xform.weight});
        return {};
    }

    void addEntry(const QString& name, document::System2 system) {
        if (system.maps.empty()) {
            refuse(name, Text::tr("The flame “%1” has no transforms.").arg(name));
            return;
        }
        document::Fractal fractal;
        fractal.name = m_names.give(name.isEmpty() ? QStringLiteral("flame") : name);
        if (fractal.name != name) fractal.headerComment = name;
        fractal.system = std::move(system);
        document::Entry entry;
        entry.id = static_cast<document::EntryId>(m_file.entries.size() + 1);
        for (Problem& remark : m_remarks)
            remark.entry = fractal.name;
        entry.problems = m_remarks;
        entry.fractal = std::make_shared<const document::Fractal>(std::move(fractal));
        m_file.entries << entry;
    }

    QXmlStreamReader m_xml;
    FlameAxis m_axis;
    document::FractalFile m_file;
    document::UniqueNames m_names;
    document::Problems m_remarks; // on the weights of the flame at hand
    qsizetype m_refused = 0;
};

QString coefficientText(const ifs::AffineMap<2>& map) {
    QByteArrayList parts;
    for (double value : {map.linear(0, 0), map.linear(1, 0), map.linear(0, 1), map.linear(1, 1),
                         map.translation.x(), map.translation.y()})
        parts << formatNumber(value);
    return QString::fromLatin1(parts.join(' '));
}

QString hexPalette(const attractor::Palette& palette) {
    QString text;
    for (int i = 0; i < 256; ++i) {
        const attractor::Rgba colour = attractor::colourAt(palette, i / 255.0);
        if (i % 8 == 0) text += QLatin1String("\n      ");
        for (int channel : {colour.red, colour.green, colour.blue})
            text += QStringLiteral("%1").arg(channel, 2, 16, QLatin1Char('0')).toUpper();
    }
    return text + QLatin1String("\n    ");
}

void writeOne(QXmlStreamWriter& xml, const document::Fractal& fractal, const document::System2& system,
              FlameAxis axis) {
    constexpr int side = 1000; // pixels of the frame that the flame's scale and centre speak of
    attractor::Camera camera;
    camera.width = camera.height = side;
    document::Fractal code = fractal;
    code.cage.reset(); // a flame holds the code; the placement is not part of it
    if (const auto box = document::displayedBox(code)) camera = attractor::fitted(camera, box->min, box->max);
    const double up = axis == FlameAxis::Flipped ? -1 : 1;

    xml.writeStartElement(QStringLiteral("flame"));
    xml.writeAttribute(QStringLiteral("name"), fractal.name);
    xml.writeAttribute(QStringLiteral("version"), QStringLiteral("Barycage"));
    xml.writeAttribute(QStringLiteral("size"), QStringLiteral("%1 %1").arg(side));
    xml.writeAttribute(QStringLiteral("center"), QString::fromLatin1(formatNumber(camera.centre.x()) + ' ' +
                                                                     formatNumber(up * camera.centre.y())));
    xml.writeAttribute(QStringLiteral("scale"), QString::fromLatin1(formatNumber(camera.pixelsPerUnit)));
    xml.writeAttribute(QStringLiteral("background"), QStringLiteral("0 0 0"));

    const std::vector<double> weights = writtenWeights(system);
    const double last = std::max<double>(1, double(system.maps.size()) - 1);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const ifs::AffineMap<2>& map = system.maps[i].map;
        xml.writeEmptyElement(QStringLiteral("xform"));
        xml.writeAttribute(QStringLiteral("weight"), QString::fromLatin1(formatNumber(weights[i])));
        xml.writeAttribute(QStringLiteral("color"), QString::fromLatin1(formatNumber(double(i) / last)));
        xml.writeAttribute(QStringLiteral("linear"), QStringLiteral("1"));
        xml.writeAttribute(QStringLiteral("coefs"),
                           coefficientText(axis == FlameAxis::Flipped ? flipped(map) : map));
    }
    xml.writeStartElement(QStringLiteral("palette"));
    xml.writeAttribute(QStringLiteral("count"), QStringLiteral("256"));
    xml.writeAttribute(QStringLiteral("format"), QStringLiteral("RGB"));
    xml.writeCharacters(hexPalette(fractal.appearance.palette));
    xml.writeEndElement();
    xml.writeEndElement();
}

} // namespace

ifs::AffineMap<2> flipped(ifs::AffineMap<2> map) {
    map.linear(0, 1) = -map.linear(0, 1);
    map.linear(1, 0) = -map.linear(1, 0);
    map.translation.y() = -map.translation.y();
    return map;
}

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
        if (const document::System2* system = document::system2(*fractal))
            writeOne(xml, *fractal, *system, axis);
    xml.writeEndElement();
    return bytes.trimmed() + '\n';
}

} // namespace io
