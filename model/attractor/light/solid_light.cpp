// SPDX-License-Identifier: MIT
#include "attractor/light/solid_light.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"
#include "attractor/kernels/kernels.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace attractor {

namespace {

constexpr Occlusion stoneOcclusion{4, 14, {0.2, 0.35, 0.45}};
constexpr Occlusion inkOcclusion{4, 8, {0.35, 0.35, 0.3}};
constexpr float stoneHeadShare = 0.4F;
constexpr float inkHeadShare = 1;

constexpr int minBandRows = 64; // a band also reads 26 rows around it

bool isLit(Look look) {
    return look == Look::Stone || look == Look::Ink;
}

const Occlusion& occlusionOf(Look look) {
    return look == Look::Ink ? inkOcclusion : stoneOcclusion;
}

ViewVector unit(const ViewVector& v) {
    const double length =
        std::sqrt(double{v.right} * v.right + double{v.up} * v.up + double{v.towards} * v.towards);
    if (!(length > 0) || !std::isfinite(length)) return {};
    return {static_cast<float>(v.right / length), static_cast<float>(v.up / length),
            static_cast<float>(v.towards / length)};
}

std::uint16_t share16(double share) {
    return static_cast<std::uint16_t>(std::clamp(share, 0.0, 1.0) * 65535 + 0.5);
}

std::uint32_t premultiplied(const Rgba& colour) {
    const std::uint32_t alpha = colour.alpha;
    const auto channel = [&](std::uint32_t value) { return (value * alpha + 127) / 255; };
    return alpha << 24 | channel(colour.red) << 16 | channel(colour.green) << 8 | channel(colour.blue);
}

Rgba16 wide(const Rgba& colour) {
    const auto channel = [](std::uint8_t value) { return static_cast<std::uint16_t>(value * 257); };
    return {channel(colour.red), channel(colour.green), channel(colour.blue), channel(colour.alpha)};
}

Rgba16 wide(const LinearColour& colour) {
    const auto channel = [](double linear) {
        return share16(encodedFromLinear(std::clamp(linear, 0.0, 1.0)));
    };
    return {channel(colour.red), channel(colour.green), channel(colour.blue), 65535};
}

// Composited as every viewer composites: in code values.
Rgba16 mixed(const Rgba16& front, const Rgba16& back, double share) {
    const double before = share * (front.alpha / 65535.0);
    const double behind = (1 - share) * (back.alpha / 65535.0);
    const double alpha = before + behind;
    if (!(alpha > 0)) return {};
    const auto channel = [&](std::uint16_t a, std::uint16_t b) {
        return static_cast<std::uint16_t>((before * a + behind * b) / alpha + 0.5);
    };
    return {channel(front.red, back.red), channel(front.green, back.green), channel(front.blue, back.blue),
            share16(alpha)};
}

// (n + 1)/2 of the full scale.
Rgba16 normalColour(float right, float up) {
    const double p = std::clamp(right, -1e6F, 1e6F), q = std::clamp(up, -1e6F, 1e6F);
    const double length = std::sqrt(p * p + q * q + 1);
    return {share16((p / length + 1) / 2), share16((q / length + 1) / 2), share16((1 / length + 1) / 2),
            65535};
}

Rgba16 depthColour(std::int32_t code) {
    const auto grey =
        static_cast<std::uint16_t>(65535 - static_cast<std::uint64_t>(code) * 65535 / maxDepthCode);
    return {grey, grey, grey, 65535};
}

std::uint32_t narrow(const Rgba16& colour) { // ignores alpha
    const auto channel = [](std::uint32_t value) { return (value * 255 + 32767) / 65535; };
    return 0xFF000000U | channel(colour.red) << 16 | channel(colour.green) << 8 | channel(colour.blue);
}

} // namespace

// Numbers of the pixels of a row, from its first.
struct SolidLight::Band {
    explicit Band(int width) : light(padded(width)), tints(padded(width)) {}
    static std::size_t padded(int width) { return static_cast<std::size_t>(width) + 16; }
    std::vector<float> light;
    std::vector<std::int32_t> tints;
};

