// The list of readers. readers.cpp is the only file that names them all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/readers/reader.h"

namespace covaria {

const std::vector<Reader>& reader_registry();
const Reader* find_reader(const std::string& name);  ///< null where there is none of that name

/// The number of bytes from the front of a file that readers are recognised by.
inline constexpr std::size_t recognised_by = 4096;

/// Readers that recognise a file: the certain ones, else the possible ones.
struct RecognisedReaders {
    std::vector<const Reader*> readers;
    std::vector<const Reader*> others;  ///< possible readers beside the certain ones
};
RecognisedReaders recognise_reader(std::string_view text, const std::string& file_name);

/// The only reader that recognises the file. Error{usage}: none, or several; the message names them.
Result<const Reader*> reader_for(std::string_view text, const std::string& file_name);

/// Adds the proposals under ids that the project does not have yet; references follow.
void add_to_project(Project& project, Proposals proposals);

}  // namespace covaria
