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
    // NVIDIA's own driver; Windows' devices under WSL; Adreno and Mali without the kernel's common interface.
    constexpr std::array own_nodes = {"nvidiactl", "dxg", "kgsl-3d0", "mali0"};
    if (std::any_of(own_nodes.begin(), own_nodes.end(),
                    [&](const char* name) { return fs::exists(devices / name, error); }))
        return true;
    // The kernel's: a card that only shows pictures has no node to render by.
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
