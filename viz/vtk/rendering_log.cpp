// A vtkOutputWindow that hands each message to the log.
#include "viz/vtk/rendering_log.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <cstring>
#include <mutex>

#include "viz/vtk/scene_renderer.h"

namespace covaria {
namespace {

std::mutex log_mutex;
std::function<void(const std::string&)> log_callback;
/// GLEW looks for a GLX display, finds none, says so at every picture, and works.
constexpr const char* harmless = "GLEW could not be initialized";

class LogWindow : public vtkOutputWindow {
public:
    static LogWindow* New();
    vtkTypeMacro(LogWindow, vtkOutputWindow) void DisplayText(const char* text) override {
        if (!text || std::strstr(text, harmless)) return;
        const std::lock_guard lock(log_mutex);
        if (log_callback) log_callback(text);
    }
};
vtkStandardNewMacro(LogWindow)

}  // namespace

void set_rendering_log(std::function<void(const std::string&)> log) {
    const std::lock_guard lock(log_mutex);
    log_callback = std::move(log);
}

void detail::redirect_vtk_messages() {
    static std::once_flag once;
    std::call_once(once, [] {
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
        vtkOutputWindow::SetInstance(vtkSmartPointer<LogWindow>::New());
    });
}

}  // namespace covaria
