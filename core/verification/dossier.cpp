#include "core/verification/dossier.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"

namespace covaria {
namespace {

std::filesystem::path dossier_folder() {
    return data_directory() / "resources" / "dossier";
}

/// The items of the part of this Markdown below a heading; lines that are no item continue the one before.
std::vector<std::string> part_of(const std::string& text, const std::string& heading) {
    std::vector<std::string> items;
    std::istringstream lines(text);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) {
            inside = line == "## " + heading;
        } else if (inside && !line.empty()) {
            if (items.empty() || line.starts_with("- "))
                items.push_back(line.starts_with("- ") ? line.substr(2) : line);
            else
                items.back() += " " + line.substr(line.find_first_not_of(' '));
        }
    }
    return items;
}

bool is_about(const CheckedCase& checked, const CheckedFigure& figure, const std::string& clause) {
    const auto in = [&](const std::vector<std::string>& clauses) {
        return std::find(clauses.begin(), clauses.end(), clause) != clauses.end();
    };
    return in(checked.of.clauses) || in(figure.check.clauses) || checked.of.source == clause;
}

}  // namespace

Result<ModelScope> model_scope(const std::string& model) {
    const auto text = read_file(dossier_folder() / (model + ".md"));
    if (!text) return fail(text.error());
    ModelScope scope;
    for (const std::string& line : part_of(*text, "Task")) scope.task += line;
    scope.covered = part_of(*text, "Covered");
    scope.not_covered = part_of(*text, "Not covered");
    if (scope.task.empty() || scope.covered.empty() || scope.not_covered.empty())
        return fail(ErrorCode::bad_input, "the scope of model \"" + model + "\" lacks a part");
    return scope;
}

Result<std::vector<EvaluationClause>> evaluation_clauses() try {
    const auto text = read_file(dossier_folder() / "clauses.json");
    if (!text) return fail(text.error());
    std::vector<EvaluationClause> all;
    for (const auto& one : nlohmann::json::parse(*text)) all.push_back({one.at("clause"), one.at("asks")});
    return all;
} catch (const std::exception& e) {
    return fail(ErrorCode::bad_input, std::string("the list of clauses cannot be read: ") + e.what());
}

std::vector<ClauseEvidence> evidence_of(const std::vector<EvaluationClause>& clauses,
                                        const std::vector<CheckedCase>& cases) {
    std::vector<ClauseEvidence> all;
    for (const EvaluationClause& clause : clauses) {
        ClauseEvidence evidence{clause, {}};
        for (const CheckedCase& one : cases) {
            const std::size_t before = evidence.figures;
            for (const CheckedFigure& figure : one.figures) {
                if (!is_about(one, figure, clause.clause)) continue;
                ++evidence.figures;
                evidence.passed += figure.passed() ? 1 : 0;
                evidence.negative += figure.check.naive ? 1 : 0;
            }
            if (evidence.figures > before) evidence.cases.push_back(one.of.title);
        }
        all.push_back(std::move(evidence));
    }
    return all;
}

ModelEvidence evidence_of(const std::string& model, const std::vector<CheckedCase>& cases) {
    ModelEvidence evidence;
    for (const CheckedCase& one : cases) {
        const std::size_t before = evidence.figures;
        for (const CheckedFigure& figure : one.figures) {
            if (figure.model != model) continue;
            ++evidence.figures;
            evidence.passed += figure.passed() ? 1 : 0;
            const VerificationCheck& check = figure.check;
            if (!check.reference || !std::isfinite(*check.reference) || figure.tolerance <= 0.0 ||
                check.scatter > 0.0)
                continue;
            const double part = std::abs(figure.value - *check.reference) / figure.tolerance;
            if (part > evidence.largest) {
                evidence.largest = part;
                evidence.largest_of = check.what + " (" + one.of.title + ")";
            }
        }
        evidence.cases += evidence.figures > before ? 1 : 0;
    }
    return evidence;
}

}  // namespace covaria
