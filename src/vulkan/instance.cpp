#include "vulkan/instance.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cstring>

namespace lambent::vulkan {

VkPhysicalDeviceFeatures2* Features::chain()
{
    newer.pNext = &newest;
    all.pNext = &newer;
    return &all;
}

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

bool has_validation()
{
    std::uint32_t count = 0;
    check(vkEnumerateInstanceLayerProperties(&count, nullptr), "listing layers");
    std::vector<VkLayerProperties> layers(count);
    check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "listing layers");
    return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, validation_layer) == 0;
    });
}

VKAPI_ATTR VkBool32 VKAPI_CALL take_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                            VkDebugUtilsMessageTypeFlagsEXT,
                                            const VkDebugUtilsMessengerCallbackDataEXT* message,
                                            void* messages)
{
    static_cast<ValidationMessages*>(messages)->add(message->pMessage);
    return VK_FALSE;
}

bool has_queue(VkPhysicalDevice device)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    return std::any_of(families.begin(), families.end(), [](const VkQueueFamilyProperties& family) {
        return (family.queueFlags & wanted) == wanted;
    });
}

bool has_features(VkPhysicalDevice device)
{
    Features there;
    vkGetPhysicalDeviceFeatures2(device, there.chain());
    const VkPhysicalDeviceFeatures& old = there.all.features;
    return there.newest.dynamicRendering == VK_TRUE && there.newest.synchronization2 == VK_TRUE &&
           there.newer.bufferDeviceAddress == VK_TRUE && old.geometryShader == VK_TRUE &&
           old.multiDrawIndirect == VK_TRUE && old.drawIndirectFirstInstance == VK_TRUE;
}

VkDeviceSize own_memory(VkPhysicalDevice device)
{
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    VkDeviceSize most = 0;
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if ((memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0)
            most = std::max(most, memory.memoryHeaps[i].size);
    return most;
}

Candidate candidate_of(VkPhysicalDevice device)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    Candidate candidate;
    candidate.device = device;
    candidate.name = properties.deviceName;
    candidate.software = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    candidate.memory = own_memory(device);
    if (properties.apiVersion < VK_API_VERSION_1_3)
        candidate.lacks = "Vulkan 1.3";
    else if (!has_queue(device))
        candidate.lacks = "a queue for graphics and compute";
    else if (!has_features(device))
        candidate.lacks = "a feature (buffer addresses, indirect draws or geometry shaders)";
    candidate.fit = candidate.lacks.empty();
    return candidate;
}

} // namespace

void ValidationMessages::add(const char* message)
{
    const std::lock_guard lock(mutex_);
    messages_.emplace_back(message);
}

std::vector<std::string> ValidationMessages::all() const
{
    const std::lock_guard lock(mutex_);
    return messages_;
}

Instance::Instance(bool validation)
{
    load_library();
    auto application = typed<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "lambent";
    application.apiVersion = VK_API_VERSION_1_3;
    auto info = typed<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    const bool validated = validation && has_validation();
    if (validated) {
        info.enabledLayerCount = info.enabledExtensionCount = 1;
        info.ppEnabledLayerNames = &validation_layer;
        info.ppEnabledExtensionNames = &extension;
    }
    const VkResult started = vkCreateInstance(&info, nullptr, &instance_);
    if (started == VK_ERROR_INCOMPATIBLE_DRIVER)
        throw NoSuchDevice(text("Vulkan: ", meaning(started)));
    check(started, "creating an instance");
    volkLoadInstanceOnly(instance_);
    if (validated)
        receive_messages();
}

Instance::~Instance()
{
    if (messenger_ != VK_NULL_HANDLE)
        vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
    vkDestroyInstance(instance_, nullptr);
}

void Instance::receive_messages()
{
    auto info =
        typed<VkDebugUtilsMessengerCreateInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = take_message;
    info.pUserData = &messages_;
    if (vkCreateDebugUtilsMessengerEXT(instance_, &info, nullptr, &messenger_) != VK_SUCCESS)
        messenger_ = VK_NULL_HANDLE; // goes on without validation
}

std::vector<Candidate> Instance::devices() const
{
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "listing devices");
    std::vector<VkPhysicalDevice> handles(count);
    check(vkEnumeratePhysicalDevices(instance_, &count, handles.data()), "listing devices");
    std::vector<Candidate> candidates;
    candidates.reserve(handles.size());
    for (VkPhysicalDevice handle : handles)
        candidates.push_back(candidate_of(handle));
    return candidates;
}

Candidate choose(const std::vector<Candidate>& devices, Choice choice)
{
    const Candidate* best = nullptr;
    std::string why;
    const auto better = [](const Candidate& a, const Candidate& b) {
        return a.software != b.software ? b.software : a.memory > b.memory;
    };
    for (const Candidate& device : devices) {
        const bool allowed = choice == Choice::any || !device.software;
        if (device.fit && allowed && (!best || better(device, *best)))
            best = &device;
        else if (!device.fit || !allowed)
            why += text("; ", device.name, device.fit ? " is software" : text(" lacks ", device.lacks));
    }
    if (!best)
        throw NoSuchDevice(text("Vulkan: there is no suitable device", why));
    return *best;
}

void Instance::require_no_validation_messages() const
{
    if (const std::vector<std::string> all = validation_messages(); !all.empty())
        throw Error(Failure::no_device, text("Vulkan's validation layer: ", all.front()));
}

} // namespace lambent::vulkan
