// Digital Calibration Certificates (PTB's schema, versions 2.3 and later).
#include <algorithm>

#include "core/base/dates.h"
#include "core/base/in_quotes.h"
#include "core/base/sha256.h"
#include "core/math/normal_quantile.h"
#include "core/readers/dcc_quantities.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr const char* length_standard_kind_id = "length-standard";
constexpr std::size_t most_length_standards = 20;

/// The full name of a quantity: "mass: nominal value".
std::string name_in(const std::string& result, const std::string& quantity) {
    return result.empty() || result == quantity ? quantity : result + ": " + quantity;
}

class CertificateReader {
public:
    CertificateReader(const XmlText& xml, const std::string& digest, const ReadChoice& choice)
        : xml_(xml), choice_(choice) {
        certificate_.digest = digest;
        certificate_.file = choice.file_name;
    }

    Result<Proposals> read() {
        const pugi::xml_node root = xml_.root();
        if (local_name(root) != "digitalCalibrationCertificate")
            return xml_.refused(
                root, tell<"no Digital Calibration Certificate: its root is <%1>">(plain_name(root.name())));
        read_heading(root);
        const pugi::xml_node results = child_called(root, "measurementResults");
        for (const pugi::xml_node& part : results.children())
            if (local_name(part) == "measurementResult")
                if (auto done = read_part(part); !done) return fail(done.error());
        name_what_is_left(root);
        if (quantities_.empty())
            return xml_.refused(results ? results : root,
                                tell<"the certificate has no results with numbers">());
        propose();
        return std::move(proposals_);
    }

private:
    void read_heading(const pugi::xml_node& root) {
        const pugi::xml_node data = child_called(root, "administrativeData");
        const pugi::xml_node core = child_called(data, "coreData");
        id_ = plain_name(text_of_child(core, "uniqueIdentifier"));
        const std::string laboratory =
            dcc_name(child_called(child_called(data, "calibrationLaboratory"), "contact"));
        const pugi::xml_node items = child_called(data, "items");
        item_ = dcc_name(child_called(items, "item"));
        if (item_.empty()) item_ = dcc_name(items);
        const std::string version = plain_name(root.attribute("schemaVersion").value());
        certificate_.number = id_;
        certificate_.issuer = laboratory;
        certificate_.issued = date_in(core, "issueDate");
        read_period(core);
        heading_ = "certificate " + (id_.empty() ? plain_name(choice_.file_name) : id_);
        if (!laboratory.empty()) heading_ += ", " + laboratory;
        if (const std::string date = plain_name(text_of_child(core, "endPerformanceDate")); !date.empty())
            heading_ += ", " + date;
        proposals_.title = item_.empty() ? heading_ : item_;
        proposals_.found.push_back(heading_ + (item_.empty() ? "" : ": " + item_));
        proposals_.found.push_back(tell<"schema version %1">((version.empty() ? "not stated" : version)));
        if (!version.starts_with("2.") && !version.starts_with("3."))
            proposals_.leave_out(xml_.line(root),
                                 tell<"what this version of the schema has beyond version 3">());
        if (choice_.length_unit)
            proposals_.leave_out(0, tell<"the stated unit of lengths: a certificate states its units">());
    }

    /// The date in an element; empty where it is none.
    static std::string date_in(const pugi::xml_node& core, const char* name) {
        const std::string text = plain_name(text_of_child(core, name)).substr(0, 10);
        return date_of(text) ? text : std::string();
    }

    void read_period(const pugi::xml_node& core) {
        const std::string begin = date_in(core, "beginPerformanceDate"),
                          end = date_in(core, "endPerformanceDate");
        const std::string both = begin + "/" + end;
        certificate_.calibrated = begin == end || !period_of(both) ? end : both;
    }

    Result<void> read_part(const pugi::xml_node& part) {
        for (const char* name : {"usedMethods", "usedSoftware", "measuringEquipments", "influenceConditions",
                                 "measurementMetaData"})
            if (const pugi::xml_node node = child_called(part, name))
                proposals_.leave_out(xml_.line(node), std::string("<") + name + ">");
        for (const pugi::xml_node& result : child_called(part, "results").children()) {
            if (local_name(result) != "result") continue;
            const pugi::xml_node data = child_called(result, "data");
            bool skip = false;
            for (pugi::xml_node at = data; at; at = next_element(at, data, skip)) {
                const std::string_view name = local_name(at);
                skip = name == "quantity" || name == "measurementMetaData" || name == "usedMethods" ||
                       name == "influenceConditions" || name == "measuringEquipments";
                if (name != "quantity") continue;
                if (auto done = take(at, dcc_name(result)); !done) return done;
            }
        }
        return {};
    }

    Result<void> take(const pugi::xml_node& node, const std::string& result) {
        if (const pugi::xml_node inner = child_called(node, "measurementMetaData"))
            proposals_.leave_out(xml_.line(inner),
                                 tell<"%1: <measurementMetaData>">(in_quotes(dcc_name(node))));
        if (quantities_.size() == most_stated_quantities) return leave_out_beyond(node);
        auto read = read_dcc_quantity(xml_, node, proposals_);
        if (!read) return fail(read.error());
        if (quantities_.size() + read->values.size() > most_stated_quantities) return leave_out_beyond(node);
        const std::size_t first = quantities_.size();
        for (StatedQuantity& q : read->values) {
            q.symbol = "q_" + std::to_string(quantities_.size() + 1);
            if (read->scalar) propose_length(*read, q, result);
            q.name = name_in(result, q.name);
            if (!q.group.empty()) q.group = name_in(result, q.group);
            q.source =
                heading_ + ", line " + std::to_string(read->line) + (q.source.empty() ? "" : ", ") + q.source;
            if (!q.statement.empty()) ++stated_;
            quantities_.push_back(std::move(q));
        }
        for (const StatedCorrelation& c : read->correlations)
            correlations_.push_back({first + c.first, first + c.second, c.coefficient});
        return {};
    }

