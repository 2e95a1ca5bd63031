// Correlation coefficients of the measurands: a matrix per group, and the largest between groups.
#include <cmath>

#include "core/report/plots.h"
#include "core/report/report_parts.h"
#include "core/report/result_columns.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t largest_matrix = 12;  // beyond it the map alone can be read

double coefficient(const Eigen::MatrixXd& matrix, std::size_t i, std::size_t j) {
    return matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
}

TableBlock matrix_block(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                        const std::string& id) {
    const std::string group = result.outputs[outputs.front()].quantity.group;
    const Table all = correlation_table(result, outputs);
    std::vector<std::string> keys;
    for (const Column& column : all.columns) keys.push_back(column.key);
    TableBuilder table(id, "Correlation coefficients" + (group.empty() ? "" : ", " + group));
    table.columns(all, keys);
    for (std::size_t row = 0; row < all.rows; ++row) table.row(print_row(all, keys, row));
    return table.take();
}

void add_between_groups(Blocks& blocks, const UncertaintyResult& result, const Eigen::MatrixXd& correlation) {
    std::size_t first = 0, second = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const OutputResult &a = result.outputs[j], &b = result.outputs[i];
            if (!is_measurand(a) || !is_measurand(b) || a.quantity.group == b.quantity.group) continue;
            if (std::abs(coefficient(correlation, i, j)) <= std::abs(largest)) continue;
            largest = coefficient(correlation, i, j);
            first = j;
            second = i;
        }
    if (measurand_groups(result).size() < 2) return;
    blocks.push_back(
        ParagraphBlock{"Between groups, which share input quantities, the largest coefficient is " +
                       format_decimals(largest, 3) +
                       (largest == 0.0 ? "."
                                       : ", of " + output_label(result.outputs[first].quantity) + " with " +
                                             output_label(result.outputs[second].quantity) + ".") +
                       " The CSV table of correlations has all of them."});
}

}  // namespace

void add_correlation(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.outputs.size() < 2) return;
    const Eigen::MatrixXd correlation = correlation_of(result.covariance);
    blocks.push_back(HeadingBlock{2, "Correlation"});
    for (const std::string& group : groups_in_full(result)) {
        const std::vector<std::size_t> outputs = measurands_of(result, group);
        const std::string id = "correlation-" + evaluated.analysis->id + "-" + id_part(group);
        if (outputs.size() < 2) continue;
        if (outputs.size() <= largest_matrix) blocks.push_back(matrix_block(result, outputs, id));
        blocks.push_back(figure(correlation_plot(result, group), evaluated,
                                "Correlation coefficients" + (group.empty() ? "." : ", " + group + ".")));
    }
    add_between_groups(blocks, result, correlation);
}

}  // namespace covaria::report_parts
