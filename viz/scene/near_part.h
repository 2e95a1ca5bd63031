// The part of a layout that can be drawn: pictures are computed in single precision, in which squares of
// large distances overflow.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/model/layout.h"

namespace covaria::detail {

/// Whether a place, or a difference of two, is near enough to be drawn.
bool is_near(const Eigen::Vector3d& place);

/// A layout without what is too far away to be drawn.
struct NearPart {
    Layout layout;
    std::vector<std::string> left_out;  ///< names of things that are too far away; not empty
};
/// The near part of a layout; nothing: all of it is near.
std::optional<NearPart> near_part(const Layout& layout);
/// Words beside a picture on what it leaves out.
Message words_of_left_out(const std::vector<std::string>& left_out);

}  // namespace covaria::detail
