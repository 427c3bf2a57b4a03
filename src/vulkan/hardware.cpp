#include "vulkan/hardware.h"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>

namespace lambent::vulkan {

bool may_have_hardware(const std::filesystem::path& devices)
{
#ifdef __linux__
    namespace fs = std::filesystem;
    std::error_code error;
    // Device nodes of NVIDIA's driver, of Windows' devices under WSL, and of Adreno and Mali drivers without DRM.
    constexpr std::array own_nodes = {"nvidiactl", "dxg", "kgsl-3d0", "mali0"};
    if (std::any_of(own_nodes.begin(), own_nodes.end(),
                    [&](const char* name) { return fs::exists(devices / name, error); }))
        return true;
    // Render nodes of DRM; a card that can only drive a display has none.
    for (const fs::directory_entry& node : fs::directory_iterator(devices / "dri", error))
        if (node.path().filename().string().starts_with("renderD"))
            return true;
    return false;
#else
    (void)devices;
    return true;
#endif
}

} // namespace lambent::vulkan
