#pragma once

#include <string>

#include <GL/glcorearb.h>

/// OpenGL 3.3 core or OpenGL ES 3.0 through a table of function pointers, so that a window and OSMesa can be
/// used in one program: nothing links libGL; whoever owns a context fills a table for it.
///
/// The types come from <GL/glcorearb.h> (Debian: libgl-dev).
namespace jw::render {

// clang-format off
/// Every GL function that the program calls: X(type of the pointer, name without "gl").
#define JW_GL_FUNCTIONS(X)                                             \
    X(PFNGLACTIVETEXTUREPROC,                  ActiveTexture)          \
    X(PFNGLATTACHSHADERPROC,                   AttachShader)           \
    X(PFNGLBINDBUFFERPROC,                     BindBuffer)             \
    X(PFNGLBINDFRAMEBUFFERPROC,                BindFramebuffer)        \
    X(PFNGLBINDRENDERBUFFERPROC,               BindRenderbuffer)       \
    X(PFNGLBINDTEXTUREPROC,                    BindTexture)            \
    X(PFNGLBINDVERTEXARRAYPROC,                BindVertexArray)        \
    X(PFNGLBLENDFUNCSEPARATEPROC,              BlendFuncSeparate)      \
    X(PFNGLBLITFRAMEBUFFERPROC,                BlitFramebuffer)        \
    X(PFNGLBUFFERDATAPROC,                     BufferData)             \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC,         CheckFramebufferStatus) \
    X(PFNGLCLEARPROC,                          Clear)                  \
    X(PFNGLCLEARCOLORPROC,                     ClearColor)             \
    X(PFNGLCOLORMASKPROC,                      ColorMask)              \
    X(PFNGLCOMPILESHADERPROC,                  CompileShader)          \
    X(PFNGLCREATEPROGRAMPROC,                  CreateProgram)          \
    X(PFNGLCREATESHADERPROC,                   CreateShader)           \
    X(PFNGLCULLFACEPROC,                       CullFace)               \
    X(PFNGLDELETEBUFFERSPROC,                  DeleteBuffers)          \
    X(PFNGLDELETEFRAMEBUFFERSPROC,             DeleteFramebuffers)     \
    X(PFNGLDELETEPROGRAMPROC,                  DeleteProgram)          \
    X(PFNGLDELETERENDERBUFFERSPROC,            DeleteRenderbuffers)    \
    X(PFNGLDELETESHADERPROC,                   DeleteShader)           \
    X(PFNGLDELETETEXTURESPROC,                 DeleteTextures)         \
    X(PFNGLDELETEVERTEXARRAYSPROC,             DeleteVertexArrays)     \
    X(PFNGLDEPTHFUNCPROC,                      DepthFunc)              \
    X(PFNGLDEPTHMASKPROC,                      DepthMask)              \
    X(PFNGLDISABLEPROC,                        Disable)                \
    X(PFNGLDRAWARRAYSPROC,                     DrawArrays)             \
    X(PFNGLDRAWARRAYSINSTANCEDPROC,            DrawArraysInstanced)    \
    X(PFNGLDRAWBUFFERSPROC,                    DrawBuffers)            \
    X(PFNGLDRAWELEMENTSPROC,                   DrawElements)           \
    X(PFNGLDRAWELEMENTSINSTANCEDPROC,          DrawElementsInstanced)  \
    X(PFNGLENABLEPROC,                         Enable)                 \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC,        EnableVertexAttribArray) \
    X(PFNGLFINISHPROC,                         Finish)                 \
    X(PFNGLFRAMEBUFFERRENDERBUFFERPROC,        FramebufferRenderbuffer) \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC,           FramebufferTexture2D)   \
    X(PFNGLGENBUFFERSPROC,                     GenBuffers)             \
    X(PFNGLGENFRAMEBUFFERSPROC,                GenFramebuffers)        \
    X(PFNGLGENRENDERBUFFERSPROC,               GenRenderbuffers)       \
    X(PFNGLGENTEXTURESPROC,                    GenTextures)            \
    X(PFNGLGENVERTEXARRAYSPROC,                GenVertexArrays)        \
    X(PFNGLGETERRORPROC,                       GetError)               \
    X(PFNGLGETINTEGERVPROC,                    GetIntegerv)            \
    X(PFNGLGETPROGRAMINFOLOGPROC,              GetProgramInfoLog)      \
    X(PFNGLGETPROGRAMIVPROC,                   GetProgramiv)           \
    X(PFNGLGETSHADERINFOLOGPROC,               GetShaderInfoLog)       \
    X(PFNGLGETSHADERIVPROC,                    GetShaderiv)            \
    X(PFNGLGETSTRINGPROC,                      GetString)              \
    X(PFNGLGETUNIFORMLOCATIONPROC,             GetUniformLocation)     \
    X(PFNGLLINKPROGRAMPROC,                    LinkProgram)            \
    X(PFNGLPIXELSTOREIPROC,                    PixelStorei)            \
    X(PFNGLREADBUFFERPROC,                     ReadBuffer)             \
    X(PFNGLREADPIXELSPROC,                     ReadPixels)             \
    X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample) \
    X(PFNGLSCISSORPROC,                        Scissor)                \
    X(PFNGLSHADERSOURCEPROC,                   ShaderSource)           \
    X(PFNGLTEXIMAGE2DPROC,                     TexImage2D)             \
    X(PFNGLTEXPARAMETERIPROC,                  TexParameteri)          \
    X(PFNGLUNIFORM1FPROC,                      Uniform1f)              \
    X(PFNGLUNIFORM1IPROC,                      Uniform1i)              \
    X(PFNGLUNIFORM2FPROC,                      Uniform2f)              \
    X(PFNGLUNIFORM3FPROC,                      Uniform3f)              \
    X(PFNGLUNIFORM4FPROC,                      Uniform4f)              \
    X(PFNGLUNIFORMMATRIX4FVPROC,               UniformMatrix4fv)       \
    X(PFNGLUSEPROGRAMPROC,                     UseProgram)             \
    X(PFNGLVERTEXATTRIBDIVISORPROC,            VertexAttribDivisor)    \
    X(PFNGLVERTEXATTRIBPOINTERPROC,            VertexAttribPointer)    \
    X(PFNGLVIEWPORTPROC,                       Viewport)
