// GlContext: a current OpenGL context, whatever door it came through (osmesa.cc, egl.cc).
#pragma once

#include <memory>
#include <string>

#include "device/backends.h"
#include "device/gl/gl_functions.h"

namespace etalon {

// The context is current on the thread that made it, and must be used there only. Ends with this
// object; the libraries stay loaded, for drivers do not survive being unloaded.
class GlContext {
  public:
    virtual ~GlContext() = default;

    const GlFunctions& gl() const { return gl_; }

    // GL_RENDERER.
    std::string Renderer() const;

  protected:
    GlFunctions gl_;
};

// What the contexts are asked for, newest first: major * 10 + minor.
inline constexpr int kGlVersions[] = {46, 45, 44, 43, 42, 41, 40, 33};

// True if the implementation that calls itself `renderer` is the software renderer `hint`:
// "llvmpipe", "softpipe", or "zink" on top of lavapipe.
bool IsSoftwareRenderer(const std::string& renderer, const std::string& hint);

// `name` as it is listed: with the candidate's driver.
std::string DeviceName(const std::string& name, const Candidate& candidate);

// The environment's value, empty where it is not set.
std::string EnvironmentValue(const char* name);

// Makes the device of an open context. `name` is the whole name; see DeviceInfo::siblings.
DeviceResult<std::unique_ptr<Device>> MakeGlDevice(std::unique_ptr<GlContext> context,
                                                   std::string name, std::uint32_t siblings);

}  // namespace etalon
