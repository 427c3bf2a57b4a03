#include "ambient.glsl"
#include "direct.glsl"
#include "specular_ggx.glsl"
#include "specular_phong.glsl"
