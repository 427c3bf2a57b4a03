// The pass that chooses rays. Included after light_passes.glsl.
#include "shading/passes/rays.glsl"
