// The OpenGL entry points that this backend calls, found at run time: no GL library is linked.
#pragma once

#include <GL/glcorearb.h>

namespace etalon {

// clang-format off

// In every 3.3 core context.
#define ETALON_GL_CORE_FUNCTIONS(X)                              \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                     \
    X(PFNGLATTACHSHADERPROC, AttachShader)                       \
    X(PFNGLBEGINQUERYPROC, BeginQuery)                           \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                           \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                   \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                 \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                         \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                 \
    X(PFNGLBUFFERDATAPROC, BufferData)                           \
    X(PFNGLBUFFERSUBDATAPROC, BufferSubData)                     \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)   \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                     \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                     \
    X(PFNGLCREATESHADERPROC, CreateShader)                       \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                     \
    X(PFNGLDELETESHADERPROC, DeleteShader)                       \
    X(PFNGLDELETEQUERIESPROC, DeleteQueries)                     \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                           \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                         \
    X(PFNGLENABLEPROC, Enable)                                   \
    X(PFNGLENDQUERYPROC, EndQuery)                               \
    X(PFNGLFINISHPROC, Finish)                                   \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)       \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                           \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                 \
    X(PFNGLGENQUERIESPROC, GenQueries)                           \
    X(PFNGLGENTEXTURESPROC, GenTextures)                         \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                 \
    X(PFNGLGETBUFFERSUBDATAPROC, GetBufferSubData)               \
    X(PFNGLGETERRORPROC, GetError)                               \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                         \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)             \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                       \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                           \
    X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v)         \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)               \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                         \
    X(PFNGLGETSTRINGPROC, GetString)                             \
    X(PFNGLGETSTRINGIPROC, GetStringi)                           \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)           \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                         \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                           \
    X(PFNGLREADPIXELSPROC, ReadPixels)                           \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                       \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                           \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                     \
    X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                     \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                             \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                           \
    X(PFNGLVIEWPORTPROC, Viewport)

// Of later versions or extensions: call only where the context's version or extensions say so, for
// Mesa hands out a pointer for any name.
#define ETALON_GL_LATER_FUNCTIONS(X)                             \
    X(PFNGLBINDPROGRAMPIPELINEPROC, BindProgramPipeline)         \
    X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute)                 \
    X(PFNGLFRAMEBUFFERPARAMETERIPROC, FramebufferParameteri)     \
    X(PFNGLGENPROGRAMPIPELINESPROC, GenProgramPipelines)         \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                     \
    X(PFNGLMEMORYBARRIERPROC, MemoryBarrier)                     \
    X(PFNGLPROGRAMPARAMETERIPROC, ProgramParameteri)             \
    X(PFNGLSHADERBINARYPROC, ShaderBinary)                       \
    X(PFNGLSPECIALIZESHADERARBPROC, SpecializeShaderARB)         \
    X(PFNGLSPECIALIZESHADERPROC, SpecializeShader)               \
    X(PFNGLUSEPROGRAMSTAGESPROC, UseProgramStages)

// clang-format on

struct GlFunctions {
#define ETALON_DECLARE(type, name) type name = nullptr;
    ETALON_GL_CORE_FUNCTIONS(ETALON_DECLARE)
    ETALON_GL_LATER_FUNCTIONS(ETALON_DECLARE)
#undef ETALON_DECLARE

    // Fills the table with `find`, the platform's GetProcAddress. Returns the name of the first
    // core function that is missing, null if there is none.
    template <typename Find>
    const char* Load(Find find) {
#define ETALON_FIND(type, name) name = reinterpret_cast<type>(find("gl" #name));
        ETALON_GL_CORE_FUNCTIONS(ETALON_FIND)
        ETALON_GL_LATER_FUNCTIONS(ETALON_FIND)
#undef ETALON_FIND
#define ETALON_REQUIRE(type, name) \
    if ((name) == nullptr) {       \
        return "gl" #name;         \
    }
        ETALON_GL_CORE_FUNCTIONS(ETALON_REQUIRE)
#undef ETALON_REQUIRE
        return nullptr;
    }
};

}  // namespace etalon
