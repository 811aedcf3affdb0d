// SPDX-License-Identifier: MIT
#include "io/exports/recipe_json.h"

#include "ifs/names.h"

#include <QJsonArray>

#include <array>
#include <cstddef>

namespace io {

namespace {

template <class Value, std::size_t Count> using Names = std::array<ifs::Named<Value>, Count>;

constexpr Names<PictureFormat::Depth, 2> depths{
    {{PictureFormat::Depth::Bits8, "8"}, {PictureFormat::Depth::Bits16, "16"}}};
constexpr Names<ShapeStyle, 3> styles{
    {{ShapeStyle::Structured, "copies"}, {ShapeStyle::Outline, "outline"}, {ShapeStyle::Points, "points"}}};
constexpr Names<attractor::YAxis, 2> axes{{{attractor::YAxis::Up, "up"}, {attractor::YAxis::Down, "down"}}};
using Projection = attractor::OrbitCamera::Projection;
constexpr Names<Projection, 2> projections{
    {{Projection::Orthographic, "orthographic"}, {Projection::Perspective, "perspective"}}};

template <class Value, std::size_t Count>
QString nameOf(const Names<Value, Count>& names, const Value& wanted) {
    for (const auto& [value, name] : names)
        if (value == wanted) return QLatin1String(name);
    return {};
}

// Reads fields one after another; a single wrong field makes all of it wrong.
class Fields {
public:
    explicit Fields(const QJsonObject& json) : m_json(json) {}
    bool areRight() const { return m_areRight; }

    void read(const char* key, double& value) {
        const QJsonValue found = at(key);
        check(found.isDouble());
        value = found.toDouble();
    }
    void read(const char* key, int& value) {
        constexpr int none = -1'000'000;
        value = at(key).toInt(none); // none for fractions, too
        check(value != none);
    }
    void read(const char* key, bool& value) {
        const QJsonValue found = at(key);
        check(found.isBool());
        value = found.toBool();
    }
    template <class Value, std::size_t Count>
    void read(const char* key, Value& value, const Names<Value, Count>& names) {
        const QString wanted = at(key).toString();
        bool isKnown = false;
        for (const auto& [known, name] : names)
            if (wanted == QLatin1String(name)) {
                value = known;
                isKnown = true;
            }
        check(isKnown);
    }
    template <class Vector> void readVector(const char* key, Vector& vector, int size) {
        const QJsonArray numbers = at(key).toArray();
        check(numbers.size() == size);
        for (int i = 0; i < size && m_areRight; ++i) {
            check(numbers[i].isDouble());
            vector[i] = numbers[i].toDouble();
        }
    }
    void read(const char* key, CageVisibility& cage) {
        bool isShown = false;
        read(key, isShown);
        cage = isShown ? CageVisibility::Shown : CageVisibility::Hidden;
    }

private:
    QJsonValue at(const char* key) const { return m_json.value(QLatin1String(key)); }
    void check(bool isRight) { m_areRight = m_areRight && isRight; }

