// Runs the program as a child process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/fresh_folder.h"

struct Outcome {
    int status = -1;  ///< exit status; 128 + n for signal n
    std::string out;
    std::string err;
    double after_signal_s = 0.0;  ///< from the signal, if one was sent, to the end
};

enum class Ending {
    by_itself,
    interrupted,  ///< SIGINT is sent as soon as the program is at work: it computes, or waits for something
};
/// Waits for the end.
Outcome run_program(const std::vector<std::string>& arguments, Ending ending = Ending::by_itself);
/// Runs the program with these variables ("NAME=VALUE") in its environment.
Outcome run_program_with(const std::vector<std::string>& environment,
                         const std::vector<std::string>& arguments, Ending ending = Ending::by_itself);

using covaria::test::fresh_folder;
std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);
/// projects/NAME of the source tree.
std::filesystem::path shipped_project(const std::string& name);
