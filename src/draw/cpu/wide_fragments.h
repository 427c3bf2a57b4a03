// Columns of Fragments as lanes: hooks of src/shading/README.md. Included after wide/wide.h, inside the target's
// namespace: no guard.

// One fragment per lane.
struct Fragment {
    float* values; // column 0 of the first fragment
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

// Each vector of fragments is tested for lobes over its base, which costs almost nothing.
HWY_INLINE int has_layers()
{
    return 1;
}

// Number `part` of the albedo table at integer coordinates.
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
#pragma GCC diagnostic ignored "-Wunused-function" // not every kernel both loads and stores
#include "shading/passes/vectors.glsl"
#pragma GCC diagnostic pop
