// The generic render window, its observers, and reading back.
#include "viz/vtk/offscreen_window.h"

#include <vtkCallbackCommand.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "viz/vtk/rendering_log.h"

namespace covaria::detail {
namespace {

/// VTK asks whether our context is current.
void answer_is_current(vtkObject*, unsigned long, void* client, void* answer) {
    *static_cast<bool*>(answer) = static_cast<EglContext*>(client)->is_current();
}
/// The context is made current around every use of the window; there is nothing to do in between.
void already_current(vtkObject*, unsigned long, void*, void*) {}
void answer_yes(vtkObject*, unsigned long, void*, void* answer) {
    *static_cast<int*>(answer) = 1;
}

void observe(vtkGenericOpenGLRenderWindow* window, unsigned long event,
             void (*answer)(vtkObject*, unsigned long, void*, void*), EglContext* context) {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(answer);
    command->SetClientData(context);
    window->AddObserver(event, command);
}

Image top_down(const vtkUnsignedCharArray* bottom_up, int width, int height) {
    Image image{width, height, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(width);
    image.rgba.resize(row * static_cast<std::size_t>(height));
    const unsigned char* from = const_cast<vtkUnsignedCharArray*>(bottom_up)->GetPointer(0);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        std::memcpy(&image.rgba[row * y], from + row * (static_cast<std::size_t>(height) - 1 - y), row);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
}

}  // namespace

Result<void> OffscreenWindow::open(vtkRenderer* renderer) {
    if (window_) return {};
    redirect_vtk_messages();
    if (auto opened = context_.open(); !opened) return opened;
    const CurrentContext current(context_);
    window_ = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    window_->SetOwnContext(false);
    observe(window_, vtkCommand::WindowIsCurrentEvent, answer_is_current, &context_);
    observe(window_, vtkCommand::WindowMakeCurrentEvent, already_current, &context_);
    observe(window_, vtkCommand::WindowSupportsOpenGLEvent, answer_yes, &context_);
    observe(window_, vtkCommand::WindowIsDirectEvent, answer_yes, &context_);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetMultiSamples(0);
    window_->SetAlphaBitPlanes(1);
    window_->AddRenderer(renderer);
    window_->SetSize(16, 16);
    window_->SetReadyForRendering(true);
    window_->OpenGLInit();
    largest_side_ = largest_texture();
    return {};
}

OffscreenWindow::~OffscreenWindow() {
    if (!window_) return;
    const CurrentContext current(context_);
    window_->Finalize();
    window_ = nullptr;
}

Result<Image> OffscreenWindow::picture(int width, int height) {
    const auto too_large = [&] {
        return fail(ErrorCode::io, "the graphics system cannot draw a picture of " + std::to_string(width) +
                                       " x " + std::to_string(height) + " pixels; choose a smaller size");
    };
    if (std::max(width, height) > largest_side_) return too_large();
    const CurrentContext current(context_);
    window_->SetSize(width, height);
    window_->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    const int read = window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
    if (read != VTK_OK || pixels->GetNumberOfValues() != 4LL * width * height) return too_large();
    return top_down(pixels, width, height);
}

Image half_size(const Image& image) {
    Image half{image.width / 2, image.height / 2, {}};
    half.rgba.resize(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    std::size_t to = 0;
    for (std::size_t y = 0; y < static_cast<std::size_t>(half.height); ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(half.width); ++x) {
            const std::uint8_t* p = &image.rgba[2 * y * row + 8 * x];
            for (std::size_t i = 0; i < 4; ++i, ++to)
                half.rgba[to] =
                    static_cast<std::uint8_t>((p[i] + p[i + 4] + p[row + i] + p[row + i + 4] + 2) / 4);
        }
    return half;
}

}  // namespace covaria::detail
