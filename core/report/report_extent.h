// The length of a report: tables and chapters that do not fit into twenty pages are shortened or left for the
// annex; internal to core/report.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_parts.h"

namespace covaria::report_parts {

/// The extent to which a chapter is shown.
struct Extent {
    std::size_t rows = all;     ///< rows of a table
    std::size_t tables = all;   ///< tables of a chapter
    std::size_t figures = all;  ///< figures of a chapter
    std::size_t budget_rows = most_budget_rows;

    static constexpr std::size_t all = 1'000'000'000;
};

/// The extents from everything to the shortest.
const std::vector<Extent>& extents();

/// Lines that blocks take on a page of print, roughly.
double lines_of(const Blocks& blocks);
inline constexpr double lines_of_page = 56.0;

/// A chapter as it stands in the body, and the rest of it, which is left for the annex.
struct ShortenedChapter {
    Blocks body, rest;
};
/// The place of blocks that are left out.
enum class Elsewhere {
    annex,
    files  ///< files, and the annex if it is asked for
};
/// The chapter shortened. Of long tables the rows of the group with the largest expanded uncertainties, or
/// the first ones, are shown, with a note of where all are.
ShortenedChapter shorten(const Blocks& chapter, const Extent& extent, const Name& group, Elsewhere elsewhere,
                         const DocumentLanguage& in);
/// The blocks with the largest extent that fits into `lines`, or with the shortest.
Blocks shortened_to(double lines, const Blocks& blocks, Elsewhere elsewhere, const DocumentLanguage& in);

/// The shares of `room` of those that need so much: one that needs less than an equal share leaves the rest
/// to the others.
std::vector<double> shares_of(double room, const std::vector<double>& needs);

}  // namespace covaria::report_parts
