#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

#include "device/gl/driver_files.h"
#include "device/gl/driver_manifests.h"
#include "device/gl/gl_context.h"
#include "device/gl/gl_device.h"
#include "device/gl/gl_error.h"
#include "device/gl/gl_info.h"

namespace etalon {
namespace {

struct EglFunctions {
    decltype(&eglBindAPI) bind_api;
    decltype(&eglCreateContext) create_context;
    decltype(&eglDestroyContext) destroy_context;
    decltype(&eglGetError) get_error;
    decltype(&eglGetProcAddress) get_procedure;
    decltype(&eglInitialize) initialize;
    decltype(&eglMakeCurrent) make_current;
    decltype(&eglQueryString) query_string;
    decltype(&eglTerminate) terminate;
    // Of extensions; null where EGL does not have them.
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display;
    PFNEGLQUERYDEVICESEXTPROC query_devices;
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string;
};

bool ListHas(const char* list, std::string_view word) {
    std::istringstream words(list != nullptr ? list : "");
    return std::find(std::istream_iterator<std::string>(words), {}, word) !=
           std::istream_iterator<std::string>();
}

template <typename Function>
bool Find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

DeviceResult<EglFunctions> LoadEgl() {
    void* library = dlopen(kEglName, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        const char* reason = dlerror();
        return Unsupported(std::string("libEGL cannot be loaded: ") +
                           (reason != nullptr ? reason : "unknown reason"));
    }
    EglFunctions egl{};
    if (!Find(library, "eglBindAPI", egl.bind_api) ||
        !Find(library, "eglCreateContext", egl.create_context) ||
        !Find(library, "eglDestroyContext", egl.destroy_context) ||
        !Find(library, "eglGetError", egl.get_error) ||
        !Find(library, "eglGetProcAddress", egl.get_procedure) ||
        !Find(library, "eglInitialize", egl.initialize) ||
        !Find(library, "eglMakeCurrent", egl.make_current) ||
        !Find(library, "eglQueryString", egl.query_string) ||
        !Find(library, "eglTerminate", egl.terminate)) {
        return Unsupported("libEGL is not complete");
    }
    const char* extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!ListHas(extensions, "EGL_EXT_platform_base")) {
        return Unsupported("EGL finds no driver with platform displays");
    }
    egl.get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        egl.get_procedure("eglGetPlatformDisplayEXT"));
    if (ListHas(extensions, "EGL_EXT_platform_device") &&
        (ListHas(extensions, "EGL_EXT_device_base") ||
         ListHas(extensions, "EGL_EXT_device_enumeration"))) {
        egl.query_devices =
            reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.get_procedure("eglQueryDevicesEXT"));
        egl.query_device_string = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
            egl.get_procedure("eglQueryDeviceStringEXT"));
    }
    return egl;
}

class EglContext final : public GlContext {
  public:
    static DeviceResult<std::unique_ptr<EglContext>> Open(const EglFunctions& egl,
                                                          EGLDisplay display);

    ~EglContext() override {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) {
            egl_.destroy_context(display_, context_);
        }
        egl_.terminate(display_);
    }

    bool MakeCurrent() {
        return egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }

  private:
    EglContext(const EglFunctions& egl, EGLDisplay display) : egl_(egl), display_(display) {}

    // The newest version; with notice of a reset where the driver gives it.
    bool CreateNewest(bool notice);

    EglFunctions egl_;
    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

bool EglContext::CreateNewest(bool notice) {
    for (int version : kGlVersions) {
        const EGLint attributes[] = {
            EGL_CONTEXT_MAJOR_VERSION_KHR,
            version / 10,
            EGL_CONTEXT_MINOR_VERSION_KHR,
            version % 10,
            EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
            notice ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY : EGL_NONE,
            EGL_LOSE_CONTEXT_ON_RESET,
            EGL_NONE};
        context_ = egl_.create_context(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context_ != EGL_NO_CONTEXT) {
            return true;
        }
    }
    return false;
}

