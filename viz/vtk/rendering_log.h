// Messages of VTK go to a callback, never to the terminal.
#pragma once

namespace covaria::detail {

/// Puts our message window in the place of VTK's; the first call counts.
void redirect_vtk_messages();
/// Between begin and end the messages of this thread are dropped: GLEW's harmless complaint about EGL.
class QuietMessages {
public:
    QuietMessages();
    ~QuietMessages();
    QuietMessages(const QuietMessages&) = delete;
    QuietMessages& operator=(const QuietMessages&) = delete;
};

}  // namespace covaria::detail
