// Edits to a model's input quantities, components and correlations.
#pragma once

#include <QString>
#include <functional>
#include <string>

#include "core/quantity/input_quantity.h"
#include "ui/document/document.h"

namespace covaria::ui {

/// The edit of a quantity, or one that changes nothing.
InputEdit find_input_edit(const Project& project, const std::string& analysis, const std::string& symbol);

/// Changes the edit of a quantity; an edit that says nothing any more is removed.
void change_input(Document& document, const std::string& analysis, const std::string& symbol,
                  const QString& text, const std::function<void(InputEdit&)>& change,
                  const QString& merge_key = {});

/// Notes that people wrote about a quantity.
QString quantity_notes(const Project& project, const std::string& analysis, const std::string& symbol);
/// Empty notes are removed.
void set_quantity_notes(Document& document, const std::string& analysis, const std::string& symbol,
                        const QString& notes);

/// The link that a quantity takes its value from; empty: it has its own.
std::optional<InputLink> find_link(const Project& project, const std::string& analysis,
                                   const std::string& symbol);
/// Replaces the quantity's link and its edits, which have no effect beside one.
void set_link(Document& document, const std::string& analysis, const std::string& symbol,
              const std::optional<InputLink>& link);

}  // namespace covaria::ui
