// Equations of the readings of a network adjustment as functions of its points, and their derivatives.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

namespace {

/// The number of the reading's figure of that kind in the state; `known` where it has none.
std::size_t place_of(const AdjustedNetwork& network, const AdjustedReading& reading, FigureKind kind) {
    for (const std::size_t f : reading.figures)
        if (network.figures[f].kind == kind) return network.figure(f);
    return AdjustedNetwork::known;
}

double figure_of(const AdjustedNetwork& network, const AdjustedReading& reading, FigureKind kind,
                 const double* state, double otherwise = 0.0) {
    const std::size_t place = place_of(network, reading, kind);
    return place == AdjustedNetwork::known ? otherwise : state[place];
}

/// The sign of index and collimation in the reading.
double sign_of_face(const AdjustedReading& reading) {
    return reading.face_two ? -1.0 : 1.0;
}

/// The fall of a zenith angle's line of sight below the plane for each m² of distance, 1/m: half the
/// curvature of the Earth less that of the ray.
double fall(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state) {
    if (network.curvature == 0.0 || reading.kind != ReadingKind::zenith_angle) return 0.0;
    return 0.5 * network.curvature *
           (1.0 - figure_of(network, reading, FigureKind::refraction, state, network.refraction));
}

Eigen::Vector3d between(const AdjustedNetwork& network, const AdjustedReading& reading, std::size_t to,
                        const double* state) {
    const double *a = state + 3 * reading.from, *b = state + 3 * to;
    Eigen::Vector3d v{b[0] - a[0], b[1] - a[1], b[2] - a[2] + reading.height_to - reading.height_from};
    if (const double by = fall(network, reading, state); by != 0.0) v.z() -= by * v.head<2>().squaredNorm();
    return v;
}

/// The axes of an instrument that leans, by columns.
Eigen::Matrix3d leaning_axes(const AdjustedNetwork& network, const AdjustedReading& reading,
                             const double* state) {
    return (Eigen::AngleAxisd(state[network.tilt(reading.tilt, 0)], Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(state[network.tilt(reading.tilt, 1)], Eigen::Vector3d::UnitY()))
        .toRotationMatrix();
}

/// The vector to the target in the axes of the instrument, m, but for the orientation of its circle.
Eigen::Vector3d seen(const AdjustedNetwork& network, const AdjustedReading& reading, std::size_t to,
                     const double* state) {
    const Eigen::Vector3d v = between(network, reading, to, state);
    if (reading.tilt == AdjustedReading::no_tilt) return v;
    return leaning_axes(network, reading, state).transpose() * v;
}

double bearing(const AdjustedNetwork& network, const Eigen::Vector3d& v) {
    return network.clockwise ? std::atan2(v.x(), v.y()) : std::atan2(v.y(), v.x());
}

Eigen::Vector3d bearing_gradient(const AdjustedNetwork& network, const Eigen::Vector3d& v) {
    const double by = (network.clockwise ? -1.0 : 1.0) / v.head<2>().squaredNorm();
    return {-v.y() * by, v.x() * by, 0.0};
}

std::size_t axis_of(ReadingKind kind) {
    switch (kind) {
        case ReadingKind::y:
        case ReadingKind::dy:
            return 1;
        case ReadingKind::z:
        case ReadingKind::dz:
        case ReadingKind::height_difference:
            return 2;
        default:
            return 0;
    }
}

Eigen::Vector3d gradient(const AdjustedNetwork& network, ReadingKind kind, const Eigen::Vector3d& v) {
    const double rho = v.head<2>().norm();
    switch (kind) {
        case ReadingKind::slope_distance:
            return v.normalized();
        case ReadingKind::horizontal_distance:
            return {v.x() / rho, v.y() / rho, 0.0};
        case ReadingKind::zenith_angle: {
            const double by = 1.0 / (rho * v.squaredNorm());
            return {v.x() * v.z() * by, v.y() * v.z() * by, -rho * rho * by};
        }
        case ReadingKind::direction:
        case ReadingKind::angle:
        case ReadingKind::azimuth:
            return bearing_gradient(network, v);
        default:
            return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis_of(kind)));
    }
}

