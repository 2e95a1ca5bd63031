// The likely meaning of a command line that cannot be understood.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace covaria {

/// A sentence about the first option or command that does not exist, with the one that was probably meant;
/// empty where all of them exist.
std::string what_does_not_exist(const CLI::App& app, int argc, char** argv);

}  // namespace covaria
