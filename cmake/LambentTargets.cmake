# How every target is compiled, and the one way to declare a library folder.

# What the build writes for files of ours to include: all that is needed to read them one by one, as `./dev lint` does.
add_custom_target(generated)

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

# Most of what a file of ours costs the compiler is the headers that it shares with its neighbours. So the files of a
# folder are compiled sixteen at a time, and the tests' headers once. Names in unnamed namespaces must therefore differ
# within a folder. Without (preset debug, by which `./dev lint` reads them), what a file forgot to include is found.
option(LAMBENT_TOGETHER "Compile files together: less than half the time" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
if(NOT LAMBENT_TOGETHER)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# lambent_library(NAME SOURCES a.cpp ... [ALONE b.cpp ...] [COLD [HOT c.cpp ...]]
#                 [DEPENDS target ...] [PRIVATE_DEPENDS target ...])
# A static library of one folder under src/, included as "folder/file.h". ALONE are those of SOURCES that are compiled
# for several processors, hold another library's code, or make GCC see what is not there when it inlines them elsewhere.
# COLD: the program spends no time in it, so the compiler spends less, too; but for the HOT of its SOURCES, which look at
# every pixel.
function(lambent_library name)
  cmake_parse_arguments(ARG "COLD" "" "SOURCES;ALONE;HOT;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(lambent_${name} STATIC ${ARG_SOURCES})
  set_target_properties(lambent_${name} PROPERTIES UNITY_BUILD ${LAMBENT_TOGETHER})
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(lambent_${name} PUBLIC ${CMAKE_SOURCE_DIR}/src)
  target_link_libraries(lambent_${name} PUBLIC ${ARG_DEPENDS} PRIVATE lambent_options ${ARG_PRIVATE_DEPENDS})
  if(ARG_COLD)
    target_compile_options(lambent_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    set_source_files_properties(${ARG_HOT} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O3>)
  endif()
endfunction()
