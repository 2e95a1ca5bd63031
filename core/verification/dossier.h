// The dossier: what each model covers and does not, the evidence for it, clause by clause, and of what
// program.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/verification/verification.h"

namespace covaria {

/// The task of a model, the inputs and sources of error that it takes account of, and others: a declaration
/// as ISO/TS 15530-4 asks for of software that evaluates uncertainty.
struct ModelScope {
    std::string task;
    std::vector<std::string> covered, not_covered;
};
/// The scope of a model, of resources/dossier. Errors: not_found; bad_input, where a part is missing.
Result<ModelScope> model_scope(const std::string& model);

/// A clause of the GUM that a program can be right or wrong about, and what it asks for in our words.
struct EvaluationClause {
    std::string clause;  ///< "JCGM 100:2008, F.2.2.1"
    std::string asks;
};
/// Those of resources/dossier/clauses.json. Errors: io, bad_input.
Result<std::vector<EvaluationClause>> evaluation_clauses();

/// The evidence for a clause.
struct ClauseEvidence {
    EvaluationClause of;
    std::vector<std::string> cases;  ///< titles
    std::size_t figures = 0, passed = 0;
    std::size_t negative = 0;  ///< figures beside which a naive one stands
};
std::vector<ClauseEvidence> evidence_of(const std::vector<EvaluationClause>& clauses,
                                        const std::vector<CheckedCase>& cases);

/// The evidence for a model.
struct ModelEvidence {
    std::size_t cases = 0, figures = 0, passed = 0;
    /// Largest difference from a reference, in parts of what is allowed, of figures by the law of
    /// propagation.
    double largest = 0.0;
    std::string largest_of = {};  ///< the figure and its case
};
ModelEvidence evidence_of(const std::string& model, const std::vector<CheckedCase>& cases);

/// Facts about the program that gave the figures: versions, digest, date.
using ProgramFacts = std::vector<std::pair<std::string, std::string>>;

/// Errors: io, bad_input of resources/dossier.
Result<ReportDocument> dossier_document(const std::vector<CheckedCase>& cases, const ProgramFacts& facts);
/// The same for programs.
Result<std::string> dossier_json(const std::vector<CheckedCase>& cases, const ProgramFacts& facts);

}  // namespace covaria
