// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/fractint/animation_comments.h"
#include "io/fractint/appearance_comments.h"
#include "io/fractint/blend_comments.h"
#include "io/fractint/label_comments.h"
#include "io/fractint/link_comments.h"
#include "io/fractint/symmetry_comments.h"
#include "io/fractint/typed_comments.h"
#include "notation/lines/space_lines.h"

#include <QByteArrayList>
#include <QByteArrayView>
#include <QStringList>

#include <vector>

// Parts of a fractal without a place in a Fractint entry (cage, appearance, maps that are off), in comment
// lines "; barycage: key values". docs/formats.md, "Barycage's comment lines".
namespace io {

// Lines without line ends, each under 70 bytes; none when everything is as in a new entry.
QByteArrayList metadataComments(const document::Fractal& fractal);

// The fractal as it comes back after being written and read: maps renumbered in their order, colours and
// labels of maps that are gone dropped, texts cut to what a line can hold.
document::Fractal asStored(document::Fractal fractal);

// Returns true if a comment (the text after the semicolon) is one of ours, whatever its key, apart from those
// that stay among the comments (document/tops/kept_theft.h).
bool isOwnComment(QByteArrayView comment);

// Collects the lines of one entry, then gives their values to the fractal that was read from its rows.
class MetadataComments {
public:
    // False when the key or its values are not understood: such a line is kept as it is.
    bool read(QByteArrayView comment);

    struct Outcome {
        QStringList sentences; // one sentence for each part that did not fit the system
        // Own comments that are kept as they are, counted from 0 among those read, ascending: lines of a cage
        // or a branch that is not of the system's dimension, and of an animation or a symmetry that is not
        // valid.
        std::vector<std::size_t> kept;
    };
    // Needs the system in place. Of an entry that could not be read, the cage, all branches, the symmetry and
    // the animation are kept.
    Outcome applyTo(document::Fractal& fractal) const;

private:
    using Lines = std::vector<std::size_t>; // 0-based indices of the own comments read

    struct Point {
        std::vector<double> coordinates;
        Lines lines;
        bool isOpen = false; // true if the last line announces further coordinates

        std::size_t dimension() const { return isOpen ? 0 : coordinates.size(); }
    };
    struct Branch {
        std::vector<int> word; // 1-based maps; 0 first: document::recurs()
        Lines lines;           // lines of the word
        std::vector<Point> by; // rows of the linear part, then the translation
    };
    struct MapSetting {
        int map = 0; // 1-based; 0: all maps
        std::optional<double> weight;
        attractor::Rgba colour;
    };
    bool readPoint(const QByteArrayList& values, std::vector<Point>& points) const;
    bool readSetting(const QByteArray& key, const QByteArrayList& values);
    bool readMapSetting(const QByteArray& key, const QByteArrayList& values);
    bool readBranch(const QByteArray& key, const QByteArrayList& values);
    template <int Dim> void applyCage(document::Shape<Dim>& shape, Outcome& outcome) const;
    template <int Dim> void applyBranches(document::Shape<Dim>& shape, Outcome& outcome) const;
    template <int Dim>
    void applyToMaps(ifs::IteratedFunctionSystem<Dim>& system, attractor::MapColours& colours,
                     QStringList& sentences) const;

    std::size_t m_ownComments = 0; // number read so far
    std::vector<Point> m_rest;
    std::vector<Point> m_current;
    ifs::Deformation m_deformation = ifs::Deformation::Bend;
    Lines m_deformationLines;
    std::vector<Branch> m_branches;
    SymmetryComments m_symmetry;
    LabelComments m_labels;
    BlendComments m_blends;
    AnimationComments m_animations;
    LinkComments m_links;
    TypedComments m_typed;
    AppearanceComments m_colouring;
    notation::SpaceReader m_inSpace;
    std::vector<MapSetting> m_colours;
    std::vector<MapSetting> m_off;
    std::vector<MapSetting> m_unweighted;
    std::vector<MapSetting> m_weights;
};

} // namespace io