    Result<void> leave_out_beyond(const pugi::xml_node& node) {
        proposals_.leave_out(xml_.line(node),
                             tell<"a quantity: more than %1 values">(most_stated_quantities));
        return {};
    }

    /// Proposes a length with an uncertainty, which may be a standard; errors of indication, limits and
    /// nominal values are none.
    void propose_length(const DccQuantity& quantity, const StatedQuantity& q, const std::string& result) {
        if (q.unit.dimension() != Unit::of("m").dimension() || !(q.value > 0.0) || !q.a) return;
        for (const char* word : {"Error", "Limit", "nominal", "orrection", "eviation"})
            if (quantity.ref_type.find(word) != std::string::npos) return;
        double u = *q.a;
        if (q.statement == "certificate-k") u /= *q.b;
        if (q.statement == "certificate-p") u /= normal_quantile(0.5 + *q.b / 200.0);
        if (q.statement == "rectangular" || q.statement == "triangular") return;
        if (lengths_.size() == most_length_standards)
            return proposals_.leave_out(quantity.line, tell<"%1 as a length standard: more than %2">(
                                                           in_quotes(quantity.name), most_length_standards));
        TableRows components(table_of(length_standard_kind_id, "components"));
        for (const char* column : {"u_cal", "u_T", "u_var", "b"}) components.set_unit(column, q.unit);
        components.add({{"u_cal", u}, {"u_T", 0.0}, {"u_var", 0.0}, {"b", 0.0}});
        AssetEntry asset{.kind = length_standard_kind_id, .name = name_in(result, q.name)};
        asset.notes = "From " + heading_ + ", line " + std::to_string(quantity.line) +
                      ". u_T, u_var and b are 0: the certificate says nothing of temperature and of "
                      "measurements of it.";
        asset.certificates = {certificate_};
        asset.setup.values["length"] = Quantity{q.value, q.unit};
        asset.setup.values["evaluation"] = std::string("components");
        asset.setup.values["components"] = components.table();
        lengths_.push_back(std::move(asset));
    }

    void name_what_is_left(const pugi::xml_node& root) {
        for (const pugi::xml_node& child : root.children()) {
            const std::string_view name = local_name(child);
            if (name == "Signature")
                proposals_.leave_out(xml_.line(child), tell<"the signature: it is not verified">());
            else if (name != "administrativeData" && name != "measurementResults" &&
                     child.type() == pugi::node_element)
                proposals_.leave_out(xml_.line(child), "<" + plain_name(std::string(name)) + ">");
        }
        const pugi::xml_node data = child_called(root, "administrativeData");
        for (const char* name : {"statements", "refTypeDefinitions"})
            if (const pugi::xml_node node = child_called(data, name))
                proposals_.leave_out(xml_.line(node), std::string("<") + name + ">");
    }

    void propose() {
        proposals_.found.push_back(
            correlations_.empty()
                ? tell<"%1 values, %2 of them with an uncertainty">(quantities_.size(), stated_)
                : tell<"%1 values, %2 of them with an uncertainty, with covariances">(quantities_.size(),
                                                                                      stated_));
        proposals_.analyses.push_back(analysis_of("certificate", proposals_.title, "From " + heading_ + ".",
                                                  quantities_, correlations_));
        proposals_.analyses.back().certificates = {certificate_};
        int number = 0;
        for (AssetEntry& asset : lengths_) {
            const std::string id = id_of(asset.name, "length");
            asset.id = lengths_.size() > 1 ? id + "-" + std::to_string(++number) : id;
            proposals_.found.push_back(
                tell<"length standard %1: delete it where the length is no standard">(in_quotes(asset.name)));
            proposals_.assets.push_back(std::move(asset));
        }
    }

    const XmlText& xml_;
    const ReadChoice& choice_;
    Proposals proposals_;
    AssetCertificate certificate_;
    std::string id_, item_, heading_;
    std::vector<StatedQuantity> quantities_;
    std::vector<StatedCorrelation> correlations_;
    std::vector<AssetEntry> lengths_;
    std::size_t stated_ = 0;
};

Recognition recognise_certificate(std::string_view beginning, const std::string&) {
    return beginning.find("digitalCalibrationCertificate") != std::string_view::npos ? Recognition::certain
                                                                                     : Recognition::no;
}

Result<Proposals> read_certificate(const std::string& text, const ReadChoice& choice) {
    const auto xml = XmlText::parse(text);
    if (!xml) return fail(xml.error());
    return CertificateReader(*xml, sha256_of(text), choice).read();
}

}  // namespace

Reader dcc_reader() {
    return {.name = "dcc",
            .title = "Digital Calibration Certificate",
            .pattern = "*.xml",
            .takes =
                "results with U and k, u or covariances -> quantities of a measurement equation; lengths -> "
                "length standards",
            .recognise = recognise_certificate,
            .read = read_certificate};
}

}  // namespace covaria