SolidLight::SolidLight(const SolidAppearance& appearance, const SolidView& view)
    : m_appearance(appearance), m_view(view) {
    heedEnvironment();
    m_appearance.keyLight = unit(appearance.keyLight);
    if (isLit(appearance.look)) m_ramp = solidRamp(appearance);
    if (!(appearance.fog > 0)) return;
    const double fog = std::min(appearance.fog, 1000.0);
    for (std::size_t k = 0; k < kernels::fogSize; ++k) {
        const double clear = exponential(-fog * static_cast<double>(k) / (kernels::fogSize - 1));
        m_clear.push_back(static_cast<std::int32_t>(clear * kernels::fullClear + 0.5));
    }
}

const float* SolidLight::light(const SurfaceRow& row, Band& band) const {
    const float headShare = m_appearance.look == Look::Ink ? inkHeadShare : stoneHeadShare;
    kernels::illuminate(row.right, row.up, row.shade, {m_appearance.keyLight, headShare},
                        static_cast<std::size_t>(row.end - row.first), band.light.data());
    return band.light.data();
}

void SolidLight::heightTints(const DepthRaster& raster, const SurfaceRow& row, int y,
                             std::vector<std::int32_t>& tints) const {
    const ViewVector& upward = m_view.upward;
    const double perCode = (raster.far - raster.near) / maxDepthCode;
    const double above = (raster.height / 2.0 - y - 0.5) * m_view.unitsPerPixel;
    for (int x = row.first; x < row.end; ++x) {
        const auto at = static_cast<std::size_t>(x - row.first);
        const double depth = raster.near + perCode * std::min<std::int32_t>(row.codes[at], maxDepthCode);
        const double right = (x + 0.5 - raster.width / 2.0) * m_view.unitsPerPixel;
        const double wider = 1 + depth / m_view.eyeDistance;
        const double unshifted = right - m_view.eyeShift * depth / wider;
        const double height = (unshifted * upward.right + above * upward.up) * wider - depth * upward.towards;
        const double share = (height - m_view.lowest) / (m_view.highest - m_view.lowest);
        tints[at] = share > 0 ? static_cast<std::int32_t>(std::min(share, 1.0) * (tintCount - 1) + 0.5) : 0;
    }
}

void SolidLight::tints(const DepthRaster& raster, const SurfaceRow& row, int y,
                       std::vector<std::int32_t>& tints) const {
    const std::uint32_t* keys = raster.row(y) + row.first;
    const auto count = static_cast<std::size_t>(row.end - row.first);
    switch (m_appearance.colourBy) {
    case SolidColour::Plain:
        break; // all further values are 0
    case SolidColour::Map:
    case SolidColour::Address:
        for (std::size_t k = 0; k < count; ++k)
            tints[k] = colourIndex(keys[k]);
        break;
    case SolidColour::Depth:
        for (std::size_t k = 0; k < count; ++k)
            tints[k] = static_cast<std::int32_t>(keys[k] >> 24);
        break;
    case SolidColour::Height:
        heightTints(raster, row, y, tints);
        break;
    }
}

void SolidLight::apply(const DepthRaster& raster, int firstRow, int endRow,
                       std::span<std::uint32_t> pixels) const {
    const std::uint32_t ground = premultiplied(m_appearance.background);
    const auto width = static_cast<std::size_t>(raster.width);
    SurfaceRows rows(raster, m_view.unitsPerPixel, occlusionOf(m_appearance.look), firstRow);
    Band band(raster.width);
    const kernels::Ramp ramp{m_ramp.pixels.data(), m_ramp.levels, ground};
    for (int y = firstRow; y < endRow; ++y) {
        const SurfaceRow row = rows.next();
        std::uint32_t* const first = pixels.data() + static_cast<std::size_t>(y - firstRow) * width;
        std::fill(first, first + row.first, ground);
        std::fill(first + row.end, first + width, ground);
        const auto count = static_cast<std::size_t>(row.end - row.first);
        if (count == 0) continue;
        std::uint32_t* const out = first + row.first;
        if (isLit(m_appearance.look)) {
            tints(raster, row, y, band.tints);
            kernels::paint(row.codes, light(row, band), band.tints.data(), ramp, count, out);
        } else {
            for (std::size_t k = 0; k < count; ++k)
                out[k] = row.codes[k] == kernels::emptyDepth ? ground : narrow(surfaceColour(row, k, band));
        }
        // Empty pixels mix ground with ground.
        if (!m_clear.empty() && isLit(m_appearance.look))
            kernels::addFog(row.codes, m_clear.data(), ground, count, out);
    }
}

