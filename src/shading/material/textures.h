// The textures that a material may have, for C++ and GLSL:
//   TEXTURE(name, number, transfer, object, key)
//       `transfer`: codes of colours, or linear values; `object` and `key`: where a glTF material has the texture:
//       under this key of this object, which is `material` for the material itself
//   NORMAL_TEXTURE(name, number, object, key)
//       a normal map in tangent space, with its own scale
TEXTURE(base_color, 0, color, pbrMetallicRoughness, baseColorTexture)
TEXTURE(metallic_roughness, 1, linear, pbrMetallicRoughness, metallicRoughnessTexture)
NORMAL_TEXTURE(normal, 2, material, normalTexture)
TEXTURE(occlusion, 3, linear, material, occlusionTexture)
TEXTURE(emissive, 4, color, material, emissiveTexture)
TEXTURE(coat, 5, linear, KHR_materials_clearcoat, clearcoatTexture)
TEXTURE(coat_roughness, 6, linear, KHR_materials_clearcoat, clearcoatRoughnessTexture)
NORMAL_TEXTURE(coat_normal, 7, KHR_materials_clearcoat, clearcoatNormalTexture)
#undef TEXTURE
#undef NORMAL_TEXTURE
