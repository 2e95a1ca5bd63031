// The library of assets: instruments, robots ... with figures from data sheets, to be copied into projects.
//
// A library file is a project without analyses; its title names the collection. Users add their own files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria {

struct LibraryItem {
    AssetEntry asset;                    ///< its notes say where the figures come from
    std::string collection;              ///< title of its file: "Laser trackers"
    bool own = false;                    ///< it is in the user's folder
    std::filesystem::path picture = {};  ///< beside its file, in pictures/ID.png; empty: there is none
};

struct Library {
    std::vector<LibraryItem> items;  ///< shipped ones first, files by name
    Problems problems;               ///< files that could not be read
};

/// $COVARIA_LIBRARY_DIR, else covaria/library in $XDG_DATA_HOME or ~/.local/share.
std::filesystem::path own_library_folder();

/// All assets shipped with the program and in the user's folder. Those that refer to other assets are left
/// out: they cannot be copied alone.
Library load_library();

/// Whether the words (parted by blanks) all occur in one of the texts, whatever the case of ASCII letters.
bool has_words(const std::vector<std::string>& texts, const std::string& words);
/// Texts of an item that a search looks at: name, collection, title of the kind, notes.
std::vector<std::string> searched_texts(const LibraryItem& item);

/// Writes the asset into the user's collection "My library", in place of one of the same kind and name.
/// Error: it refers to other assets, or the file cannot be read or written.
Result<void> add_to_own_library(const AssetEntry& asset);

}  // namespace covaria
