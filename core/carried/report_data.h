// Files that a report carries: the project that it was made of, and its results for machines.
#pragma once

#include <string>
#include <vector>

#include "core/pdf/pdf_archive.h"
#include "core/report/report.h"

namespace covaria {

namespace carried {
inline constexpr const char* project = "project.covaria";
inline constexpr const char* results = "results.json";
inline constexpr const char* certificate = "certificate.xml";
}  // namespace carried

/// The project with the CSV files that it refers to, results.json, the budget of each analysis as CSV, a
/// Digital Calibration Certificate where the project's certificate is complete. A CSV file that is no longer
/// what was read stands in the project itself. Equal contents give equal bytes.
std::vector<AttachedFile> report_data(const ReportSource& content);

}  // namespace covaria
