#include "core/base/version.h"

namespace covaria {

const char* version() {
    return COVARIA_VERSION;
}

}  // namespace covaria
