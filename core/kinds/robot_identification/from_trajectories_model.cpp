// Measurement model "robot by joint trajectories": the model class and its descriptor.
#include "core/kinds/robot_identification/from_trajectories_model.h"

#include "core/base/name.h"
#include "core/kinds/robot_identification/from_trajectories.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

class RobotCirclePoints : public EquationModel<RobotCirclePoints> {
public:
    explicit RobotCirclePoints(circle_points::Identification id) : id_(std::move(id)) {
        for (const IdentifiedParameter& p : id_.parameters) {
            const Name joint = own_name<"joint %1">(p.joint + 1);
            outputs_.push_back(
                {.symbol = p.symbol(),
                 .name = tell<"%1 of %2">(words_of(p.parameter), tell<"joint %1">(p.joint + 1)),
                 .unit = Unit::of(is_length(p.parameter) ? "mm" : "deg"),
                 .group = joint,
                 .periodic = !is_length(p.parameter)});
        }
        for (std::size_t j = 0; j < id_.trajectories.size(); ++j)
            outputs_.push_back({.symbol = "R_" + std::to_string(j + 1),
                                .name = tell<"radius of the circle of joint %1">(j + 1),
                                .unit = Unit::of("mm"),
                                .group = own_name<"circles">(),
                                .role = OutputRole::intermediate});
    }

    const InputSet& inputs() const override { return id_.inputs; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return circle_points::tables(id_); }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return id_.evidence.readings;
    }
    Layout layout(std::span<const double>) const override { return circle_points::layout(id_); }

    std::shared_ptr<const Asset> as_asset(const std::string& id) const override {
        auto data = circle_points::identified(id_);
        return data ? robot_of_analysis(std::move(*data), id_.parameters, id) : nullptr;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        return circle_points::evaluate<Real>(id_, x,
                                             [&](std::size_t j, const Real& value) { y.set(j, value); });
    }

private:
    circle_points::Identification id_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_circle_points(const SetupReader& reader, const AssetLibrary& assets,
                                                       Problems& problems) {
    auto id = circle_points::read(reader, assets, problems);
    if (!id) return nullptr;
    if (!circle_points::estimates(*id)) {
        problems.error(circle_points::fields().place(&circle_points::Identification::points),
                       tell<"the points do not lead to parameters of the arm">());
        return nullptr;
    }
    return std::make_unique<RobotCirclePoints>(std::move(*id));
}

std::vector<ModelEquation> circle_equations() {
    const std::string paper = "Wen et al., ";
    return {{tell<"n·p = D with |n| = 1, least sum of squares">(),
             "total least squares; offered beside it: " + paper + "Eqs 1-3"},
            {tell<"min Σ (|p_j − c| − R)²  in the fitted plane">(),
             paper + "Eq 4, corrected: the bracket is squared"},
            {tell<"x_i = ± z_{i−1} × z_i/|…|,  O_i: foot of the common perpendicular on axis i + 1">(),
             paper + "2.1.3"},
            {tell<"parallel: O_i in the plane through O_{i−1} normal to z_{i−1},  y_i = z_i × h/|…|,  x_i = "
                  "y_i × z_i">(),
             paper + "2.1.3, corrected"},
            {"theta = atan2(m_21, m_11),  alpha = atan2(m_32, m_33)", "from Eq 5, axes not parallel"},
            {"theta = atan2(−m_12, m_22),  alpha = asin m_32,  beta = atan2(−m_31, m_33)",
             "from Eq 5, parallel axes"},
            {"a = m_14 cos theta + m_24 sin theta,  d = m_34", "from Eq 5"}};
}

std::vector<std::string> circle_notes() {
    return {"Eq 4 is corrected: without the square its derivative by R gives R = 0.",
            "2.1.3 is corrected: x_i = z_i × y_i is left-handed.",
            "2.1.4 is corrected: alpha_i and beta_i turn z_{i−1} into z_i.",
            "The auxiliary plane of Figure 2 is not defined in the paper; it must pass through O_{i−1} with "
            "the normal "
            "z_{i−1}, or d_i = 0 is impossible.",
            "Eq 1 has no plane through the origin and fails near it; total least squares is the default.",
            "Eq 8 is a standard deviation of the mean of repeats. The paper applies it to different ranges "
            "and numbers of "
            "points, which are no repeats: the ±10° run dominates, and the noise is counted three times. "
            "Here the "
            "covariance is that of the chosen experiment.",
            "The standard deviation falls with the square of the range (factor 30 from ±10° to ±60°) and "
            "with the root of "
            "the number of points.",
            "Parameters are strongly correlated (d_3 and alpha_3: −0.99): use their full covariance, as an "
            "identified "
            "robot does.",
            "Every joint needs a ball off its axis; at the paper's flange origin joint 6 draws no circle."};
}

}  // namespace

ModelDescriptor robot_circle_points_model() {
    ModelDescriptor d;
    d.id = "robot-circle-points";
    d.title = "Robot by joint trajectories";
    d.summary =
        "Geometric parameters of a serial robot from points measured while one joint after the other turns "
        "(circle point analysis).";
    d.references = {{"X. Wen, S. He, G. Qiao, D. Wang, A. Song, C. Kang, Z. Lv: Uncertainty estimation of "
                     "robot geometric "
                     "parameters and end-effector position based on new generation GPS"},
                    {"JCGM 100:2008 (GUM), JCGM 101:2008, JCGM 102:2011"}};
    d.equations = circle_equations();
    d.notes = circle_notes();
    d.help_page = "robot-circle-points.md";
    d.example = "er10l-c10.covaria";
    d.capabilities = {"serial-robot"};
    d.was_asset = "identified-robot";
    d.schema = circle_points::fields().schema();
    d.create = create_circle_points;
    return d;
}

}  // namespace covaria
