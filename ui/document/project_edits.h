// Adding, duplicating, renaming and removing assets and analyses, each as one undo step.
#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "core/made/analysis_templates.h"
#include "ui/document/document.h"
#include "ui/document/setup_address.h"

namespace covaria::ui {

/// `wanted` made of letters, digits, '-' and '_', with a number appended while the project has it already.
std::string unique_id(const Project& project, const std::string& wanted);
/// `wanted`, or "wanted (2)" ..., so that no two entries have one name.
std::string unique_name(const Project& project, const std::string& wanted);

/// Ids of the new entries; empty when the kind or model is not registered.
std::string add_asset(Document& document, const std::string& kind);
/// A copy of an asset of the library.
std::string add_copy(Document& document, const AssetEntry& asset);
std::string add_analysis(Document& document, const std::string& model, const EvaluationOptions& options = {});
/// The template's analysis with what it needs (core/made/analysis_templates.h). Empty, and a message in
/// `why`, where it cannot be read.
std::string add_from_template(Document& document, const AnalysisTemplate& wanted, QString& why);
/// Id of the copy, which stands right after the original.
std::string duplicate(Document& document, const SetupAddress& entry);
/// Renames an entry, or gives the project another title.
void rename(Document& document, const SetupAddress& entry, const QString& name);
void set_notes(Document& document, const SetupAddress& entry, const QString& notes);
void remove(Document& document, const SetupAddress& entry);
/// The entry moves to another place among the assets (analyses).
void move_entry(Document& document, const SetupAddress& entry, std::size_t position);

/// Names of the assets and analyses that refer to the entry, directly or through another asset.
QStringList dependants(const Project& project, const SetupAddress& entry);

/// Assets, and analyses, that offer one of the capabilities (any asset, if none is named), by id and name;
/// not the entry itself, nor what takes from it.
std::vector<Choice> fitting_assets(const Project& project, const std::vector<std::string>& capabilities,
                                   const SetupAddress& itself);

}  // namespace covaria::ui
