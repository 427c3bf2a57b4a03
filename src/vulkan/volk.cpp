// volk's own code, in this one file.
#define VOLK_IMPLEMENTATION
#include <volk.h>
