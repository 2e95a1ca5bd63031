// Models whose outputs are inputs of others: the whole chain as one measurement model.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/model/measurement_model.h"

namespace covaria {

/// An input quantity of a model whose value is an output of a model before it in the chain.
struct ModelLink {
    std::size_t input = 0;   ///< input of the part that has the link
    std::size_t part = 0;    ///< number of the part upstream
    std::size_t output = 0;  ///< output of that part
};

/// A model of a chain, with its inputs as an analysis states them.
struct ChainPart {
    std::string id, name;  ///< id and name of the analysis
    std::shared_ptr<const MeasurementModel> model;
    InputSet inputs;
    std::vector<ModelLink> links = {};
};

/// The inputs of all parts that are not linked, each component once.
struct ChainInputs {
    InputSet inputs;
    /// [part][input]: index in `inputs`, or npos for what is linked.
    std::vector<std::vector<std::size_t>> quantities;
    /// Components of one identity that two parts state differently (one holds it): they are independent here.
    std::vector<Message> kept_apart;  ///< names of components
};

/// The inputs of a chain. Those of the last part come first and keep ids and symbols; those of an upstream
/// part get its id. Components of linked quantities alone are left out; all others are tagged with their
/// analysis.
ChainInputs chain_inputs(const std::vector<ChainPart>& parts);

/// y = f(x) of the last part, where linked inputs are outputs of parts before it. In every trial each part is
/// evaluated once, upstream first; a trial without value upstream has none downstream. Outputs, layout,
/// formulas and evaluation are those of the last part. Angles from upstream lie on the branch of their
/// estimate.
class ComposedModel : public MeasurementModel {
public:
    /// A part may link to parts before it only; the last one is the model whose outputs are wanted.
    explicit ComposedModel(std::vector<ChainPart> parts);

    const InputSet& inputs() const override { return merged_.inputs; }
    const std::vector<OutputQuantity>& outputs() const override { return last().model->outputs(); }
    bool evaluate(std::span<const double> x, std::span<double> y) const override;
    void evaluate_block(const TrialBlock& block) const override;
    bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const override;
    /// The sensitivities by the chain rule, row by row.
    bool sensitivities(std::span<const double> x, SensitivityRows& rows) const override;
    Layout layout(std::span<const double> x) const override;
    std::vector<ModelEquation> formulas() const override { return last().model->formulas(); }
    /// Tables of the last part's set-up as it is stated, which the first table says.
    std::vector<Table> evaluation() const override;
    std::vector<PlotSpecification> figures() const override { return last().model->figures(); }

    const std::vector<ChainPart>& parts() const { return parts_; }
    const std::vector<Message>& kept_apart() const { return merged_.kept_apart; }

private:
    /// Place of an input of a part: a quantity of the chain, or a row of upstream outputs.
    struct Place {
        bool linked = false;
        std::size_t index = 0;
        std::size_t link = 0;  ///< its number among the links of the part
    };
    /// A row of upstream outputs that something is linked to.
    struct UsedOutput {
        std::size_t output = 0;
        bool periodic = false;
        double estimate = 0.0;
    };

    const ChainPart& last() const { return parts_.back(); }
    void place_inputs();
    void find_used_outputs();
    /// A point of the last part's layout, with its inputs as they are in the chain.
    void place_in_chain(LayoutPoint& point) const;
    /// Number of links of the last part that its set-up states with another value; `x` are its inputs.
    std::size_t count_restated_links(std::span<const double> x) const;
    void gather(std::size_t part, std::span<const double> x, std::span<const double> rows,
                std::span<double> to) const;
    void gather(std::size_t part, const TrialBlock& block, const double* rows, double* to) const;
    /// Evaluates what is upstream of the last part, and gathers the inputs of that.
    bool evaluate_upstream(std::span<const double> x, std::span<double> rows,
                           std::vector<double>& of_last) const;
    static double unwrapped(const UsedOutput& used, double y);
    /// Makes the outputs of an upstream part fit to be read by the next in all lanes.
    void settle(std::size_t part, const TrialBlock& whole, double* rows) const;

    std::vector<ChainPart> parts_;
    ChainInputs merged_;
    std::vector<std::vector<Place>> places_;     ///< [part][input]
    std::vector<std::size_t> first_row_;         ///< first row of the outputs of each part
    std::vector<std::vector<UsedOutput>> used_;  ///< [part]
    std::size_t rows_ = 0;                       ///< outputs of all parts but the last
    std::size_t most_inputs_ = 0;                ///< largest number of inputs of a part
    std::size_t restated_links_ = 0;             ///< links that the evaluation of the set-up does not show
};

/// The linked inputs of the last part as a model of their own: the same symbols as outputs.
std::unique_ptr<ComposedModel> linked_quantities(std::vector<ChainPart> parts);

}  // namespace covaria
