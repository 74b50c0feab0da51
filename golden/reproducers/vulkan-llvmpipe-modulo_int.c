// Written by `etalon run --findings`.
//
// llvmpipe (LLVM 15.0.6, 256 bits) returns for i % k
//
//     i = 2147483647 = 2147483647 (0x7fffffff)
//     k = -2147483648 = -2147483648 (0x80000000)
//     result: 2147483647 = 2147483647 (0x7fffffff)
//
// vulkan-1.3 allows
//
//     from -1 = -1 (0xffffffff)
//     to   -1 = -1 (0xffffffff)
//
// Seen on vulkan:llvmpipe, llvmpipe Mesa 22.3.6.
// Run: cc vulkan-llvmpipe-modulo_int.c -lvulkan && ./a.out

#define DEVICE "llvmpipe"
#define IS_FLOAT 0
#define LOW 0xffffffffu
#define HIGH 0xffffffffu
#define OUTPUTS 1u
#define OUTPUT 0u

#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <vulkan/vulkan.h>

// The number of rows, then the inputs' words.
static const uint32_t inputs[] = {
    0x00000001, 0x7fffffff, 0x80000000,
};

static const uint32_t spirv[] = {
    0x07230203, 0x00010300, 0x0008000b, 0x00000057, 0x00000000, 0x00020011, 0x00000001, 0x0006000b,
    0x00000001, 0x4c534c47, 0x6474732e, 0x3035342e, 0x00000000, 0x0003000e, 0x00000000, 0x00000001,
    0x0006000f, 0x00000005, 0x00000004, 0x6e69616d, 0x00000000, 0x00000016, 0x00060010, 0x00000004,
    0x00000011, 0x00000040, 0x00000001, 0x00000001, 0x00030003, 0x00000002, 0x000001c2, 0x000a0004,
    0x475f4c47, 0x4c474f4f, 0x70635f45, 0x74735f70, 0x5f656c79, 0x656e696c, 0x7269645f, 0x69746365,
    0x00006576, 0x00080004, 0x475f4c47, 0x4c474f4f, 0x6e695f45, 0x64756c63, 0x69645f65, 0x74636572,
    0x00657669, 0x00040005, 0x00000004, 0x6e69616d, 0x00000000, 0x00090005, 0x0000000c, 0x6c617465,
    0x655f6e6f, 0x756c6176, 0x28657461, 0x693b3169, 0x31693b31, 0x0000003b, 0x00050005, 0x00000009,
    0x6c617465, 0x725f6e6f, 0x00000030, 0x00030005, 0x0000000a, 0x00000069, 0x00030005, 0x0000000b,
    0x0000006b, 0x00050005, 0x00000013, 0x6c617465, 0x725f6e6f, 0x0000776f, 0x00080005, 0x00000016,
    0x475f6c67, 0x61626f6c, 0x766e496c, 0x7461636f, 0x496e6f69, 0x00000044, 0x00060005, 0x0000001d,
    0x6c617465, 0x495f6e6f, 0x7475706e, 0x00000073, 0x00060006, 0x0000001d, 0x00000000, 0x6c617465,
    0x725f6e6f, 0x0073776f, 0x00060006, 0x0000001d, 0x00000001, 0x6c617465, 0x695f6e6f, 0x0000006e,
    0x00030005, 0x0000001f, 0x00000000, 0x00050005, 0x00000029, 0x6c617465, 0x615f6e6f, 0x00000030,
    0x00050005, 0x00000033, 0x6c617465, 0x615f6e6f, 0x00000031, 0x00050005, 0x0000003d, 0x6c617465,
    0x725f6e6f, 0x00000030, 0x00040005, 0x0000003e, 0x61726170, 0x0000006d, 0x00040005, 0x0000003f,
    0x61726170, 0x0000006d, 0x00040005, 0x00000041, 0x61726170, 0x0000006d, 0x00060005, 0x00000046,
    0x6c617465, 0x4f5f6e6f, 0x75707475, 0x00007374, 0x00060006, 0x00000046, 0x00000000, 0x6c617465,
    0x6f5f6e6f, 0x00007475, 0x00030005, 0x00000048, 0x00000000, 0x00080005, 0x00000054, 0x6c617465,
    0x775f6e6f, 0x5f64726f, 0x69736f70, 0x6e6f6974, 0x00000000, 0x00040047, 0x00000016, 0x0000000b,
    0x0000001c, 0x00040047, 0x0000001c, 0x00000006, 0x00000004, 0x00040048, 0x0000001d, 0x00000000,
    0x00000018, 0x00050048, 0x0000001d, 0x00000000, 0x00000023, 0x00000000, 0x00040048, 0x0000001d,
    0x00000001, 0x00000018, 0x00050048, 0x0000001d, 0x00000001, 0x00000023, 0x00000004, 0x00030047,
    0x0000001d, 0x00000002, 0x00040047, 0x0000001f, 0x00000022, 0x00000000, 0x00040047, 0x0000001f,
    0x00000021, 0x00000000, 0x00040047, 0x00000045, 0x00000006, 0x00000004, 0x00040048, 0x00000046,
    0x00000000, 0x00000019, 0x00050048, 0x00000046, 0x00000000, 0x00000023, 0x00000000, 0x00030047,
    0x00000046, 0x00000002, 0x00040047, 0x00000048, 0x00000022, 0x00000000, 0x00040047, 0x00000048,
    0x00000021, 0x00000001, 0x00040047, 0x00000056, 0x0000000b, 0x00000019, 0x00020013, 0x00000002,
    0x00030021, 0x00000003, 0x00000002, 0x00040015, 0x00000006, 0x00000020, 0x00000001, 0x00040020,
    0x00000007, 0x00000007, 0x00000006, 0x00060021, 0x00000008, 0x00000002, 0x00000007, 0x00000007,
    0x00000007, 0x00040015, 0x00000011, 0x00000020, 0x00000000, 0x00040020, 0x00000012, 0x00000007,
    0x00000011, 0x00040017, 0x00000014, 0x00000011, 0x00000003, 0x00040020, 0x00000015, 0x00000001,
    0x00000014, 0x0004003b, 0x00000015, 0x00000016, 0x00000001, 0x0004002b, 0x00000011, 0x00000017,
    0x00000000, 0x00040020, 0x00000018, 0x00000001, 0x00000011, 0x0003001d, 0x0000001c, 0x00000011,
    0x0004001e, 0x0000001d, 0x00000011, 0x0000001c, 0x00040020, 0x0000001e, 0x0000000c, 0x0000001d,
    0x0004003b, 0x0000001e, 0x0000001f, 0x0000000c, 0x0004002b, 0x00000006, 0x00000020, 0x00000000,
    0x00040020, 0x00000021, 0x0000000c, 0x00000011, 0x00020014, 0x00000024, 0x0004002b, 0x00000006,
    0x0000002a, 0x00000001, 0x0004002b, 0x00000011, 0x00000034, 0x00000001, 0x0003001d, 0x00000045,
    0x00000011, 0x0003001e, 0x00000046, 0x00000045, 0x00040020, 0x00000047, 0x0000000c, 0x00000046,
    0x0004003b, 0x00000047, 0x00000048, 0x0000000c, 0x00030016, 0x00000051, 0x00000020, 0x00040017,
    0x00000052, 0x00000051, 0x00000004, 0x00040020, 0x00000053, 0x00000006, 0x00000052, 0x0004003b,
    0x00000053, 0x00000054, 0x00000006, 0x0004002b, 0x00000011, 0x00000055, 0x00000040, 0x0006002c,
    0x00000014, 0x00000056, 0x00000055, 0x00000034, 0x00000034, 0x00050036, 0x00000002, 0x00000004,
    0x00000000, 0x00000003, 0x000200f8, 0x00000005, 0x0004003b, 0x00000012, 0x00000013, 0x00000007,
    0x0004003b, 0x00000007, 0x00000029, 0x00000007, 0x0004003b, 0x00000007, 0x00000033, 0x00000007,
    0x0004003b, 0x00000007, 0x0000003d, 0x00000007, 0x0004003b, 0x00000007, 0x0000003e, 0x00000007,
    0x0004003b, 0x00000007, 0x0000003f, 0x00000007, 0x0004003b, 0x00000007, 0x00000041, 0x00000007,
    0x00050041, 0x00000018, 0x00000019, 0x00000016, 0x00000017, 0x0004003d, 0x00000011, 0x0000001a,
    0x00000019, 0x0003003e, 0x00000013, 0x0000001a, 0x0004003d, 0x00000011, 0x0000001b, 0x00000013,
    0x00050041, 0x00000021, 0x00000022, 0x0000001f, 0x00000020, 0x0004003d, 0x00000011, 0x00000023,
    0x00000022, 0x000500ae, 0x00000024, 0x00000025, 0x0000001b, 0x00000023, 0x000300f7, 0x00000027,
    0x00000000, 0x000400fa, 0x00000025, 0x00000026, 0x00000027, 0x000200f8, 0x00000026, 0x000100fd,
    0x000200f8, 0x00000027, 0x00050041, 0x00000021, 0x0000002b, 0x0000001f, 0x00000020, 0x0004003d,
    0x00000011, 0x0000002c, 0x0000002b, 0x00050084, 0x00000011, 0x0000002d, 0x00000017, 0x0000002c,
    0x0004003d, 0x00000011, 0x0000002e, 0x00000013, 0x00050080, 0x00000011, 0x0000002f, 0x0000002d,
    0x0000002e, 0x00060041, 0x00000021, 0x00000030, 0x0000001f, 0x0000002a, 0x0000002f, 0x0004003d,
    0x00000011, 0x00000031, 0x00000030, 0x0004007c, 0x00000006, 0x00000032, 0x00000031, 0x0003003e,
    0x00000029, 0x00000032, 0x00050041, 0x00000021, 0x00000035, 0x0000001f, 0x00000020, 0x0004003d,
    0x00000011, 0x00000036, 0x00000035, 0x00050084, 0x00000011, 0x00000037, 0x00000034, 0x00000036,
    0x0004003d, 0x00000011, 0x00000038, 0x00000013, 0x00050080, 0x00000011, 0x00000039, 0x00000037,
    0x00000038, 0x00060041, 0x00000021, 0x0000003a, 0x0000001f, 0x0000002a, 0x00000039, 0x0004003d,
    0x00000011, 0x0000003b, 0x0000003a, 0x0004007c, 0x00000006, 0x0000003c, 0x0000003b, 0x0003003e,
    0x00000033, 0x0000003c, 0x0004003d, 0x00000006, 0x00000040, 0x00000029, 0x0003003e, 0x0000003f,
    0x00000040, 0x0004003d, 0x00000006, 0x00000042, 0x00000033, 0x0003003e, 0x00000041, 0x00000042,
    0x00070039, 0x00000002, 0x00000043, 0x0000000c, 0x0000003e, 0x0000003f, 0x00000041, 0x0004003d,
    0x00000006, 0x00000044, 0x0000003e, 0x0003003e, 0x0000003d, 0x00000044, 0x00050041, 0x00000021,
    0x00000049, 0x0000001f, 0x00000020, 0x0004003d, 0x00000011, 0x0000004a, 0x00000049, 0x00050084,
    0x00000011, 0x0000004b, 0x00000017, 0x0000004a, 0x0004003d, 0x00000011, 0x0000004c, 0x00000013,
    0x00050080, 0x00000011, 0x0000004d, 0x0000004b, 0x0000004c, 0x0004003d, 0x00000006, 0x0000004e,
    0x0000003d, 0x0004007c, 0x00000011, 0x0000004f, 0x0000004e, 0x00060041, 0x00000021, 0x00000050,
    0x00000048, 0x00000020, 0x0000004d, 0x0003003e, 0x00000050, 0x0000004f, 0x000100fd, 0x00010038,
    0x00050036, 0x00000002, 0x0000000c, 0x00000000, 0x00000008, 0x00030037, 0x00000007, 0x00000009,
    0x00030037, 0x00000007, 0x0000000a, 0x00030037, 0x00000007, 0x0000000b, 0x000200f8, 0x0000000d,
    0x0004003d, 0x00000006, 0x0000000e, 0x0000000a, 0x0004003d, 0x00000006, 0x0000000f, 0x0000000b,
    0x0005008b, 0x00000006, 0x00000010, 0x0000000e, 0x0000000f, 0x0003003e, 0x00000009, 0x00000010,
    0x000100fd, 0x00010038,
};

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
