// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"

#include <vector>

// Tone curve: densities to tones, and vibrancy of colours. docs/mathematics.md, "Density to colour".
namespace attractor {

// v = [ln(1 + κρ) / ln(1 + κρ_w)]^(1/γ), clamped to [0, 1].
double tone(double density, double brightness, double whitePoint, double gamma);
// A tone v with contrast c > 0: v^c / (v^c + (1 − v)^c), which is v itself for c = 1.
double contrasted(double v, double contrast);
// The tone of a density with all that an appearance says of tones.
double tone(double density, const Appearance& appearance, double whitePoint);

// A channel of a colour, a code value f in [0, 1]: νf + (1 − ν)f^(1/γ) with the vibrancy ν, f itself for ν
// = 1.
double vibrant(double code, const Appearance& appearance);

// The same for channels in linear light, from a table: to half a level of 256, for gammas from a half on.
class VibrantCodes {
public:
    VibrantCodes() = default; // no change of colours; operator() must not be called
    explicit VibrantCodes(const Appearance& appearance);

    bool changesColours() const { return !m_codes.empty(); }
    // The code value 0 … 255. Needs changesColours().
    double operator()(double linear) const;

private:
    std::vector<float> m_codes; // indexed by the leading bits of the light as a float; empty: colours stay
};

} // namespace attractor
