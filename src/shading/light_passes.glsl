// The light passes. Included after numbers.glsl, all.glsl and the hooks.
#include "shading/lobes/albedo.glsl"
#include "shading/lobes/layers.glsl"
#include "shading/passes/gbuffer.glsl"
#include "shading/passes/mirrors.glsl"
#include "shading/passes/bases.h"
#include "shading/passes/layers.glsl"
#include "shading/passes/light.glsl"
#include "shading/passes/background.glsl"
