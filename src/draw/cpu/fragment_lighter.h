// Who lights the fragments of a tile, if not the processor.
#pragma once

#include "draw/cpu/fragments.h"
#include "draw/cpu/light_kernel.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lambent::draw {

/// Called from any thread, by several at a time.
class FragmentLighter {
public:
    virtual ~FragmentLighter() = default;

    /// Fills what light_directly does and, with an environment, what light_ambiently and light_specularly do, of all
    /// fragments. Throws Error(no_device).
    virtual void light(Fragments& fragments) = 0;

    /// Passes so far and the milliseconds that they took on the device.
    virtual std::vector<std::pair<std::string, double>> passes() const = 0;
};

/// Makes one for a picture; what it is given outlives it.
using MakeLighter = std::function<std::unique_ptr<FragmentLighter>(const LightContext& context,
                                                                   std::span<const LightSource> lights)>;

} // namespace lambent::draw
