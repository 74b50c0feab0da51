#include "device/gl/gl_info.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace etalon {
namespace {

std::string Text(const GlFunctions& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

std::uint32_t Integer(const GlFunctions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return static_cast<std::uint32_t>(std::max(value, 0));
}

std::set<std::string> Extensions(const GlFunctions& gl) {
    std::set<std::string> extensions;
    const std::uint32_t count = Integer(gl, GL_NUM_EXTENSIONS);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (const GLubyte* name = gl.GetStringi(GL_EXTENSIONS, i)) {
            extensions.insert(reinterpret_cast<const char*>(name));
        }
    }
    return extensions;
}

bool IsLetterOrDigit(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// An interpreter: a larger batch gains nothing, and a costly function over 2^20 rows would outlast
// the watchdog.
constexpr std::uint32_t kSoftpipeRows = 1u << 16;

}  // namespace

std::string RendererSlug(std::string_view renderer) {
    std::string text(renderer);
    for (std::string_view mark : {"(R)", "(r)", "(TM)", "(tm)"}) {
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) {
            text.replace(at, mark.size(), " ");
        }
    }
    std::string slug;
    for (char c : text.substr(0, text.find_first_of("(/"))) {
        if (IsLetterOrDigit(c) || c == '.') {
            slug += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else if (!slug.empty() && slug.back() != '-') {
            slug += '-';
        }
    }
    while (!slug.empty() && slug.back() == '-') {
        slug.pop_back();
    }
    return slug;
}

std::string RendererCompiler(std::string_view renderer) {
    const std::size_t begin = renderer.find("LLVM ");
    if (begin == std::string_view::npos) {
        return "";
    }
    return std::string(renderer.substr(begin, renderer.find(')', begin) - begin));
}

DriverVersion ParseDriverVersion(std::string_view gl_version) {
    std::string_view rest = gl_version.substr(std::min(gl_version.find(' '), gl_version.size()));
    constexpr std::string_view kProfile = "Profile) ";
    if (const std::size_t at = rest.find(kProfile); at != std::string_view::npos) {
        rest.remove_prefix(at + kProfile.size());
    }
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const std::size_t space = std::min(rest.find(' '), rest.size());
    DriverVersion version{std::string(rest.substr(0, space)), ""};
    if (space < rest.size()) {
        version.version = rest.substr(space + 1);
    }
    return version;
}

DeviceInfo DescribeContext(const GlFunctions& gl) {
    const std::uint32_t major = Integer(gl, GL_MAJOR_VERSION);
    const std::uint32_t minor = Integer(gl, GL_MINOR_VERSION);
    const std::uint32_t version = 10 * major + minor;
    const std::set<std::string> extensions = Extensions(gl);

    DeviceInfo info;
    info.description = Text(gl, GL_RENDERER);
    const DriverVersion driver = ParseDriverVersion(Text(gl, GL_VERSION));
    info.driver = driver.driver;
    info.version = driver.version;
    info.api = "OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " core";
    info.compiler = RendererCompiler(info.description);
    // The kit's GLSL is at most 4.50.
    info.glsl_version = std::min(10 * version, 450u);
    info.features = {"glsl", "fragment"};
    // Storage blocks, compute and framebuffers without attachments are all of 4.3. An older context
    // may have them as extensions, but then its GLSL needs other text.
    if (version >= 43) {
        info.features.push_back("compute");
        if (version >= 46 || extensions.contains("GL_ARB_gl_spirv")) {
            info.features.push_back("spirv");
        }
    }
    if (version >= 40) {
        info.features.push_back("float64");
    }
    // zink names what it runs on in parentheses.
    for (const char* name : {"llvmpipe", "softpipe", "SwiftShader"}) {
        info.on_host = info.on_host || info.description.find(name) != std::string::npos;
    }
    if (info.description.starts_with("softpipe")) {
        info.max_rows = kSoftpipeRows;
        info.slow = true;
    }
    return info;
}

GlLimits ReadLimits(const GlFunctions& gl, const DeviceInfo& info) {
    GlLimits limits;
    limits.texture_size = Integer(gl, GL_MAX_TEXTURE_SIZE);
    limits.cube_size = Integer(gl, GL_MAX_CUBE_MAP_TEXTURE_SIZE);
    limits.texture_units = Integer(gl, GL_MAX_TEXTURE_IMAGE_UNITS);
    limits.targets =
        std::min(Integer(gl, GL_MAX_DRAW_BUFFERS), Integer(gl, GL_MAX_COLOR_ATTACHMENTS));
    if (info.Has("compute")) {
        GLint groups = 0;
        gl.GetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &groups);
        limits.groups = static_cast<std::uint32_t>(std::max(groups, 0));
        limits.block_bytes = Integer(gl, GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
        limits.fragment_blocks = Integer(gl, GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS);
    }
    return limits;
}

}  // namespace etalon
