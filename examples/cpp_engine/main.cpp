// A stripped scene in a C++17 engine over Vulkan: the module, its table, and the generated header.
//
//   corput strip tests/data/scenes/diffuse_sky.toml --out out --target spirv,c
//   c++ -std=c++17 -O2 -I out examples/cpp_engine/main.cpp -o cpp_engine -lvulkan
//   ./cpp_engine out
//
// It draws all samples on every device and prints a checksum of their words, which is the same
// on all. It needs the Vulkan headers and loader: libvulkan-dev on Debian and Ubuntu.

#include "diffuse_sky.h"

#include <vulkan/vulkan.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

void check(VkResult result, const char* call) {
    if (result != VK_SUCCESS) {
        throw std::runtime_error(std::string(call) + " gave " + std::to_string(result));
    }
}
#define CHECK(call, ...) check(call(__VA_ARGS__), #call)

// Files of words have the lowest byte first, as have the machines that this is for.
std::vector<uint32_t> read_words(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::vector<uint32_t> words(file ? static_cast<size_t>(file.tellg()) / 4 : 0);
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(4 * words.size()))) {
        throw std::runtime_error("cannot read " + path);
    }
    return words;
}

// A storage buffer that the host sees; an engine uploads to device-local memory instead.
struct Buffer {
    VkBuffer buffer;
    VkDeviceMemory memory;
    void* at;
};

Buffer make_buffer(VkPhysicalDevice physical, VkDevice device, VkDeviceSize bytes) {
    Buffer made = {};
    VkBufferCreateInfo create = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    create.size = bytes;
    create.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    CHECK(vkCreateBuffer, device, &create, nullptr, &made.buffer);
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, made.buffer, &needs);
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    const VkMemoryPropertyFlags visible =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkMemoryAllocateInfo allocate = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    allocate.allocationSize = needs.size;
    // Every device has such a type for every buffer.
    while ((needs.memoryTypeBits >> allocate.memoryTypeIndex & 1) == 0 ||
           (memory.memoryTypes[allocate.memoryTypeIndex].propertyFlags & visible) != visible) {
        allocate.memoryTypeIndex++;
    }
    CHECK(vkAllocateMemory, device, &allocate, nullptr, &made.memory);
    CHECK(vkBindBufferMemory, device, made.buffer, made.memory, 0);
    CHECK(vkMapMemory, device, made.memory, 0, VK_WHOLE_SIZE, 0, &made.at);
    return made;
}

