// Where the rows of an equirectangular picture are.
#pragma once

#include <vector>

namespace lambent::image {

/// For each of `height` rows (at least 1) the polar angle in radians, from +Y down, at which it holds. Between them a picture
/// is read linearly; before the first and behind the last it stays as it is there. Read so, each row gives the light of its
/// texels: radiance times their solid angle. They are the middles of the rows but next to the poles, where those would give
/// a first row 13/12 of its light and this is a fourteenth of a row closer to the pole.
std::vector<double> row_angles(int height);

} // namespace lambent::image
