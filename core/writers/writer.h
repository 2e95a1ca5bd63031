// A writer: the file for others that is made of results, and the results that it is made of.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/made/evaluated_analysis.h"

namespace covaria {

/// Evaluated analyses, and the project that they are of.
struct WriterSource {
    const MadeProject& made;
    const std::vector<EvaluatedAnalysis>& analyses;
};

struct WrittenFile {
    std::string bytes;
    /// Lines about the file: what was written, how others understand it, and what is not in it.
    std::vector<std::string> said = {};
};

struct Writer {
    std::string name;    ///< name as typed: "dcc"
    std::string title;   ///< title for people: "Digital Calibration Certificate"
    std::string ending;  ///< ending of file names: ".xml"
    std::string writes;  ///< sentence on what is made of which results
    /// Writes a file; equal sources give equal bytes. Error: the source has nothing for it, or the format has
    /// no place for what is there; the message says what.
    Result<WrittenFile> (*write)(const WriterSource& source);
    /// The gaps of the project that hinder the writer, whatever the results are; null where there can be
    /// none.
    Problems (*missing)(const Project& project) = nullptr;
};

}  // namespace covaria
