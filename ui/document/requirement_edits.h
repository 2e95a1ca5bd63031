// Edits of the requirements of an analysis, each as one step of undo.
#pragma once

#include <functional>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "ui/document/document.h"

namespace covaria::ui {

/// Whether the requirement is about this output.
bool is_about(const Requirement& requirement, const OutputQuantity& output);
/// Null: nothing is required of the output.
const Requirement* find_requirement(const AnalysisEntry& analysis, const OutputQuantity& output);

/// A complaint about a target uncertainty that is not above zero; else empty.
QString complaint_of_target(const std::optional<Quantity>& target);
/// A complaint where the limits of a tolerance are in the wrong order; else empty.
QString complaint_of_limits(const std::optional<Quantity>& lower, const std::optional<Quantity>& upper);

/// Changes the requirement on each of the outputs, which is made where there is none; one that asks for
/// nothing any more goes. `key`: edits of one key that follow each other are one step.
void change_requirements(Document& document, const std::string& analysis,
                         const std::vector<OutputQuantity>& outputs,
                         const std::function<void(Requirement&)>& edit, const QString& key = {});

}  // namespace covaria::ui
