// EGL: displays that need no window system, contexts, currency.
#include "viz/vtk/egl_context.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <array>
#include <mutex>
#include <string>
#include <vector>

namespace covaria::detail {
namespace {

EGLDisplay initialised(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_DISPLAY;
    return eglBindAPI(EGL_OPENGL_API) ? display : EGL_NO_DISPLAY;
}

std::vector<EGLDisplay> candidates() {
    std::vector<EGLDisplay> displays;
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!platform_display) return displays;
    displays.push_back(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    const auto query_devices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query_devices && query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count))
        for (EGLint i = 0; i < count; ++i)
            displays.push_back(
                platform_display(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr));
    return displays;
}

/// One display for the whole process and for its whole life: terminating it would take the contexts of other
/// renderers along.
EGLDisplay shared_display() {
    static const EGLDisplay display = [] {
        for (EGLDisplay candidate : candidates())
            if (EGLDisplay found = initialised(candidate); found != EGL_NO_DISPLAY) return found;
        return static_cast<EGLDisplay>(EGL_NO_DISPLAY);
    }();
    return display;
}

EGLContext make_context(EGLDisplay display) {
    static constexpr EGLint config_wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                               EGL_NONE};
    static constexpr EGLint context_wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                2,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, config_wanted, &config, 1, &count) ||
        count == 0)
        return EGL_NO_CONTEXT;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, context_wanted);
}

}  // namespace

Result<void> EglContext::open() {
    if (is_open()) return {};
    EGLDisplay display = shared_display();
    if (display == EGL_NO_DISPLAY)
        return fail(
            ErrorCode::io,
            "no OpenGL without a display: EGL offers neither Mesa's surfaceless platform nor a device; "
            "install the package libgl1-mesa-dri");
    EGLContext context = make_context(display);
    if (context == EGL_NO_CONTEXT)
        return fail(ErrorCode::io,
                    "EGL cannot make an OpenGL 3.2 context; update the graphics driver or "
                    "install the package libgl1-mesa-dri");
    display_ = display;
    context_ = context;
    return {};
}

EglContext::~EglContext() {
    if (context_) eglDestroyContext(display_, context_);
}

bool EglContext::is_current() const {
    return context_ && eglGetCurrentContext() == context_;
}

int largest_texture() {
    // VTK's own answer is undefined before its first picture.
    GLint side = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    return side > 0 ? side : 4096;
}

CurrentContext::CurrentContext(const EglContext& context)
    : display_(context.display_),
      previous_display_(eglGetCurrentDisplay()),
      previous_context_(eglGetCurrentContext()),
      previous_draw_(eglGetCurrentSurface(EGL_DRAW)),
      previous_read_(eglGetCurrentSurface(EGL_READ)),
      previous_api_(eglQueryAPI()) {
    eglBindAPI(EGL_OPENGL_API);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_);
}

CurrentContext::~CurrentContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglBindAPI(previous_api_);
    if (previous_context_ && previous_display_)
        eglMakeCurrent(previous_display_, previous_draw_, previous_read_, previous_context_);
}

}  // namespace covaria::detail
