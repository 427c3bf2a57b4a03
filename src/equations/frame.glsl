// Rotation that takes +z to the unit vector N; its columns are two tangents and N. Smooth but for N.z = 0 crossings.
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
vec3 mirrored(vec3 N, vec3 V) { return 2.0 * dot(N, V) * N - V; }

// Rotation that takes +z to N and the half plane x > 0 to the side of V, so that V = (sin, 0, cos) in it.
// Any frame about N when V is along N. Witness: as orthonormal_frame, and the y component of V is 0.
mat3 view_frame(vec3 N, vec3 V)
{
    vec3 sideways = V - dot(N, V) * N;
    Real length2 = dot(sideways, sideways);
    mat3 any = orthonormal_frame(N);
    vec3 tangent = select(length2 > 1.0e-12, inversesqrt(max(length2, 1.0e-12)) * sideways, any * vec3(1.0, 0.0, 0.0));
    return mat3(tangent, cross(N, tangent), N);
}

// N, or where it faces away from V (an interpolated or mapped normal near the silhouette), N bent towards V until its
// cosine is at least `least`. Unit length. Witness: the cosine, and that N in front is returned unchanged.
vec3 facing_normal(vec3 N, vec3 V, Real least)
{
    Real NV = dot(N, V);
    vec3 bent = normalize(N + 1.01 * (least - NV) * V);
    return select(NV < least, bent, N);
}
