// Frames of a network adjustment whose pose the readings tell, and planes and lines, which are frames of
// which fewer figures count.
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "core/kinds/network/adjusted_setup.h"
#include "core/math/decompositions.h"
#include "core/math/registration.h"

namespace covaria::network {

namespace {

Eigen::Index axis_in_frame(ReadingKind kind) {
    return kind == ReadingKind::frame_x ? 0 : kind == ReadingKind::frame_y ? 1 : 2;
}

/// The figures of a frame in a state, with the axes and the scale that they give it.
struct LaidFrame {
    const double* figures;
    Eigen::Matrix3d axes;
    double scale;

    LaidFrame(const AdjustedNetwork& network, std::size_t f, const double* state)
        : figures(state + network.frame(f, 0)),
          axes(network.frames[f].axes *
               rotation_from_zyx<double>(Eigen::Vector3d(figures[3], figures[4], figures[5]))),
          scale(1.0 + figures[6]) {}
    Eigen::Vector3d origin(const AdjustedFrame& frame) const {
        return frame.origin + frame.shifts * Eigen::Map<const Eigen::Vector3d>(figures);
    }
};

/// The vector from the origin of a frame to a point; in a flat frame it has no height.
Eigen::Vector3d from_origin(const AdjustedFrame& frame, const LaidFrame& laid, const double* point) {
    Eigen::Vector3d v = Eigen::Map<const Eigen::Vector3d>(point) - laid.origin(frame);
    if (frame.is_flat) v.z() = 0.0;
    return v;
}

/// The vectors, by columns, about which an angular velocity of one turns the frame while one of its three
/// angles grows by one; A_0 is not in them.
Eigen::Matrix3d turns_of(const double* figures) {
    const Eigen::Matrix3d about_z = rotation_z(figures[5]);
    Eigen::Matrix3d turns;
    turns << about_z * rotation_y(figures[4]) * Eigen::Vector3d::UnitX(), about_z * Eigen::Vector3d::UnitY(),
        Eigen::Vector3d::UnitZ();
    return turns;
}

/// Lays a plane or line by the places of its points: A_0 has its normal as the z-axis or its direction as the
/// x-axis. False where the points are too few.
bool lay_on(AdjustedFrame& frame, const std::vector<Eigen::Vector3d>& places) {
    const bool plane = frame.shape == FrameShape::plane;
    if (places.size() < (plane ? 3U : 2U)) return false;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : places) middle += p / double(places.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : places) scatter += (p - middle) * (p - middle).transpose();
    if (frame.is_flat) scatter.row(2).setZero(), scatter.col(2).setZero();
    const auto svd = singular_values(Eigen::MatrixXd(scatter), Eigen::ComputeFullU);
    Eigen::Vector3d first = svd.matrixU().col(0), second = svd.matrixU().col(1);
    if (frame.is_flat) second = Eigen::Vector3d::UnitZ().cross(first);
    frame.axes << first, second, first.cross(second);
    frame.shifts = frame.axes;
    frame.origin = middle;
    return true;
}

/// Takes a pose, with an A_0 that keeps the angles away from where they are not defined, which is a right
/// angle about y.
void take_pose(AdjustedNetwork& network, std::size_t f, const Eigen::Matrix3d& axes,
               const Eigen::Vector3d& origin, double scale) {
    constexpr double steep = 1.0;  // rad
    AdjustedFrame& frame = network.frames[f];
    frame.axes.setIdentity();
    Eigen::Vector3d angles = zyx_from_rotation<double>(axes);
    if (std::abs(angles[1]) > steep) {
        frame.axes = rotation_y(std::copysign(0.5 * std::numbers::pi, angles[1]));
        angles = zyx_from_rotation<double>(frame.axes.transpose() * axes);
    }
    auto figures = network.state.segment<7>(static_cast<Eigen::Index>(network.frame(f, 0)));
    figures << origin, angles, scale - 1.0;
}

struct PairedPoints {
    std::vector<Eigen::Vector3d> here, there;  ///< places of points in the network, and in the frame
};

bool fit_frame(AdjustedNetwork& network, std::size_t f, const PairedPoints& points) {
    const AdjustedFrame& frame = network.frames[f];
    const double n = double(points.here.size());
    if (points.here.size() < (frame.is_flat ? 2U : 3U)) return false;
    Eigen::Vector3d here = Eigen::Vector3d::Zero(), there = here;
    for (std::size_t i = 0; i < points.here.size(); ++i)
        here += points.here[i] / n, there += points.there[i] / n;
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero(), A = Eigen::Matrix3d::Identity();
    double spread_here = 0.0, spread_there = 0.0;
    for (std::size_t i = 0; i < points.here.size(); ++i) {
        const Eigen::Vector3d p = points.here[i] - here, l = points.there[i] - there;
        H += p * l.transpose();
        spread_here += p.squaredNorm();
        spread_there += l.squaredNorm();
    }
    if (frame.is_flat)
        A = rotation_z(std::atan2(H(1, 0) - H(0, 1), H(0, 0) + H(1, 1)));
    else if (!registration<double>(H, A))
        return false;
    if (!(spread_here > 0.0) || !(spread_there > 0.0)) return false;
    double scale = 1.0 + network.state[static_cast<Eigen::Index>(network.frame(f, 6))];
    if (frame.is_found[6]) scale = std::sqrt(spread_there / spread_here);
    take_pose(network, f, A, here - A * there / scale, scale);
    return true;
}

}  // namespace

