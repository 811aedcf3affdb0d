// SPDX-License-Identifier: MIT
#include "io/exchange/flame_xform.h"

#include "document/text/text.h"
#include "io/text/coefficient.h"
#include "io/text/number.h"

#include <QXmlStreamReader>

#include <array>
#include <optional>

namespace io {

namespace {

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

// Attributes of an xform that are not variations.
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

bool areCoefficients(const ifs::AffineMap<3>& map) {
    return (map.linear.array().abs() <= maxCoefficient).all() &&
           (map.translation.array().abs() <= maxCoefficient).all();
}

// A part of the xform that JWildfire has for another plane of space.
bool isPartInSpace(QStringView name) {
    return name == u"yzCoefs" || name == u"zxCoefs";
}

// Reads the amounts of `linear` and `linear3D`, or the reason why there are other variations.
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
                xform.linear += 1; // older form: index of a variation; 0 is linear
            else
                *refusal = Text::tr("it uses a variation other than linear");
        } else if (name == u"var") {
            if (!ok || values.isEmpty() ||
                std::any_of(values.begin() + 1, values.end(), [](double v) { return v != 0; }))
                *refusal = Text::tr("it uses a variation other than linear");
            else
                xform.linear += values.first();
        } else if (name == u"pre_linear" && ok && values.size() == 1) {
            xform.before *= values.first();
        } else if (name == u"flatten" && ok && values.size() == 1) {
            xform.isFlat = values.first() != 0;
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

} // namespace

ifs::AffineMap<2> Xform::inPlane() const {
    const double amount = before * (linear + linear3D);
    return post * ifs::AffineMap<2>{amount * coefs.linear, amount * coefs.translation};
}

ifs::AffineMap<3> Xform::inSpace(bool keepsZ) const {
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
    const ifs::AffineMap<3> first{zx3.linear * yz3.linear * xy3.linear,
                                  xy3.translation + yz3.translation + zx3.translation};
    const double flat = linear + linear3D;
    const ifs::Vector<3> amounts(flat, flat, keepsZ ? flat : linear3D);
    return within(post, 0, 1) *
           ifs::AffineMap<3>{amounts.asDiagonal() * first.linear, amounts.cwiseProduct(first.translation)};
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
    if (xform.isSpatial() && (xform.isFlat || xform.before != 1)) {
        xform.refusal = Text::tr("it uses the variation “%1”")
                            .arg(xform.isFlat ? QStringLiteral("flatten") : QStringLiteral("pre_linear"));
        return xform;
    }
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
    // Same behaviour as flam3.
    if (xform.opacity == 0 || attributes.value(QLatin1String("plotmode")) == u"off")
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

} // namespace io
