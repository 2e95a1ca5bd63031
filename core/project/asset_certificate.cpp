#include "core/project/asset_certificate.h"

#include <algorithm>
#include <cmath>

#include "core/base/dates.h"
#include "core/base/in_quotes.h"
#include "core/base/sha256.h"
#include "core/base/small_letters.h"
#include "core/project/asset_certificate_fields.h"

namespace covaria {

namespace {

void check_texts(const AssetCertificate& certificate, const std::string& path, Problems& problems) {
    using Kind = AssetCertificateText::Kind;
    for (const AssetCertificateText& text : asset_certificate_texts()) {
        const std::string& value = certificate.*text.member;
        if (value.empty() || text.kind == Kind::line) continue;
        const Message title = Message::declared(text.title);
        const std::string place = path + "/" + text.key;
        if (text.kind == Kind::date && !date_of(value))
            problems.error(place,
                           tell<"'%1' must be a date of the form 2026-04-17; it is '%2'">(title, value));
        if (text.kind == Kind::dates && !period_of(value))
            problems.error(place, tell<"'%1' must be a date of the form 2026-04-17 or an interval "
                                       "2026-04-17/2026-04-18; it is '%2'">(title, value));
    }
    if (!certificate.digest.empty() && !is_sha256(certificate.digest))
        problems.error(path + "/digest", tell<"it must be the SHA-256 of the file: 64 hexadecimal digits">());
}

void check_order(const AssetCertificate& certificate, const std::string& path, Problems& problems) {
    const auto calibrated = period_of(certificate.calibrated);
    const auto issued = date_of(certificate.issued), until = date_of(certificate.valid_until);
    if (calibrated && issued && *issued < calibrated->first)
        problems.warning(path + "/issued",
                         tell<"the certificate cannot have been issued before the calibration">());
    if (calibrated && until && *until < calibrated->first)
        problems.warning(path + "/validUntil",
                         tell<"its figures would have been valid only before the calibration">());
}

void check_range(const CertifiedRange& range, const std::string& path, Problems& problems) {
    if (range.of.empty())
        problems.error(path + "/of", tell<"the symbol of a quantity or the key of a field is missing">());
    const auto &low = range.lowest, &high = range.highest;
    if (!low && !high)
        problems.error(path, tell<"a range needs its lowest or its highest value">());
    else if (low && high && low->unit.dimension() != high->unit.dimension())
        problems.error(path + "/highest", tell<"its unit does not fit that of the lowest value">());
    else if (low && high && !(low->si() <= high->si()))
        problems.error(path + "/highest", tell<"it is below the lowest value">());
}

}  // namespace

Message name_of(const AssetCertificate& certificate) {
    const std::string& called = certificate.number.empty() ? certificate.file : certificate.number;
    for (const FiguresFromWord& word : figures_from_words()) {
        if (word.value != certificate.kind) continue;
        const Message kind = Message::declared(word.title);
        if (certificate.issuer.empty()) return called.empty() ? kind : tell<"%1 %2">(kind, called);
        return called.empty() ? tell<"%1 of %2">(kind, certificate.issuer)
                              : tell<"%1 %2 of %3">(kind, called, certificate.issuer);
    }
    return called;
}

bool is_called(const AssetCertificate& certificate, const std::string& number_or_digest) {
    if (number_or_digest.empty()) return false;
    const std::string wanted = in_small_letters(number_or_digest);
    return in_small_letters(certificate.number) == wanted || in_small_letters(certificate.digest) == wanted;
}

void check_certificates(const std::vector<AssetCertificate>& certificates, const std::string& path,
                        Problems& problems) {
    for (std::size_t i = 0; i < certificates.size(); ++i) {
        const AssetCertificate& one = certificates[i];
        const std::string place = path + "/" + std::to_string(i);
        if (one.number.empty() && one.file.empty() && one.issuer.empty())
            problems.warning(place + "/number",
                             tell<"nothing says which certificate it is: its number is missing">());
        check_texts(one, place, problems);
        check_order(one, place, problems);
        for (std::size_t k = 0; k < one.ranges.size(); ++k)
            check_range(one.ranges[k], place + "/ranges/" + std::to_string(k), problems);
    }
}

void check_measured(const std::string& measured, const std::string& path, Problems& problems) {
    if (!measured.empty() && !period_of(measured))
        problems.error(path, tell<"'%1' must be a date of the form 2026-04-17 or an interval "
                                  "2026-04-17/2026-04-18; it is '%2'">(
                                 Message::declared("Date of the measurement"), measured));
}

}  // namespace covaria
