// Places of the candidates of a design, read off the layouts of their models: no family is known here.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/design/candidate.h"
#include "core/result/design_places.h"

namespace covaria::detail {

class DesignSpace {
public:
    /// Throws Stopped, as everything below.
    DesignSpace(CandidateJudge& judge, const PreparedDesign& design, Candidate chosen, std::stop_token stop);

    /// Place of every row of the table: that of the first thing the model shows with it only, instruments
    /// before points before frames.
    std::vector<std::optional<Eigen::Vector3d>> places_of_rows();
    DesignPlaces places(const std::vector<DesignStep>& steps);

private:
    /// Something that stands somewhere; lower ranks come first.
    struct Stand {
        int rank = 0;
        std::string name;
        Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
    };
    /// Empty: such a candidate has no model.
    std::vector<Stand> stands_of(const Candidate& candidate);
    std::optional<Layout> layout_of(const Candidate& candidate);
    Candidate chosen_with(std::size_t variable, double value) const;
    std::optional<Eigen::Vector3d> place_of_kept(std::size_t row);
    std::vector<std::size_t> moving(std::size_t stand) const;
    std::vector<Eigen::Vector3d> region_of(std::size_t stand);
    void find_moves();
    void follow(const std::vector<DesignStep>& steps, std::vector<DesignTrack>& tracks,
                const std::vector<std::size_t>& stands);

    CandidateJudge& judge_;
    const PreparedDesign& design_;
    const Candidate chosen_;
    std::stop_token stop_;
    std::vector<Stand> stands_;             ///< things of the chosen design
    std::vector<std::vector<bool>> moves_;  ///< variable, stand: it is moved
};

}  // namespace covaria::detail
