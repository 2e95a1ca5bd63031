// Readings of a target by a sensor, for every number type: their residuals and derivatives.
#pragma once

#include "core/kinds/network/setup.h"
#include "core/math/dual.h"

namespace covaria::network {

/// A station as drawn in one trial: axes by columns, and where they meet.
template <class Real>
struct Place {
    Matrix3<Real> R;
    Vector3<Real> o;
};

/// `moved`: from the coordinates that were drawn.
template <class Real, class In, class Moved>
Place<Real> place_of(const NetworkSetup& setup, const In& x, std::size_t set_up, std::size_t sensor,
                     const Moved* moved) {
    const std::size_t first = setup.station_input(set_up, sensor);
    std::array<Real, 6> at;
    for (std::size_t i = 0; i < 6; ++i) {
        at[i] = Real(x[first + i]);
        if (moved) at[i] += Real(moved[i]);
    }
    return {
        station_rotation<Real>(setup.sensors[sensor]->station().angles, Vector3<Real>(at[3], at[4], at[5])),
        Vector3<Real>(at[0], at[1], at[2])};
}

template <class Real, class In>
Place<Real> place_of(const NetworkSetup& setup, const In& x, std::size_t set_up, std::size_t sensor) {
    const double* moved =
        setup.found.empty() ? nullptr : setup.found[set_up * setup.sensors.size() + sensor].moved.data();
    return place_of<Real>(setup, x, set_up, sensor, moved);
}

/// Directions of the spherical coordinates at the angles that a sensor read, in the sensor's axes.
template <class Real>
struct ReadDirections {
    Vector3<Real> r, azimuth, elevation;
    ReadDirections(const Real& az, const Real& el) {
        using namespace real_functions;
        const Real ca = cos(az), sa = sin(az), ce = cos(el), se = sin(el), zero(0.0);
        r = Vector3<Real>(Real(ce * ca), Real(ce * sa), se);
        azimuth = Vector3<Real>(Real(-sa), ca, zero);
        elevation = Vector3<Real>(Real(-se * ca), Real(-se * sa), ce);
    }
};

/// The azimuth that was read; overhead a constant, and what was read is the displacement across it.
template <class Real, class In>
Real azimuth_of(const Sight& sight, const In& x) {
    return sight.overhead ? Real(sight.reading[1]) : Real(x[sight.input[1]]);
}
template <class Real, class In>
Real across_of(const Sight& sight, const In& x) {
    return sight.overhead ? Real(x[sight.input[1]]) : Real(0.0);
}

/// A target in the axes of a sensor.
template <class Real>
struct View {
    Vector3<Real> v;
    Real rho2, rho, d2;
    View(const Place<Real>& place, const Vector3<Real>& X) : v(place.R.transpose() * (X - place.o)) {
        using namespace real_functions;
        rho2 = v[0] * v[0] + v[1] * v[1];
        rho = sqrt(rho2);
        d2 = rho2 + v[2] * v[2];
    }
};

/// Sine and cosine of the angles that were read: what all steps of a trial have in common.
template <class Real>
struct ReadAngles {
    Real cos_azimuth, sin_azimuth, cos_elevation, sin_elevation;

    ReadAngles() = default;
    template <class In>
    ReadAngles(const Sight& sight, const In& x) {
        using namespace real_functions;
        if (sight.has[1]) {
            const Real azimuth = azimuth_of<Real>(sight, x);
            cos_azimuth = cos(azimuth);
            sin_azimuth = sin(azimuth);
        }
        if (sight.has[2]) {
            const Real elevation(x[sight.input[2]]);
            cos_elevation = cos(elevation);
            sin_elevation = sin(elevation);
        }
    }

