// The settings of a computation of Comp3D (.comp), which name the files of its network.
#pragma once

#include <string>

#include "core/readers/comp3d_ground.h"

namespace covaria {

struct Comp3dProject {
    std::string name = {};
    std::string coordinates = {}, observations = {}, covariance = {};  ///< names of files; may be empty
    bool has_angle_unit = false;  ///< whether the settings say the unit of angles
    bool is_simulated = false;    ///< whether the values of the observations are none that were read
    Comp3dSettings settings = {};
};

/// Whether a text begins as one.
bool is_comp3d_project(std::string_view beginning);
/// The settings in a text "data= {...}". Error with a line: it is none.
Result<Comp3dProject> comp3d_project(const std::string& text);

}  // namespace covaria
