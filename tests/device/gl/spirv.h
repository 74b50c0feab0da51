// GLSL to SPIR-V for these tests, through glslang directly.
#pragma once

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace etalon {

// A module for Vulkan in SPIR-V 1.0 or 1.3: they differ in how they spell a storage buffer.
inline std::vector<std::uint32_t> ToSpirv(const std::string& text, EShLanguage stage,
                                          glslang::EShTargetLanguageVersion version) {
    static const bool initialized = glslang::InitializeProcess();
    EXPECT_TRUE(initialized);
    glslang::TShader shader(stage);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, version == glslang::EShTargetSpv_1_0
                                                      ? glslang::EShTargetVulkan_1_0
                                                      : glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, version);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    EXPECT_TRUE(shader.parse(GetDefaultResources(), 450, false, messages)) << shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    EXPECT_TRUE(program.link(messages)) << program.getInfoLog();
    std::vector<std::uint32_t> words;
    glslang::GlslangToSpv(*program.getIntermediate(stage), words);
    return words;
}

}  // namespace etalon
