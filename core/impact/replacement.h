// Figures that take the place of those of a certificate, wherever a project has them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/made/load_project.h"
#include "core/project/project.h"

namespace covaria {

/// An asset or an analysis of a project that has figures from the certificate.
struct CertificateHolder {
    bool is_asset = true;
    std::size_t entry = 0;  ///< index among the assets, or among the analyses
    std::size_t certificate = npos;
    /// The certificate of an asset that was called by its id or name.
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};
/// Holders of figures of the certificate that is `called` by its number or digest, in any case of letters;
/// where no certificate has it, the asset of that id or name.
std::vector<CertificateHolder> holders_of(const Project& project, const std::string& called);

/// Entries that bring figures.
struct NewFigures {
    std::string source = {};  ///< the file as messages name it
    std::vector<AssetEntry> assets = {};
    std::vector<AnalysisEntry> analyses = {};
};
/// Figures of a project, a report (PDF) or a file that a reader knows (a Digital Calibration Certificate
/// ...); with "#ID" behind the file's name, the figures of that asset or analysis alone.
Result<NewFigures> new_figures(const std::string& file_and_id);

/// The project with the figures of the new entries in the place of those of the holders: the set-up of an
/// asset of the same kind, the stated rows of an analysis of the same model by their symbols. Of several
/// assets the one with the same id is taken. Error: none fits, or several do.
Result<Project> with_new_figures(Project project, const std::vector<CertificateHolder>& holders,
                                 const NewFigures& figures);

}  // namespace covaria
