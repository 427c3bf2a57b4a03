// All equations over the lanes of the target being compiled. A file that uses them looks like this:
//
//     #undef HWY_TARGET_INCLUDE
//     #define HWY_TARGET_INCLUDE "folder/this_file.cpp"
//     #include <hwy/foreach_target.h>
//     #include "wide/highway.h"
//     HWY_BEFORE_NAMESPACE();
//     namespace lambent::folder::HWY_NAMESPACE {
//     namespace {
//     #include "wide/wide.h"
//     ...
//
// No guard, by design: it is read once for each target.

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // no file uses all equations

#undef ONE_BODY
#define ONE_BODY HWY_NOINLINE HWY_FLATTEN
#include "wide/lanes.h"
#include "wide/approximations.h"
#include "equations/vectors.h"
#include "equations/all.glsl"

#pragma GCC diagnostic pop