/// Adds the gradient of one leg by the points, and by how the instrument leans.
void add_leg(const AdjustedNetwork& network, const AdjustedReading& reading, std::size_t to, double sign,
             const double* state, StateTerms& terms) {
    const Eigen::Vector3d v = seen(network, reading, to, state);
    Eigen::Vector3d g = sign * gradient(network, reading.kind, v);
    if (reading.kind == ReadingKind::direction) {
        const double rho = v.head<2>().norm(), d = v.norm();
        g += sign_of_face(reading) * figure_of(network, reading, FigureKind::collimation, state) *
             (v / (d * rho) - d / (rho * rho * rho) * Eigen::Vector3d(v.x(), v.y(), 0.0));
    }
    if (reading.tilt != AdjustedReading::no_tilt) {
        g = leaning_axes(network, reading, state) * g;
        const Eigen::Vector3d turned = g.cross(between(network, reading, to, state));
        const double a = state[network.tilt(reading.tilt, 0)];
        terms.push_back({network.tilt(reading.tilt, 0), turned.x()});
        terms.push_back({network.tilt(reading.tilt, 1), std::cos(a) * turned.y() + std::sin(a) * turned.z()});
    }
    if (const double by = fall(network, reading, state); by != 0.0) {
        const Eigen::Vector3d level = between(network, reading, to, state);
        if (const std::size_t k = place_of(network, reading, FigureKind::refraction);
            k != AdjustedNetwork::known)
            terms.push_back({k, 0.5 * network.curvature * g.z() * level.head<2>().squaredNorm()});
        g.head<2>() -= 2.0 * by * g.z() * level.head<2>();
    }
    for (std::size_t c = 0; c < 3; ++c) {
        const double by = g[static_cast<Eigen::Index>(c)];
        if (by == 0.0) continue;
        terms.push_back({3 * to + c, by});
        terms.push_back({3 * reading.from + c, -by});
    }
}

bool is_of_tilt(ReadingKind kind) {
    return kind == ReadingKind::tilt_x || kind == ReadingKind::tilt_y;
}

bool is_distance(ReadingKind kind) {
    return kind == ReadingKind::slope_distance || kind == ReadingKind::horizontal_distance;
}

/// Adds the derivatives by the figures of the instrument that change the reading.
void add_figures(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state,
                 StateTerms& terms) {
    if (reading.figures.empty()) return;
    const Eigen::Vector3d v = seen(network, reading, reading.to, state);
    for (const std::size_t f : reading.figures) {
        switch (network.figures[f].kind) {
            case FigureKind::zero:
                terms.push_back({network.figure(f), 1.0});
                break;
            case FigureKind::index:
                terms.push_back({network.figure(f), sign_of_face(reading)});
                break;
            case FigureKind::scale:
                terms.push_back({network.figure(f), reading.kind == ReadingKind::slope_distance
                                                        ? v.norm()
                                                        : v.head<2>().norm()});
                break;
            case FigureKind::collimation:
                terms.push_back({network.figure(f), sign_of_face(reading) * v.norm() / v.head<2>().norm()});
                break;
            case FigureKind::refraction:
                break;  // refraction belongs to the leg: see `fall`
        }
    }
}

/// The number in the state of the tilt, scale or figure that is stated of an instrument or of a frame.
std::size_t place_of_stated(const AdjustedNetwork& network, const AdjustedReading& reading) {
    const bool scale = reading.kind == ReadingKind::figure_ratio;
    const std::size_t axis = reading.kind == ReadingKind::tilt_y ? 1 : 0;
    if (reading.frame != AdjustedReading::no_frame) return network.frame(reading.frame, scale ? 6 : 3 + axis);
    return is_of_tilt(reading.kind) ? network.tilt(reading.tilt, axis)
                                    : network.figure(reading.figures.front());
}

/// The reading of an instrument without fault.
double read_without_fault(const AdjustedNetwork& network, const AdjustedReading& reading,
                          const double* state) {
    const Eigen::Vector3d v = seen(network, reading, reading.to, state);
    switch (reading.kind) {
        case ReadingKind::slope_distance:
            return v.norm();
        case ReadingKind::horizontal_distance:
            return v.head<2>().norm();
        case ReadingKind::zenith_angle:
            return std::atan2(v.head<2>().norm(), v.z());
        case ReadingKind::direction:
            return bearing(network, v) - state[network.orientation(reading.round)];
        case ReadingKind::azimuth:
            return bearing(network, v);
        case ReadingKind::angle:
            return bearing(network, seen(network, reading, reading.second, state)) - bearing(network, v);
        default:
            return v[static_cast<Eigen::Index>(axis_of(reading.kind))];
    }
}

}  // namespace

bool is_of_angle(ReadingKind kind) {
    return kind == ReadingKind::direction || kind == ReadingKind::angle || kind == ReadingKind::azimuth ||
           kind == ReadingKind::zenith_angle || kind == ReadingKind::tilt_x || kind == ReadingKind::tilt_y ||
           kind == ReadingKind::figure_angle;
}

bool is_in_frame(ReadingKind kind) {
    return kind == ReadingKind::frame_x || kind == ReadingKind::frame_y || kind == ReadingKind::frame_z;
}

bool is_read(ReadingKind kind) {
    return kind < ReadingKind::tilt_x;
}

Unit unit_of_residual(ReadingKind kind) {
    if (kind == ReadingKind::figure_ratio) return Unit::of("ppm");
    return Unit::of(is_of_angle(kind) ? "arcsec" : "mm");
}