Message words_of(const AdjustedFrame& frame) {
    return frame.shape == FrameShape::axes    ? tell<"frame %1">(frame.name)
           : frame.shape == FrameShape::plane ? tell<"plane %1">(frame.name)
                                              : tell<"line %1">(frame.name);
}

double predicted_in_frame(const AdjustedNetwork& network, const AdjustedReading& reading,
                          const double* state) {
    const AdjustedFrame& frame = network.frames[reading.frame];
    const LaidFrame laid(network, reading.frame, state);
    return laid.scale *
           laid.axes.col(axis_in_frame(reading.kind)).dot(from_origin(frame, laid, state + 3 * reading.from));
}

void derivatives_in_frame(const AdjustedNetwork& network, const AdjustedReading& reading, const double* state,
                          StateTerms& terms) {
    const AdjustedFrame& frame = network.frames[reading.frame];
    const LaidFrame laid(network, reading.frame, state);
    const Eigen::Vector3d axis = laid.axes.col(axis_in_frame(reading.kind)),
                          v = from_origin(frame, laid, state + 3 * reading.from);
    const Eigen::Vector3d by_point = laid.scale * axis, by_shift = frame.shifts.transpose() * by_point,
                          by_turn = (frame.axes * turns_of(laid.figures)).transpose() * axis.cross(v);
    for (Eigen::Index c = 0; c < (frame.is_flat ? 2 : 3); ++c)
        terms.push_back({3 * reading.from + static_cast<std::size_t>(c), by_point[c]});
    for (std::size_t c = 0; c < 3; ++c) {
        const auto k = static_cast<Eigen::Index>(c);
        terms.push_back({network.frame(reading.frame, c), -by_shift[k]});
        terms.push_back({network.frame(reading.frame, 3 + c), laid.scale * by_turn[k]});
    }
    terms.push_back({network.frame(reading.frame, 6), axis.dot(v)});
}

Eigen::Matrix<double, 7, 7> moves_of_frame(const AdjustedNetwork& network, std::size_t f,
                                           const Eigen::Vector3d& middle) {
    const AdjustedFrame& frame = network.frames[f];
    const LaidFrame laid(network, f, network.state.data());
    const Eigen::Vector3d v = laid.origin(frame) - middle;
    Eigen::Matrix<double, 3, 7> shifts;
    shifts << Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitX().cross(v),
        Eigen::Vector3d::UnitY().cross(v), Eigen::Vector3d::UnitZ().cross(v), v;
    Eigen::Matrix<double, 7, 7> moves = Eigen::Matrix<double, 7, 7>::Zero();
    moves.topRows<3>() = frame.shifts.transpose() * shifts;
    moves.block<3, 3>(3, 3) = turns_of(laid.figures).inverse() * frame.axes.transpose();
    moves(6, 6) = -laid.scale;
    for (std::size_t k = 0; k < AdjustedFrame::figures; ++k)
        if (!frame.is_found[k] && (frame.shape != FrameShape::axes || k == 6 || frame.is_flat))
            moves.row(static_cast<Eigen::Index>(k)).setZero();
    return moves;
}

std::vector<std::pair<std::size_t, Eigen::Vector3d>> points_of_frame(const AdjustedNetwork& network,
                                                                     std::size_t f) {
    std::map<std::size_t, std::pair<Eigen::Vector3d, int>> read;
    for (const AdjustedReading& reading : network.readings) {
        if (reading.frame != f || !is_in_frame(reading.kind)) continue;
        const Eigen::Index axis = axis_in_frame(reading.kind);
        auto& [l, axes] = read.try_emplace(reading.from, Eigen::Vector3d::Zero(), 0).first->second;
        l[axis] = reading.value;
        axes |= 1 << axis;
    }
    std::vector<std::pair<std::size_t, Eigen::Vector3d>> points;
    const AdjustedFrame& frame = network.frames[f];
    const int all = frame.shape != FrameShape::axes ? 0 : frame.is_flat ? 3 : 7;
    for (const auto& [point, of] : read)
        if ((of.second & all) == all) points.emplace_back(point, of.first);
    return points;
}

bool lay_frame(AdjustedNetwork& network, std::size_t f, const std::vector<char>& placed) {
    PairedPoints points;
    for (const auto& [p, l] : points_of_frame(network, f)) {
        if (!placed[p]) continue;
        points.here.push_back(network.position(p));
        if (network.frames[f].is_flat) points.here.back().z() = 0.0;
        points.there.push_back(l);
    }
    if (network.frames[f].shape != FrameShape::axes) return lay_on(network.frames[f], points.here);
    return fit_frame(network, f, points);
}

Eigen::Vector3d out_of_frame(const AdjustedNetwork& network, std::size_t f, const Eigen::Vector3d& in_frame) {
    const LaidFrame laid(network, f, network.state.data());
    return laid.origin(network.frames[f]) + laid.axes * in_frame / laid.scale;
}

}  // namespace covaria::network
