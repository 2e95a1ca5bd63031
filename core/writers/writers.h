// The list of writers. writers.cpp is the only file that names them all.
#pragma once

#include <string>
#include <vector>

#include "core/writers/writer.h"

namespace covaria {

const std::vector<Writer>& writer_registry();
const Writer* find_writer(const std::string& name);  ///< null where there is none of that name

}  // namespace covaria