Rgba16 SolidLight::surfaceColour(const SurfaceRow& row, std::size_t at, const Band& band) const {
    if (m_appearance.look == Look::Depth) return depthColour(row.codes[at]);
    if (m_appearance.look == Look::Normals) return normalColour(row.right[at], row.up[at]);
    const auto tint = static_cast<std::size_t>(band.tints[at]);
    const Rgba16 colour =
        wide(litColour(m_appearance.look, m_ramp.tints[tint], static_cast<double>(band.light[at])));
    if (m_clear.empty()) return colour;
    const auto clear = m_clear[static_cast<std::size_t>(row.codes[at]) >> kernels::fogShift];
    return mixed(colour, wide(m_appearance.background), clear / double{kernels::fullClear});
}

void SolidLight::apply(const DepthRaster& raster, int firstRow, int endRow, std::span<Rgba16> pixels) const {
    const Rgba16 ground = wide(m_appearance.background);
    const auto width = static_cast<std::size_t>(raster.width);
    SurfaceRows rows(raster, m_view.unitsPerPixel, occlusionOf(m_appearance.look), firstRow);
    Band band(raster.width);
    for (int y = firstRow; y < endRow; ++y) {
        const SurfaceRow row = rows.next();
        Rgba16* const out = pixels.data() + static_cast<std::size_t>(y - firstRow) * width;
        std::fill(out, out + width, ground);
        if (row.first == row.end) continue;
        if (isLit(m_appearance.look)) {
            tints(raster, row, y, band.tints);
            light(row, band);
        }
        for (int x = row.first; x < row.end; ++x) {
            const auto at = static_cast<std::size_t>(x - row.first);
            if (row.codes[at] != kernels::emptyDepth) out[x] = surfaceColour(row, at, band);
        }
    }
}

std::vector<std::uint32_t> lit(const DepthRaster& raster, const SolidAppearance& appearance,
                               const SolidView& view, Workers& workers) {
    const SolidLight light(appearance, view);
    std::vector<std::uint32_t> pixels(raster.keys.size());
    const int team = static_cast<int>(workers.size());
    const int bands = std::clamp(raster.height / minBandRows, 1, team == 1 ? 1 : 4 * team);
    std::atomic<int> next = 0;
    workers.run([&](std::size_t) {
        for (int band = next++; band < bands; band = next++) {
            const int first = raster.height * band / bands, end = raster.height * (band + 1) / bands;
            const auto at = static_cast<std::size_t>(first) * static_cast<std::size_t>(raster.width);
            light.apply(raster, first, end, std::span(pixels).subspan(at));
        }
    });
    return pixels;
}

void depthValues(const DepthRaster& raster, int firstRow, int endRow, std::span<std::uint16_t> values) {
    const auto width = static_cast<std::size_t>(raster.width);
    const std::span keys(raster.row(firstRow), static_cast<std::size_t>(endRow - firstRow) * width);
    std::ranges::transform(keys, values.begin(), [](std::uint32_t key) {
        const std::uint64_t code = std::min(depthCode(key), maxDepthCode);
        return key == emptyKey ? std::uint16_t{65535}
                               : static_cast<std::uint16_t>((code * 65534 + maxDepthCode / 2) / maxDepthCode);
    });
}

} // namespace attractor
