// States of a project that people kept, to compare later results with and to go back to.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace covaria {

struct Project;

/// Of one analysis: what its results then follow from. They are computed from it, so that both sides of a
/// comparison are always of one version of the program.
struct KeptState {
    std::string analysis;  ///< id
    std::string at;        ///< when it was kept: ISO 8601
    /// What influences numbers, and what belongs to it: assets, analyses, how results are stated. Its tables
    /// are in it, whatever becomes of the files that they were read from. Never null.
    std::shared_ptr<const Project> project;
    /// Where another analysis stands in the place of what this one was, maybe one of another project: its id
    /// in `project`, and what people call it ("hall.covaria: Points by two trackers"). Empty: it is this
    /// one's.
    std::string other = {}, other_name = {};
    /// Id of the analysis in `project` whose results are compared with.
    const std::string& compared() const { return other.empty() ? analysis : other; }
    bool operator==(const KeptState& with) const;
};

/// What can be gone back to, and is compared with until then.
KeptState state_to_keep(const Project& project, const std::string& analysis, const std::string& at);
/// Results may be of a state a moment older than `now`: studies, designs, views, notes and certificates,
/// which no result follows from, are then those of `now`.
KeptState state_to_keep(Project of_results, const Project& now, const std::string& analysis,
                        const std::string& at);
/// `other` is an analysis of `project`, which may be another one than that of `analysis`.
KeptState state_of_other(const Project& project, const std::string& other, const std::string& other_name,
                         const std::string& analysis, const std::string& at);
/// Null: nothing is kept of the analysis.
const KeptState* find_kept(const std::vector<KeptState>& kept, const std::string& analysis);
/// Puts a state in place of what was kept of its analysis before.
void put_kept(std::vector<KeptState>& kept, KeptState state);
void discard_kept(std::vector<KeptState>& kept, const std::string& analysis);

/// The analysis, what it uses and the coverage factor become what they were; everything else stays. A table
/// of a file that still has these rows is one of that file again.
void go_back(Project& project, const KeptState& state);

}  // namespace covaria
