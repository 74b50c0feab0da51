#include "report/reproducer.h"

#include <algorithm>

#include "base/format.h"

namespace etalon {
namespace {

constexpr std::uint32_t kSign = 0x80000000u;

constexpr std::string_view kMark = "Written by `etalon run --findings`.";

std::string Notes(const Reproduction& reproduction, std::string_view mark) {
    std::string text = format("{} {}\n{}\n", mark, kMark, mark);
    for (const std::string& note : reproduction.notes) {
        text += std::string(mark) + (note.empty() ? "" : " ") + note + "\n";
    }
    return text;
}

// Bits grow with the number where it is positive and against it where it is negative. An interval
// around zero is what is not above it as an int and not below it as a uint.
std::string Probes(const Reproduction& reproduction) {
    const std::uint32_t at = reproduction.output * 4;
    const auto as_uint = [at](const char* relation, std::uint32_t word) {
        return format("probe ssbo uint 1 {} {} {:#010x}\n", at, relation, word);
    };
    if (!reproduction.is_float) {
        return as_uint("==", reproduction.low);
    }
    const bool low_is_zero = (reproduction.low & ~kSign) == 0;
    const bool high_is_zero = (reproduction.high & ~kSign) == 0;
    const bool low_is_negative = (reproduction.low & kSign) != 0;
    const bool high_is_negative = (reproduction.high & kSign) != 0;
    if (!low_is_negative && !low_is_zero) {
        return as_uint(">=", reproduction.low) + as_uint("<=", reproduction.high);
    }
    if (high_is_negative && !high_is_zero) {
        return as_uint(">=", reproduction.high) + as_uint("<=", reproduction.low);
    }
    return format("probe ssbo int 1 {} <= {}\n", at, reproduction.high & ~kSign) +
           as_uint("<=", reproduction.low | kSign);
}

// Without the lines that only Etalon has a use for.
std::string Tidy(std::string_view glsl) {
    std::string text;
    while (!glsl.empty()) {
        const std::size_t end = std::min(glsl.find('\n'), glsl.size());
        const std::string_view line = glsl.substr(0, end);
        glsl.remove_prefix(std::min(end + 1, glsl.size()));
        const bool is_blank = line.find_first_not_of(" \t") == std::string_view::npos;
        if (!is_blank && !line.starts_with("#line") && !line.starts_with("#version")) {
            text += std::string(line) + "\n";
        }
    }
    return text;
}

std::string Words(std::span<const std::uint32_t> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += format("{}{:#010x},", i % 8 == 0 ? "\n    " : " ", words[i]);
    }
    return text;
}

constexpr std::string_view kVulkanBody = R"(
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <vulkan/vulkan.h>

#define CHECK(call)                                                 \
    do {                                                            \
        VkResult result_ = (call);                                  \
        if (result_ != VK_SUCCESS) {                                \
            fprintf(stderr, "%s: VkResult %d\n", #call, result_); \
            return 2;                                               \
        }                                                           \
    } while (0)

/* Places a float's bits in the order of the numbers; both zeros are 0. */
static int64_t order(uint32_t bits) {
    return bits & 0x80000000u ? -(int64_t)(bits & 0x7fffffffu) : (int64_t)bits;
}

static int is_allowed(uint32_t bits) {
    if (!IS_FLOAT) {
        return bits == LOW;
    }
    return (bits & 0x7fffffffu) <= 0x7f800000u && order(bits) >= order(LOW) &&
           order(bits) <= order(HIGH);
}

static float number(uint32_t bits) {
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

struct buffer {
    VkBuffer handle;
    VkDeviceMemory memory;
    uint32_t* words;
};

static int make_buffer(VkPhysicalDevice physical, VkDevice device, VkDeviceSize size,
                       struct buffer* out) {
    VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = size;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    CHECK(vkCreateBuffer(device, &info, NULL, &out->handle));
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, out->handle, &needs);
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    const VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    uint32_t type = 0;
    while (type < memory.memoryTypeCount &&
           (!(needs.memoryTypeBits & (1u << type)) ||
            (memory.memoryTypes[type].propertyFlags & wanted) != wanted)) {
        ++type;
    }
    VkMemoryAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    allocate.allocationSize = needs.size;
    allocate.memoryTypeIndex = type;
    CHECK(vkAllocateMemory(device, &allocate, NULL, &out->memory));
    CHECK(vkBindBufferMemory(device, out->handle, out->memory, 0));
    CHECK(vkMapMemory(device, out->memory, 0, VK_WHOLE_SIZE, 0, (void**)&out->words));
    memset(out->words, 0, size);
    return 0;
}

int main(int count, char** arguments) {
    const char* wanted = count > 1 ? arguments[1] : DEVICE;
    VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo instance_info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    instance_info.pApplicationInfo = &application;
    VkInstance instance;
    CHECK(vkCreateInstance(&instance_info, NULL, &instance));

    VkPhysicalDevice found[16];
    uint32_t devices = 16;
    vkEnumeratePhysicalDevices(instance, &devices, found);
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    for (uint32_t i = 0; i < devices && physical == VK_NULL_HANDLE; ++i) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(found[i], &properties);
        if (strstr(properties.deviceName, wanted) != NULL) {
            physical = found[i];
            printf("%s, driver version %#x\n", properties.deviceName, properties.driverVersion);
        }
    }
    if (physical == VK_NULL_HANDLE) {
        fprintf(stderr, "no device's name contains '%s'\n", wanted);
        return 2;
    }
    VkQueueFamilyProperties families[16];
    uint32_t family_count = 16;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &family_count, families);
    uint32_t family = 0;
    while (family < family_count && !(families[family].queueFlags & VK_QUEUE_COMPUTE_BIT)) {
        ++family;
    }
    const float priority = 1;
    VkDeviceQueueCreateInfo queue_info = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue_info.queueFamilyIndex = family;
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    VkDeviceCreateInfo device_info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    device_info.queueCreateInfoCount = 1;
    device_info.pQueueCreateInfos = &queue_info;
    VkDevice device;
    CHECK(vkCreateDevice(physical, &device_info, NULL, &device));
    VkQueue queue;
    vkGetDeviceQueue(device, family, 0, &queue);

