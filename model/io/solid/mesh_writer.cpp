// SPDX-License-Identifier: MIT
#include "io/solid/mesh_writer.h"

#include "document/text/file_names.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <cmath>

namespace io {

namespace {

using namespace Qt::StringLiterals;

using Position = std::array<float, 3>;

// Bytes on their way to a device, little endian.
class Stream {
public:
    Stream(QIODevice& device, const std::stop_token& stop) : m_device(device), m_stop(stop) {}

    template <class Number> void addNumber(Number value) {
        std::array<char, sizeof value> bytes{};
        qToLittleEndian(value, bytes.data());
        addText(QByteArrayView(bytes.data(), qsizetype(bytes.size())));
    }
    void addPosition(const Position& position) {
        for (const float c : position)
            addNumber(c);
    }
    void addText(QByteArrayView text) {
        m_bytes.append(text);
        if (m_bytes.size() >= chunk) flush();
    }
    bool finish() {
        flush();
        return m_isGood;
    }

private:
    static constexpr qsizetype chunk = 1 << 20;

    void flush() {
        m_isGood = m_isGood && !m_stop.stop_requested() && m_device.write(m_bytes) == m_bytes.size();
        m_bytes.clear();
    }

    QIODevice& m_device;
    const std::stop_token& m_stop;
    QByteArray m_bytes;
    bool m_isGood = true;
};

Position positionOf(const PrintableSolid& solid, std::uint32_t point) {
    Position result{};
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = float(solid.origin[Eigen::Index(k)] + solid.unit * double(solid.mesh.points[point][k]));
    return result;
}

void writeStl(const PrintableSolid& solid, const QString& /*name*/, Stream& stream) {
    stream.addText(QByteArray("Barycage: binary STL, millimetres").leftJustified(80, ' '));
    stream.addNumber(quint32(solid.mesh.triangles.size()));
    for (const auto& triangle : solid.mesh.triangles) {
        std::array<ifs::Vector<3>, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& point = solid.mesh.points[triangle[k]];
            p[k] = {double(point[0]), double(point[1]), double(point[2])};
        }
        const ifs::Vector<3> a = p[1] - p[0];
        const ifs::Vector<3> b = p[2] - p[0];
        ifs::Vector<3> normal(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                              a.x() * b.y() - a.y() * b.x());
        normal.normalize();
        stream.addPosition(Position{float(normal.x()), float(normal.y()), float(normal.z())});
        for (const std::uint32_t point : triangle)
            stream.addPosition(positionOf(solid, point));
        stream.addNumber(quint16(0));
    }
}

void writeObj(const PrintableSolid& solid, const QString& name, Stream& stream) {
    constexpr int digits = 9; // all digits of a float
    QString object = document::oneLine(name.simplified());
    // A backslash at the end of a line would join it with the next.
    object.replace(u' ', u'_').replace(u'\\', u'_');
    stream.addText("# Barycage, millimetres\no " + object.toUtf8() + '\n');
    for (std::uint32_t i = 0; i < solid.mesh.points.size(); ++i) {
        QByteArray line = "v";
        for (const float c : positionOf(solid, i))
            line += ' ' + QByteArray::number(double(c), 'g', digits);
        stream.addText(line + '\n');
    }
    for (const auto& triangle : solid.mesh.triangles) {
        QByteArray line = "f";
        for (const std::uint32_t point : triangle)
            line += ' ' + QByteArray::number(point + 1);
        stream.addText(line + '\n');
    }
}

void writePly(const PrintableSolid& solid, const QString& /*name*/, Stream& stream) {
    stream.addText("ply\nformat binary_little_endian 1.0\ncomment Barycage, millimetres\nelement vertex " +
                   QByteArray::number(qulonglong(solid.mesh.points.size())) +
                   "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                   QByteArray::number(qulonglong(solid.mesh.triangles.size())) +
                   "\nproperty list uchar int vertex_indices\nend_header\n");
    for (std::uint32_t i = 0; i < solid.mesh.points.size(); ++i)
        stream.addPosition(positionOf(solid, i));
    for (const auto& triangle : solid.mesh.triangles) {
        stream.addNumber(quint8(3));
        for (const std::uint32_t point : triangle)
            stream.addNumber(qint32(point));
    }
}

QJsonArray arrayOf(const Position& position) {
    return {double(position[0]), double(position[1]), double(position[2])};
}

// The JSON chunk of a scene of one mesh; in the binary chunk stand indices, then positions.
QByteArray sceneOf(const PrintableSolid& solid, const QString& name) {
    constexpr int elementArray = 34963;
    constexpr int array = 34962;
    constexpr int unsignedInt = 5125;
    constexpr int floatNumber = 5126;
    constexpr double metresPerMillimetre = 0.001;
    const auto indexBytes = qint64(12 * solid.mesh.triangles.size());
    const auto positionBytes = qint64(12 * solid.mesh.points.size());
    Position low = positionOf(solid, 0);
    Position high = low;
    for (std::uint32_t i = 0; i < solid.mesh.points.size(); ++i) {
        const Position p = positionOf(solid, i);
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    const QJsonObject stone{{"baseColorFactor"_L1, QJsonArray{0.76, 0.68, 0.55, 1.0}},
                            {"metallicFactor"_L1, 0.0},
                            {"roughnessFactor"_L1, 0.9}};
    const QJsonObject primitive{{"attributes"_L1, QJsonObject{{"POSITION"_L1, 1}}},
                                {"indices"_L1, 0},
                                {"material"_L1, 0},
                                {"mode"_L1, 4}};
    const QJsonObject scene{
        {"asset"_L1, QJsonObject{{"version"_L1, "2.0"_L1}, {"generator"_L1, "Barycage"_L1}}},
        {"scene"_L1, 0},
        {"scenes"_L1, QJsonArray{QJsonObject{{"nodes"_L1, QJsonArray{0}}}}},
        {"nodes"_L1, QJsonArray{QJsonObject{{"mesh"_L1, 0},
                                            {"name"_L1, name},
                                            {"scale"_L1, QJsonArray{metresPerMillimetre, metresPerMillimetre,
                                                                    metresPerMillimetre}}}}},
        {"meshes"_L1, QJsonArray{QJsonObject{{"name"_L1, name}, {"primitives"_L1, QJsonArray{primitive}}}}},
        {"materials"_L1, QJsonArray{QJsonObject{{"pbrMetallicRoughness"_L1, stone}}}},
        {"accessors"_L1, QJsonArray{QJsonObject{{"bufferView"_L1, 0},
                                                {"componentType"_L1, unsignedInt},
                                                {"count"_L1, qint64(3 * solid.mesh.triangles.size())},
                                                {"type"_L1, "SCALAR"_L1}},
                                    QJsonObject{{"bufferView"_L1, 1},
                                                {"componentType"_L1, floatNumber},
                                                {"count"_L1, qint64(solid.mesh.points.size())},
                                                {"type"_L1, "VEC3"_L1},
                                                {"min"_L1, arrayOf(low)},
                                                {"max"_L1, arrayOf(high)}}}},
        {"bufferViews"_L1,
         QJsonArray{QJsonObject{{"buffer"_L1, 0}, {"byteLength"_L1, indexBytes}, {"target"_L1, elementArray}},
                    QJsonObject{{"buffer"_L1, 0},
                                {"byteOffset"_L1, indexBytes},
                                {"byteLength"_L1, positionBytes},
                                {"target"_L1, array}}}},
        {"buffers"_L1, QJsonArray{QJsonObject{{"byteLength"_L1, indexBytes + positionBytes}}}}};
    QByteArray json = QJsonDocument(scene).toJson(QJsonDocument::Compact);
    while (json.size() % 4 != 0)
        json += ' ';
    return json;
}

void writeGlb(const PrintableSolid& solid, const QString& name, Stream& stream) {
    const QByteArray json = sceneOf(solid, name);
    const std::size_t binary = 12 * (solid.mesh.triangles.size() + solid.mesh.points.size());
    constexpr std::size_t headers = 12 + 8 + 8;
    stream.addText("glTF");
    stream.addNumber(quint32(2));
    stream.addNumber(quint32(headers + std::size_t(json.size()) + binary));
    stream.addNumber(quint32(json.size()));
    stream.addText("JSON");
    stream.addText(json);
    stream.addNumber(quint32(binary));
    stream.addText(QByteArrayView("BIN\0", 4));
    for (const auto& triangle : solid.mesh.triangles)
        for (const std::uint32_t point : triangle)
            stream.addNumber(quint32(point));
    for (std::uint32_t i = 0; i < solid.mesh.points.size(); ++i)
        stream.addPosition(positionOf(solid, i));
}

struct MeshKind {
    MeshFormat format;
    const char* title;
    void (*write)(const PrintableSolid& solid, const QString& name, Stream& stream);
};
constexpr MeshKind kinds[] = {
    {MeshFormat::Stl, QT_TRANSLATE_NOOP("Text", "Mesh for 3D printing (.stl)"), writeStl},
    {MeshFormat::Obj, QT_TRANSLATE_NOOP("Text", "Mesh (.obj)"), writeObj},
    {MeshFormat::Glb, QT_TRANSLATE_NOOP("Text", "Mesh (.glb)"), writeGlb},
    {MeshFormat::Ply, QT_TRANSLATE_NOOP("Text", "Mesh (.ply)"), writePly},
};

const MeshKind& kindOf(MeshFormat format) {
    return *std::ranges::find(kinds, format, &MeshKind::format);
}

} // namespace

std::optional<MeshFormat> meshFormat(const QString& suffix) {
    return ifs::named<MeshFormat>(suffix.toLower().toStdString());
}

QString suffixOf(MeshFormat format) {
    return QLatin1String(ifs::nameOf(format));
}

const char* titleOf(MeshFormat format) {
    return kindOf(format).title;
}

bool writeMesh(const PrintableSolid& solid, MeshFormat format, const QString& name, QIODevice& device,
               const std::stop_token& stop) {
    Stream stream(device, stop);
    kindOf(format).write(solid, name, stream);
    return stream.finish();
}

} // namespace io