DeviceResult<std::unique_ptr<EglContext>> EglContext::Open(const EglFunctions& egl,
                                                           EGLDisplay display) {
    EGLint major = 0;
    EGLint minor = 0;
    if (display == EGL_NO_DISPLAY || egl.initialize(display, &major, &minor) != EGL_TRUE) {
        return Unsupported("EGL does not start such a display");
    }
    std::unique_ptr<EglContext> context(new EglContext(egl, display));
    const char* extensions = egl.query_string(display, EGL_EXTENSIONS);
    if (!ListHas(extensions, "EGL_KHR_no_config_context") ||
        !ListHas(extensions, "EGL_KHR_surfaceless_context") ||
        egl.bind_api(EGL_OPENGL_API) != EGL_TRUE) {
        return Unsupported("EGL has no OpenGL contexts without a surface");
    }
    const bool notices = major > 1 || minor >= 5;
    if (!(notices && context->CreateNewest(true)) && !context->CreateNewest(false)) {
        return Unsupported("EGL makes no core context of version 3.3 or later");
    }
    if (!context->MakeCurrent()) {
        return Unsupported("EGL does not make its context current");
    }
    if (const char* missing = context->gl_.Load(egl.get_procedure)) {
        return Unsupported(std::string("EGL has no ") + missing);
    }
    return context;
}

bool IsAnySoftwareRenderer(const std::string& renderer) {
    return renderer.find("llvmpipe") != std::string::npos || renderer.starts_with("softpipe") ||
           renderer.find("swrast") != std::string::npos ||
           renderer.find("SwiftShader") != std::string::npos;
}

DeviceResult<std::unique_ptr<Device>> OpenSoftware(const EglFunctions& egl,
                                                   const Candidate& candidate) {
    ETALON_TRY(context,
               EglContext::Open(egl, egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA,
                                                              EGL_DEFAULT_DISPLAY, nullptr)));
    const std::string renderer = context->Renderer();
    if (!IsSoftwareRenderer(renderer, candidate.hint)) {
        return Unsupported("EGL offers '" + renderer + "' in place of " + candidate.hint);
    }
    return MakeGlDevice(std::move(context), DeviceName("egl:" + candidate.hint, candidate), 1);
}

// The displays of graphics cards, in EGL's order.
std::vector<EGLDisplay> HardwareDisplays(const EglFunctions& egl) {
    EGLint count = 0;
    if (egl.query_devices == nullptr || egl.query_devices(0, nullptr, &count) != EGL_TRUE) {
        return {};
    }
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    egl.query_devices(count, devices.data(), &count);
    std::vector<EGLDisplay> displays;
    for (EGLDeviceEXT device : devices) {
        if (!ListHas(egl.query_device_string(device, EGL_EXTENSIONS), "EGL_MESA_device_software")) {
            displays.push_back(egl.get_platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        }
    }
    return displays;
}

// Opens all cards to know which work: one card may be offered by two drivers, of which one fails or
// falls back to software. The second card of a name is "...-2".
DeviceResult<std::unique_ptr<Device>> OpenHardware(const EglFunctions& egl,
                                                   const Candidate& candidate) {
    std::unique_ptr<EglContext> chosen;
    std::string name;
    std::vector<std::string> slugs;
    for (EGLDisplay display : HardwareDisplays(egl)) {
        auto context = EglContext::Open(egl, display);
        if (!context || IsAnySoftwareRenderer((*context)->Renderer())) {
            continue;
        }
        const std::string slug = RendererSlug((*context)->Renderer());
        const auto same = std::count(slugs.begin(), slugs.end(), slug);
        if (slugs.size() == candidate.index) {
            chosen = std::move(*context);
            name = "egl:" + slug + (same > 0 ? "-" + std::to_string(same + 1) : "");
        }
        slugs.push_back(slug);
    }
    if (chosen == nullptr) {
        return Unsupported(slugs.empty() ? "no graphics card is reachable through EGL"
                                         : "EGL reaches " + std::to_string(slugs.size()) +
                                               " graphics cards only");
    }
    if (!chosen->MakeCurrent()) {
        return Unsupported("EGL does not make its context current");
    }
    return MakeGlDevice(std::move(chosen), DeviceName(name, candidate),
                        static_cast<std::uint32_t>(slugs.size()));
}

}  // namespace

DeviceResult<std::unique_ptr<Device>> OpenEglDevice(const Candidate& candidate) {
    const DriverManifests manifests;  // until the driver is loaded
    ETALON_TRY(egl, LoadEgl());
    return candidate.hint == "hardware" ? OpenHardware(egl, candidate)
                                        : OpenSoftware(egl, candidate);
}

}  // namespace etalon
