// Files of tests/data/readers, read by name, and what becomes of a project that they are added to.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/base/file_io.h"
#include "core/made/made_project.h"
#include "core/readers/readers.h"

namespace covaria::readers_test {

inline std::string data(const std::string& name) {
    const auto text = read_file(std::string(COVARIA_SOURCE_DIR) + "/tests/data/readers/" + name);
    EXPECT_TRUE(text) << name;
    return text.value_or("");
}

inline Result<Proposals> read_with(const std::string& reader, const std::string& text,
                                   ReadChoice choice = {}) {
    const Reader* found = find_reader(reader);
    if (!found) return fail(ErrorCode::not_found, "no reader " + reader);
    if (choice.file_name.empty()) choice.file_name = "file.txt";
    return found->read(text, choice);
}

/// The errors of the project that has these proposals; empty if it may be evaluated.
inline std::string errors_of(Proposals proposals) {
    Project project;
    add_to_project(project, std::move(proposals));
    std::string errors;
    const Problems problems = MadeProject::make(project)->problems();
    for (const Problem& problem : problems.items())
        if (problem.severity == Severity::error)
            errors += problem.path + ": " + problem.message.english() + "\n";
    return errors;
}

/// The first analysis of a project with these proposals, by the law of propagation.
inline UncertaintyResult first_order(Proposals proposals) {
    Project project;
    add_to_project(project, std::move(proposals));
    project.analyses.at(0).options.method = Method::first_order;
    const auto made = MadeProject::make(std::move(project));
    const auto prepared = made->analysis(made->project().analyses[0].id);
    EXPECT_TRUE(prepared);
    if (!prepared) return {};
    auto result = run_analysis(*prepared);
    EXPECT_TRUE(result);
    return result ? std::move(*result) : UncertaintyResult();
}

inline std::string all_found(const Proposals& proposals) {
    std::string all;
    for (const Message& line : proposals.found) all += line.english() + "\n";
    for (const LeftOut& left : proposals.left_out)
        all += std::to_string(left.line) + " " + left.what.english() + "\n";
    return all;
}

/// A cell of a table of an asset's or an analysis' set-up, by the key of its column.
inline SetupCell cell(const SetupSchema& schema, const Setup& setup, const std::string& table,
                      std::size_t row, const std::string& column) {
    const auto& rows = std::get<SetupTable>(setup.values.at(table)).rows;
    return rows.at(row).at(SetupSchema::column(*schema.find(table), column));
}

}  // namespace covaria::readers_test
