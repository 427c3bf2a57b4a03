#include "tests/vulkan/compute.h"

#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>

#if defined(__SANITIZE_ADDRESS__)
#define LAMBENT_LEAKS_ARE_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LAMBENT_LEAKS_ARE_WATCHED 1
#endif
#endif
#ifdef LAMBENT_LEAKS_ARE_WATCHED
#include <sanitizer/lsan_interface.h>
#endif

namespace lambent::test {
namespace {

// A structure of Vulkan's with its type set and all else zero.
template <class Structure>
Structure typed(VkStructureType type)
{
    Structure structure = {};
    structure.sType = type;
    return structure;
}

// Drivers keep some memory to the end of the program: not leaks of ours while one of these lives.
struct LeaksOfDrivers {
#ifdef LAMBENT_LEAKS_ARE_WATCHED
    LeaksOfDrivers()
    {
        __lsan_disable();
    }
    ~LeaksOfDrivers()
    {
        __lsan_enable();
    }
#endif
};

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

bool has_validation(const Api& api)
{
    uint32_t count = 0;
    check(api.EnumerateInstanceLayerProperties(&count, nullptr), "vkEnumerateInstanceLayerProperties");
    std::vector<VkLayerProperties> layers(count);
    check(api.EnumerateInstanceLayerProperties(&count, layers.data()), "vkEnumerateInstanceLayerProperties");
    for (const VkLayerProperties& layer : layers)
        if (std::strcmp(layer.layerName, validation_layer) == 0)
            return true;
    return false;
}

VKAPI_ATTR VkBool32 VKAPI_CALL take_complaint(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                              VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* message,
                                              void* complaints)
{
    static_cast<std::vector<std::string>*>(complaints)->emplace_back(message->pMessage);
    return VK_FALSE;
}

// Index of a queue family that can compute; -1 where none can.
int compute_family(const Api& api, VkPhysicalDevice device)
{
    uint32_t count = 0;
    api.GetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    api.GetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    for (uint32_t i = 0; i < count; i++)
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT)
            return static_cast<int>(i);
    return -1;
}

} // namespace

Compute::Undo::~Undo()
{
    while (!steps.empty()) {
        steps.back()();
        steps.pop_back();
    }
}

bool vulkan_required()
{
    const char* value = std::getenv("LAMBENT_REQUIRE_VULKAN");
    return value && std::string_view(value) == "1";
}

std::unique_ptr<Compute> Compute::open()
{
    [[maybe_unused]] const LeaksOfDrivers allowed;
    std::unique_ptr<Compute> compute(new Compute);
    if (!compute->api_.load() || !compute->make_instance() || !compute->make_device())
        return nullptr;
    return compute;
}

Compute::~Compute()
{
    if (device_)
        api_.DestroyDevice(device_, nullptr);
    if (messenger_) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            api_.GetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance_, messenger_, nullptr);
    }
    if (instance_)
        api_.DestroyInstance(instance_, nullptr);
}

bool Compute::make_instance()
{
    auto application = typed<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "lambent tests";
    application.apiVersion = VK_API_VERSION_1_1;
    auto info = typed<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    const bool validation = has_validation(api_);
    if (validation) {
        info.enabledLayerCount = info.enabledExtensionCount = 1;
        info.ppEnabledLayerNames = &validation_layer;
        info.ppEnabledExtensionNames = &extension;
    }
    if (api_.CreateInstance(&info, nullptr, &instance_) != VK_SUCCESS)
        return false; // a library without a driver
    api_.load_instance(instance_);
    if (validation)
        watch();
    return true;
}

void Compute::watch()
{
    auto info =
        typed<VkDebugUtilsMessengerCreateInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = take_complaint;
    info.pUserData = &complaints_;
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        api_.GetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
    check(create(instance_, &info, nullptr, &messenger_), "vkCreateDebugUtilsMessengerEXT");
}

