// Where an instrument and its target are on a robot and beside it: A X = Z B by least squares from poses of
// the flange and what the instrument measured in each.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/robot_identification/least_squares.h"
#include "core/math/rotation.h"
#include "core/quantity/input_quantity.h"

namespace covaria::hand_eye {

inline constexpr std::size_t unknowns_of_a_pose = 6, most_unknowns = 12;
inline constexpr std::size_t nothing = InputSet::npos;

enum class Mount { target, instrument };  ///< what the flange carries

struct StatedPair {
    std::string name;
    bool check = false;  ///< held back from the fit
    Eigen::Vector3d p_BF = Eigen::Vector3d::Zero(), angles_BF = Eigen::Vector3d::Zero();
    Eigen::Vector3d p_measured = Eigen::Vector3d::Zero();
    std::array<std::optional<double>, 3> measured_angles = {};
};

/// The set-up as typed, SI.
struct StatedHandEye {
    Mount mount = Mount::instrument;
    std::vector<StatedPair> stated;
    double u_position = 0.0, u_angle = 0.0, u_robot_position = 0.0, u_robot_angle = 0.0;
    evidence::UncertaintiesFrom uncertainties = evidence::UncertaintiesFrom::stated;
};
const Fields<StatedHandEye>& fields();

struct Pair {
    std::string name, source;
    bool check = false;
    Eigen::Vector3d p_BF, p_measured;
    Eigen::Matrix3d R_BF, R_measured = Eigen::Matrix3d::Identity();
    std::size_t measured_input = 0;     ///< x, y, z, then rotations about the axes of what is measured
    std::size_t robot_input = nothing;  ///< likewise of the flange
};

/// X: what the flange carries, in its frame. Z: the other, in the frame of the base.
struct Unknown {
    bool of_X = true;
    std::size_t coordinate = 0;  ///< x, y, z, rotations about x, y, z
};

struct Calibration : StatedHandEye {
    explicit Calibration(StatedHandEye s) : StatedHandEye(std::move(s)) {}
    std::vector<Pair> pairs;  ///< those of the fit, then the others
    std::size_t fitted_pairs = 0;
    bool with_orientation = true;
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity(), Z = Eigen::Isometry3d::Identity();
    std::vector<Unknown> unknowns;
    std::vector<double> solution;  ///< rotations from X and Z
    std::vector<HeldParameter> held;
    Eigen::MatrixXd gain;           ///< unknowns by rows of the fit
    std::vector<double> inverse_u;  ///< of the unknowns
    identification::FitStatistics statistics;
    Eigen::VectorXd deviations,
        u_deviations;  ///< of the pairs held back, positions, calculated less measured
    InputSet inputs;

    std::size_t rows_per_pair() const { return with_orientation ? 6 : 3; }
    std::size_t rows() const { return fitted_pairs * rows_per_pair(); }
    std::vector<Message> names() const;
    /// "camera in the flange": what X is, what Z is.
    Message words_of(bool X) const;
};

/// Empty if `problems` got an error.
std::optional<Calibration> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems);
/// False after an error.
bool fit(Calibration& c, Problems& problems);
std::vector<Table> tables(const Calibration& c);
/// `first_output_of_Z`: index of the output that is its x.
Layout layout(const Calibration& c, std::size_t first_output_of_Z);

template <class Real>
struct Places {
    Matrix3<Real> R_X, R_Z;
    Vector3<Real> p_X, p_Z;
};

template <class Real, class Values>
Places<Real> places_of(const Calibration& c, const Values& v) {
    const Vector3<Real> zero(Real(0.0), Real(0.0), Real(0.0));
    Vector3<Real> turn_X = zero, turn_Z = zero;
    Places<Real> places;
    for (int k = 0; k < 3; ++k) {
        places.p_X[k] = Real(c.X.translation()[k]);
        places.p_Z[k] = Real(c.Z.translation()[k]);
    }
    for (std::size_t i = 0; i < c.unknowns.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(c.unknowns[i].coordinate);
        const bool of_X = c.unknowns[i].of_X;
        if (k < 3)
            (of_X ? places.p_X : places.p_Z)[k] = v[i];
        else
            (of_X ? turn_X : turn_Z)[k - 3] = v[i];
    }
    places.R_X = c.X.linear().cast<Real>() * rotation_from_zyx<Real>(turn_X);
    places.R_Z = c.Z.linear().cast<Real>() * rotation_from_zyx<Real>(turn_Z);
    return places;
}