    struct buffer buffers[2];
    if (make_buffer(physical, device, sizeof inputs, &buffers[0]) != 0 ||
        make_buffer(physical, device, 4 * OUTPUTS, &buffers[1]) != 0) {
        return 2;
    }
    memcpy(buffers[0].words, inputs, sizeof inputs);

    VkDescriptorSetLayoutBinding bindings[2];
    memset(bindings, 0, sizeof bindings);
    for (uint32_t i = 0; i < 2; ++i) {
        bindings[i].binding = i;
        bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        bindings[i].descriptorCount = 1;
        bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
    }
    VkDescriptorSetLayoutCreateInfo set_info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    set_info.bindingCount = 2;
    set_info.pBindings = bindings;
    VkDescriptorSetLayout set_layout;
    CHECK(vkCreateDescriptorSetLayout(device, &set_info, NULL, &set_layout));
    VkPipelineLayoutCreateInfo layout_info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layout_info.setLayoutCount = 1;
    layout_info.pSetLayouts = &set_layout;
    VkPipelineLayout layout;
    CHECK(vkCreatePipelineLayout(device, &layout_info, NULL, &layout));
    VkShaderModuleCreateInfo module_info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    module_info.codeSize = sizeof spirv;
    module_info.pCode = spirv;
    VkShaderModule module;
    CHECK(vkCreateShaderModule(device, &module_info, NULL, &module));
    VkComputePipelineCreateInfo pipeline_info = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    pipeline_info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    pipeline_info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    pipeline_info.stage.module = module;
    pipeline_info.stage.pName = "main";
    pipeline_info.layout = layout;
    VkPipeline pipeline;
    CHECK(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &pipeline_info, NULL, &pipeline));

    const VkDescriptorPoolSize pool_size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
    VkDescriptorPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &pool_size;
    VkDescriptorPool pool;
    CHECK(vkCreateDescriptorPool(device, &pool_info, NULL, &pool));
    VkDescriptorSetAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &set_layout;
    VkDescriptorSet set;
    CHECK(vkAllocateDescriptorSets(device, &allocate, &set));
    for (uint32_t i = 0; i < 2; ++i) {
        const VkDescriptorBufferInfo whole = {buffers[i].handle, 0, VK_WHOLE_SIZE};
        VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = set;
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &whole;
        vkUpdateDescriptorSets(device, 1, &write, 0, NULL);
    }

    VkCommandPoolCreateInfo commands_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    commands_info.queueFamilyIndex = family;
    VkCommandPool command_pool;
    CHECK(vkCreateCommandPool(device, &commands_info, NULL, &command_pool));
    VkCommandBufferAllocateInfo command_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    command_info.commandPool = command_pool;
    command_info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    command_info.commandBufferCount = 1;
    VkCommandBuffer commands;
    CHECK(vkAllocateCommandBuffers(device, &command_info, &commands));
    VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    CHECK(vkBeginCommandBuffer(commands, &begin));
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, NULL);
    vkCmdDispatch(commands, 1, 1, 1);
    VkMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                         0, 1, &barrier, 0, NULL, 0, NULL);
    CHECK(vkEndCommandBuffer(commands));
    VkSubmitInfo submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    CHECK(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE));
    CHECK(vkQueueWaitIdle(queue));

    const uint32_t seen = buffers[1].words[OUTPUT];
    const int allowed = is_allowed(seen);
    if (IS_FLOAT) {
        printf("result  %#010x = %a\nallowed %#010x = %a to %#010x = %a\n", seen, number(seen), LOW,
               number(LOW), HIGH, number(HIGH));
    } else {
        printf("result  %#010x\nallowed %#010x\n", seen, LOW);
    }
    puts(allowed ? "allowed" : "OUTSIDE");
    return allowed ? 0 : 1;
}
)";

}  // namespace

