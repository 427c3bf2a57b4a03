// The implementation of volk, compiled in this file only.
#define VOLK_IMPLEMENTATION
#include <volk.h>
