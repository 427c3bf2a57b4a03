# Every outside library, found once. All are Debian packages; `./dev` installs them.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(glm CONFIG QUIET)
if(NOT TARGET glm::glm)
  find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
  add_library(glm::glm INTERFACE IMPORTED)
  target_include_directories(glm::glm SYSTEM INTERFACE ${GLM_INCLUDE_DIR})
endif()
find_package(CLI11 CONFIG REQUIRED)
find_package(nlohmann_json REQUIRED)
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED) # inlined: nothing to link
pkg_check_modules(SPNG REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(JPEG REQUIRED IMPORTED_TARGET libjpeg)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)
# Without it KTX 2 files are written uncompressed only.
pkg_check_modules(ZSTD IMPORTED_TARGET libzstd)

# Vulkan's headers and volk, which opens the library when the program runs (package libvulkan-volk-dev).
find_path(LAMBENT_VOLK_HEADERS volk.h DOC "volk and Vulkan's headers")

# Embree 3 (Debian 12, Ubuntu 22.04) or 4 (later); src/trace/embree.h hides the difference.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
