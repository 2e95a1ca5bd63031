// Figures that take the place of those of a certificate, wherever a project has them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/made/load_project.h"
#include "core/project/project.h"

namespace covaria {

/// What has figures from the certificate in a project.
struct CertificateHolder {
    bool is_asset = true;
    std::size_t entry = 0;  ///< index among the assets, or among the analyses
    std::size_t certificate = npos;
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);  ///< an asset of that id or name
};
/// `called`: number or digest of a certificate, in any case of letters; where no certificate has it, id or
/// name of an asset.
std::vector<CertificateHolder> holders_of(const Project& project, const std::string& called);

/// Entries that bring figures.
struct NewFigures {
    std::string source = {};  ///< the file, in messages
    std::vector<AssetEntry> assets = {};
    std::vector<AnalysisEntry> analyses = {};
};
/// Of a project, a report (PDF) or a file that a reader knows (a Digital Calibration Certificate ...); with
/// "#ID" behind its name of that asset or analysis alone.
Result<NewFigures> new_figures(const std::string& file_and_id);

/// The project with the figures of the new entries in the place of those of the holders: the set-up of an
/// asset of the same kind, the stated rows of an analysis of the same model by their symbols. Of several
/// assets the one with the same id is taken. Error: none fits, or several do.
Result<Project> with_new_figures(Project project, const std::vector<CertificateHolder>& holders,
                                 const NewFigures& figures);

}  // namespace covaria
