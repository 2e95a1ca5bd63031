// Capability "sensor": an instrument that stands somewhere and reads distances and angles to targets.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/math/rotation.h"
#include "core/model/capability.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// Readings of a target at v = (x, y, z) in the sensor's axes: |v|, atan2(y, x), atan2(z, hypot(x, y)).
enum class Observable { distance, azimuth, elevation };
inline constexpr std::array<Observable, 3> observables{Observable::distance, Observable::azimuth,
                                                       Observable::elevation};
/// "azimuth".
Message words_of(Observable observable);

/// Convention by which the three angles of a station turn its axes.
enum class StationAngles {
    zyx,  ///< R = Rz(gamma) Ry(beta) Rx(alpha)
    xyz,  ///< R = Rx(omega) Ry(phi) Rz(kappa), as in photogrammetry (Galetto et al.)
};

template <class Real>
Matrix3<Real> station_rotation(StationAngles angles, const Vector3<Real>& a) {
    if (angles == StationAngles::zyx) return rotation_from_zyx(a);
    return rotation_x(a[0]) * rotation_y(a[1]) * rotation_z(a[2]);
}

/// Place of a sensor: X_W = position + R x_S.
struct Station {
    std::array<double, 6> coordinates{};  ///< x, y, z in m, three angles in rad
    StationAngles angles = StationAngles::zyx;
    Eigen::Isometry3d X_WS() const;
};

/// The part of readings that follows from a station alone, for all the points that are seen from it.
class StationGeometry {
public:
    explicit StationGeometry(const Station& station);

    const Eigen::Isometry3d& X_WS() const { return X_WS_; }
    /// A point of the world in the axes of the sensor.
    Eigen::Vector3d in_axes(const Eigen::Vector3d& p_W) const { return inverse_ * p_W; }
    /// Change of `in_axes(p_W)` by the coordinates of the station.
    Eigen::Matrix<double, 3, 6> effect_on(const Eigen::Vector3d& p_W) const;

private:
    Eigen::Isometry3d X_WS_, inverse_;
    /// Axes in W about which the three angles turn the sensor, by columns.
    Eigen::Matrix3d turning_axes_;
};

/// A deviation that all readings of the sensor share: scale, index, axes ...
struct SystematicDeviation {
    UncertaintyComponent component;  ///< its id is completed by the model
    /// Change of a reading of the target at v (sensor's axes, m) per unit; of an azimuth in m across it.
    double (*effect)(Observable, const Eigen::Vector3d& v) = nullptr;
};

struct StationCorrelation {
    std::size_t first = 0, second = 0;  ///< indices of the six coordinates
    double coefficient = 0.0;
};

/// Region in which a sensor sees targets, in its own axes.
struct FieldOfView {
    double nearest = 0.0, farthest = std::numeric_limits<double>::infinity();  ///< m
    double azimuth = std::numbers::pi, elevation = 0.5 * std::numbers::pi;     ///< half angles about x, rad
    bool contains(const Eigen::Vector3d& v) const;
    bool is_limited() const;
};

class SensorSource : public Capability {
public:
    static constexpr const char* capability = "sensor";
    static constexpr const char* lacking = "is no sensor";
    virtual std::string glyph() const = 0;  ///< see LayoutBody::glyph
    virtual bool reads(Observable observable) const = 0;
    virtual const Station& station() const = 0;
    /// Deviations of the six coordinates of the station.
    virtual const std::array<UncertaintyComponent, 6>& station_components() const = 0;
    virtual const std::vector<StationCorrelation>& station_correlations() const = 0;
    /// Deviation of one reading of the target at v, independent of all others.
    virtual UncertaintyComponent reading(Observable observable, const Eigen::Vector3d& v) const = 0;
    virtual const std::vector<SystematicDeviation>& systematic() const = 0;
    /// Whether a target at v (sensor's axes, m) is in its range and field of view.
    virtual bool sees(const Eigen::Vector3d& v) const = 0;
    virtual const FieldOfView& field_of_view() const = 0;
};

/// Horizontal distance over distance below which a target counts as overhead: its azimuth is then read by its
/// effect, a displacement in m across the azimuth read.
inline constexpr double near_zenith = 1e-3;

/// Derivatives of the readings of a target, to first order: a row for every observable.
struct ReadingSensitivity {
    Eigen::Matrix3d to_point;                ///< derivatives by the target's coordinates in W
    Eigen::Matrix<double, 3, 6> to_station;  ///< derivatives by the six coordinates of the station
    bool overhead = false;
    /// Factor of an azimuth's own deviation in rad: 1, overhead the horizontal distance (at least
    /// near_zenith of the distance).
    double azimuth_scale = 1.0;
};
/// The azimuth that was read decides what "across" is where the target is overhead.
ReadingSensitivity reading_sensitivity(const StationGeometry& station, const Eigen::Vector3d& p_W,
                                       double azimuth);

/// Whether the correlation coefficients of the station are possible together (no negative eigenvalue).
bool has_valid_correlation(const SensorSource& sensor);
/// F with F Fᵀ the covariance of the station's six coordinates: they are F times six independent deviations
/// of standard uncertainty one.
Eigen::Matrix<double, 6, 6> station_factor(const SensorSource& sensor);

}  // namespace covaria
