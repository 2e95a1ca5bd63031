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

namespace covaria {

/// A cell of a table of the model's evaluation, by what people read there.
struct VerificationCell {
    std::string table;  ///< id
    std::string row;    ///< text of the first cell
    std::string column = "value";
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
};

struct VerificationCase {
    std::string project;  ///< file in the folder of the program's data: "projects/gum/...", "resources/..."
    std::string title;
    std::string source;  ///< "JCGM 101:2008, 9.3"
    std::vector<VerificationCheck> checks;
};

/// The figures of a result line that a check may name: by the law of propagation, and what Monte Carlo adds.
const std::vector<std::string>& first_order_line();
const std::vector<std::string>& monte_carlo_line();

/// Reads resources/verification.json. Errors: io, bad_input with the path.
Result<std::vector<VerificationCase>> read_verification(const std::string& text);

struct CheckedFigure {
    VerificationCheck check;
    double value = 0.0;      ///< value in the check's unit
    double tolerance = 0.0;  ///< about the reference: 4 combined standard errors, or the stated one
    bool agrees_with_reference = true;
    bool reproduces_published = true;
    /// Agrees with the reference; and reproduces the published value or says why not.
    bool passed() const { return agrees_with_reference && (reproduces_published || !check.because.empty()); }
};
struct CheckedCase {
    VerificationCase of;
    std::vector<CheckedFigure> figures;
    bool passed() const;
};

/// `results`: those of the case's project. Error: an analysis, output or figure does not exist.
Result<CheckedCase> check_case(const VerificationCase& verification,
                               const std::vector<EvaluatedAnalysis>& results);

/// The table to be attached to a quality manual.
ReportDocument verification_report(const std::vector<CheckedCase>& cases);
/// The same for a terminal: one line a figure.
std::string verification_text(const std::vector<CheckedCase>& cases);
/// The same for programs.
std::string verification_json(const std::vector<CheckedCase>& cases);

}  // namespace covaria