// The words of samples `push.first` to `push.first + push.count - 1`.
std::vector<uint32_t> draw(VkPhysicalDevice physical, const std::vector<uint32_t>& module,
                           const std::vector<uint32_t>& table, DiffuseSkyPush push) {
    uint32_t family = 0;
    uint32_t count = 32;
    VkQueueFamilyProperties families[32];
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families);
    while (family < count && (families[family].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) {
        family++;
    }
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queues = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queues.queueFamilyIndex = family;
    queues.queueCount = 1;
    queues.pQueuePriorities = &priority;
    VkDeviceCreateInfo create_device = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    create_device.queueCreateInfoCount = 1;
    create_device.pQueueCreateInfos = &queues;
    VkDevice device;
    CHECK(vkCreateDevice, physical, &create_device, nullptr, &device);
    VkQueue queue;
    vkGetDeviceQueue(device, family, 0, &queue);

    const size_t made = size_t{push.count} * DIFFUSE_SKY_RECORD_WORDS;
    const uint32_t multiple = DIFFUSE_SKY_SAMPLES_MULTIPLE;
    const VkDeviceSize rounded = (VkDeviceSize{push.count} + multiple - 1) / multiple * multiple;
    const Buffer buffers[] = {
        make_buffer(physical, device, rounded * DIFFUSE_SKY_STRIDE_SAMPLES),
        make_buffer(physical, device, 4 * table.size()),
    };
    std::memcpy(buffers[1].at, table.data(), 4 * table.size());
    const uint32_t numbers[] = {DIFFUSE_SKY_BINDING_SAMPLES, DIFFUSE_SKY_BINDING_ENVIRONMENT};

    VkDescriptorSetLayoutBinding bindings[2] = {};
    for (int i = 0; i < 2; i++) {
        bindings[i].binding = numbers[i];
        bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        bindings[i].descriptorCount = 1;
        bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
    }
    VkDescriptorSetLayoutCreateInfo create_set = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    create_set.bindingCount = 2;
    create_set.pBindings = bindings;
    VkDescriptorSetLayout set_layout;
    CHECK(vkCreateDescriptorSetLayout, device, &create_set, nullptr, &set_layout);
    const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, DIFFUSE_SKY_PUSH_BYTES};
    VkPipelineLayoutCreateInfo create_layout = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    create_layout.setLayoutCount = 1;
    create_layout.pSetLayouts = &set_layout;
    create_layout.pushConstantRangeCount = 1;
    create_layout.pPushConstantRanges = &range;
    VkPipelineLayout layout;
    CHECK(vkCreatePipelineLayout, device, &create_layout, nullptr, &layout);

    VkShaderModuleCreateInfo create_shader = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    create_shader.codeSize = 4 * module.size();
    create_shader.pCode = module.data();
    VkShaderModule shader;
    CHECK(vkCreateShaderModule, device, &create_shader, nullptr, &shader);
    VkComputePipelineCreateInfo create_pipeline = {VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    create_pipeline.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    create_pipeline.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    create_pipeline.stage.module = shader;
    create_pipeline.stage.pName = DIFFUSE_SKY_ENTRY_POINT;
    create_pipeline.layout = layout;
    VkPipeline pipeline;
    CHECK(vkCreateComputePipelines, device, VK_NULL_HANDLE, 1, &create_pipeline, nullptr, &pipeline);

    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
    VkDescriptorPoolCreateInfo create_pool = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    create_pool.maxSets = 1;
    create_pool.poolSizeCount = 1;
    create_pool.pPoolSizes = &size;
    VkDescriptorPool pool;
    CHECK(vkCreateDescriptorPool, device, &create_pool, nullptr, &pool);
    VkDescriptorSetAllocateInfo allocate_set = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate_set.descriptorPool = pool;
    allocate_set.descriptorSetCount = 1;
    allocate_set.pSetLayouts = &set_layout;
    VkDescriptorSet set;
    CHECK(vkAllocateDescriptorSets, device, &allocate_set, &set);
    for (int i = 0; i < 2; i++) {
        const VkDescriptorBufferInfo whole = {buffers[i].buffer, 0, VK_WHOLE_SIZE};
        VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = set;
        write.dstBinding = numbers[i];
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &whole;
        vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
    }

    VkCommandPoolCreateInfo create_commands = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    create_commands.queueFamilyIndex = family;
    VkCommandPool command_pool;
    CHECK(vkCreateCommandPool, device, &create_commands, nullptr, &command_pool);
    VkCommandBufferAllocateInfo allocate_commands = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate_commands.commandPool = command_pool;
    allocate_commands.commandBufferCount = 1;
    VkCommandBuffer commands;
    CHECK(vkAllocateCommandBuffers, device, &allocate_commands, &commands);
    const VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    CHECK(vkBeginCommandBuffer, commands, &begin);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
    vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push, &push);
    // These are few; more groups than the x axis holds go over x and y.
    const uint32_t invocations = (push.count + DIFFUSE_SKY_RUN - 1) / DIFFUSE_SKY_RUN;
    vkCmdDispatch(commands, (invocations + DIFFUSE_SKY_WORKGROUP_X - 1) / DIFFUSE_SKY_WORKGROUP_X, 1, 1);
    // Here the host reads next; before a shader that does it is its stage, with SHADER_READ.
    VkMemoryBarrier written = {VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &written, 0, nullptr, 0, nullptr);
    CHECK(vkEndCommandBuffer, commands);
    VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    CHECK(vkQueueSubmit, queue, 1, &submit, VK_NULL_HANDLE);
    CHECK(vkQueueWaitIdle, queue);

    std::vector<uint32_t> words(made);
    std::memcpy(words.data(), buffers[0].at, 4 * made);
    vkDestroyCommandPool(device, command_pool, nullptr);
    vkDestroyDescriptorPool(device, pool, nullptr);
    vkDestroyPipeline(device, pipeline, nullptr);
    vkDestroyShaderModule(device, shader, nullptr);
    vkDestroyPipelineLayout(device, layout, nullptr);
    vkDestroyDescriptorSetLayout(device, set_layout, nullptr);
    for (const Buffer& buffer : buffers) {
        vkDestroyBuffer(device, buffer.buffer, nullptr);
        vkFreeMemory(device, buffer.memory, nullptr);
    }
    vkDestroyDevice(device, nullptr);
    return words;
}

void run(const std::string& folder) {
    const std::vector<uint32_t> module = read_words(folder + "/diffuse_sky.spv");
    const std::vector<uint32_t> table = read_words(folder + "/diffuse_sky.environment.bin");
    if (module.size() != DIFFUSE_SKY_SPIRV_WORDS) {
        throw std::runtime_error("diffuse_sky.h is of another module");
    }
    VkApplicationInfo about = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
    about.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo create = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    create.pApplicationInfo = &about;
    VkInstance instance;
    CHECK(vkCreateInstance, &create, nullptr, &instance);
    uint32_t count = 8;
    VkPhysicalDevice devices[8];
    const VkResult listed = vkEnumeratePhysicalDevices(instance, &count, devices);
    check(listed == VK_INCOMPLETE ? VK_SUCCESS : listed, "vkEnumeratePhysicalDevices");
    for (uint32_t i = 0; i < count; i++) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        if (properties.apiVersion < VK_API_VERSION_1_1) {
            continue;  // it takes no SPIR-V 1.3
        }
        const DiffuseSkyPush all = {0, DIFFUSE_SKY_SAMPLES_MOST};
        uint64_t sum = 0xcbf29ce484222325u;  // FNV-1a, of words
        for (const uint32_t word : draw(devices[i], module, table, all)) {
            sum = (sum ^ word) * 0x100000001b3u;
        }
        std::printf("%016llx %s\n", static_cast<unsigned long long>(sum), properties.deviceName);
    }
    vkDestroyInstance(instance, nullptr);
}

}  // namespace

int main(int count, char** arguments) {
    try {
        run(count > 1 ? arguments[1] : "out");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cpp_engine: %s\n", error.what());
        return 1;
    }
    return 0;
}
