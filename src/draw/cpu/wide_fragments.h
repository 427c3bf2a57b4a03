// Columns of Fragments as lanes. Included after wide/wide.h, inside the target's namespace: no guard.

HWY_INLINE vec3 uniform(glm::vec3 v)
{
    return vec3(v.x, v.y, v.z);
}

// Three columns side by side, of the fragments from `at` on.
HWY_INLINE vec3 load3(const Fragments& f, Column first, size_t at)
{
    return vec3(load(f[first] + at), load(f[Column(first + 1)] + at), load(f[Column(first + 2)] + at));
}

HWY_INLINE void store3(vec3 v, Fragments& f, Column first, size_t at)
{
    store(v.x, f[first] + at);
    store(v.y, f[Column(first + 1)] + at);
    store(v.z, f[Column(first + 2)] + at);
}