    const QJsonObject& m_json;
    bool m_areRight = true;
};

QJsonObject cameraJson(const attractor::Camera& camera) {
    QJsonObject json{{QStringLiteral("centre"), QJsonArray{camera.centre.x(), camera.centre.y()}},
                     {QStringLiteral("pixelsPerUnit"), camera.pixelsPerUnit},
                     {QStringLiteral("width"), camera.width},
                     {QStringLiteral("height"), camera.height},
                     {QStringLiteral("yAxis"), nameOf(axes, camera.yAxis)}};
    if (camera.rotation != 0) json.insert(QStringLiteral("rotation"), attractor::degreesOf(camera.rotation));
    return json;
}

bool read(const QJsonObject& json, attractor::Camera& camera) {
    Fields fields(json);
    fields.readVector("centre", camera.centre, 2);
    fields.read("pixelsPerUnit", camera.pixelsPerUnit);
    fields.read("width", camera.width);
    fields.read("height", camera.height);
    fields.read("yAxis", camera.yAxis, axes);
    if (json.contains(QLatin1String("rotation"))) {
        double degrees = 0;
        fields.read("rotation", degrees);
        camera.rotation = attractor::rotationOf(degrees);
    }
    return fields.areRight();
}

QJsonObject cameraJson(const attractor::OrbitCamera& camera) {
    const auto turned = camera.orientation.coeffs();
    return {{QStringLiteral("target"), QJsonArray{camera.target.x(), camera.target.y(), camera.target.z()}},
            {QStringLiteral("orientation"), QJsonArray{turned[0], turned[1], turned[2], turned[3]}},
            {QStringLiteral("height"), camera.height},
            {QStringLiteral("projection"), nameOf(projections, camera.projection)},
            {QStringLiteral("fieldOfView"), camera.fieldOfView},
            {QStringLiteral("screen"), QJsonArray{camera.size.width, camera.size.height}}};
}

bool read(const QJsonObject& json, attractor::OrbitCamera& camera) {
    Fields fields(json);
    double screen[2] = {};
    fields.readVector("target", camera.target, 3);
    fields.readVector("orientation", camera.orientation.coeffs(), 4);
    fields.read("height", camera.height);
    fields.read("projection", camera.projection, projections);
    fields.read("fieldOfView", camera.fieldOfView);
    fields.readVector("screen", screen, 2);
    constexpr double maxSide = 1e6;
    for (const double side : screen)
        if (!(side >= 1 && side <= maxSide)) return false;
    camera.size = {int(screen[0]), int(screen[1])};
    return fields.areRight();
}

QJsonObject jsonOf(const PixelRecipe& recipe) {
    return {{QStringLiteral("kind"), QStringLiteral("pixels")},
            {QStringLiteral("camera"), cameraJson(recipe.camera)},
            {QStringLiteral("file"), nameOf(ifs::names<PictureFile>, recipe.file)},
            {QStringLiteral("depth"), nameOf(depths, recipe.depth)},
            {QStringLiteral("samplesPerPixel"), recipe.samplesPerPixel},
            {QStringLiteral("supersample"), recipe.supersample},
            {QStringLiteral("dotsPerInch"), recipe.dotsPerInch},
            {QStringLiteral("cage"), recipe.cage == CageVisibility::Shown},
            {QStringLiteral("transparent"), recipe.isTransparent}};
}

bool read(const QJsonObject& json, PixelRecipe& recipe) {
    Fields fields(json);
    fields.read("file", recipe.file, ifs::names<PictureFile>);
    fields.read("depth", recipe.depth, depths);
    fields.read("samplesPerPixel", recipe.samplesPerPixel);
    fields.read("supersample", recipe.supersample);
    fields.read("dotsPerInch", recipe.dotsPerInch);
    fields.read("cage", recipe.cage);
    fields.read("transparent", recipe.isTransparent);
    return fields.areRight() && read(json.value(QLatin1String("camera")).toObject(), recipe.camera);
}

QJsonObject jsonOf(const ShapeRecipe& recipe) {
    QJsonObject json{{QStringLiteral("kind"), QStringLiteral("shapes")},
                     {QStringLiteral("camera"), cameraJson(recipe.camera)},
                     {QStringLiteral("file"), nameOf(ifs::names<ShapeFile>, recipe.file)},
                     {QStringLiteral("style"), nameOf(styles, recipe.style)},
                     {QStringLiteral("levels"), recipe.depth.value_or(-1)}, // −1: as many as a pixel needs
                     {QStringLiteral("points"), recipe.points},
                     {QStringLiteral("cage"), recipe.cage == CageVisibility::Shown},
                     {QStringLiteral("transparent"), recipe.isTransparent}};
    if (recipe.dotsPerInch != pixelsOfSvg) json.insert(QStringLiteral("dotsPerInch"), recipe.dotsPerInch);
    return json;
}

bool read(const QJsonObject& json, ShapeRecipe& recipe) {
    Fields fields(json);
    int levels = 0;
    fields.read("file", recipe.file, ifs::names<ShapeFile>);
    fields.read("style", recipe.style, styles);
    fields.read("levels", levels);
    fields.read("points", recipe.points);
    if (json.contains(QLatin1String("dotsPerInch"))) fields.read("dotsPerInch", recipe.dotsPerInch);
    fields.read("cage", recipe.cage);
    fields.read("transparent", recipe.isTransparent);
    if (levels != -1) recipe.depth = levels;
    return fields.areRight() && read(json.value(QLatin1String("camera")).toObject(), recipe.camera);
}

QJsonObject jsonOf(const SpaceRecipe& recipe) {
    QJsonObject json{{QStringLiteral("kind"), QStringLiteral("space")},
                     {QStringLiteral("camera"), cameraJson(recipe.camera)},
                     {QStringLiteral("width"), recipe.size.width},
                     {QStringLiteral("height"), recipe.size.height},
                     {QStringLiteral("file"), nameOf(ifs::names<PictureFile>, recipe.file)},
                     {QStringLiteral("depth"), nameOf(depths, recipe.depth)},
                     {QStringLiteral("stereo"), nameOf(ifs::names<Stereo>, recipe.stereo)},
                     {QStringLiteral("supersample"), recipe.supersample},
                     {QStringLiteral("dotsPerInch"), recipe.dotsPerInch},
                     {QStringLiteral("transparent"), recipe.isTransparent},
                     {QStringLiteral("cage"), recipe.showsCage}};
    if (recipe.page) json.insert(QStringLiteral("page"), nameOf(ifs::names<ShapeFile>, *recipe.page));
    return json;
}

bool read(const QJsonObject& json, SpaceRecipe& recipe) {
    Fields fields(json);
    fields.read("width", recipe.size.width);
    fields.read("height", recipe.size.height);
    fields.read("file", recipe.file, ifs::names<PictureFile>);
    fields.read("depth", recipe.depth, depths);
    fields.read("stereo", recipe.stereo, ifs::names<Stereo>);
    fields.read("supersample", recipe.supersample);
    fields.read("dotsPerInch", recipe.dotsPerInch);
    fields.read("transparent", recipe.isTransparent);
    if (json.contains(QLatin1String("cage"))) fields.read("cage", recipe.showsCage); // older ones have none
    if (json.contains(QLatin1String("page")))
        fields.read("page", recipe.page.emplace(), ifs::names<ShapeFile>);
    return fields.areRight() && read(json.value(QLatin1String("camera")).toObject(), recipe.camera);
}

QJsonObject jsonOf(const BodyRecipe& recipe) {
    return {{QStringLiteral("kind"), QStringLiteral("body")},
            {QStringLiteral("format"), nameOf(ifs::names<MeshFormat>, recipe.format)},
            {QStringLiteral("longest"), recipe.longest},
            {QStringLiteral("resolution"), recipe.resolution},
            {QStringLiteral("wall"), recipe.wall},
            {QStringLiteral("fills"), recipe.fillsCavities}};
}

bool read(const QJsonObject& json, BodyRecipe& recipe) {
    Fields fields(json);
    fields.read("format", recipe.format, ifs::names<MeshFormat>);
    fields.read("longest", recipe.longest);
    fields.read("resolution", recipe.resolution);
    fields.read("wall", recipe.wall);
    fields.read("fills", recipe.fillsCavities);
    return fields.areRight();
}

template <class Recipe> std::optional<ExportRecipe> recipeOf(const QJsonObject& json) {
    Recipe recipe;
    return read(json, recipe) ? std::optional<ExportRecipe>(recipe) : std::nullopt;
}

} // namespace

QJsonObject recipeJson(const ExportRecipe& recipe) {
    return std::visit([](const auto& one) { return jsonOf(one); }, recipe);
}

std::optional<ExportRecipe> recipeIn(const QJsonObject& json) {
    const QString kind = json.value(QLatin1String("kind")).toString();
    if (kind == QLatin1String("pixels")) return recipeOf<PixelRecipe>(json);
    if (kind == QLatin1String("shapes")) return recipeOf<ShapeRecipe>(json);
    if (kind == QLatin1String("space")) return recipeOf<SpaceRecipe>(json);
    if (kind == QLatin1String("body")) return recipeOf<BodyRecipe>(json);
    return std::nullopt;
}

} // namespace io
