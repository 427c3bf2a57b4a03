// The probes: PROBE(number, name, lanes_absolute, lanes_relative, glsl_absolute, glsl_relative), read as C++
// and as GLSL. Over lanes and in GLSL a result may differ from that in double by absolute + relative |result|.
// Bounds looser than 1e-5 have their reason above them. Those of GLSL allow what Vulkan allows a device.
PROBE(0, fresnel, 1e-5, 0.0, 1e-5, 0.0)
PROBE(1, frame_matrix, 1e-5, 0.0, 1e-5, 0.0)
PROBE(2, frame_carried, 1e-5, 0.0, 1e-5, 0.0)
PROBE(3, frame_carried_little, 1e-5, 0.0, 1e-5, 0.0)
PROBE(4, frame_mirrored, 1e-5, 0.0, 1e-5, 0.0)
PROBE(5, frame_facing, 1e-5, 0.0, 1e-5, 0.0)
// Vulkan allows log2 an absolute error of 2^-21 between 1/2 and 2; the exponent multiplies it by up to 1e6,
// then by up to 100.
PROBE(6, phong_density, 1e-5, 1e-5, 0.5, 1e-5)
PROBE(7, phong_terms, 1e-5, 1e-5, 6e-5, 1e-5)
PROBE(8, phong_sample, 1e-5, 0.0, 1e-5, 0.0)
// The exponent, here up to 100 and then 10,000, multiplies the rounding of NH; L + V has few digits where
// they oppose.
PROBE(9, phong_brdf, 1e-5, 1e-3, 1e-5, 1e-3)
PROBE(10, phong_brdf_sharp, 1e-5, 5e-3, 1e-5, 1e-2)
PROBE(11, ggx_density, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(12, ggx_masking, 1e-5, 0.0, 1e-5, 0.0)
PROBE(13, ggx_pair, 1e-5, 1e-5, 1e-5, 1e-5)
// At a grazing view and a small alpha a short vector is normalised, whose z has few digits.
PROBE(14, ggx_stretched, 1e-4, 0.0, 1e-4, 0.0)
// As xi2 nears 1 the facet turns edge-on: it becomes the difference of nearly equal vectors, of which alpha
// shrinks the larger part. To 1 - 2^-10, alpha above and below 0.05; and to the end.
PROBE(15, ggx_sample, 3e-4, 0.0, 3e-4, 0.0)
PROBE(16, ggx_sample_smooth, 1e-3, 0.0, 1e-3, 0.0)
PROBE(17, ggx_sample_last, 2.0, 0.0, 2.0, 0.0)
PROBE(18, energy_factor, 1e-5, 0.0, 1e-5, 0.0)
PROBE(19, energy_reflectance, 1e-5, 0.0, 1e-5, 0.0)
// The density divides the rounding of NH by alpha^2, here at least 0.04 and then 0.0004; L + V as above.
PROBE(20, energy_brdf, 1e-5, 3e-4, 1e-5, 3e-4)
PROBE(21, energy_brdf_smooth, 1e-5, 2e-3, 1e-5, 2e-3)
PROBE(22, light_attenuations, 1e-5, 1e-5, 1e-5, 1e-5)
// An arc cosine near 1 has half the digits of its argument. Vulkan allows sin and cos an absolute error of 2^-11.
PROBE(23, map_from_direction, 1e-4, 0.0, 1e-4, 0.0)
PROBE(24, map_direction, 1e-5, 0.0, 1e-3, 0.0)
PROBE(25, map_cube, 1e-5, 1e-5, 1e-5, 5e-4)
PROBE(26, sh_values, 1e-5, 0.0, 1e-5, 0.0)
PROBE(27, sh_irradiance, 1e-5, 0.0, 1e-5, 0.0)
PROBE(28, footprint_levels, 1e-5, 0.0, 1e-5, 0.0)
PROBE(29, transfer_curves, 1e-5, 0.0, 1e-5, 0.0)
PROBE(30, transfer_powers, 1e-5, 0.0, 1e-5, 0.0)
PROBE(31, transfer_colour, 1e-5, 0.0, 1e-5, 0.0)
PROBE(32, tone_simple, 1e-5, 0.0, 1e-5, 0.0)
PROBE(33, tone_neutral_any, 1e-5, 0.0, 1e-5, 0.0)
PROBE(34, tone_neutral_some, 1e-5, 0.0, 1e-5, 0.0)
PROBE(35, tone_aces_any, 1e-5, 0.0, 1e-5, 0.0)
PROBE(36, tone_aces_some, 1e-5, 0.0, 1e-5, 0.0)
PROBE(37, tone_agx_any, 1e-5, 0.0, 1e-5, 0.0)
PROBE(38, tone_agx_some, 1e-5, 0.0, 1e-5, 0.0)
// The passes: twelve samples each, whose directions and levels carry the errors of the functions above.
PROBE(39, shading_ggx, 1e-4, 1e-4, 1e-3, 1e-3)
PROBE(40, shading_phong, 1e-4, 1e-4, 1e-3, 1e-3)
PROBE(41, shading_phong_report, 1e-4, 1e-3, 1e-3, 2e-3)
PROBE(42, shading_direct_metallic, 1e-5, 1e-3, 1e-5, 1e-3)
PROBE(43, shading_direct_phong, 1e-5, 1e-3, 1e-5, 1e-3)
PROBE(44, shading_ambient, 1e-5, 0.0, 1e-5, 0.0)
PROBE(45, fresnel_base, 1e-6, 0.0, 1e-6, 0.0)
PROBE(46, map_cube_place, 1e-5, 1e-5, 1e-5, 1e-5)
// Facets and their spreads as above.
PROBE(47, shading_lobe_sample, 1e-4, 1e-4, 1e-3, 1e-3)
// The footprint of a pixel may be as thin as two directions nearly the same make it.
PROBE(48, shading_lamps, 1e-4, 1e-3, 1e-3, 1e-3)
PROBE(49, shading_facet, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(50, shading_steps, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(51, shading_turning, 1e-5, 0.0, 1e-5, 0.0)
PROBE(52, shading_mapped, 1e-5, 0.0, 1e-5, 0.0)
PROBE(53, shading_surface, 1e-5, 0.0, 1e-5, 0.0)
PROBE(54, shading_material, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(55, shading_texture, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(56, lobe_weights, 1e-5, 1e-5, 1e-5, 1e-5)
// smith_ggx of two numbers adds up the squares of a view's components, each with the rounding of its frame.
PROBE(57, shading_middle_levels, 4e-5, 1e-5, 1e-4, 1e-4)
PROBE(58, shading_pipeline_report, 1e-4, 1e-3, 1e-3, 2e-3)
// The exponent is up to 1e4 here, as in phong_brdf_sharp, and how far a light is off a lobe has few digits.
PROBE(59, shading_direct_in_pixel, 1e-5, 2e-2, 1e-5, 2e-2)
PROBE(60, shading_parameters, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(61, shading_albedo, 1e-4, 0.0, 1e-4, 0.0)
PROBE(62, shading_arrivals, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(63, shading_layers, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(64, ggx_two, 1e-5, 1e-4, 1e-5, 1e-4)
// Facets as in ggx_sample; spreads as their squares.
PROBE(65, ggx_two_sample, 3e-4, 1e-3, 3e-4, 1e-3)
PROBE(66, energy_brdf_two, 1e-5, 3e-4, 1e-5, 3e-4)
PROBE(67, shading_facets, 1e-5, 1e-5, 1e-5, 1e-5)
PROBE(68, shading_drawn_cosine, 1e-5, 1e-5, 1e-5, 1e-5)
// Facets as in ggx_sample, mirrored, and so turned twice as far.
PROBE(69, shading_drawn_facets, 2e-5, 2e-4, 1e-4, 1e-3)
PROBE(70, shading_drawn_facets_two, 2e-5, 2e-4, 1e-4, 1e-3)
PROBE(71, shading_drawn_phong, 2e-5, 2e-4, 1e-4, 1e-3)
