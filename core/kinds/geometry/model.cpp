// Measurement model "geometry from points": the model class and its descriptor.
#include "core/kinds/geometry/model.h"

#include "core/kinds/geometry/feature_source.h"
#include "core/kinds/geometry/results.h"
#include "core/kinds/geometry/tables.h"
#include "core/model/dense_jacobian.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using geometry::Feature;
using geometry::GeometrySetup;

class GeometryFromPoints : public MeasurementModel {
public:
    GeometryFromPoints(GeometrySetup setup, InputSet inputs)
        : setup_(std::move(setup)), inputs_(std::move(inputs)) {
        for (const Feature& feature : setup_.features) {
            first_outputs_.push_back(outputs_.size());
            for (OutputQuantity& output : geometry::outputs_of(feature))
                outputs_.push_back(std::move(output));
        }
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }

    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        Outputs<double> out(y.data());
        const bool valid = all_features<double>(Inputs<double>(x.data()), out);
        return valid && out.finite();
    }

    void evaluate_block(const TrialBlock& block) const override {
        for (std::size_t t = 0; t < block.trials; t += Batch::size) {
            Outputs<Batch> out(block, t);
            const mask_of<Batch> has_value = all_features<Batch>(Inputs<Batch>(block, t), out);
            bool valid[Batch::size];
            (has_value && out.finite()).store_unaligned(valid);
            for (std::size_t lane = 0; lane < Batch::size && t + lane < block.trials; ++lane)
                block.valid[t + lane] = valid[lane] ? 1 : 0;
        }
    }

    bool sensitivities(std::span<const double> x, SensitivityRows& rows) const override {
        rows.assign(outputs_.size(), {});
        for (std::size_t k = 0; k < setup_.features.size(); ++k) {
            const Feature& feature = setup_.features[k];
            const Eigen::MatrixXd D = geometry::derivatives_of(feature, x);
            if (D.size() == 0) return false;
            const std::size_t first = feature.points.front().first_input;  // the points follow each other
            for (Eigen::Index j = 0; j < D.rows(); ++j)
                for (Eigen::Index i = 0; i < D.cols(); ++i)
                    if (D(j, i) != 0.0)
                        rows[first_outputs_[k] + std::size_t(j)].push_back({first + std::size_t(i), D(j, i)});
        }
        return true;
    }

    bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const override {
        SensitivityRows rows;
        if (!sensitivities(x, rows)) return false;
        set_dense(rows, x.size(), jacobian);
        return true;
    }

    Layout layout(std::span<const double> x) const override {
        std::vector<double> y(outputs_.size());
        if (!evaluate(x, y)) return {};
        return geometry::geometry_layout(setup_, first_outputs_, x, y);
    }
    std::vector<Table> evaluation() const override { return geometry::geometry_tables(setup_); }

    std::shared_ptr<const Asset> as_asset(const std::string& id) const override {
        return std::make_shared<OutputFeatures>(id, *this);
    }

private:
    template <class Real>
    mask_of<Real> all_features(const Inputs<Real>& x, Outputs<Real>& y) const {
        mask_of<Real> valid = Real(0.0) == Real(0.0);
        for (std::size_t k = 0; k < setup_.features.size(); ++k)
            valid = geometry::evaluate_feature<Real>(setup_.features[k], x, first_outputs_[k], y) && valid;
        return valid;
    }

    GeometrySetup setup_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    std::vector<std::size_t> first_outputs_;  ///< first output of each feature
};

std::unique_ptr<MeasurementModel> create_geometry(const SetupReader& reader, const AssetLibrary& assets,
                                                  Problems& problems) {
    std::optional<GeometrySetup> setup = geometry::read_geometry_setup(reader, assets, problems);
    if (!setup) return nullptr;
    InputSet inputs = geometry::geometry_inputs(*setup, problems);
    if (problems.has_errors()) return nullptr;
    geometry::warn_of_condition(*setup, problems);
    return std::make_unique<GeometryFromPoints>(std::move(*setup), std::move(inputs));
}

std::vector<ModelEquation> geometry_equations() {
    return {{"min Σ d_i²", tell<"orthogonal distances of the points from the feature">()},
            {"d = nᵀ(p − p₀)", tell<"plane">()},
            {"d = |w|, w = (p − p₀) − n nᵀ(p − p₀)", tell<"line">()},
            {"d = |w| − r", tell<"circle in its plane, cylinder">()},
            {"d = |p − p₀| − r", tell<"sphere">()},
            {"d = (|w| − r) cos φ − nᵀ(p − p₀) sin φ", tell<"cone, half angle φ">()},
            {"f_t = max d − min d,  f_q = √(Σ d²/m)", tell<"form deviations of m points">()}};
}

}  // namespace

ModelDescriptor geometry_from_points_model() {
    ModelDescriptor d;
    d.id = "geometry-from-points";
    d.title = "Geometry from points";
    d.summary =
        "Lines, planes, circles, spheres, cylinders and cones through measured points by orthogonal least "
        "squares: place, direction, diameter and form deviation with the full covariance of the points.";
    d.references = {
        {"C. M. Shakarji: Least-squares fitting algorithms of the NIST algorithm testing system, J. Res. "
         "Natl. Inst. Stand. Technol. 103 (1998) 633"},
        {"ISO 10360-6:2001"},
        {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = geometry_equations();
    d.notes = {
        "Points weigh alike, whatever their uncertainty, as in least-squares features of coordinate "
        "measurement; their covariance goes into the uncertainty of the results.",
        "A circle in space is fitted in two steps, as NIST's: the plane by all points, then the circle by "
        "the "
        "points projected onto it.",
        "The direction has its largest component positive; that of a cone leads from the apex into it. "
        "\"Reversed\" turns it. Trials keep the sign of the estimates.",
        "The place of a plane or line is the mean of the points; of a cylinder or cone it is the point of "
        "the axis next to that mean, so the uncertainty along the axis is that of the mean.",
        "Every trial of a Monte Carlo run fits its points anew. Form deviations of trials are larger than "
        "that of the points as measured, for uncertainty adds to what is form."};
    d.help_page = "geometry-from-points.md";
    d.example = "robot-flange.covaria";
    d.capabilities = {PointUncertaintySource::capability, FeatureSource::capability};
    d.schema = geometry::geometry_fields().schema();
    d.create = create_geometry;
    return d;
}

}  // namespace covaria
