#include <dlfcn.h>

#include <array>

#include "device/gl/driver_files.h"
#include "device/gl/gl_context.h"
#include "device/gl/gl_device.h"
#include "device/gl/gl_error.h"

namespace etalon {
namespace {

// From GL/osmesa.h, which cannot be included beside GL/glcorearb.h.
using OsmesaContextHandle = void*;
using OsmesaProcedure = void (*)();
constexpr int kFormat = 0x22;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;
constexpr int kRgba = GL_RGBA;

struct OsmesaFunctions {
    OsmesaContextHandle (*create_context)(const int* attributes, OsmesaContextHandle shared);
    void (*destroy_context)(OsmesaContextHandle context);
    GLboolean (*make_current)(OsmesaContextHandle context, void* buffer, GLenum type, GLsizei width,
                              GLsizei height);
    OsmesaProcedure (*get_procedure)(const char* name);
};

template <typename Function>
bool Find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

void* OpenLibrary() {
    const std::string path = EnvironmentValue(kOsmesaLibraryVariable);
    if (!path.empty()) {
        return dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    }
    for (const char* name : kOsmesaNames) {
        if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
            return library;
        }
    }
    return nullptr;
}

class OsmesaContext final : public GlContext {
  public:
    static DeviceResult<std::unique_ptr<GlContext>> Open();

    ~OsmesaContext() override { osmesa_.destroy_context(context_); }

  private:
    OsmesaContext(const OsmesaFunctions& osmesa, OsmesaContextHandle context)
        : osmesa_(osmesa), context_(context) {}

    OsmesaFunctions osmesa_;
    OsmesaContextHandle context_;
    // OSMesa insists on a window's buffer, here one that nothing is drawn to.
    static constexpr GLsizei kBufferSize = 4;
    std::array<GLubyte, std::size_t{4} * kBufferSize * kBufferSize> buffer_{};
};

DeviceResult<std::unique_ptr<GlContext>> OsmesaContext::Open() {
    void* library = OpenLibrary();
    if (library == nullptr) {
        const char* reason = dlerror();
        return Unsupported(std::string("libOSMesa cannot be loaded: ") +
                           (reason != nullptr ? reason : "unknown reason"));
    }
    OsmesaFunctions osmesa{};
    if (!Find(library, "OSMesaCreateContextAttribs", osmesa.create_context) ||
        !Find(library, "OSMesaDestroyContext", osmesa.destroy_context) ||
        !Find(library, "OSMesaMakeCurrent", osmesa.make_current) ||
        !Find(library, "OSMesaGetProcAddress", osmesa.get_procedure)) {
        return Unsupported("libOSMesa is too old for core profiles");
    }
    OsmesaContextHandle handle = nullptr;
    for (int version : kGlVersions) {
        const int attributes[] = {
            kFormat,      kRgba, kProfile, kCoreProfile, kMajorVersion, version / 10, kMinorVersion,
            version % 10, 0,     0};
        handle = osmesa.create_context(attributes, nullptr);
        if (handle != nullptr) {
            break;
        }
    }
    if (handle == nullptr) {
        return Unsupported("OSMesa makes no core context of version 3.3 or later");
    }
    std::unique_ptr<OsmesaContext> context(new OsmesaContext(osmesa, handle));
    if (osmesa.make_current(handle, context->buffer_.data(), GL_UNSIGNED_BYTE, kBufferSize,
                            kBufferSize) != GL_TRUE) {
        return Unsupported("OSMesa does not make its context current");
    }
    if (const char* missing = context->gl_.Load(osmesa.get_procedure)) {
        return Unsupported(std::string("OSMesa has no ") + missing);
    }
    return std::unique_ptr<GlContext>(std::move(context));
}

}  // namespace

DeviceResult<std::unique_ptr<Device>> OpenOsmesaDevice(const Candidate& candidate) {
    ETALON_TRY(context, OsmesaContext::Open());
    const std::string renderer = context->Renderer();
    if (!IsSoftwareRenderer(renderer, candidate.hint)) {
        return Unsupported("OSMesa offers '" + renderer + "' in place of " + candidate.hint);
    }
    return MakeGlDevice(std::move(context), DeviceName("osmesa:" + candidate.hint, candidate), 1);
}

}  // namespace etalon
