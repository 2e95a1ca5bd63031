// The words and selections that the views of a result share.
#pragma once

#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/cell.h"
#include "core/text/document_language.h"

namespace covaria::result_words {

std::string type_text(EvaluationType type);  ///< text such as "A", "B"
std::string unit_text(const Unit& unit);     ///< text such as "mm", "1" for the unit one
/// Part of a block's id, and so of a file's name, in small letters.
std::string id_part(const std::string& text);
/// Text such as "x (pose 7)".
Text output_text(const OutputQuantity& quantity, const DocumentLanguage& in = {});
Message output_label(const OutputQuantity& quantity);  ///< the same in Unicode
Measured value_in(const Unit& unit, double si);
Measured interval_in(const Unit& unit, double si);  ///< difference or uncertainty

Message contributor_title(const ContributorResult& result);  ///< name, or "the set-up" if it has none
bool is_measurand(const OutputResult& output);
/// Groups that have measurands, in order.
std::vector<Name> measurand_groups(const UncertaintyResult& result);
std::vector<std::size_t> measurands_of(const UncertaintyResult& result, const std::string& group);
bool groups_alike(const UncertaintyResult& result, const std::vector<Name>& groups);
/// Groups whose measurands have the symbols and units of the first group's, so that they can be compared with
/// it.
std::vector<Name> groups_like_the_first(const UncertaintyResult& result);
/// Groups that are shown: all if there are at most two, else, of those like the first, the one with the
/// largest U, measured for each symbol by its mean over the groups.
std::vector<Name> groups_in_full(const UncertaintyResult& result);

}  // namespace covaria::result_words
