// The pass that finds surfaces. Included after numbers.glsl, points.glsl and the hooks.
#include "shading/passes/gbuffer.glsl"
#include "shading/passes/surfaces.glsl"
