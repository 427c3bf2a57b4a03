// The lobes that lie over a material's base, from the lowest up, for C++ and GLSL alike:
//   LAYER(name, number, normal)
// `name` is the parameter that says how much of it is there, 0 to 1, and the ending of its functions; `number`, from 1 on, that of
// its shading normal; `normal` the texture that bends it.
#undef LAYER
