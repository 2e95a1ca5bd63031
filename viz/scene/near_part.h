// What of a layout can be drawn: pictures are computed in single precision, and whose squares of distances
// overflow has no picture.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/model/layout.h"

namespace covaria::detail {

/// Of places and of differences between them.
bool is_near(const Eigen::Vector3d& place);

/// A layout without what is too far away to be drawn.
struct NearPart {
    Layout layout;
    std::vector<std::string> left_out;  ///< by name; not empty
};
/// Nothing: all of it is near.
std::optional<NearPart> near_part(const Layout& layout);
/// Beside a picture.
Message words_of_left_out(const std::vector<std::string>& left_out);

}  // namespace covaria::detail
