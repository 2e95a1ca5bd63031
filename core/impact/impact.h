// The impact of a certificate whose figures change: every report and project that used it, evaluated with the
// old figures and with the new ones.
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

/// A result line of a measurand before and after.
struct ImpactLine {
    double estimate = 0.0, standard_uncertainty = 0.0, expanded_uncertainty = 0.0;
    std::string stated;            ///< as a report states it: "(50.000 78 ± 0.000 41) mm"
    std::optional<bool> met = {};  ///< whether its requirements are met; nothing where there are none
};

/// A measurand of an analysis that the certificate reaches.
struct ImpactRow {
    /// `project` and `number`: title and number of the project, or number of its certificate.
    std::string file, project, number;
    std::string analysis, analysis_name;  ///< id and name
    OutputQuantity quantity;
    ImpactLine before, after;

    double change() const { return after.estimate - before.estimate; }
    /// The change in units of u and of U before; infinite where those are 0 and there is a change.
    double change_in_u() const;
    double change_in_U() const;
    /// The change of U, as a part of U before.
    double change_of_U() const;
    bool verdict_changes() const { return before.met != after.met; }
    /// Whether the result would now be stated otherwise than it was, or its verdict is another.
    bool is_to_amend() const { return before.stated != after.stated || verdict_changes(); }
};

/// A file that cannot be evaluated, or that has an analysis which cannot be.
struct ImpactFailure {
    std::string file;
    Message cause;
};

/// A file that has figures of a document whose results change, which somebody has to amend first: its own
/// change is known when the new figures of that document are there.
struct ImpactFollower {
    std::string file;
    std::string number;  ///< the certificate that it has figures of
    std::string of;      ///< file of that document
};

struct Impact {
    std::vector<ImpactRow> rows;          ///< rows by falling change, those with another verdict first
    std::vector<ImpactFailure> failures;  ///< failures in the order of files
    std::vector<std::string> using_it;    ///< files that have figures of the certificate
    /// Those that have figures of a document to amend, or of such a one themselves; without new figures, of a
    /// document that uses the certificate. In the order in which they follow.
    std::vector<ImpactFollower> followers;
    std::size_t looked_at = 0;  ///< number of projects, and of reports that carry one
    /// Files with a row to amend, each once.
    std::vector<std::string> to_amend() const;
};

/// Projects and PDF files below the folders, and those of the arguments that are files themselves; sorted,
/// each once. Error: one of them does not exist.
Result<std::vector<std::filesystem::path>> files_below(const std::vector<std::string>& folders);

struct ImpactQuestion {
    std::string old_figures;  ///< number, digest or asset, as `holders_of` takes it
    /// Without them the files that used the certificate are found, and nothing is evaluated.
    std::optional<NewFigures> figures = {};
    std::vector<std::filesystem::path> files = {};
    /// Makes of a project the one that is evaluated (one of fewer trials); where it is empty, the project's
    /// own options hold.
    std::function<MadeProject::Pointer(const MadeProject::Pointer&)> asked = {};
};
/// A question as people ask it.
struct ImpactWords {
    std::string old_figures;           ///< number, digest, file of the certificate, or asset
    std::string new_figures;           ///< as `new_figures` takes it; empty: only who used the old ones
    std::vector<std::string> folders;  ///< folders and files that are searched
    bool is_first_order = false;       ///< evaluated by the law of propagation, whatever projects ask for
};
/// The question that the words ask; a file stands for its digest, so that a certificate is found by itself.
/// Reads the new figures and the folders. Errors: as `new_figures` and `files_below`.
Result<ImpactQuestion> question_of(const ImpactWords& words);

/// The impact on files, several at a time on `control.threads` threads; the answer is the same for any
/// number. PDF files that carry no project are passed over. Error: cancelled.
Result<Impact> impact_of(const ImpactQuestion& question, const RunControl& control = {});

}  // namespace covaria
