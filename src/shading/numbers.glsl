// What C++ and shaders agree on, before anything else of this folder.
#include "shading/choices.glsl"
#include "shading/material/numbers.glsl"
#include "shading/columns.glsl"