/// Measured less calculated of one pair in `r`: x, y, z, then the rotation vector (to first order).
template <class Real, class In>
void residuals(const Calibration& c, const Pair& pair, const Places<Real>& places, const In& x, Real* r) {
    Matrix3<Real> R_BF = pair.R_BF.cast<Real>();
    Vector3<Real> p_BF = pair.p_BF.cast<Real>();
    if (const std::size_t i = pair.robot_input; i != nothing) {
        for (std::size_t k = 0; k < 3; ++k) p_BF[static_cast<Eigen::Index>(k)] = Real(x[i + k]);
        R_BF = (R_BF * rotation_from_zyx<Real>({Real(x[i + 3]), Real(x[i + 4]), Real(x[i + 5])})).eval();
    }
    const Matrix3<Real> R_carried = R_BF * places.R_X;
    const Vector3<Real> p_carried = R_BF * places.p_X + p_BF;
    const bool instrument = c.mount == Mount::instrument;
    const Matrix3<Real>& R_eye = instrument ? R_carried : places.R_Z;
    const Vector3<Real> away =
        instrument ? Vector3<Real>(places.p_Z - p_carried) : Vector3<Real>(p_carried - places.p_Z);
    const Vector3<Real> p = R_eye.transpose() * away;
    const std::size_t i = pair.measured_input;
    for (std::size_t k = 0; k < 3; ++k) r[k] = Real(x[i + k]) - p[static_cast<Eigen::Index>(k)];
    if (!c.with_orientation) return;
    const Matrix3<Real> R = R_eye.transpose() * (instrument ? places.R_Z : R_carried);
    const Matrix3<Real> stated = pair.R_measured.cast<Real>();
    const Matrix3<Real> measured =
        stated * rotation_from_zyx<Real>({Real(x[i + 3]), Real(x[i + 4]), Real(x[i + 5])});
    const Matrix3<Real> turned = R.transpose() * measured;
    r[3] = Real(0.5) * (turned(2, 1) - turned(1, 2));
    r[4] = Real(0.5) * (turned(0, 2) - turned(2, 0));
    r[5] = Real(0.5) * (turned(1, 0) - turned(0, 1));
}

/// X and Z of a trial, then `deviation(i, value)`: positions of the pairs held back, calculated less
/// measured.
template <class Real, class In, class Set>
mask_of<Real> evaluate(const Calibration& c, const In& x, Places<Real>& places, Set deviation) {
    const std::size_t m = c.rows_per_pair();
    std::array<Real, most_unknowns> v;
    std::array<Real, 6> r;
    for (std::size_t i = 0; i < c.unknowns.size(); ++i) v[i] = Real(c.solution[i]);
    const auto settled =
        identification::follow_gain<Real>(c.gain, c.inverse_u, v, [&](const auto& at, const auto& add) {
            places = places_of<Real>(c, at);
            for (std::size_t pair = 0; pair < c.fitted_pairs; ++pair) {
                residuals<Real>(c, c.pairs[pair], places, x, r.data());
                for (std::size_t row = 0; row < m; ++row) add(pair * m + row, r[row]);
            }
        });
    places = places_of<Real>(c, v);
    for (std::size_t pair = c.fitted_pairs; pair < c.pairs.size(); ++pair) {
        residuals<Real>(c, c.pairs[pair], places, x, r.data());
        for (std::size_t k = 0; k < 3; ++k) deviation(3 * (pair - c.fitted_pairs) + k, Real(-r[k]));
    }
    return settled;
}

}  // namespace covaria::hand_eye
