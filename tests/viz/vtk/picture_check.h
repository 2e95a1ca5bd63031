// Checks of pictures: colours near a place, differences, baselines.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "viz/scene/camera.h"
#include "viz/vtk/image.h"

namespace covaria::test {

/// Part of the pixels of two pictures that differ by more than 24 in any channel, and the mean difference.
struct Difference {
    double fraction = 1.0;
    double mean = 255.0;
};
Difference difference(const Image& a, const Image& b);

/// Number of pixels within `reach` of `at` whose hue leans to `stronger` (0 red, 1 green, 2 blue) over
/// `weaker` by at least 30.
int coloured_near(const Image& image, Pixel at, int reach, int stronger, int weaker);
/// Number of pixels in the rectangle that are at least 100 darker than the ground.
int dark_in(const Image& image, int x, int y, int width, int height);

/// Equal to tests/viz/baselines/NAME.png up to the small differences between drivers; otherwise leaves the
/// picture at COVARIA_BINARY_DIR/failed-pictures/NAME.png and says so.
testing::AssertionResult matches_baseline(const Image& image, const std::string& name);
/// Compares with another file and other limits. With COVARIA_UPDATE_BASELINES=1 in the environment the file
/// is written instead; without it a missing file is a failure that says so.
testing::AssertionResult matches_baseline(const Image& image, const std::filesystem::path& file,
                                          const Difference& largest);
/// Leaves the picture for the person who looks into the failure.
std::string left_picture(const Image& image, const std::string& name);

}  // namespace covaria::test
