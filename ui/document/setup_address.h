// The address of a set-up that a form or table edits, and its place in the file.
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/project/project.h"
#include "core/setup/setup_schema.h"

namespace covaria::ui {

/// `project`: what is said of the project itself; its id is empty and it has no set-up.
enum class SetupOwner { asset, analysis, project };

/// Names the set-up by id, so that it stays right when entries are added, removed or reordered.
struct SetupAddress {
    SetupOwner owner = SetupOwner::analysis;
    std::string id = {};
    bool operator==(const SetupAddress&) const = default;
};

/// Address of the title, notes, certificate and report of the project.
inline const SetupAddress project_address{SetupOwner::project, {}};
/// Whether the entry is there; the project always is.
bool exists(const Project& project, const SetupAddress& address);

/// Null when the entry is gone.
const Setup* find_setup(const Project& project, const SetupAddress& address);
Setup* find_setup(Project& project, const SetupAddress& address);
/// Null when the entry is gone or its kind is not registered.
const SetupSchema* find_schema(const Project& project, const SetupAddress& address);

/// The set-up with what it implies added (rows for names in equations); empty when its model adds nothing.
std::optional<Setup> completed_setup(const Project& project, const SetupAddress& address);

/// JSON pointer of the entry ("/assets/3"); empty when it is gone, and of the project.
std::string entry_path(const Project& project, const SetupAddress& address);
/// JSON pointer of the entry's set-up ("/assets/3/setup"); empty when it is gone.
std::string setup_path(const Project& project, const SetupAddress& address);
/// The entry a JSON pointer points into, or the project itself; an empty id when there is no such entry.
SetupAddress address_of_path(const Project& project, const std::string& path);

AssetEntry* find_asset_entry(Project& project, const std::string& id);
AnalysisEntry* find_analysis_entry(Project& project, const std::string& id);

/// Place of the entry, or of a field of its set-up, on the pages of help; empty when the entry is
/// gone.
QString help_anchor(const Project& project, const SetupAddress& address, const std::string& field = {},
                    const std::string& column = {});

}  // namespace covaria::ui
