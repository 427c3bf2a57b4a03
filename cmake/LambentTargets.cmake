# How every target is compiled, and the one way to declare a library folder.
add_library(lambent_options INTERFACE)
target_compile_options(lambent_options INTERFACE -Wall -Wextra -Wconversion
  # Contraction to fused multiply-add is wanted; -ffast-math is not: it deletes Highway's rounding on SSSE3.
  -ffp-contract=fast
  # The ABI note about vector arguments is about calls that are all inlined.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)
if(LAMBENT_WERROR)
  target_compile_options(lambent_options INTERFACE -Werror)
endif()
if(LAMBENT_SANITIZE)
  target_compile_options(lambent_options INTERFACE -fsanitize=${LAMBENT_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  # What sanitizers add makes GCC see things that are not there, even in <regex>; they see the real ones themselves.
  target_compile_options(lambent_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(lambent_options INTERFACE -fsanitize=${LAMBENT_SANITIZE})
endif()
# By how much longer tests wait for what this build makes: sanitizers slow it down.
set(LAMBENT_PATIENCE 1)
if(LAMBENT_SANITIZE)
  set(LAMBENT_PATIENCE 10)
endif()
if(LAMBENT_FUZZ)
  target_compile_options(lambent_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# lambent_library(NAME SOURCES a.cpp ... [DEPENDS target ...] [PRIVATE_DEPENDS target ...])
# A static library of one folder under src/, included as "folder/file.h".
function(lambent_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(lambent_${name} STATIC ${ARG_SOURCES})
  target_include_directories(lambent_${name} PUBLIC ${CMAKE_SOURCE_DIR}/src)
  target_link_libraries(lambent_${name} PUBLIC ${ARG_DEPENDS} PRIVATE lambent_options ${ARG_PRIVATE_DEPENDS})
endfunction()
