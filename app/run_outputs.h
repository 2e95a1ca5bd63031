// Output of `covaria run` and `covaria merge`: result files, and on request report, certificate, pictures.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/evaluation.h"

namespace CLI {
class App;
}

namespace covaria {

struct RunOutputs {
    std::string folder = "out";
    bool report = false;
    bool certificate = false;
    bool pictures = false;
    std::vector<std::string> formats = {};  ///< formats of report and certificate: "pdf"; empty = all
};

/// Adds --out, --report, --certificate, --pictures. `outputs` must outlive the parser.
void add_output_options(CLI::App& command, RunOutputs& outputs);

/// Writes into the folder, which exists. `chosen`: only some analyses were asked for.
Result<void> write_run_outputs(const RunOutputs& outputs, const MadeProject& opened,
                               const Evaluation& evaluation, bool chosen, const std::stop_token& stop);

}  // namespace covaria
