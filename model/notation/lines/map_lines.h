// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"
#include "ifs/system/iterated_function_system.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

// What the rows of an entry cannot say of its maps, in comment lines: weights of maps that are off, symmetry,
// links, typed coefficients. docs/formats.md, "Barycage's comment lines".
namespace notation {

// And the colours that maps have been given.
template <int Dim>
std::vector<std::string> weightLines(const ifs::IteratedFunctionSystem<Dim>& system,
                                     const attractor::MapColours& colours);
template <int Dim> std::vector<std::string> symmetryLines(const ifs::Symmetry<Dim>& symmetry);
template <int Dim> std::vector<std::string> linkLines(const ifs::IteratedFunctionSystem<Dim>& system);
template <int Dim> std::vector<std::string> typedLines(const ifs::IteratedFunctionSystem<Dim>& system);

// Collects the lines of one entry.
class MapReader {
public:
    // False when the key is another one, or the values are not understood.
    bool read(const std::string& key, const std::vector<std::string>& values);
    // Needs the rows in place. What does not fit them is left out.
    template <int Dim> void applyTo(ifs::IteratedFunctionSystem<Dim>& system) const;

private:
    struct Setting {
        int map = 0; // 1-based; 0: all maps
        std::optional<double> weight;
    };
    struct Typed {
        std::size_t map = 0; // 1-based
        int which = 0;
        std::string text;
    };
    bool readWeight(const std::string& key, const std::vector<std::string>& values);
    bool readSymmetry(const std::string& key, const std::vector<std::string>& values);
    bool readNumbers(const std::vector<std::string>& values, std::vector<double>& numbers);
    bool readLinks(const std::vector<std::string>& values);
    bool readTyped(const std::vector<std::string>& values);
    template <int Dim> void applyWeights(ifs::IteratedFunctionSystem<Dim>& system) const;
    template <int Dim> void applySymmetry(ifs::IteratedFunctionSystem<Dim>& system) const;
    template <int Dim> std::optional<ifs::Symmetry<Dim>> symmetry() const;
    void applyLinks(ifs::IteratedFunctionSystem<2>& system) const;

    std::vector<Setting> m_off;
    std::vector<Setting> m_unweighted;
    std::vector<Setting> m_weights;
    std::string m_symmetry; // name of the symmetry
    bool m_isSymmetryUnderstood = true;
    std::vector<double> m_centre;
    std::vector<double> m_frame;               // row by row
    std::map<int, std::vector<double>> m_rows; // links by 1-based map
    std::vector<Typed> m_typed;
};

} // namespace notation
