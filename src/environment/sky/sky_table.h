// A sky tabulated at some directions and interpolated between them.
#pragma once

#include "environment/sky/sky_light.h"

#include <array>
#include <vector>

namespace lambent::environment {

/// The table's resolution: elevations for each of sky and ground, closest near the ground's edge, and horizontal angles
/// from the sun, over half a turn (the other half is symmetric).
struct SkyTableSize {
    int elevations = 40;
    int angles = 24;
};

/// ClearSky::light, interpolated. tests/environment bounds the error.
class SkyTable {
public:
    explicit SkyTable(const ClearSky& sky, const SkyTableSize& size = {});

    /// At one elevation, the light at the table's angles from the sun: 0 to pi in equal steps.
    using Row = std::vector<SkyLight>;
    Row row(double elevation) const;

private:
    double node_elevation(int i, bool ground) const;

    SkyTableSize size_;
    double edge_;
    std::vector<SkyLight> lights_;
};

/// Interpolates a row at a fraction between one angle and the next.
SkyLight between(const SkyTable::Row& row, int angle, float fraction);

} // namespace lambent::environment
