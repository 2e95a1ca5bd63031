// Names that people type, as names of files.
#pragma once

#include <set>
#include <string>

namespace covaria {

/// "pose 7" -> "pose-7": letters and digits of any script and '_' stay, what stands between them becomes one
/// '-'. Empty if nothing is left.
std::string file_name_part(const std::string& text);

/// Gives every file of a folder a name of its own.
class FileNames {
public:
    /// `stem` + `ending`, with a number before the ending where that name is taken ("pose-1-2.png"); capital
    /// letters make no difference. Long stems are cut at a character.
    std::string unique(const std::string& stem, const std::string& ending);

private:
    std::set<std::string> taken_;  // in small letters
};

}  // namespace covaria
