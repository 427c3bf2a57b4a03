// The split-sum table: the directional albedo of GGX surfaces.
#pragma once

namespace lambent {

/// Points of the table along each axis: at column i the cosine NV is (i / (n - 1))^2, denser towards grazing angles
/// where the albedo changes fastest; at row j the perceptual roughness is j / (n - 1).
constexpr int albedo_table_size = 64;

/// Pairs (x, y), row by row: a surface of reflectance F0 reflects F0 x + y of the light from a uniform environment,
/// by single scattering. [Karis 2013, "Real shading in Unreal Engine 4"] Computed by the build, by quadrature in double
/// over the visible normals (make_albedo_table.cpp); tests/environment compares it with quadrature over directions.
extern const float albedo_table[albedo_table_size * albedo_table_size * 2];

} // namespace lambent
