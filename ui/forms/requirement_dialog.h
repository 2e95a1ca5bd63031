// Requires the same of several results: a target uncertainty, the limits of a tolerance.
#pragma once

#include <QDialog>
#include <string_view>
#include <vector>

#include "core/project/requirement_fields.h"
#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "ui/document/document.h"

namespace covaria::ui {

class QuantityEdit;

/// The results are of one dimension. A field that is left as it is changes no requirement.
class RequirementDialog : public QDialog {
    Q_OBJECT
public:
    /// `now`: what is required of the first result; null: nothing. `left_out`: results that were selected
    /// too.
    RequirementDialog(const std::vector<OutputQuantity>& outputs, const Requirement* now,
                      const DisplayUnits& units, std::size_t left_out, QWidget* parent = nullptr);

    /// Gives a requirement the figures that were typed.
    void apply_to(Requirement& requirement) const;

private:
    struct Row {
        const RequirementField& field;
        QuantityEdit* edit;
        bool is_typed = false;
    };
    QuantityEdit& edit_of(std::string_view key);
    /// Marks the target uncertainty where it is not above zero.
    bool is_target_positive();
    /// Marks the upper limit where it is not above the lower one.
    bool are_limits_in_order();

    std::vector<Row> rows_;
};

/// Asks what is required of these results, and writes it into the analysis as one step. Outputs of another
/// dimension than the first have another unit: they are left out.
void ask_what_is_required(Document& document, const std::string& analysis,
                          std::vector<OutputQuantity> outputs, const DisplayUnits& units, QWidget* parent);

}  // namespace covaria::ui
