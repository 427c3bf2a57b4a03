// What every way of drawing has to show, in numbers worked out by hand: each check draws its own small scene.
#pragma once

#include "draw/frame.h"
#include "draw/settings.h"
#include "environment/environment.h"
#include "scene/scene.h"

#include <functional>

namespace lambent::draw::testing {

/// A way of drawing; the environment may be null.
using Draw = std::function<Frame(const scene::Scene&, const environment::Environment*, const Settings&)>;

/// Texels by every filter and wrap mode, on even and odd sizes, turned and moved, against glTF's and Vulkan's words.
void expect_samplers(const Draw& draw);

/// Each texture of a material does what its slot says, with either set of coordinates, its factor and colours of vertices.
void expect_slots(const Draw& draw);

/// Stretching an instance turns its normals the other way.
void expect_stretched_normals(const Draw& draw);

/// A mirrored instance shows the mirror image of its normal map.
void expect_mirrored_normal_maps(const Draw& draw);

/// Opaque, mask and blend, by alpha of factor, texture and vertices.
void expect_alpha_modes(const Draw& draw);

/// Panes of different colours one behind the other, in the order in which they are met, down to little light.
void expect_panes_in_order(const Draw& draw);

/// A step or a bend inside a surface is an edge from the size on that is said, and not below it.
void expect_edges(const Draw& draw);

/// Looks stand for even parts of a pixel; a surface is lit in the middle of what is seen of it.
void expect_looks(const Draw& draw);

/// Highlights smaller than a pixel that is looked at many times keep their light.
void expect_small_highlights(const Draw& draw);

/// Spots fade between their cones, lamps towards their range.
void expect_lamps(const Draw& draw);

/// Large pixels show the mean of what is behind them, not a point of it.
void expect_backgrounds_to_average(const Draw& draw);

/// A blurred background keeps the light of a sun, whatever the blur.
void expect_blurs_to_keep_light(const Draw& draw);

/// Lights that are taken together stay as wide as they were.
void expect_merged_lamps_to_spread(const Draw& draw);

/// The report's own order of things: its sky, ambient, specular and direct light, in linear and nonlinear colour.
void expect_the_reports_pipeline(const Draw& draw);

/// Its samples show the texels that they read.
void expect_the_reports_blocks(const Draw& draw);

} // namespace lambent::draw::testing
