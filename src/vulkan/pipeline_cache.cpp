#include "vulkan/pipeline_cache.h"

#include "base/error.h"
#include "base/file.h"

#include <cstring>
#include <system_error>
#include <vector>

namespace lambent::vulkan {
namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;

using Bytes = std::vector<std::uint8_t>;

Bytes read(const std::filesystem::path& file)
{
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(file, error))
        return {};
    try {
        return read_file(file, most_bytes);
    } catch (const Error&) {
        return {};
    }
}

// Compares the header with the device, because not all drivers do so themselves.
bool is_of(const VkPhysicalDeviceProperties& properties, const Bytes& bytes)
{
    VkPipelineCacheHeaderVersionOne header;
    if (bytes.size() < sizeof header)
        return false;
    std::memcpy(&header, bytes.data(), sizeof header);
    return header.headerSize == sizeof header &&
           header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == properties.vendorID && header.deviceID == properties.deviceID &&
           std::memcmp(header.pipelineCacheUUID, properties.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

} // namespace

PipelineCache::PipelineCache(const Device& device, std::filesystem::path file)
    : device_(device), file_(std::move(file))
{
    Bytes bytes = read(file_);
    if (!is_of(device.properties(), bytes))
        bytes.clear();
    auto info = typed<VkPipelineCacheCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
    info.initialDataSize = bytes.size();
    info.pInitialData = bytes.data();
    loaded_ = !bytes.empty();
    bytes_before_ = bytes.size();
    check(device.call().vkCreatePipelineCache(device.handle(), &info, nullptr, &cache_),
          "creating a pipeline cache");
}

PipelineCache::~PipelineCache()
{
    device_.call().vkDestroyPipelineCache(device_.handle(), cache_, nullptr);
}

void PipelineCache::keep() const
{
    std::size_t size = 0;
    if (file_.empty() ||
        device_.call().vkGetPipelineCacheData(device_.handle(), cache_, &size, nullptr) != VK_SUCCESS ||
        size <= bytes_before_ || size > most_bytes)
        return;
    Bytes bytes(size);
    if (device_.call().vkGetPipelineCacheData(device_.handle(), cache_, &size, bytes.data()) != VK_SUCCESS)
        return;
    bytes.resize(size);
    std::error_code ignored;
    std::filesystem::create_directories(file_.parent_path(), ignored);
    try {
        write_file(file_, bytes);
    } catch (const Error&) { // harmless: the next run compiles again
    }
}

} // namespace lambent::vulkan
