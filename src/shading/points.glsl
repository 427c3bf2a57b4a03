// Surface points: code that needs no hooks.
#include "shading/material/material.glsl"
#include "shading/surface/pixel.glsl"
#include "shading/surface/texture.glsl"
#include "shading/surface/surface.glsl"
