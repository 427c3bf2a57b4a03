// GLSL's vec2, vec3 and mat3 over the Real in scope. Included inside the namespace of each C++ backend: no guard.

// Tables of one-line functions are read down their columns.
// clang-format off
inline Real clamp(Real a, Real low, Real high) { return min(max(a, low), high); }
inline Real mix(Real a, Real b, Real t) { return a + t * (b - a); }

struct vec2 {
    Real x, y;

    vec2(Real x_, Real y_) : x(x_), y(y_) {}
    explicit vec2(Real s) : x(s), y(s) {}
};

inline vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline vec2 operator-(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline vec2 operator*(Real s, vec2 a) { return {s * a.x, s * a.y}; }
inline Real dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }

struct vec3 {
    Real x, y, z;

    vec3(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
    explicit vec3(Real s) : x(s), y(s), z(s) {}
};

inline vec3 operator-(vec3 a) { return {-a.x, -a.y, -a.z}; }
inline vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline vec3 operator+(Real s, vec3 a) { return {s + a.x, s + a.y, s + a.z}; }
inline vec3 operator-(Real s, vec3 a) { return {s - a.x, s - a.y, s - a.z}; }
inline vec3 operator*(Real s, vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline vec3 operator*(vec3 a, Real s) { return s * a; }
inline vec3 operator/(vec3 a, Real s) { return (1.0 / s) * a; }
inline vec3& operator+=(vec3& a, vec3 b) { return a = a + b; }
inline Real dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline vec3 cross(vec3 a, vec3 b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline vec3 mix(vec3 a, vec3 b, Real t) { return a + t * (b - a); }
inline vec3 min(vec3 a, vec3 b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
inline vec3 max(vec3 a, vec3 b) { return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }
inline vec3 clamp(vec3 a, Real low, Real high)
{
    return {clamp(a.x, low, high), clamp(a.y, low, high), clamp(a.z, low, high)};
}
inline vec3 normalize(vec3 a) { return inversesqrt(dot(a, a)) * a; }
inline vec3 select(Mask m, vec3 yes, vec3 no)
{
    return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

// Three columns, as in GLSL.
struct mat3 {
    vec3 x, y, z;

    mat3(vec3 x_, vec3 y_, vec3 z_) : x(x_), y(y_), z(z_) {}
};

inline vec3 operator*(mat3 m, vec3 v) { return v.x * m.x + v.y * m.y + v.z * m.z; }
