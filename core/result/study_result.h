// Results of a study: estimates and uncertainties of some outputs at every point of a grid. Plain data, SI.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/model/output_quantity.h"
#include "core/text/typeset_message.h"

namespace covaria {

struct StudyAxisValues {
    TypesetMessage title;  ///< "Targets, B: x"
    Unit unit = {};        ///< unit of the values as typed and shown
    bool logarithmic = false;
    std::vector<double> values;  ///< factors, differences or values, in `unit`
    double present = 0.0;        ///< value of the unchanged analysis, in `unit`
};

struct StudyValue {
    double estimate = 0.0;
    double standard_uncertainty = 0.0;
    double expanded_uncertainty = 0.0;
};

/// Three outputs that are the coordinates of a point.
struct StudyTriple {
    Name name;                             ///< name of the point
    std::array<std::size_t, 3> outputs{};  ///< indices into StudyResult::outputs
};

/// Place and uncertainty of such a point.
struct StudyPlace {
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
    Eigen::Matrix3d R_WQ = Eigen::Matrix3d::Identity();    ///< axes of the three coordinates
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< covariance of the three outputs, in those axes
    double standard_uncertainty() const;  ///< u_3D: square root of the trace of the covariance
};

struct StudyPoint {
    std::size_t reason = 0;               ///< 0: has values; else why not, index into StudyResult::reasons
    std::vector<StudyValue> values = {};  ///< per output; empty without values
    std::vector<StudyPlace> places = {};  ///< per triple
    std::uint64_t failed_trials = 0;
    bool has_values() const { return reason == 0; }
};

struct StudyResult {
    std::string id, name;
    std::vector<StudyAxisValues> axes;
    std::vector<OutputQuantity> outputs;
    std::vector<StudyTriple> triples;
    std::vector<StudyPoint> points;  ///< the last axis varies fastest
    std::vector<Message> reasons;    ///< [0] is empty
    std::uint64_t trials = 0;        ///< number at each point; 0 = first order
    std::uint64_t seed = 0;
    double coverage_probability = 0.95;
    std::string fingerprint;  ///< hash of everything that influences these numbers

    /// Indices of a point on the axes.
    std::vector<std::size_t> indices_of(std::size_t point) const;
    std::size_t failed() const;  ///< number of points without values
};

/// Quantity that can be shown of a study as one number at each point: the expanded uncertainty of an output,
/// or u_3D of a point's position.
struct StudyQuantity {
    std::string id;  ///< plain, for names of files: "U(theta_1), B"
    Text title;      ///< title for people: "U(θ₁), B", "u(3D), B"
    Text symbol;     ///< symbol for people: "U(θ₁)"
    Unit unit = {};
    bool position = false;  ///< u_3D of a triple
    std::size_t index = 0;  ///< index of the output or triple
};
std::vector<StudyQuantity> study_quantities(const StudyResult& study, const DocumentLanguage& in = {});
/// NaN where the point has no values.
double value_at(const StudyResult& study, const StudyQuantity& quantity, std::size_t point);
/// Points with the smallest and the greatest value; nothing when no point has values.
struct StudyExtremes {
    std::size_t best = 0, worst = 0;
    bool known = false;
};
StudyExtremes extremes_of(const StudyResult& study, const StudyQuantity& quantity);

}  // namespace covaria