/// Functions of OpenGL 3.3 that OpenGL ES 3.0 does not have: null there.
#define JW_GL_33_FUNCTIONS(X)                                          \
    X(PFNGLTEXIMAGE2DMULTISAMPLEPROC,          TexImage2DMultisample)
// clang-format on

/// Kinds of OpenGL for drawing pictures. They differ in the first lines of shaders (gl_objects.cpp) and in
/// the averaging of samples (render_targets.cpp); only the first can read depth.
enum class GlProfile {
    core_33,  ///< OpenGL 3.3 core
    es_30,    ///< OpenGL ES 3.0, which WebGL 2 is
};

struct GlFunctions {
    GlProfile profile = GlProfile::core_33;
#define JW_DECLARE(type, name) type name = nullptr;
    JW_GL_FUNCTIONS(JW_DECLARE)
    JW_GL_33_FUNCTIONS(JW_DECLARE)
#undef JW_DECLARE
};

/// Looks up a GL function of the current context by its full name, e.g. "glClear".
using GlLoader = void* (*)(const char* name);

/// Fills the table for the current context.
/// @throws std::runtime_error naming the entries that the context does not have.
GlFunctions load_gl_functions(GlLoader loader);

/// Name of the renderer of the current context, such as "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile)
/// Mesa 22.3.6".
std::string renderer_name(const GlFunctions& gl);

/// Reads and clears all waiting errors. GL keeps errors until they are read, whichever call caused them: read
/// at the end of a frame, they are not blamed on a call of the next one. The context must be current.
/// @return the first of them in words, "OpenGL error 0x502 (invalid operation)"; empty if there is none
std::string take_gl_errors(const GlFunctions& gl);

/// @throws std::runtime_error "`during` failed with OpenGL error ..." if one is waiting
void throw_on_gl_error(const GlFunctions& gl, const char* during);

}  // namespace jw::render
