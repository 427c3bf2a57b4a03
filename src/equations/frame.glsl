// Rotation that takes +z to the unit vector N; its columns are two tangents and N. Smooth except where N.z crosses 0.
// [Duff et al. 2017, "Building an orthonormal basis, revisited", JCGT 6(1)]
// Witness: orthonormality and determinant 1 over the sphere.
mat3 orthonormal_frame(vec3 N)
{
    Real s = select(N.z < 0.0, -1.0, 1.0);
    Real a = -1.0 / (s + N.z);
    Real b = N.x * N.y * a;
    return mat3(vec3(1.0 + s * N.x * N.x * a, s * b, -s * N.x), vec3(b, s + N.y * N.y * a, -N.y), N);
}

// Mirror image of V in the plane of normal N: the direction from which a mirror sends light along V.
// Witness: coplanar, at the same angle.
vec3 mirrored(vec3 N, vec3 V) { return 2.0 * dot(N, V) * N - V; }

// A frame about N for sampling as seen along V: `across`, made perpendicular to V, is carried from V to N by the
// shortest rotation. As it turns with V and not with N alone, it has no seam in an image and no swirl where N and V
// coincide; it is undefined only at N = -V. `across` is any direction but V, such as the camera's right.
// Columns: two tangents and N. Witness: orthonormality; V along N gives `across` back; the limit towards V.
mat3 carried_frame(vec3 N, vec3 V, vec3 across)
{
    vec3 aside = across - dot(across, V) * V;
    vec3 start = inversesqrt(max(dot(aside, aside), 1.0e-12)) * aside;
    vec3 sum = N + V;
    vec3 tangent = start - (dot(N, start) / max(1.0 + dot(N, V), 1.0e-6)) * sum;
    return mat3(tangent, cross(N, tangent), N);
}

// A frame about N whose first column is as near to `along` as can be: any direction but N. Witness: orthonormality.
mat3 frame_along(vec3 N, vec3 along)
{
    vec3 aside = along - dot(along, N) * N;
    vec3 tangent = inversesqrt(max(dot(aside, aside), 1.0e-30)) * aside;
    return mat3(tangent, cross(N, tangent), N);
}

// The components of v along the three columns of a rotation. Witness: the rotation of them is v.
vec3 in_frame(mat3 frame, vec3 v)
{
    vec3 x = frame * vec3(1.0, 0.0, 0.0);
    vec3 y = frame * vec3(0.0, 1.0, 0.0);
    vec3 z = frame * vec3(0.0, 0.0, 1.0);
    return vec3(dot(v, x), dot(v, y), dot(v, z));
}

// N, or where it faces away from V (an interpolated or mapped normal near the silhouette), N bent towards V until its
// cosine is at least `least`, which may be up to 0.09. Unit length. Witness: the cosine, and that N in front is
// returned unchanged.
vec3 facing_normal(vec3 N, vec3 V, Real least)
{
    Real NV = dot(N, V);
    vec3 bent = normalize(N + 1.01 * (least - NV) * V);
    return select(NV < least, bent, N);
}
