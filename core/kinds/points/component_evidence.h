// Readings whose uncertainty is made of components, as evidence for or against what is stated of these; and
// components with the uncertainty that the evidence sees.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/evidence/as_seen.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria {

/// A figure that states the standard uncertainty of a component.
struct FigureOfComponent {
    std::string key;  ///< key of the figure: its components have the same; figures stand in their order
    Message name;
    Unit unit;
    std::string source = {};  ///< place in the set-up
};

/// The components of each figure of the evidence, by their indices in the inputs.
using ComponentsOfFigures = std::vector<std::vector<std::size_t>>;

/// Adds figures and shares to readings that have none yet. `deviations`: readings by components of the
/// inputs, each times its standard uncertainty. A component that no figure states, or that is the only one of
/// its figure, is one of the others: one deviation has no scatter.
ComponentsOfFigures add_figures(const InputSet& inputs,
                                const std::map<std::size_t, FigureOfComponent>& figure_of,
                                const Eigen::MatrixXd& deviations, evidence::RedundantReadings& readings);

struct ComponentEvidence {
    std::shared_ptr<const evidence::RedundantReadings> readings;  ///< null: nothing speaks
    ComponentsOfFigures figures;
};

/// Least-squares fits that each have unknowns of their own and share what makes their readings uncertain.
class FitsWithSharedComponents {
public:
    explicit FitsWithSharedComponents(const InputSet& inputs) : inputs_(inputs) {}

    /// Residuals are drawn over this, too; rows that are added have its value.
    void over(evidence::Abscissa abscissa) { abscissas_.push_back(std::move(abscissa)); }

    /// The part of an input quantity in a deviation of a row.
    struct Part {
        std::size_t quantity = 0;
        double factor = 1.0;
    };
    struct Row {
        Message name;
        Eigen::VectorXd design;  ///< derivatives by the unknowns of the fit
        double residual = 0.0;   ///< up to what the unknowns take up; all rows have one weight
        std::vector<Part> parts;
        std::vector<double> over = {};  ///< SI, in the order of the abscissas; empty: none
    };
    void add(const std::vector<Row>& rows);
    /// None where there are no rows, no figures, or too many rows for them.
    ComponentEvidence evidence(const std::map<std::size_t, FigureOfComponent>& figure_of) const;

private:
    struct Fit {
        Eigen::MatrixXd design, deviations;
        Eigen::VectorXd residuals;
    };
    const InputSet& inputs_;
    std::vector<Fit> fits_;
    std::vector<Message> names_;
    std::vector<double> w_;
    std::vector<evidence::Abscissa> abscissas_;
};

/// Components of figures that are seen become Type A, rest on one estimate of variance for each figure (or
/// for all, with one factor), and are normally distributed. Warns at `place` of what stays as stated.
void take_as_seen(InputSet& inputs, const ComponentEvidence& evidence, evidence::UncertaintiesFrom from,
                  const std::string& place, Problems& problems);

/// The choices of a field that takes them over; `evidence::TakeOver` of all of them.
std::vector<ChoiceOf<evidence::UncertaintiesFrom>> choices_of_uncertainties();
inline constexpr const char* uncertainties_key = "uncertainties";
evidence::TakeOver take_over_of_uncertainties();
/// The way out of uncertainties that are stated too small; `place`: of that field.
Remedy remedy_as_seen(std::string place);

}  // namespace covaria
