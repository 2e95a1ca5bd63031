// The examples that are shipped with the program: projects with a picture beside them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace covaria {

/// Title and summary are English, as they stand in the file; the window translates them.
struct Example {
    std::filesystem::path file;
    std::string title;
    std::string summary;            ///< first sentence of its notes
    std::filesystem::path picture;  ///< may be missing
};

/// Examples by their files' names: in the folder of examples, or in one in it ("gum"). Those that cannot be
/// read are left out.
std::vector<Example> shipped_examples(const std::string& subfolder = {});

}  // namespace covaria
