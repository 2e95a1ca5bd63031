#include "core/project/asset_certificate_fields.h"

namespace covaria {

namespace {

using CertificateLine = AssetCertificateText;

JsonFields<CertifiedRange> certified_range_fields() {
    return JsonFields<CertifiedRange>(tell<"a range of a certificate">(), JsonWriter::Style::one_line)
        .required("of", &CertifiedRange::of)
        .add("lowest", &CertifiedRange::lowest)
        .add("highest", &CertifiedRange::highest);
}

OneOf<FiguresFrom> figures_from_in_files() {
    OneOf<FiguresFrom> words;
    for (const FiguresFromWord& word : figures_from_words()) words.words.push_back({word.value, word.key});
    return words;
}

}  // namespace

const std::vector<AssetCertificateText>& asset_certificate_texts() {
    using C = AssetCertificate;
    static const std::vector<CertificateLine> texts{
        {"number", "Number", "As it stands on the certificate.", &C::number},
        {"edition", "Edition", "Of an amended certificate or a data sheet.", &C::edition},
        {"issuer", "Issuer", "Laboratory, manufacturer.", &C::issuer},
        {"calibrated", "Date of calibration", "A date, or two of an interval: 2026-04-17/2026-04-18.",
         &C::calibrated, CertificateLine::Kind::dates},
        {"issued", "Date of issue", "ISO 8601: 2026-04-20.", &C::issued, CertificateLine::Kind::date},
        {"validUntil", "Valid until", "The last day on which the figures may be used, by your own rule.",
         &C::valid_until, CertificateLine::Kind::date},
        {"conditions", "Conditions", "What the figures hold for, in words: mode, filter, support.",
         &C::conditions},
        {"file", "File", "Its name.", &C::file},
        {"digest", "Digest", "SHA-256 of the file, 64 hexadecimal digits.", &C::digest}};
    return texts;
}

const std::vector<FiguresFromWord>& figures_from_words() {
    static const std::vector<FiguresFromWord> words{{FiguresFrom::certificate, "certificate", "certificate"},
                                                    {FiguresFrom::report, "report", "report"},
                                                    {FiguresFrom::data_sheet, "dataSheet", "data sheet"}};
    return words;
}

const JsonFields<AssetCertificate>& asset_certificate_fields() {
    static const auto fields = [] {
        JsonFields<AssetCertificate> all(tell<"a certificate of figures">());
        all.add("kind", &AssetCertificate::kind, figures_from_in_files());
        for (const CertificateLine& text : asset_certificate_texts()) all.add(text.key, text.member);
        all.add("ranges", &AssetCertificate::ranges, ListOf{certified_range_fields()});
        all.add("quantities", &AssetCertificate::quantities);
        return all;
    }();
    return fields;
}

}  // namespace covaria
