// The lobes at the bottom of a material, one for each shading model, for C++ and GLSL alike. Where BASE is defined, a row each:
//   BASE(name, number, layered)
//       `name` and `number`: of the model; `layered`: 1 where the lobes of layers.h may lie over it, else 0
// elsewhere the files that hold them. Each file has a struct Base_name, what the lobe is at a point, and functions of it:
//   base_name(Environment, Fragment, ShinyPoint)             makes it of a fragment
//   direct_base(Environment, Base_name, ShinyPoint, Arrival) what it sends to the viewer of a light without size
//   ambient_base(Environment, Base_name, vec3, Real)         the same of the irradiance around it, times a brightness
//   reflected_base(Environment, Base_name, ShinyPoint)       the same of what it mirrors of the environment
//   level_of_base(Environment, Base_name, ShinyPoint)        the level read in its middle, as a part of the highest
#ifdef BASE
BASE(ggx, 0, 1)
BASE(phong, 1, 0)
#undef BASE
#else
#include "shading/passes/base_ggx.glsl"
#include "shading/passes/base_phong.glsl"
#endif
