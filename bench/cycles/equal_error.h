// How long each program takes to the same error.
#pragma once

#include "bench/cycles/agreement.h"

namespace lambent::bench {

/// Runs both in turn with few, more and many samples per pixel, some rounds, and prints each one's error against its
/// own converged picture (the mean of `converged`, whose remaining noise is taken off), its seconds of sampling, and
/// the ratio of the seconds in which both reach Cycles' errors.
void print_time_to_equal_error(const Programs& programs, const SamePictures& converged, int rounds);

} // namespace lambent::bench
