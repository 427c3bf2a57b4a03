// Columns of Fragments as lanes: hooks of src/shading/README.md. Included after wide/wide.h, inside the target's namespace: no
// guard.

// As many fragments as there are lanes.
struct Fragment {
    float* values; // of the first in column 0
    size_t capacity;
};

HWY_INLINE Fragment fragment(Fragments& fragments, size_t at)
{
    return {fragments[0] + at, fragments.capacity()};
}

HWY_INLINE Real load(const Fragment& f, int column)
{
    return load(f.values + static_cast<size_t>(column) * f.capacity);
}

HWY_INLINE void store(const Fragment& f, int column, Real value)
{
    store(value, f.values + static_cast<size_t>(column) * f.capacity);
}

// Asking each vector of fragments costs next to nothing.
HWY_INLINE int has_layers()
{
    return 1;
}

// The table's part of that number at whole coordinates.
HWY_INLINE Real albedo_entry(Real column, Real row, int part)
{
    const Int index = hn::Add(hn::Mul(truncated(row), integer(albedo_table_size)), truncated(column));
    return hn::GatherIndex(FloatTag(), albedo_table + part, hn::Add(index, index));
}

HWY_INLINE vec3 uniform(glm::vec3 v)
{
    return vec3(v.x, v.y, v.z);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" // not every kernel does both
#include "shading/passes/vectors.glsl"
#pragma GCC diagnostic pop
