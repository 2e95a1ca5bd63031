// What changes when the figures of a certificate do: every report and project that used it, evaluated with
// the old figures and with the new ones.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/run_control.h"
#include "core/impact/replacement.h"
#include "core/made/made_project.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

enum class RequirementsVerdict { none, met, not_met };

/// A result line of a measurand before and after.
struct ImpactLine {
    double estimate = 0.0, standard_uncertainty = 0.0, expanded_uncertainty = 0.0;
    std::string stated;  ///< as a report states it: "(50.000 78 ± 0.000 41) mm"
    RequirementsVerdict verdict = RequirementsVerdict::none;
};

/// A measurand of an analysis that the certificate reaches.
struct ImpactRow {
    std::string file, project, number;    ///< title and number of the project, or number of its certificate
    std::string analysis, analysis_name;  ///< id and name
    OutputQuantity quantity;
    ImpactLine before, after;

    double change() const { return after.estimate - before.estimate; }
    /// In units of u and of U before; infinite where those are 0 and there is a change.
    double change_in_u() const;
    double change_in_U() const;
    /// Of U, as a part of U before.
    double change_of_U() const;
    bool verdict_changes() const { return before.verdict != after.verdict; }
    /// What was stated is no longer what would be stated.
    bool is_to_amend() const { return before.stated != after.stated || verdict_changes(); }
};

/// A file that cannot be evaluated, or a part of one.
struct ImpactFailure {
    std::string file;
    Message cause;
};

struct Impact {
    std::vector<ImpactRow> rows;          ///< by falling change: other verdicts first
    std::vector<ImpactFailure> failures;  ///< in the order of files
    std::vector<std::string> using_it;    ///< files that have figures of the certificate
    std::size_t looked_at = 0;            ///< projects and reports that carry one
    /// Files with a row to amend, each once.
    std::vector<std::string> to_amend() const;
};

/// Projects and PDF files below the folders, files among them themselves; sorted, each once. Error: one of
/// them does not exist.
Result<std::vector<std::filesystem::path>> files_below(const std::vector<std::string>& folders);

struct ImpactQuestion {
    std::string old_figures;                 ///< as `holders_of` takes it
    std::optional<NewFigures> figures = {};  ///< without: who used it, and nothing is evaluated
    std::vector<std::filesystem::path> files = {};
    /// The project as it is to be evaluated (fewer trials); empty: by its own options.
    std::function<MadeProject::Pointer(const MadeProject::Pointer&)> asked = {};
};
/// Several files at a time, `control.threads` of them; the same answer for any number. PDF files that carry
/// no project are passed over. Error: cancelled.
Result<Impact> impact_of(const ImpactQuestion& question, const RunControl& control = {});

}  // namespace covaria