bool IsReproducer(std::string_view text) {
    return text.substr(0, text.find('\n')).ends_with(kMark);
}

std::string ShaderTest(const Reproduction& reproduction, std::string_view glsl,
                       std::uint32_t version) {
    const bool has_compute = version >= 430;
    constexpr std::string_view kExtensions[] = {"GL_ARB_compute_shader",
                                                "GL_ARB_shader_storage_buffer_object",
                                                "GL_ARB_shading_language_420pack"};
    std::string text = Notes(reproduction, "#") +
                       format("\n[require]\nGLSL >= {}.{:02}\n", version / 100, version % 100);
    for (const std::string_view extension : kExtensions) {
        text += has_compute ? "" : std::string(extension) + "\n";
    }
    text += format("\n[compute shader]\n#version {} core\n", version);
    for (const std::string_view extension : kExtensions) {
        text += has_compute ? "" : "#extension " + std::string(extension) + " : require\n";
    }
    text += Tidy(glsl);
    text += format("\n[test]\nssbo 0 {}\nssbo 0 subdata int 0 1\n",
                   4 * (reproduction.inputs.size() + 1));
    for (std::size_t i = 0; i < reproduction.inputs.size(); ++i) {
        text += format("ssbo 0 subdata int {} {}\n", 4 * (i + 1),
                       static_cast<std::int32_t>(reproduction.inputs[i]));
    }
    text += format("ssbo 1 {}\ncompute 1 1 1\n", 4 * reproduction.outputs);
    return text + Probes(reproduction);
}

std::string VulkanProgram(const Reproduction& reproduction, std::span<const std::uint32_t> spirv,
                          std::string_view device) {
    std::vector<std::uint32_t> inputs = {1};
    inputs.insert(inputs.end(), reproduction.inputs.begin(), reproduction.inputs.end());
    return Notes(reproduction, "//") +
           format(
               "\n#define DEVICE \"{}\"\n#define IS_FLOAT {}\n#define LOW {:#010x}u\n"
               "#define HIGH {:#010x}u\n#define OUTPUTS {}u\n#define OUTPUT {}u\n",
               device, reproduction.is_float ? 1 : 0, reproduction.low, reproduction.high,
               reproduction.outputs, reproduction.output) +
           std::string(kVulkanBody.substr(0, kVulkanBody.find("\n#define CHECK") + 1)) +
           "// The number of rows, then the inputs' words.\nstatic const uint32_t inputs[] = {" +
           Words(inputs) + "\n};\n\nstatic const uint32_t spirv[] = {" + Words(spirv) + "\n};\n\n" +
           std::string(kVulkanBody.substr(kVulkanBody.find("\n#define CHECK") + 1));
}

}  // namespace etalon
