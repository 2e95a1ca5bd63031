// Capability "point-uncertainty": what an artefact, an instrument or a data sheet says about measured points.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/model/capability.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// Deviation of a measured point along one direction, with its distribution.
struct PointDeviation {
    std::string id;  ///< "x", "range", "azimuth": unique per point
    Message name;    ///< "coordinate x"
    Eigen::Vector3d direction =
        Eigen::Vector3d::UnitX();    ///< per unit of the component; need not be a unit vector
    UncertaintyComponent component;  ///< its id is completed by the model ("b_1." + id)
    bool common = false;             ///< one and the same draw for all points of a set-up
    /// Name, unique in the asset, of the estimate of variance that it shares with other deviations and points
    /// (VarianceEstimate); empty: it shares none.
    std::string estimate = {};
};

/// Deviation of several points measured together that one component causes.
struct JointDeviation {
    std::string id;
    Message name;
    UncertaintyComponent component;
    std::optional<std::size_t> point = {};  ///< point whose reading it is; empty: all of the set-up
    std::string owner = {};  ///< id of the asset whose deviation it is; empty: the asset that is asked
    std::vector<Eigen::Vector3d> directions;  ///< per unit of the component, one for each point
    std::string estimate = {};                ///< see PointDeviation
};

/// Source that states the uncertainty of a measured point's coordinates.
class PointUncertaintySource : public Capability {
public:
    static constexpr const char* capability = "point-uncertainty";
    static constexpr const char* lacking = "does not locate points by itself";
    enum class Axes {
        own_frame,  ///< directions are along the axes of the frame the points define
        world,      ///< directions are in the world frame (an instrument that stands somewhere)
    };
    virtual Axes axes() const = 0;
    /// Deviations of a point at p (in the frame that `axes` names).
    virtual std::vector<PointDeviation> deviations(const Eigen::Vector3d& p) const = 0;
    /// Deviations of points measured together, from one set-up. Default: each point by itself, `common` ones
    /// shared by all.
    virtual std::vector<JointDeviation> joint_deviations(const std::vector<Eigen::Vector3d>& points) const;
    /// Places of the instruments that measure a point at p, for its sight lines.
    virtual std::vector<Eigen::Vector3d> stations_seeing(const Eigen::Vector3d&) const { return {}; }
    /// Why a point at p cannot be measured so; empty if it can.
    virtual Message objection(const Eigen::Vector3d&) const { return {}; }
};

/// Beside it, of analyses: the points are outputs, with all their uncertainty.
class PointOutputSource : public Capability {
public:
    /// The output that is coordinate 0, 1, 2 (x, y, z in the world frame) of the point of this name; empty:
    /// there is no such point.
    virtual std::optional<OutputReference> coordinate(const std::string& point, std::size_t axis) const = 0;
};

}  // namespace covaria
