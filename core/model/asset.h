// Assets: artefacts, instruments, robots, point sets. Defined once in a project, used by many analyses.
//
// A model asks an asset for a capability (an interface below), never for its kind. A new capability is added
// here with its interface; asset kinds live in core/assets.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/data_table.h"
#include "core/base/error.h"
#include "core/base/plot_specification.h"
#include "core/model/ballbar.h"
#include "core/model/layout.h"
#include "core/model/repeatability.h"
#include "core/model/sensor.h"
#include "core/model/setup_schema.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

class SerialRobotSource;      // core/model/serial_robot.h
class ForceSensorSource;      // core/model/force_sensor.h
class ForceCalibratorSource;  // core/model/force_sensor.h

/// Deviation of a measured point along one direction, with its distribution.
struct PointDeviation {
    std::string id;    ///< "x", "range", "azimuth": unique per point
    std::string name;  ///< "coordinate x"
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
    std::string id, name;
    UncertaintyComponent component;
    std::optional<std::size_t> point = {};  ///< whose reading it is; empty: of the whole set-up
    std::string owner = {};  ///< id of the asset whose deviation it is; empty: the asset that is asked
    std::vector<Eigen::Vector3d> directions;  ///< per unit of the component, one for each point
    std::string estimate = {};                ///< see PointDeviation
};

/// Capability "point-uncertainty": what the asset says about the uncertainty of a measured point's
/// coordinates.
class PointUncertaintySource {
public:
    virtual ~PointUncertaintySource() = default;
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
    /// Where the instruments stand that measure a point at p, for its sight lines.
    virtual std::vector<Eigen::Vector3d> stations_seeing(const Eigen::Vector3d&) const { return {}; }
    /// Why a point at p cannot be measured so; empty if it can.
    virtual std::string objection(const Eigen::Vector3d&) const { return {}; }
};

/// Beside "point-uncertainty", of analyses: the points are outputs, with all their uncertainty.
class PointOutputSource {
public:
    virtual ~PointOutputSource() = default;
    /// The output that is coordinate 0, 1, 2 (x, y, z in the world frame) of the point of this name; empty:
    /// there is no such point.
    virtual std::optional<OutputReference> coordinate(const std::string& point, std::size_t axis) const = 0;
};

class AssetLibrary;

/// Made from a checked set-up; immutable.
class Asset {
public:
    virtual ~Asset() = default;
    virtual const PointUncertaintySource* point_uncertainty() const { return nullptr; }
    virtual const PointOutputSource* point_outputs() const { return nullptr; }
    virtual const SensorSource* sensor() const { return nullptr; }
    virtual const BallbarSource* ballbars() const { return nullptr; }
    virtual const RepeatabilitySource* repeatability() const { return nullptr; }
    virtual const SerialRobotSource* serial_robot() const { return nullptr; }
    virtual const ForceSensorSource* force_sensor() const { return nullptr; }
    virtual const ForceCalibratorSource* force_calibrator() const { return nullptr; }
    /// The asset's own evaluation as tables (budget of calibration, temperature, variability, bias;
    /// observations ...).
    virtual std::vector<DataTable> evaluation() const { return {}; }
    /// The same as charts; ids are unique in the asset.
    virtual std::vector<PlotSpecification> figures() const { return {}; }
    /// What to draw when the asset itself is looked at.
    virtual Layout layout() const { return {}; }
};

enum class AssetCategory { artefact, instrument, robot, points };

struct Reference {
    std::string text;  ///< "Porath, Gross, Eger: Experimental-numerical approach ..., Eqs 1-6"
};

struct AssetDescriptor {
    std::string kind;  ///< in files: "artefact-2d"
    std::string title;
    AssetCategory category = AssetCategory::artefact;
    std::string summary;
    std::vector<Reference> references;
    std::vector<std::string> notes;
    std::vector<std::string> capabilities;  ///< "point-uncertainty"
    SetupSchema schema;
    /// Null if `problems` got an error. `setup` has passed check_setup; `assets` holds those it refers to.
    std::function<std::unique_ptr<Asset>(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems)>
        create;
};

/// The assets of a project, made; what models see.
class AssetLibrary {
public:
    struct Entry {
        std::string name;
        const AssetDescriptor* descriptor = nullptr;  ///< null: an analysis stands for an asset
        std::shared_ptr<const Asset> asset;
    };
    void add(const std::string& id, Entry entry) { entries_[id] = std::move(entry); }
    const Entry* find(const std::string& id) const {
        auto it = entries_.find(id);
        return it == entries_.end() ? nullptr : &it->second;
    }
    const std::map<std::string, Entry>& entries() const { return entries_; }

private:
    std::map<std::string, Entry> entries_;
};

}  // namespace covaria