bool needs_heights(ReadingKind kind) {
    return kind == ReadingKind::slope_distance || kind == ReadingKind::zenith_angle ||
           kind == ReadingKind::height_difference || kind == ReadingKind::z || kind == ReadingKind::dz ||
           is_in_frame(kind);
}

bool needs_plane(ReadingKind kind) {
    return kind != ReadingKind::height_difference && kind != ReadingKind::z && kind != ReadingKind::dz;
}

double predicted(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state) {
    switch (reading.kind) {
        case ReadingKind::tilt_x:
        case ReadingKind::tilt_y:
        case ReadingKind::figure_length:
        case ReadingKind::figure_ratio:
        case ReadingKind::figure_angle:
            return state[place_of_stated(network, reading)];
        case ReadingKind::frame_x:
        case ReadingKind::frame_y:
        case ReadingKind::frame_z:
            return predicted_in_frame(network, reading, state);
        case ReadingKind::x:
        case ReadingKind::y:
        case ReadingKind::z:
            return state[3 * reading.from + axis_of(reading.kind)];
        default:
            break;
    }
    const double without_fault = read_without_fault(network, reading, state);
    double value = without_fault;
    for (const std::size_t f : reading.figures) {
        const double figure = state[network.figure(f)];
        const FigureKind kind = network.figures[f].kind;
        if (kind == FigureKind::collimation) {
            const Eigen::Vector3d v = seen(network, reading, reading.to, state);
            value += sign_of_face(reading) * figure * v.norm() / v.head<2>().norm();
        } else if (kind == FigureKind::scale) {
            value += figure * without_fault;
        } else if (kind == FigureKind::index) {
            value += sign_of_face(reading) * figure;
        } else if (kind != FigureKind::refraction) {
            value += figure;
        }
    }
    return value;
}

double residual_of(const AdjustedNetwork& network, const AdjustedReading& reading, double value,
                   const double* state) {
    const double r = value - predicted(network, reading, state);
    return is_of_angle(reading.kind) ? std::remainder(r, 2.0 * std::numbers::pi) : r;
}

void derivatives(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state,
                 StateTerms& terms) {
    terms.clear();
    switch (reading.kind) {
        case ReadingKind::tilt_x:
        case ReadingKind::tilt_y:
        case ReadingKind::figure_length:
        case ReadingKind::figure_ratio:
        case ReadingKind::figure_angle:
            return terms.push_back({place_of_stated(network, reading), 1.0});
        case ReadingKind::frame_x:
        case ReadingKind::frame_y:
        case ReadingKind::frame_z:
            return derivatives_in_frame(network, reading, state, terms);
        case ReadingKind::x:
        case ReadingKind::y:
        case ReadingKind::z:
            return terms.push_back({3 * reading.from + axis_of(reading.kind), 1.0});
        case ReadingKind::angle:
            add_leg(network, reading, reading.to, -1.0, state, terms);
            return add_leg(network, reading, reading.second, 1.0, state, terms);
        default:
            break;
    }
    const double scale =
        is_distance(reading.kind) ? 1.0 + figure_of(network, reading, FigureKind::scale, state) : 1.0;
    add_leg(network, reading, reading.to, scale, state, terms);
    add_figures(network, reading, state, terms);
    if (reading.kind == ReadingKind::direction) terms.push_back({network.orientation(reading.round), -1.0});
}

adjustment::SparseRows design_of(const AdjustedNetwork& network, const double* state) {
    constexpr std::size_t usual = 8;  // derivatives of a reading
    std::vector<int> starts{0}, columns;
    std::vector<double> values;
    starts.reserve(network.readings.size() + 1);
    columns.reserve(usual * network.readings.size());
    values.reserve(usual * network.readings.size());
    StateTerms terms;
    terms.reserve(2 * usual);
    for (const AdjustedReading& reading : network.readings) {
        derivatives(network, reading, state, terms);
        const auto first = static_cast<std::size_t>(starts.back());
        for (const StateTerm& term : terms) {
            if (network.unknown_of[term.place] == AdjustedNetwork::known) continue;
            const int column = static_cast<int>(network.unknown_of[term.place]);
            std::size_t at = columns.size();
            while (at > first && columns[at - 1] > column) --at;
            if (at > first && columns[at - 1] == column) {
                values[at - 1] += term.coefficient;
                continue;
            }
            columns.insert(columns.begin() + static_cast<std::ptrdiff_t>(at), column);
            values.insert(values.begin() + static_cast<std::ptrdiff_t>(at), term.coefficient);
        }
        starts.push_back(static_cast<int>(columns.size()));
    }
    adjustment::SparseRows design(static_cast<Eigen::Index>(network.readings.size()),
                                  static_cast<Eigen::Index>(network.place_of.size()));
    design.resizeNonZeros(static_cast<Eigen::Index>(columns.size()));
    std::ranges::copy(starts, design.outerIndexPtr());
    std::ranges::copy(columns, design.innerIndexPtr());
    std::ranges::copy(values, design.valuePtr());
    return design;
}

