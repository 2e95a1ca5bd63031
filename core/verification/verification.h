// Shipped examples held against published and reference values: `covaria verify`.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"
#include "core/document/report_document.h"
#include "core/made/evaluated_analysis.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// A cell of a table of the model's evaluation, by what people read there.
struct VerificationCell {
    std::string table;  ///< id
    std::string row;    ///< text of the first cell
    std::string column = "value";
};

/// A figure by an evaluation that overlooks a clause, and what that does.
struct NaiveFigure {
    double value = 0.0;
    std::string how;  ///< "adds variances of correlated quantities"
};

/// A figure of a result with what it should be; numbers in `unit`.
struct VerificationCheck {
    std::string what;         ///< name for people: "u(l), law of propagation"
    std::string analysis;     ///< id
    std::string output = {};  ///< symbol
    std::string group = {};
    std::string figure = {};                    ///< key of `verification_figures()`; empty: `cell`
    std::string with = {};                      ///< the other output of a correlation
    std::optional<VerificationCell> cell = {};  ///< cell of a table, in the unit of that
    Unit unit = {};
    std::string entry = {};  ///< place of the reference value in the project's tests
    std::optional<double> published = {};
    double half_digit = 0.0;  ///< half of the last printed digit
    std::optional<double> reference = {};
    double relative = 0.0;        ///< tolerance of a deterministic figure, relative to the reference
    double absolute = 0.0;        ///< its tolerance in `unit`
    double standard_error = 0.0;  ///< standard error of a reference value by Monte Carlo
    double scatter = 0.0;         ///< standard deviation of the figure in runs of 10^6 trials
    std::string because = {};     ///< why the published value differs
    /// Condition number of the figure with respect to what is rounded on its way, relative to `scale`: where
    /// it is stated, the tolerance is 10 condition epsilon scale.
    double condition = 0.0;
    double scale = 0.0;  ///< magnitude in `unit`; 0: that of the reference
    std::optional<NaiveFigure> naive = {};
    /// Clauses that it is evidence for, beside those of its case: "JCGM 100:2008, F.2.2.1".
    std::vector<std::string> clauses = {};
    std::optional<OutputRequirement> requirement = {};  ///< what a verdict is about; limits in `unit`
};

struct VerificationCase {
    std::string project;  ///< file in the folder of the program's data: "projects/gum/...", "resources/..."
    std::string title;
    std::string source;  ///< "JCGM 101:2008, 9.3"
    std::vector<VerificationCheck> checks;
    std::vector<std::string> clauses = {};  ///< clauses that all of its figures are evidence for
};

/// The figures of a result line that a check may name: by the law of propagation, and what Monte Carlo adds.
const std::vector<std::string>& first_order_line();
const std::vector<std::string>& monte_carlo_line();

/// Reads a list of cases. Error: bad_input.
Result<std::vector<VerificationCase>> read_verification(const std::string& text);
/// The cases of resources/verification.json, then those of the lists in resources/verification by their
/// names. Errors: io, bad_input.
Result<std::vector<VerificationCase>> shipped_verification();

struct CheckedFigure {
    VerificationCheck check;
    double value = 0.0;      ///< value in the check's unit
    double tolerance = 0.0;  ///< about the reference: 4 combined standard errors, or the stated one
    bool agrees_with_reference = true;
    bool reproduces_published = true;
    bool differs_from_naive = true;  ///< by more than the tolerance
    std::string model = {};          ///< id of the model that it is a figure of
    /// Agrees with the reference; and reproduces the published value or says why not; and is not naive.
    bool passed() const {
        return agrees_with_reference && (reproduces_published || !check.because.empty()) &&
               differs_from_naive;
    }
};
struct CheckedCase {
    VerificationCase of;
    std::vector<CheckedFigure> figures;
    std::string not_evaluated = {};  ///< why it has no figures
    bool passed() const;
};

/// The rule by which a figure passes: "printed digits", "4 standard errors", "10 Îº Îµ", "digits of the
/// reference", "equal".
std::string pass_rule(const CheckedFigure& figure);

/// `results`: those of the case's project. Error: an analysis, output or figure does not exist.
Result<CheckedCase> check_case(const VerificationCase& verification,
                               const std::vector<EvaluatedAnalysis>& results);

/// Whether a figure takes trials.
bool needs_trials(const VerificationCheck& check);

/// The figures of a case: what they should be, what they are, by which rule they pass.
TableBlock verification_table(const CheckedCase& one);
/// The table to be attached to a quality manual.
ReportDocument verification_report(const std::vector<CheckedCase>& cases);
/// The same for a terminal: one line a figure.
std::string verification_text(const std::vector<CheckedCase>& cases);
/// The same for programs.
std::string verification_json(const std::vector<CheckedCase>& cases);

}  // namespace covaria
