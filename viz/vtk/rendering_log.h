// Messages of VTK go to a callback, never to the terminal.
#pragma once

namespace covaria::detail {

/// Puts our message window in the place of VTK's; the first call counts.
void redirect_vtk_messages();

}  // namespace covaria::detail
