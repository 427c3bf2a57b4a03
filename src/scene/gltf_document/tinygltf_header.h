// tinygltf's declarations, always with the same switches: no image codecs and no way to open a file. What it
// gets to parse holds neither buffers nor images (gltf_document.cpp keeps those back).
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>
