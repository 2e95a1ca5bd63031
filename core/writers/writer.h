// A writer: which file for others is made of results, and of which.
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
    /// Lines: what was written, how others understand it, and what is not in the file.
    std::vector<std::string> said = {};
};

struct Writer {
    std::string name;    ///< as typed: "dcc"
    std::string title;   ///< "Digital Calibration Certificate"
    std::string ending;  ///< of file names: ".xml"
    std::string writes;  ///< what of which results becomes what, in a sentence
    /// Equal sources give equal bytes. Error: the source has nothing for it, or the format has no place for
    /// what is there; the message says what.
    Result<WrittenFile> (*write)(const WriterSource& source);
    /// What the project lacks for it, whatever its results are; null: nothing.
    Problems (*missing)(const Project& project) = nullptr;
};

}  // namespace covaria
