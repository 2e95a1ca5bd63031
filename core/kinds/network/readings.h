// What a sensor reads of a target, for every number type: residuals of readings and their derivatives.
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

template <class Real, class In>
Place<Real> place_of(const NetworkSetup& setup, const In& x, std::size_t set_up, std::size_t sensor) {
    const std::size_t first = setup.station_input(set_up, sensor);
    const auto angles = Vector3<Real>(Real(x[first + 3]), Real(x[first + 4]), Real(x[first + 5]));
    return {station_rotation<Real>(setup.sensors[sensor].source().station().angles, angles),
            Vector3<Real>(Real(x[first]), Real(x[first + 1]), Real(x[first + 2]))};
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

/// Reading minus what the sensor would read of X.
template <class Real, class In>
Real residual(const Sight& sight, std::size_t observable, const View<Real>& view, const In& x) {
    using namespace real_functions;
    const Real reading = observable == 1 ? azimuth_of<Real>(sight, x) : Real(x[sight.input[observable]]);
    const Vector3<Real>& v = view.v;
    if (observable == 0) return reading - sqrt(view.d2);
    if (observable == 2 && sight.overhead && sight.has[1]) {  // past the zenith an elevation goes on growing
        const ReadDirections<Real> e(azimuth_of<Real>(sight, x), reading);
        return -e.elevation.dot(v) / sqrt(view.d2);
    }
    if (observable == 2) return reading - atan2(v[2], view.rho);
    // The difference of two angles on the circle, from the components along and across the reading.
    const Real c = cos(reading), s = sin(reading), across = s * v[0] - c * v[1];
    return sight.overhead ? Real(across + across_of<Real>(sight, x))
                          : Real(atan2(across, Real(c * v[0] + s * v[1])));
}

/// Derivative of the reading by the target's coordinates in W.
template <class Real, class In>
Vector3<Real> gradient(const Sight& sight, std::size_t observable, const Place<Real>& place,
                       const View<Real>& view, const In& x) {
    using namespace real_functions;
    const Vector3<Real>& v = view.v;
    const Real zero(0.0);
    if (observable == 0) return place.R * (v * Real(Real(1.0) / sqrt(view.d2)));
    if (observable == 1) {
        const Real azimuth = azimuth_of<Real>(sight, x);
        const Vector3<Real> turn(Real(-v[1] / view.rho2), Real(v[0] / view.rho2), zero);
        const Vector3<Real> across(Real(-sin(azimuth)), Real(cos(azimuth)), zero);
        return place.R * (sight.overhead ? across : turn);
    }
    if (sight.overhead && sight.has[1]) {
        const ReadDirections<Real> e(azimuth_of<Real>(sight, x), Real(x[sight.input[2]]));
        return place.R * Vector3<Real>(e.elevation * Real(Real(1.0) / sqrt(view.d2)));
    }
    const Real factor = Real(1.0) / (view.rho * view.d2);
    return place.R *
           Vector3<Real>(Real(-v[0] * v[2] * factor), Real(-v[1] * v[2] * factor), Real(view.rho2 * factor));
}

}  // namespace covaria::network
