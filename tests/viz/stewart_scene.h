// A Stewart platform at its middle pose, made by hand: layout, result and trials for the tests of pictures.
#pragma once

#include <Eigen/Core>

#include "core/model/layout.h"
#include "core/result/uncertainty_result.h"
#include "viz/scene/build_scene.h"

namespace covaria::test {

struct StewartSetup {
    Layout layout;
    UncertaintyResult result;
    Eigen::MatrixXd input_trials;
    Eigen::MatrixXd output_trials;
    SceneSource source() const {
        return {&layout, &result, &input_trials, &output_trials, "Stewart platform"};
    }
};

/// Inputs b1x ... b3z (0 ... 8), p1x ... p3z (9 ... 17); outputs x y z of "pose 3". `scale` multiplies all
/// uncertainties. Trials are normal, by a congruential generator: the same on every machine.
StewartSetup stewart_setup(int trials, double scale = 1.0);

/// With a tracker 2 m beside it, which sees its first point.
Scene stewart_with_tracker();

}  // namespace covaria::test
