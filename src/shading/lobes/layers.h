// The lobes over a material's base, from the lowest up, for C++ and GLSL. If LAYER is defined, a row for each:
//   LAYER(name, number, normal)
//       `name`: its strength's parameter, 0 to 1, and the suffix of its function facets_name();
//       `number`: that of its shading normal, from 1; `normal`: the normal map of this normal
// Otherwise the files that define them.
#ifdef LAYER
LAYER(coat, 1, coat_normal)
#undef LAYER
#else
#include "shading/lobes/coat.glsl"
#endif
