#include "viz/vtk/vtk_version.h"

#include <vtkVersion.h>

namespace covaria {

std::string vtk_version() {
    return vtkVersion::GetVTKVersion();
}

}  // namespace covaria
