// A VTK render window on our own OpenGL context; pictures are read back from it.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "viz/vtk/egl_context.h"
#include "viz/vtk/image.h"

namespace covaria::detail {

class OffscreenWindow {
public:
    OffscreenWindow() = default;
    ~OffscreenWindow();
    OffscreenWindow(const OffscreenWindow&) = delete;
    OffscreenWindow& operator=(const OffscreenWindow&) = delete;

    /// Opens the window, once; errors as EglContext::open.
    Result<void> open(vtkRenderer* renderer);
    /// Draws the renderer. The context is current only during the call.
    Result<Image> picture(int width, int height);
    /// Makes the context current while it lives: wherever VTK gives back what it has in the graphics memory.
    CurrentContext current() const { return CurrentContext(context_); }
    /// Largest width and height that the driver draws.
    int largest_side() const { return largest_side_; }

private:
    EglContext context_;
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
    int largest_side_ = 4096;
};

/// Mean of each block of 2 x 2 pixels; width and height are even.
Image half_size(const Image& image);

}  // namespace covaria::detail
