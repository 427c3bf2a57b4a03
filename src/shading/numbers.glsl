// Constants shared by C++ and shaders. Included before all other files of this folder.
#include "shading/choices.glsl"
#include "shading/material/numbers.glsl"
#include "shading/columns.glsl"
