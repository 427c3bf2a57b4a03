# GLSL to SPIR-V at build time, as C arrays that programs include: nothing is looked for at run time.
include_guard(GLOBAL)
find_program(LAMBENT_GLSLC glslc DOC "GLSL compiler (Debian package glslc)")

# lambent_spirv(TARGET shader.comp ...) Compiles shaders of the current folder, optimised and with warnings as
# errors, so that the target's sources can say
#     const uint32_t code[] =
#     #include "shader.comp.spv.inc"
#         ;
# The shaders include files by their path from the root or from src/.
function(lambent_spirv target)
  foreach(shader IN LISTS ARGN)
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${shader})
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${shader}.spv.inc)
    add_custom_command(OUTPUT ${output}
      COMMAND ${LAMBENT_GLSLC} -Werror -O --target-env=vulkan1.2 -mfmt=c
        -I ${CMAKE_SOURCE_DIR} -I ${CMAKE_SOURCE_DIR}/src
        -MD -MF ${output}.d -MT ${output} -o ${output} ${source}
      DEPENDS ${source} DEPFILE ${output}.d COMMENT "Compiling ${shader}" VERBATIM)
    target_sources(${target} PRIVATE ${output})
    list(APPEND outputs ${output})
  endforeach()
  add_custom_target(${target}_shaders DEPENDS ${outputs})
  add_dependencies(generated ${target}_shaders)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
