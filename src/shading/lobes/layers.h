// The lobes that lie over a material's base, from the lowest up, for C++ and GLSL alike. Where LAYER is defined, a row each:
//   LAYER(name, number, normal)
//       `name`: the parameter that says how much of it is there, 0 to 1, and the ending of its function facets_name();
//       `number`, from 1 on: that of its shading normal; `normal`: the texture that bends it
// elsewhere the files that hold them.
#ifdef LAYER
LAYER(coat, 1, coat_normal)
#undef LAYER
#else
#include "shading/lobes/coat.glsl"
#endif
