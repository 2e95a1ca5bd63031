// Correlation coefficients of the measurands: a matrix per group, and the largest between groups.
#include <cmath>

#include "core/base/name.h"
#include "core/report/report_parts.h"
#include "core/text/numbers.h"
#include "core/views/plots.h"
#include "core/views/result_columns.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t largest_matrix = 12;  // a larger matrix can only be read as a map

double coefficient(const Eigen::MatrixXd& matrix, std::size_t i, std::size_t j) {
    return matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
}

Message title_of(const Name& group) {
    return group.empty() ? tell<"Correlation coefficients">()
                         : tell<"Correlation coefficients, %1">(said_name(group));
}

TableBlock matrix_block(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                        const std::string& id, const DocumentLanguage& in) {
    const Name group = result.outputs[outputs.front()].quantity.group;
    const Table all = correlation_table(result, outputs);
    std::vector<std::string> keys;
    for (const Column& column : all.columns) keys.push_back(column.key);
    TableBuilder table(id, title_of(group), in);
    table.all_of(all, keys);
    return table.take();
}

void add_between_groups(Blocks& blocks, const UncertaintyResult& result, const Eigen::MatrixXd& correlation,
                        const DocumentLanguage& in) {
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
    const std::string number = grouped_digits(format_decimals(largest, 3), in.numbers());
    const Message words =
        largest == 0.0
            ? tell<"Between groups, which share input quantities, the largest coefficient is %1.">(number)
            : tell<
                  "Between groups, which share input quantities, the largest coefficient is %1, of %2 with "
                  "%3.">(number, output_label(result.outputs[first].quantity),
                         output_label(result.outputs[second].quantity));
    blocks.push_back(ParagraphBlock{in.say(words) + " " +
                                    in.say(tell<"The CSV table of correlations has all of them.">())});
}

}  // namespace

void add_correlation(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.outputs.size() < 2) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Correlation">())});
    for (const Name& group : groups_in_full(result)) {
        const std::vector<std::size_t> outputs = measurands_of(result, group);
        const std::string id = "correlation-" + evaluated.analysis->id + "-" + id_part(group);
        if (outputs.size() < 2) continue;
        if (outputs.size() <= largest_matrix) blocks.push_back(matrix_block(result, outputs, id, in));
        blocks.push_back(
            figure(correlation_plot(result, outputs, in), evaluated, in.say(title_of(group)) + "."));
    }
    if (result.covariance.is_whole())
        add_between_groups(blocks, result, correlation_of(result.covariance.whole()), in);
}

}  // namespace covaria::report_parts
