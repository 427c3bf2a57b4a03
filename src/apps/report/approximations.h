// What each of the report's approximations costs, apart from the others.
#pragma once

#include "apps/report/page.h"
#include "apps/report/shot_renderer.h"

namespace lambent::report {

/// What the table says, for under it.
extern const char* const approximations_caption;

/// A row for each of the reflecting sphere's exponents.
Table approximations(ShotRenderer& renderer);

} // namespace lambent::report