    /// Direction in which the elevation grows.
    Vector3<Real> upwards() const {
        return {Real(-sin_elevation * cos_azimuth), Real(-sin_elevation * sin_azimuth), cos_elevation};
    }
};

/// Arctangent of t to the last bit, for |t| < small_angle.
inline constexpr double small_angle = 0.01;
template <class Real>
Real small_arctangent(const Real& t) {
    const Real t2 = t * t;
    return t * (Real(1.0) - t2 * (Real(1.0 / 3) - t2 * (Real(1.0 / 5) - t2 * Real(1.0 / 7))));
}

/// Azimuth read minus that of v, on the circle, from the components across and along the reading.
template <class Real>
Real azimuth_residual(const Vector3<Real>& v, const ReadAngles<Real>& read) {
    using namespace real_functions;
    const Real across = read.sin_azimuth * v[0] - read.cos_azimuth * v[1];
    const Real along = read.cos_azimuth * v[0] + read.sin_azimuth * v[1];
    const auto small = abs(across) < Real(Real(small_angle) * along);
    const Real near = small_arctangent(Real(across / along));
    return all(small) ? near : Real(select(small, near, atan2(across, along)));
}

/// Elevation read minus that of v.
template <class Real>
Real elevation_residual(const View<Real>& view, const Real& reading, const ReadAngles<Real>& read) {
    using namespace real_functions;
    const Real across = read.sin_elevation * view.rho - read.cos_elevation * view.v[2];
    const Real along = read.cos_elevation * view.rho + read.sin_elevation * view.v[2];
    constexpr double no_whole_turn = 3.0;
    const auto small = abs(across) < Real(Real(small_angle) * along) && abs(reading) < Real(no_whole_turn);
    const Real near = small_arctangent(Real(across / along));
    return all(small) ? near : Real(select(small, near, Real(reading - atan2(view.v[2], view.rho))));
}

/// Reading minus what the sensor would read of X from where it is taken to stand.
template <class Real, class In>
Real plain_residual(const Sight& sight, std::size_t observable, const View<Real>& view, const In& x,
                    const ReadAngles<Real>& read) {
    using namespace real_functions;
    const Vector3<Real>& v = view.v;
    if (observable == 0) return Real(x[sight.input[0]]) - sqrt(view.d2);
    if (observable == 2 && sight.overhead && sight.has[1])  // past the zenith an elevation goes on growing
        return -read.upwards().dot(v) / sqrt(view.d2);
    if (observable == 2) return elevation_residual<Real>(view, Real(x[sight.input[2]]), read);
    if (!sight.overhead) return azimuth_residual<Real>(v, read);
    return read.sin_azimuth * v[0] - read.cos_azimuth * v[1] + across_of<Real>(sight, x);
}

/// The same from where its station was stated, to first order where it was found.
template <class Real, class In>
Real residual(const Sight& sight, std::size_t observable, const View<Real>& view, const In& x,
              const ReadAngles<Real>& read) {
    return plain_residual(sight, observable, view, x, read) + Real(sight.raised[observable]);
}

/// Derivative of the reading by the target's coordinates in W.
template <class Real>
Vector3<Real> gradient(const Sight& sight, std::size_t observable, const Place<Real>& place,
                       const View<Real>& view, const ReadAngles<Real>& read) {
    using namespace real_functions;
    const Vector3<Real>& v = view.v;
    const Real zero(0.0);
    if (observable == 0) return place.R * (v * Real(Real(1.0) / sqrt(view.d2)));
    if (observable == 1) {
        if (sight.overhead) return place.R * Vector3<Real>(Real(-read.sin_azimuth), read.cos_azimuth, zero);
        const Real by_rho2 = Real(1.0) / view.rho2;
        return place.R * Vector3<Real>(Real(-v[1] * by_rho2), Real(v[0] * by_rho2), zero);
    }
    if (sight.overhead && sight.has[1])
        return place.R * Vector3<Real>(read.upwards() * Real(Real(1.0) / sqrt(view.d2)));
    const Real factor = Real(1.0) / (view.rho * view.d2);
    return place.R *
           Vector3<Real>(Real(-v[0] * v[2] * factor), Real(-v[1] * v[2] * factor), Real(view.rho2 * factor));
}

}  // namespace covaria::network
