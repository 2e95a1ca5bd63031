#include "core/project/certificate_json.h"

#include <optional>

namespace covaria {

namespace {

/// Fields of one group, or those of the certificate itself that stand together.
struct FieldRun {
    std::string group;
    std::vector<const CertificateField*> fields;
};

const std::vector<FieldRun>& field_runs() {
    static const std::vector<FieldRun> runs = [] {
        std::vector<FieldRun> all;
        for (const CertificateField& field : certificate_fields()) {
            if (all.empty() || all.back().group != field.group) all.push_back({field.group, {}});
            all.back().fields.push_back(&field);
        }
        return all;
    }();
    return runs;
}

void read_fields(ObjectReader& reader, const FieldRun& run, Certificate& certificate) {
    for (const CertificateField* field : run.fields) certificate.*field->member = reader.text(field->key);
}

void write_fields(JsonWriter& out, const FieldRun& run, const Certificate& certificate) {
    for (const CertificateField* field : run.fields)
        if (const std::string& text = certificate.*field->member; !text.empty()) out.member(field->key, text);
}

bool has_text(const FieldRun& run, const Certificate& certificate) {
    for (const CertificateField* field : run.fields)
        if (!(certificate.*field->member).empty()) return true;
    return false;
}

}  // namespace

Certificate certificate_from_json(const Json& value, const std::string& path, Problems& problems) {
    Certificate certificate;
    ObjectReader reader(value, path, tell<"the certificate">(), problems);
    for (const FieldRun& run : field_runs()) {
        if (run.group.empty()) {
            read_fields(reader, run, certificate);
        } else if (const Json* group = reader.find(run.group)) {
            ObjectReader inner(*group, reader.path_of(run.group), "'" + run.group + "'", problems);
            read_fields(inner, run, certificate);
            inner.refuse_unknown_keys();
        }
    }
    reader.refuse_unknown_keys();
    return certificate;
}

void write_certificate(JsonWriter& out, const Certificate& certificate) {
    out.begin_object();
    for (const FieldRun& run : field_runs()) {
        if (!has_text(run, certificate)) continue;
        if (!run.group.empty()) {
            out.key(run.group);
            out.begin_object();
        }
        write_fields(out, run, certificate);
        if (!run.group.empty()) out.end();
    }
    out.end();
}

}  // namespace covaria
