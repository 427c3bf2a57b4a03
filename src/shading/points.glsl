// What needs no hooks: a point of a surface.
#include "shading/material/material.glsl"
#include "shading/surface/pixel.glsl"
#include "shading/surface/texture.glsl"
#include "shading/surface/surface.glsl"