Eigen::VectorXd residuals_of(const AdjustedNetwork& network, const double* state) {
    Eigen::VectorXd r(static_cast<Eigen::Index>(network.readings.size()));
    for (std::size_t i = 0; i < network.readings.size(); ++i)
        r[static_cast<Eigen::Index>(i)] =
            residual_of(network, network.readings[i], network.readings[i].value, state);
    return r;
}

Message words_of(const InstrumentFigure& figure) {
    const Message of = figure.instrument.empty() ? tell<"all instruments">() : Message(figure.instrument);
    switch (figure.kind) {
        case FigureKind::zero:
            return tell<"the zero of %1">(of);
        case FigureKind::scale:
            return tell<"the scale of %1">(of);
        case FigureKind::refraction:
            return tell<"the refraction coefficient of %1">(of);
        case FigureKind::index:
            return tell<"the vertical index of %1">(of);
        case FigureKind::collimation:
            return tell<"the collimation of %1">(of);
    }
    return {};
}

double offset_of(const AdjustedNetwork& network, const AdjustedReading& reading) {
    const double r = residual_of(network, reading, reading.value, network.state.data());
    if (!is_of_angle(reading.kind)) return r;
    const double* state = network.state.data();
    if (reading.kind == ReadingKind::zenith_angle)
        return r * between(network, reading, reading.to, state).norm();
    double farthest = 0.0;
    for (const std::size_t to : {reading.to, reading.second})
        farthest = std::max(farthest, between(network, reading, to, state).head<2>().norm());
    return r * farthest;
}

namespace {

Message words_in_frame(const AdjustedNetwork& network, const AdjustedReading& reading) {
    const Message frame = words_of(network.frames[reading.frame]);
    if (reading.kind == ReadingKind::figure_ratio) return tell<"the scale of %1">(frame);
    if (is_of_tilt(reading.kind))
        return tell<"tilt of %1 about %2">(frame, reading.kind == ReadingKind::tilt_x ? "x" : "y");
    const char* axis = reading.kind == ReadingKind::frame_x   ? "x"
                       : reading.kind == ReadingKind::frame_y ? "y"
                                                              : "z";
    return tell<"%1 of %2 in %3">(axis, network.points[reading.from].name, frame);
}

Message words_of_kind(const AdjustedNetwork& network, const AdjustedReading& reading) {
    const std::string& from = network.points[reading.from].name;
    const std::string& to = network.points[reading.to].name;
    if (reading.frame != AdjustedReading::no_frame) return words_in_frame(network, reading);
    switch (reading.kind) {
        case ReadingKind::slope_distance:
            return tell<"slope distance %1 – %2">(from, to);
        case ReadingKind::horizontal_distance:
            return tell<"horizontal distance %1 – %2">(from, to);
        case ReadingKind::direction:
            return tell<"direction %1 – %2">(from, to);
        case ReadingKind::azimuth:
            return tell<"azimuth %1 – %2">(from, to);
        case ReadingKind::zenith_angle:
            return tell<"zenith angle %1 – %2">(from, to);
        case ReadingKind::height_difference:
            return tell<"height difference %1 – %2">(from, to);
        case ReadingKind::angle:
            return tell<"angle at %1 from %2 to %3">(from, to, network.points[reading.second].name);
        case ReadingKind::figure_length:
        case ReadingKind::figure_ratio:
        case ReadingKind::figure_angle:
            return words_of(network.figures[reading.figures.front()]);
        case ReadingKind::tilt_x:
            return tell<"tilt about x of the instrument at %1">(from);
        case ReadingKind::tilt_y:
            return tell<"tilt about y of the instrument at %1">(from);
        case ReadingKind::x:
            return tell<"x of %1">(from);
        case ReadingKind::y:
            return tell<"y of %1">(from);
        case ReadingKind::z:
            return tell<"z of %1">(from);
        case ReadingKind::frame_x:
        case ReadingKind::frame_y:
        case ReadingKind::frame_z:
            return {};  // these are named above
        case ReadingKind::dx:
            return tell<"difference of x, %1 – %2">(from, to);
        case ReadingKind::dy:
            return tell<"difference of y, %1 – %2">(from, to);
        case ReadingKind::dz:
            return tell<"difference of z, %1 – %2">(from, to);
    }
    return {};
}

}  // namespace

Message words_of(const AdjustedNetwork& network, const AdjustedReading& reading) {
    const Message words = words_of_kind(network, reading);
    return reading.face_two ? tell<"%1, face two">(words) : words;
}

}  // namespace covaria::network
