// The report's tone mapping of every value that it reads of its environment (docs/REPORT.md).

// decode: power of a value read, 2.2, or 1 in nonlinear colour. exposure: e. encode: power of the curve, K / 2.2, or K.
// back: power of the specular pass's mean, 1 / 2.2, or 1.
struct ReportTone {
    Real decode;
    Real exposure;
    Real encode;
    Real back;
};

// (e C / (e C + 1))^encode of a value read, C = read^decode, per channel. Witness: std::pow, in double.
vec3 toned_report(ReportTone t, vec3 read)
{
    vec3 c = min(t.exposure * power(read, t.decode), vec3(1.0e30));
    return power(tone_reinhard(c), t.encode);
}
