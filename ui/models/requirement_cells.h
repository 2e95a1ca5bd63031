// The cells of a table of results in which requirements are typed: target uncertainty and limits.
#pragma once

#include <QString>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/project/requirement_fields.h"
#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "ui/document/document.h"

namespace covaria::ui {

class RequirementCells {
public:
    /// A text that was typed and not taken.
    struct Refused {
        QString text, complaint;
    };

    /// Keys of the columns, in their order.
    static std::vector<std::string> columns();

    /// What is typed is required of results of this analysis. Without a document nothing can be typed.
    void follow(Document& document, std::string analysis);
    /// Outputs whose requirement is typed together with that of any one of them.
    void set_typed_together(std::vector<std::size_t> outputs) { together_ = std::move(outputs); }

    /// Field of a requirement that a column is of; null: nothing is typed there.
    const RequirementField* field_of(const std::string& column) const;
    /// Null: what stands in the cell was taken.
    const Refused* refused(std::size_t output, const std::string& column) const;
    /// The text that would be typed for what is required of an output.
    QString text_of(const OutputQuantity& output, const RequirementField& field,
                    const DisplayUnits& units) const;
    /// Requires a quantity as it is typed, of all outputs typed together that have its dimension. A text that
    /// is none is kept, and false returned.
    bool type(const UncertaintyResult& result, std::size_t output, const std::string& column,
              const QString& text, const DisplayUnits& units);

private:
    /// A complaint, or empty: the quantity is required now.
    QString require(const UncertaintyResult& result, std::size_t output, const RequirementField& field,
                    const QString& text, const DisplayUnits& units);

    Document* document_ = nullptr;
    std::string analysis_;
    std::vector<std::size_t> together_;
    std::map<std::pair<std::size_t, std::string>, Refused> refused_;
};

}  // namespace covaria::ui
