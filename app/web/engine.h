// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// The C interface through which web pages draw an entry: model/ifs and model/attractor without Qt. Numbers
// are doubles and small integers, arrays belong to the caller, and nothing throws: whatever is not valid is
// left out of the picture. One engine serves one thread.
#ifdef __EMSCRIPTEN__
#define BARYCAGE_WEB extern "C" __attribute__((used, visibility("default")))
#else
#define BARYCAGE_WEB extern "C"
#endif

namespace web {
struct Engine;
}

// Raised by 1 whenever a function of this header changes its meaning, or is new.
constexpr int webInterface = 2;
// "barycage web engine: interface I, pixels P, hashes H": what a built engine is made from.
BARYCAGE_WEB const char* barycage_versions();

BARYCAGE_WEB web::Engine* barycage_new();
BARYCAGE_WEB void barycage_free(web::Engine* engine);

// The system. A row is the linear part by rows, the translation, and a weight: NaN where none is given. What
// was loaded before is forgotten. Dimension 2, or 3 in an engine that knows space; 0 is returned for others.
BARYCAGE_WEB int barycage_load(web::Engine* engine, int dimension, const double* rows, int maps);
BARYCAGE_WEB void barycage_links(web::Engine* engine, const double* matrix); // maps × maps, row by row
// The group as in ifs::SymmetryGroup; the centre, then the frame by rows. 0 where there is no such symmetry.
BARYCAGE_WEB int barycage_symmetry(web::Engine* engine, int group, int order, double angle,
                                   const double* place);
// A branch that is shown elsewhere: indices of maps, and the change as a row without a weight.
BARYCAGE_WEB void barycage_branch(web::Engine* engine, const int* word, int length, const double* change);

// Computes the extent of the loaded system. Returns whether there is a certified attractor.
BARYCAGE_WEB int barycage_settle(web::Engine* engine);
// Least and greatest coordinates of the attractor, and by how much they may be wrong; then the vertices of
// the minimal canonical simplex: 5 + 6 numbers, or 7 + 12 in space. 0 without an attractor.
BARYCAGE_WEB int barycage_extent(web::Engine* engine, double* box, double* simplex);

// The cage, at rest and as it is dragged, `count` vertices each. Without vertices the system is drawn as it
// is. 0 where the rest vertices hold nothing.
BARYCAGE_WEB int barycage_cage(web::Engine* engine, const double* rest, const double* current, int count,
                               int bends);

// The animation of the loaded entry, from its comment lines, one below the other. `ownsCage`: the cage that
// was set last is stored in the entry. Facts: frames and seconds of its rate, length, last frame,
// animation::Loop; whether keys move the cage, the camera and the look, and whether the picture turns; then
// whether keys move each map: 9 + maps numbers. 0 where no animation is understood: then the entry is still.
BARYCAGE_WEB int barycage_animation(web::Engine* engine, const char* lines, int ownsCage, double* facts);
// The frame that is shown from now on; below 0: the entry at rest. `followsCamera`: where keys set the
// camera, it is theirs, and not that of barycage_camera().
BARYCAGE_WEB void barycage_moment(web::Engine* engine, int frame, int followsCamera);
// What is shown: rows of maps as for barycage_load(), and vertices of the cage. The camera of the keys in the
// plane: centre, height, 1 where y points down, and rotation in radians; that of the picture in space:
// target, directions to the right, up and to the eye, height, and field of view as for barycage_camera(). 0
// where there is no such camera.
BARYCAGE_WEB int barycage_shown(web::Engine* engine, double* rows, double* vertices, double* camera);
// The extent of the system that is shown, roughly, as the box of barycage_extent(). 0 without an attractor.
BARYCAGE_WEB int barycage_reach(web::Engine* engine, double* box);
// Changes the row of a map, as it is shown, into that at rest: what no key moves, without the motions.
BARYCAGE_WEB void barycage_still(web::Engine* engine, int map, double* row);

// The view: the centre and pixels per unit; in space the target, azimuth and elevation in degrees, the height
// of the picture in world units, and the field of view in degrees, 0 for parallel rays.
BARYCAGE_WEB void barycage_camera(web::Engine* engine, int width, int height, const double* view);
// The same camera in the plane turned by radians, and with y down or up.
BARYCAGE_WEB void barycage_turn(web::Engine* engine, double rotation, int isDown);

// colourBy (attractor::ColourBy), brightness, gamma, contrast, vibrancy, supersample, then the plain colour
// and the background as red, green, blue, alpha up to 255.
BARYCAGE_WEB void barycage_appearance(web::Engine* engine, const double* numbers);
// Positions and colours, five numbers for each stop.
BARYCAGE_WEB void barycage_stops(web::Engine* engine, const double* stops, int count);
BARYCAGE_WEB void barycage_map_colour(web::Engine* engine, int map, const double* colour);
BARYCAGE_WEB void barycage_map_blend(web::Engine* engine, int map, double coordinate, double speed);
// Solids: attractor::LookInSpace and SolidColour, azimuth and elevation of the light, fog.
BARYCAGE_WEB void barycage_light(web::Engine* engine, int look, int colour, const double* numbers);

// The visible part of an entry in space: a normal, the lowest and the greatest height along it. A normal of
// 0: everything.
BARYCAGE_WEB void barycage_clip(web::Engine* engine, const double* clip);

// Draws `samples` more points; `begin` drops those before. A solid needs no points and is drawn whole. While
// the exposure is kept, the picture does not flicker during a drag. Returns how many points are drawn.
BARYCAGE_WEB double barycage_draw(web::Engine* engine, double samples, int begin, int keepExposure);
// The last picture: straight (not premultiplied) RGBA, rows from the top, width × height × 4 bytes.
BARYCAGE_WEB const std::uint8_t* barycage_pixels(web::Engine* engine);
// FNV-1a of its premultiplied 0xAARRGGBB pixels, lowest byte first: the low or the high half.
BARYCAGE_WEB std::uint32_t barycage_hash(web::Engine* engine, int high);

// The palettes that come with the program.
BARYCAGE_WEB int barycage_palettes();
BARYCAGE_WEB const char* barycage_palette_name(int palette);
BARYCAGE_WEB int barycage_palette_stops(int palette, double* stops); // room for 5 × 64 numbers
