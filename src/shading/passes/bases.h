// The base of a material, its lowest lobe, of each shading model, for C++ and GLSL. If BASE is defined, a row for each:
//   BASE(name, number, layered)
//       `name` and `number`: of the model; `layered`: 1 if the lobes of lobes/layers.h may lie over it, else 0
// Otherwise the files that define them. Each file has a struct Base_name, the base at a point, and these functions:
//   base_name(Environment, Fragment, ShinyPoint)             the base of a fragment
//   direct_base(Environment, Base_name, ShinyPoint, Arrival) light of a source without size that it reflects
//   ambient_base(Environment, Base_name, vec3, Real)         irradiance that it reflects, times a brightness
//   reflected_base(Environment, Base_name, ShinyPoint)       light of the environment that its glossy part reflects
//   level_of_base(Environment, Base_name, ShinyPoint)        level read at the lobe's centre / highest level
//   parts_of_base(Base_name)                                 luminance that it reflects diffusely, and by its glossy lobe
//   drawn_by_base(Base_name, ShinyPoint, vec3)               a direction drawn from its glossy lobe, from a point
//   density_by_base(Base_name, ShinyPoint, vec3)             the density of such directions
#ifdef BASE
BASE(ggx, 0, 1)
BASE(phong, 1, 0)
#undef BASE
#else
#include "shading/passes/base_ggx.glsl"
#include "shading/passes/base_phong.glsl"
#endif
