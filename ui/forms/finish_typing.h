// Text typed in a field or cell counts without Enter, too.
#pragma once

namespace covaria::ui {

/// Takes over what is being typed, as leaving the field does: before saving, running and exporting.
void finish_typing();

}  // namespace covaria::ui
