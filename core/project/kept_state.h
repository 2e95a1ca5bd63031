// States of a project that people kept, to compare later results with and to go back to.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace covaria {

struct Project;

/// The state of a project that the results of one analysis followed from when it was kept. They are computed
/// from it, so that both sides of a comparison are always of one version of the program.
struct KeptState {
    std::string analysis;  ///< id of the analysis
    std::string at;        ///< time when it was kept, by ISO 8601
    /// The part of the project that influences numbers, and what belongs to it: assets, analyses, how results
    /// are stated. Its tables are in it, whatever becomes of the files that they were read from. It is never
    /// null.
    std::shared_ptr<const Project> project;
    /// The analysis that stands in the place of what this one was, maybe one of another project: its id in
    /// `project`, and what people call it ("hall.covaria: Points by two trackers"). Both are empty where it
    /// is this one itself.
    std::string other = {}, other_name = {};
    /// Id of the analysis in `project` whose results are compared with.
    const std::string& compared() const { return other.empty() ? analysis : other; }
    bool operator==(const KeptState& with) const;
};

/// The state of the project that people can go back to, and that is compared with until then.
KeptState state_to_keep(const Project& project, const std::string& analysis, const std::string& at);
/// The state that results are of, which may be a moment older than `now`: its studies, designs, views, notes
/// and certificates, which no result follows from, are then those of `now`.
KeptState state_to_keep(Project of_results, const Project& now, const std::string& analysis,
                        const std::string& at);
/// A state in which `other`, an analysis of `project`, stands in the place of `analysis`; `project` may be
/// another one than that of `analysis`.
KeptState state_of_other(const Project& project, const std::string& other, const std::string& other_name,
                         const std::string& analysis, const std::string& at);
/// The state kept of the analysis, or null where none is.
const KeptState* find_kept(const std::vector<KeptState>& kept, const std::string& analysis);
/// Puts a state in place of the one that was kept of its analysis before.
void put_kept(std::vector<KeptState>& kept, KeptState state);
void discard_kept(std::vector<KeptState>& kept, const std::string& analysis);

/// Takes the project back to the state: the analysis, what it uses and the coverage factor become what they
/// were, and everything else stays. A table of a file that still has these rows is one of that file again.
void go_back(Project& project, const KeptState& state);

}  // namespace covaria
