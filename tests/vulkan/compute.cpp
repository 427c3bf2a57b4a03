#include "tests/vulkan/compute.h"

#include "base/error.h"

#include <cstdlib>
#include <cstring>
#include <string_view>

#if defined(__SANITIZE_ADDRESS__)
#define LAMBENT_LEAKS_ARE_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LAMBENT_LEAKS_ARE_WATCHED 1
#endif
#endif

#ifdef LAMBENT_LEAKS_ARE_WATCHED
// Drivers stay loaded: what they keep to the end, some of it from threads of their own, could not be found any more once
// they are gone, and would count as lost.
extern "C" int dlclose(void*)
{
    return 0;
}
#endif

namespace lambent::test {

bool vulkan_required()
{
    const char* value = std::getenv("LAMBENT_REQUIRE_VULKAN");
    return value && std::string_view(value) == "1";
}

Compute::Compute()
    : instance_(true), device_(instance_, vulkan::choose(instance_.devices(), vulkan::Choice::any)),
      cache_(device_, {})
{
}

std::unique_ptr<Compute> Compute::open()
{
    try {
        return std::unique_ptr<Compute>(new Compute);
    } catch (const Error&) {
        return nullptr;
    }
}

void Compute::run(std::span<const uint32_t> spirv, std::span<std::vector<float>> buffers, Groups groups)
{
    std::vector<vulkan::Buffer> made;
    std::vector<vulkan::Resource> resources;
    made.reserve(buffers.size());
    for (const std::vector<float>& buffer : buffers) {
        made.emplace_back(device_, buffer.size() * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                          vulkan::MemoryKind::readback);
        std::memcpy(made.back().memory().data(), buffer.data(), made.back().bytes());
        resources.push_back({&made.back(), nullptr, VK_NULL_HANDLE});
    }
    const std::vector<vulkan::Binding> bindings(buffers.size(), vulkan::Binding::storage_buffer);
    const vulkan::ShaderLayout layout(device_, bindings, 0);
    const vulkan::ComputePipeline pipeline(cache_, layout, spirv);
    const vulkan::BindingSet set(device_, layout, resources);
    vulkan::Commands commands(device_);
    commands.dispatch(pipeline, set, {}, groups);
    commands.run();
    for (std::size_t i = 0; i < made.size(); ++i)
        std::memcpy(buffers[i].data(), made[i].memory().data(), made[i].bytes());
}

} // namespace lambent::test
