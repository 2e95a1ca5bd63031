// Small kinds of assets and a model of the tests' own, in place of the registries of the program: this
// executable defines the registry functions itself, so that every kind of field is there whatever models
// exist.
#pragma once

#include <string>

#include "core/made/load_project.h"
#include "tests/fresh_folder.h"

namespace covaria::test {

/// A canonical project with every kind of field, edits, correlations, options and requirements.
extern const char* const whole_project;

/// Parses text as "test.covaria" in the folder of the test data.
LoadedProject parse(const std::string& text);
/// `whole_project` with the first occurrence of `from` (which must be there) replaced.
std::string changed(const std::string& from, const std::string& to);

/// The first problem whose message has `words`, or one that says so and lists all.
Problem problem_with(const Problems& problems, const std::string& words);

std::string bytes_of(const std::filesystem::path& file);
void put_bytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace covaria::test
