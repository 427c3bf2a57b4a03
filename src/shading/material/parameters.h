// The parameters of a material, for C++ and GLSL. They become fields of the scene's material and of the material at a
// point, numbers in the device's record, and columns of the G-buffer. Each is a factor times a channel of a texture.
//   COLOR_AND_ALPHA(name, alpha, number, value, object, key, texture)
//       four numbers: linear RGB, and alpha, which becomes an opacity by the alpha mode
//   COLOR(name, number, value, object, key, texture)
//       three numbers: linear RGB
//   SCALAR(name, number, value, object, key, texture, channel)
//       a number from 0 to 1
//   ROUGHNESS(name, factor, number, value, object, key, texture, channel)
//       perceptual roughness from 0 to 1 in files; at a point its square, alpha
//   STRENGTH(name, factor, number, value, object, key, texture, channel)
//       a number from 0 to 1 that interpolates between 1 and the texture's value
// `number`: index of the first of its values; `value`: the factor if a file gives none; `object` and `key`: where a
// glTF material has the factor: under this key of this object, which is `material` for the material itself.
COLOR_AND_ALPHA(base_color, opacity, 0, 1.0, pbrMetallicRoughness, baseColorFactor, base_color)
SCALAR(metallic, 4, 1.0, pbrMetallicRoughness, metallicFactor, metallic_roughness, b)
ROUGHNESS(alpha, perceptual_roughness, 5, 1.0, pbrMetallicRoughness, roughnessFactor, metallic_roughness, g)
STRENGTH(occlusion, occlusion_strength, 6, 1.0, occlusionTexture, strength, occlusion, r)
COLOR(emissive, 7, 0.0, material, emissiveFactor, emissive)
SCALAR(coat, 10, 0.0, KHR_materials_clearcoat, clearcoatFactor, coat, r)
ROUGHNESS(coat_alpha, coat_roughness, 11, 0.0, KHR_materials_clearcoat, clearcoatRoughnessFactor,
          coat_roughness, g)
#undef COLOR_AND_ALPHA
#undef COLOR
#undef SCALAR
#undef ROUGHNESS
#undef STRENGTH
