// The only conversion of light to code values: exposure, tone curve, contrast, transfer, rounding.
#pragma once

#include "image/image.h"

namespace lambent::display {

/// Tone curves, from exposed light to [0, 1]; see equations/tone.glsl for each curve and its source.
enum class Tone { reinhard, neutral, aces, agx, linear };

struct Settings {
    float exposure = 1.0f; ///< e of the report: factor on the light, above 0
    float contrast = 1.0f; ///< K of the report: power on the curve's result, above 0
    Tone tone = Tone::reinhard;
    /// Encode for a display: pow(1/2.2) after `reinhard`, so that the whole is the report's (eC / (eC + 1))^(K / 2.2),
    /// and after `agx`, which is made for it; the exact sRGB curve after the others. False: codes are the curve's
    /// result itself (the report's "nonlinear" comparison).
    bool encode = true;
    bool unlit_by_power =
        false; ///< colours without lighting were decoded by a power of 2.2, not by the sRGB curve
    bool dither =
        false; ///< noise of one code, triangular, the same for every image, before rounding to 8 bits
};

/// 8-bit RGB codes of an RGB or RGBA image, rounded to nearest. NaN and negative light become black, infinite light
/// white. Colours without lighting (RadianceImage::unlit) are only encoded: whatever exposure, curve and contrast are,
/// a texel's code is displayed unchanged. In pixels with both, they are mixed as light emitted by the display.
image::CodeImage to_codes(const image::RadianceImage& light, const Settings& settings);

} // namespace lambent::display
