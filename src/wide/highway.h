// Highway, with its mathematics for the rarely used functions. Guarded per target by Highway's own headers: no guard.
#include <hwy/highway.h>
#include <hwy/contrib/math/math-inl.h>
