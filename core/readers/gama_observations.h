// Observations of GNU Gama networks: clusters with their standard deviations or a band of their covariance.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/readers/reader.h"
#include "core/readers/stated_quantities.h"
#include "core/readers/xml_text.h"

namespace covaria {

/// The matrix of an element <cov-mat>, which has the rows of a band above the diagonal of a symmetric n x n
/// matrix. Error with its place: dim is not n, an element is no number.
Result<Eigen::MatrixXd> gama_band(const XmlText& xml, const pugi::xml_node& matrix, std::size_t n,
                                  const std::string& what);

/// One observation for the network: lengths in m, angles in gon.
struct GamaObserved {
    std::string kind;  ///< kind of a reading of the network: "slope-distance", "x"
    std::string from = {}, to = {}, second = {}, round = {};
    int line = 0;
    bool is_angle = false;
    bool face_two = false;  ///< of a direction
    double value = 0.0, height_from = 0.0, height_to = 0.0;
    std::optional<double> u = {};
};

class GamaObservations {
public:
    /// `defaults` is <points-observations>, whose attributes hold for observations without their own.
    /// `of_one_km` is the standard deviation, in mm, of a height difference that states its length alone.
    GamaObservations(const XmlText& xml, const pugi::xml_node& defaults, double of_one_km,
                     Proposals& proposals)
        : xml_(xml), defaults_(defaults), of_one_km_(of_one_km), proposals_(proposals) {}

    static bool is_cluster(std::string_view name) {
        return name == "obs" || name == "height-differences" || name == "vectors";
    }
    /// Reads a cluster: lengths in metres with standard deviations in mm, angles in gon with 0.1 mgon or in
    /// degrees ("12-34-56.7") with seconds.
    Result<void> read(const pugi::xml_node& cluster);
    /// Proposes all observations as one analysis, each its own result; nothing where there is none.
    void propose(const std::string& title, const std::string& source);
    /// All observations; correlations refer to them by their numbers.
    const std::vector<GamaObserved>& observed() const { return observed_; }
    const std::vector<StatedCorrelation>& observed_correlations() const { return observed_correlations_; }

private:
    Result<void> read_observation(const pugi::xml_node& node, const std::string& station);
    Result<void> read_vector(const pugi::xml_node& node);
    Result<void> add(const pugi::xml_node& node, const std::string& name, const char* value,
                     const char* kind);
    /// Takes the same observation for the network; its u is in the unit of the file.
    Result<void> observe(const pugi::xml_node& node, const char* value, const char* kind, double number,
                         bool degrees, const std::optional<double>& u);
    Result<void> take_matrix(const pugi::xml_node& matrix, std::size_t first);
    Result<void> take_observed_matrix(const pugi::xml_node& matrix, std::size_t first);
    Result<std::optional<double>> deviation(const pugi::xml_node& node, const char* kind, double value) const;

    const XmlText& xml_;
    pugi::xml_node defaults_;
    double of_one_km_;
    Proposals& proposals_;
    std::vector<StatedQuantity> quantities_;
    std::vector<double> per_unit_;  ///< units of each standard deviation in the file per own unit
    std::vector<StatedCorrelation> correlations_;
    std::vector<GamaObserved> observed_;
    std::vector<StatedCorrelation> observed_correlations_;
    pugi::xml_node cluster_ = {};  ///< cluster that is being read
    std::size_t clusters_ = 0, beyond_ = 0;
};

}  // namespace covaria
