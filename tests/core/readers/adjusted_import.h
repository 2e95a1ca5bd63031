// A network that a reader proposes, adjusted: its coordinates, and how well its readings agree.
#pragma once

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "core/text/table.h"
#include "tests/core/readers/reading.h"

namespace covaria::readers_test {

struct AdjustedImport {
    double degrees_of_freedom = NAN, s0 = NAN, sum_of_squares = NAN;
    std::map<std::string, double> estimate, u;  ///< by "A_x"
    std::string found;
};

inline AdjustedImport adjusted(const Result<Proposals>& read) {
    AdjustedImport made;
    EXPECT_TRUE(read) << read.error().message.english();
    if (!read) return made;
    made.found = all_found(*read);
    EXPECT_EQ(errors_of(*read), "") << made.found;
    EXPECT_EQ(read->analyses.size(), 1u) << made.found;
    if (read->analyses.size() != 1) return made;
    EXPECT_EQ(read->analyses[0].model, "network-adjustment") << made.found;
    Project project;
    add_to_project(project, *read);
    project.analyses[0].options.method = Method::first_order;
    const auto project_made = MadeProject::make(std::move(project));
    const auto prepared = project_made->analysis(project_made->project().analyses[0].id);
    if (!prepared) return made;
    const auto result = run_analysis(*prepared);
    EXPECT_TRUE(result);
    if (!result) return made;
    for (const OutputResult& output : result->outputs) {
        const std::string name = output.quantity.group + "_" + output.quantity.symbol.substr(0, 1);
        made.estimate[name] = output.estimate;
        made.u[name] = output.standard_uncertainty;
    }
    for (const Table& table : prepared->model->evaluation()) {
        if (table.id != "adjustment") continue;
        for (std::size_t row = 0; row < table.rows; ++row) {
            const std::string words = english_of(table.columns[0].cell(row));
            const auto value = exact_quantity(table.columns[1].cell(row));
            if (!value) continue;
            if (words.starts_with("degrees of freedom")) made.degrees_of_freedom = value->value;
            if (words.starts_with("s₀")) made.s0 = value->value;
            if (words.starts_with("sum of squares")) made.sum_of_squares = value->value;
        }
    }
    return made;
}

inline Result<Proposals> import(const std::filesystem::path& file) {
    const auto text = read_file(file);
    EXPECT_TRUE(text) << file;
    const auto reader = reader_for(text.value_or(""), file.filename().string());
    EXPECT_TRUE(reader) << file;
    if (!reader) return fail(reader.error());
    return (*reader)->read(*text, {.file_name = file.filename().string(), .beside = neighbours_of(file)});
}

}  // namespace covaria::readers_test