bool Compute::make_device()
{
    uint32_t count = 0;
    check(api_.EnumeratePhysicalDevices(instance_, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> devices(count);
    check(api_.EnumeratePhysicalDevices(instance_, &count, devices.data()), "vkEnumeratePhysicalDevices");
    for (VkPhysicalDevice candidate : devices) {
        VkPhysicalDeviceProperties properties;
        api_.GetPhysicalDeviceProperties(candidate, &properties);
        const int family = compute_family(api_, candidate);
        if (family < 0 || properties.apiVersion < VK_API_VERSION_1_1)
            continue;
        physical_ = candidate;
        family_ = static_cast<uint32_t>(family);
        device_name_ = properties.deviceName;
        const float priority = 1.0f;
        auto queue = typed<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
        queue.queueFamilyIndex = family_;
        queue.queueCount = 1;
        queue.pQueuePriorities = &priority;
        auto info = typed<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
        info.queueCreateInfoCount = 1;
        info.pQueueCreateInfos = &queue;
        check(api_.CreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
        api_.load_device(device_);
        api_.GetDeviceQueue(device_, family_, 0, &queue_);
        return true;
    }
    return false;
}

uint32_t Compute::shared_memory_type(uint32_t allowed) const
{
    constexpr VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkPhysicalDeviceMemoryProperties memory;
    api_.GetPhysicalDeviceMemoryProperties(physical_, &memory);
    for (uint32_t i = 0; i < memory.memoryTypeCount; i++)
        if ((allowed & (1u << i)) && (memory.memoryTypes[i].propertyFlags & wanted) == wanted)
            return i;
    throw std::runtime_error(
        "the Vulkan device shares no memory with the host"); // Vulkan promises one such type
}

Compute::Buffer Compute::make_buffer(size_t floats, Undo& undo) const
{
    Buffer made = {VK_NULL_HANDLE, VK_NULL_HANDLE, floats * sizeof(float)};
    auto info = typed<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = made.bytes;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    check(api_.CreateBuffer(device_, &info, nullptr, &made.buffer), "vkCreateBuffer");
    undo.steps.push_back([this, made] { api_.DestroyBuffer(device_, made.buffer, nullptr); });

    VkMemoryRequirements needs;
    api_.GetBufferMemoryRequirements(device_, made.buffer, &needs);
    auto allocation = typed<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    allocation.allocationSize = needs.size;
    allocation.memoryTypeIndex = shared_memory_type(needs.memoryTypeBits);
    check(api_.AllocateMemory(device_, &allocation, nullptr, &made.memory), "vkAllocateMemory");
    undo.steps.push_back([this, made] { api_.FreeMemory(device_, made.memory, nullptr); });
    check(api_.BindBufferMemory(device_, made.buffer, made.memory, 0), "vkBindBufferMemory");
    return made;
}

void Compute::copy_in(const Buffer& buffer, const std::vector<float>& from) const
{
    void* mapped = nullptr;
    check(api_.MapMemory(device_, buffer.memory, 0, buffer.bytes, 0, &mapped), "vkMapMemory");
    std::memcpy(mapped, from.data(), buffer.bytes);
    api_.UnmapMemory(device_, buffer.memory);
}

void Compute::copy_out(const Buffer& buffer, std::vector<float>& to) const
{
    void* mapped = nullptr;
    check(api_.MapMemory(device_, buffer.memory, 0, buffer.bytes, 0, &mapped), "vkMapMemory");
    std::memcpy(to.data(), mapped, buffer.bytes);
    api_.UnmapMemory(device_, buffer.memory);
}

VkDescriptorSetLayout Compute::make_set_layout(uint32_t buffers, Undo& undo) const
{
    std::vector<VkDescriptorSetLayoutBinding> bindings(buffers);
    for (uint32_t i = 0; i < buffers; i++)
        bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    auto info = typed<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    info.bindingCount = buffers;
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    check(api_.CreateDescriptorSetLayout(device_, &info, nullptr, &layout), "vkCreateDescriptorSetLayout");
    undo.steps.push_back([this, layout] { api_.DestroyDescriptorSetLayout(device_, layout, nullptr); });
    return layout;
}

VkDescriptorSet Compute::make_set(VkDescriptorSetLayout layout, const std::vector<Buffer>& buffers,
                                  Undo& undo) const
{
    const uint32_t count = static_cast<uint32_t>(buffers.size());
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count};
    auto info = typed<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = info.poolSizeCount = 1;
    info.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(api_.CreateDescriptorPool(device_, &info, nullptr, &pool), "vkCreateDescriptorPool");
    undo.steps.push_back([this, pool] { api_.DestroyDescriptorPool(device_, pool, nullptr); });

    auto allocation = typed<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    allocation.descriptorPool = pool;
    allocation.descriptorSetCount = 1;
    allocation.pSetLayouts = &layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(api_.AllocateDescriptorSets(device_, &allocation, &set), "vkAllocateDescriptorSets");

    for (uint32_t i = 0; i < count; i++) {
        const VkDescriptorBufferInfo buffer = {buffers[i].buffer, 0, buffers[i].bytes};
        auto write = typed<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        write.dstSet = set;
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &buffer;
        api_.UpdateDescriptorSets(device_, 1, &write, 0, nullptr);
    }
    return set;
}

VkPipeline Compute::make_pipeline(std::span<const uint32_t> spirv, VkPipelineLayout layout, Undo& undo) const
{
    auto code = typed<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    code.codeSize = spirv.size_bytes();
    code.pCode = spirv.data();
    VkShaderModule shader = VK_NULL_HANDLE;
    check(api_.CreateShaderModule(device_, &code, nullptr, &shader), "vkCreateShaderModule");
    undo.steps.push_back([this, shader] { api_.DestroyShaderModule(device_, shader, nullptr); });

    auto info = typed<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader;
    info.stage.pName = "main";
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(api_.CreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "vkCreateComputePipelines");
    undo.steps.push_back([this, pipeline] { api_.DestroyPipeline(device_, pipeline, nullptr); });
    return pipeline;
}

VkCommandBuffer Compute::begin_commands(Undo& undo) const
{
    auto info = typed<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    info.queueFamilyIndex = family_;
    VkCommandPool pool = VK_NULL_HANDLE;
    check(api_.CreateCommandPool(device_, &info, nullptr, &pool), "vkCreateCommandPool");
    undo.steps.push_back([this, pool] { api_.DestroyCommandPool(device_, pool, nullptr); });

    auto allocation = typed<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    allocation.commandPool = pool;
    allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocation.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(api_.AllocateCommandBuffers(device_, &allocation, &commands), "vkAllocateCommandBuffers");
    auto begin = typed<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(api_.BeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    return commands;
}

void Compute::submit_and_wait(VkCommandBuffer commands) const
{
    auto written = typed<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    api_.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                            &written, 0, nullptr, 0, nullptr);
    check(api_.EndCommandBuffer(commands), "vkEndCommandBuffer");
    auto submit = typed<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    check(api_.QueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(api_.QueueWaitIdle(queue_), "vkQueueWaitIdle");
}

void Compute::run(std::span<const uint32_t> spirv, std::span<std::vector<float>> buffers, Groups groups)
{
    Undo undo;
    std::vector<Buffer> made;
    for (const std::vector<float>& buffer : buffers) {
        made.push_back(make_buffer(buffer.size(), undo));
        copy_in(made.back(), buffer);
    }
    const VkDescriptorSetLayout set_layout = make_set_layout(static_cast<uint32_t>(made.size()), undo);
    const VkDescriptorSet set = make_set(set_layout, made, undo);
    auto info = typed<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_layout;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    check(api_.CreatePipelineLayout(device_, &info, nullptr, &layout), "vkCreatePipelineLayout");
    undo.steps.push_back([this, layout] { api_.DestroyPipelineLayout(device_, layout, nullptr); });

    const VkPipeline pipeline = make_pipeline(spirv, layout, undo);
    const VkCommandBuffer commands = begin_commands(undo);
    api_.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    api_.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
    api_.CmdDispatch(commands, groups.x, groups.y, groups.z);
    submit_and_wait(commands);
    for (size_t i = 0; i < made.size(); i++)
        copy_out(made[i], buffers[i]);
}

} // namespace lambent::test
