// Parts of zip files. This is the only file that knows libzip.
#include "core/readers/zip_parts.h"

#include <zip.h>

#include <algorithm>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

constexpr zip_int64_t most_parts = 10'000;
constexpr std::size_t block = 65536;

tl::unexpected<Error> refused_zip(const Message& message) {
    return fail(ErrorCode::bad_input, tell<"the file has %1">(message));
}

}  // namespace

struct ZipParts::Archive {
    zip_t* zip = nullptr;
    ~Archive() {
        if (zip) zip_discard(zip);
    }
};

Result<ZipParts> ZipParts::open(const std::string& bytes, std::size_t limit) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    auto archive = std::make_shared<Archive>();
    if (source) archive->zip = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (source && !archive->zip) zip_source_free(source);
    const std::string words = plain_line(zip_error_strerror(&error));
    zip_error_fini(&error);
    if (!archive->zip) return refused_zip(tell<"no readable zip archive in it (%1)">(words));
    if (zip_get_num_entries(archive->zip, 0) > most_parts)
        return refused_zip(tell<"more than %1 parts, which are not read">(most_parts));
    return ZipParts(std::move(archive), limit);
}

bool ZipParts::has(const std::string& name) const {
    return zip_name_locate(archive_->zip, name.c_str(), 0) >= 0;
}

Result<std::string> ZipParts::read(const std::string& name) {
    const std::string quoted = in_quotes(plain_name(name));
    const zip_int64_t index = zip_name_locate(archive_->zip, name.c_str(), 0);
    if (index < 0) return refused_zip(tell<"no part %1">(quoted));
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive_->zip, static_cast<zip_uint64_t>(index), 0, &stat) != 0)
        return refused_zip(tell<"a part %1 that cannot be read">(quoted));
    if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) && stat.encryption_method != ZIP_EM_NONE)
        return refused_zip(tell<"an encrypted part %1: save it without a password">(quoted));
    zip_file_t* file = zip_fopen_index(archive_->zip, static_cast<zip_uint64_t>(index), 0);
    if (!file) return refused_zip(tell<"a part %1 that cannot be unpacked">(quoted));
    std::string text;
    zip_int64_t count = 0;
    while (text.size() <= left_) {
        const std::size_t before = text.size();
        text.resize(before + block);
        count = zip_fread(file, text.data() + before, block);
        text.resize(before + static_cast<std::size_t>(std::max<zip_int64_t>(count, 0)));
        if (count <= 0) break;
    }
    zip_fclose(file);
    if (count < 0) return refused_zip(tell<"a damaged part %1">(quoted));
    if (text.size() > left_)
        return refused_zip(tell<"parts that unpack to more than %1 MB (at %2), which are not read">(
            limit_ / 1'000'000, quoted));
    left_ -= text.size();
    return text;
}

}  // namespace covaria
