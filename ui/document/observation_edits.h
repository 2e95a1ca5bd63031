// Observations of one quantity of a set-up, as its budget states them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/document/setup_address.h"

namespace covaria::ui {

/// The table in which the set-up has them (FieldSpec::observes_quantities); null: it has none.
const FieldSpec* observing_table(const Project& project, const SetupAddress& address);

/// Observations of the series that is measured now, in the unit of the quantity.
std::vector<double> observations_of(const Project& project, const SetupAddress& address,
                                    const std::string& symbol);
/// Their weights, as many as values (a histogram: less the last); empty: they have none.
std::vector<double> weights_of(const Project& project, const SetupAddress& address,
                               const std::string& symbol);
/// Whether the statement is made by rows of that table: observations, a sample, a histogram.
bool is_listed(const std::string& statement);
/// Mean of the values with their weights, or of the cells of a histogram, without the noise of the
/// sum: 10.13, not 10.129999999999999. Empty: there are none.
std::optional<double> listed_mean(const Project& project, const SetupAddress& address,
                                  const std::string& symbol);
/// Replaces that series. Rows keep their numbers if there are as many as before, else they have none; behind
/// the last of the weights there is none.
void set_observations(Project& project, const SetupAddress& address, const std::string& symbol,
                      const std::vector<double>& values, const std::vector<double>& weights = {});
/// The file that the rows are read from, and which cannot be edited here; empty: none.
std::string file_of_observations(const Project& project, const SetupAddress& address);

}  // namespace covaria::ui
