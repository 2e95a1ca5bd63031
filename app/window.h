// The program as a window.
#pragma once

#include <string>

namespace covaria {

/// Opens the window with a project (or, with an empty name, the start page) and runs it until it is closed.
/// `language`: code of the one to speak this time; empty: as preferred.
int run_window(const std::string& file, const std::string& language);

/// Codes of the languages that the window speaks: "en, de".
std::string languages_of_window();
/// Why the window does not speak the language of that code; empty where it does.
std::string complaint_about_language(const std::string& code);

}  // namespace covaria
