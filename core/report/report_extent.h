// How long a report becomes: tables and chapters that do not fit into twenty pages are shortened or left for
// the annex; internal to core/report.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_parts.h"

namespace covaria::report_parts {

/// What is shown of a chapter.
struct Extent {
    std::size_t rows = all;     ///< of a table
    std::size_t tables = all;   ///< of a chapter
    std::size_t figures = all;  ///< of a chapter
    std::size_t budget_rows = most_budget_rows;

    static constexpr std::size_t all = 1'000'000'000;
};

/// From everything to the shortest.
const std::vector<Extent>& extents();

/// Lines that blocks take on a page of print, roughly.
double lines_of(const Blocks& blocks);
inline constexpr double lines_of_page = 56.0;

/// A chapter as it stands in the body, and what it leaves for the annex.
struct ShortenedChapter {
    Blocks body, rest;
};
/// Where what is left out stands.
enum class Elsewhere {
    annex,
    files  ///< and in the annex, if it is asked for
};
/// Of long tables the rows of the group with the largest expanded uncertainties, or the first ones, are
/// shown, with a note of where all are.
ShortenedChapter shorten(const Blocks& chapter, const Extent& extent, const Name& group, Elsewhere elsewhere,
                         const DocumentLanguage& in);
/// As long as it may be to fit into `lines`, or the shortest.
Blocks shortened_to(double lines, const Blocks& blocks, Elsewhere elsewhere, const DocumentLanguage& in);

/// `room` for all that need so much: who needs less than an equal share leaves the rest to the others.
std::vector<double> shares_of(double room, const std::vector<double>& needs);

}  // namespace covaria::report_parts
