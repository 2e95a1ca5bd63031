// Measuring in a scene: which places can be picked, and what lies between them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "viz/scene/camera.h"
#include "viz/scene/scene.h"

namespace covaria {

/// Id of the point, or else the frame by its origin, under a pixel: what one may measure from.
std::optional<std::string> place_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                    const std::function<bool(Layer)>& shown, double reach = 10.0);

/// Why a measurement has no standard uncertainty.
enum class NotStated {
    none,           ///< it has
    no_result,      ///< there is none, or the scene shows something else
    no_quantities,  ///< a place is no quantity of the analysis
    constant,       ///< a place has no uncertainty: it is a constant of the set-up
    not_finite,     ///< or not known jointly
    not_linear      ///< the first order is not enough
};

/// Two places: their distance (m). Three: the angle at the second (rad).
struct Measurement {
    std::vector<std::string> names;
    std::vector<Eigen::Vector3d> at;  ///< in W, m
    double value = 0.0;
    std::optional<double> u = {};
    NotStated reason = NotStated::none;
    std::string place = {};  ///< the one that is the reason, where it is one of them
    bool is_angle() const { return at.size() == 3; }
};

/// Empty unless `ids` are two or three items of the scene. `result` is the one that the scene shows, or null.
std::optional<Measurement> measure(const Scene& scene, const UncertaintyResult* result,
                                   const std::vector<std::string>& ids);

/// A measurement, or what is picked of it so far, as it is drawn.
struct MeasureMark {
    std::vector<Eigen::Vector3d> at;  ///< one to three places; in the middle of three the apex of an angle
    std::string text = {};            ///< written at the line or the arc
    bool operator==(const MeasureMark&) const = default;
};

}  // namespace covaria
