// The types of the equations over SIMD lanes: Real is one float per lane of the widest vector of the Highway target
// that is being compiled.
// Included inside the target's namespace, between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE: no guard, by design.
// No friend function is defined inside a class: g++ 12 would compile it for the baseline instead of the target.
// Never built with -ffast-math: it cancels the additions by which Highway rounds on SSSE3.

// Tables of one-line functions are read down their columns.
// clang-format off
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::RebindToSigned<FloatTag>;
using Int = hn::Vec<IntTag>;

// The most lanes that any target has, and the length of buffers for one vector.
constexpr size_t max_lanes = 16;

// Lanes of this target, known when compiling for all but the scalable targets, which are not built.
constexpr size_t lane_count = HWY_LANES(float);

// One truth value per lane; unlike GLSL's bool, both sides of && and || are evaluated.
struct Mask {
    hn::Mask<FloatTag> m;
};

HWY_INLINE Mask operator&&(Mask a, Mask b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE Mask operator||(Mask a, Mask b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE Mask operator!(Mask a) { return {hn::Not(a.m)}; }
HWY_INLINE bool none(Mask a) { return hn::AllFalse(FloatTag(), a.m); }
HWY_INLINE bool any_of(Mask a) { return !none(a); }

// One float per lane; a number fills every lane.
struct Real {
    hn::Vec<FloatTag> v;

    HWY_INLINE Real(hn::Vec<FloatTag> lanes) : v(lanes) {}
    HWY_INLINE Real(double s) : v(hn::Set(FloatTag(), static_cast<float>(s))) {}
    HWY_INLINE Real(float s) : v(hn::Set(FloatTag(), s)) {}
    HWY_INLINE Real(int s) : v(hn::Set(FloatTag(), static_cast<float>(s))) {}
};

// A number as mantissa * 4^exponent, mantissa in [1, 4).
struct PowersOfFour {
    Real mantissa, exponent;
};

HWY_INLINE Real to_real(Int i) { return hn::ConvertTo(FloatTag(), i); }
HWY_INLINE Real load(const float* from) { return hn::LoadU(FloatTag(), from); }
HWY_INLINE void store(Real a, float* to) { hn::StoreU(a.v, FloatTag(), to); }

HWY_INLINE Real operator-(Real a) { return hn::Neg(a.v); }
HWY_INLINE Real operator+(Real a, Real b) { return hn::Add(a.v, b.v); }
HWY_INLINE Real operator-(Real a, Real b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Real operator*(Real a, Real b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Mask operator<(Real a, Real b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE Mask operator>(Real a, Real b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE Mask operator<=(Real a, Real b) { return {hn::Le(a.v, b.v)}; }
HWY_INLINE Mask operator>=(Real a, Real b) { return {hn::Ge(a.v, b.v)}; }
HWY_INLINE Real& operator+=(Real& a, Real b) { return a = a + b; }
HWY_INLINE Real& operator*=(Real& a, Real b) { return a = a * b; }

HWY_INLINE Real abs(Real a) { return hn::Abs(a.v); }
HWY_INLINE Real floor(Real a) { return hn::Floor(a.v); }
HWY_INLINE Real max(Real a, Real b) { return hn::Max(a.v, b.v); }
HWY_INLINE Real min(Real a, Real b) { return hn::Min(a.v, b.v); }
HWY_INLINE Real sqrt(Real a) { return hn::Sqrt(a.v); }
HWY_INLINE Real select(Mask m, Real yes, Real no) { return hn::IfThenElse(m.m, yes.v, no.v); }

// The largest of all lanes.
HWY_INLINE float largest_lane(Real a) { return hn::GetLane(hn::MaxOfLanes(FloatTag(), a.v)); }

HWY_INLINE Int integer(int i) { return hn::Set(IntTag(), i); }
HWY_INLINE Int truncated(Real a) { return hn::ConvertTo(IntTag(), a.v); }
HWY_INLINE Int bits(Real a) { return hn::BitCast(IntTag(), a.v); }
HWY_INLINE Real from_bits(Int i) { return hn::BitCast(FloatTag(), i); }
