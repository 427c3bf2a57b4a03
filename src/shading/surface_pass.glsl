// The pass that finds surfaces. Included after numbers.glsl, points.glsl and the hooks.
#include "shading/lobes/albedo.glsl"
#include "shading/lobes/layers.glsl"
#include "shading/passes/bases.glsl"
#include "shading/passes/gbuffer.glsl"
#include "shading/passes/surfaces.glsl"
