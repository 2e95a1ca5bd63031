// The only file that knows libzip.
#include "core/readers/zip_parts.h"

#include <zip.h>

#include <algorithm>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

constexpr zip_int64_t most_parts = 10'000;
constexpr std::size_t block = 65536;

tl::unexpected<Error> refused_zip(const std::string& message) {
    return fail(ErrorCode::bad_input, "the file has " + message);
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
    if (!archive->zip) return refused_zip("no readable zip archive in it (" + words + ")");
    if (zip_get_num_entries(archive->zip, 0) > most_parts)
        return refused_zip("more than " + std::to_string(most_parts) + " parts, which are not read");
    return ZipParts(std::move(archive), limit);
}

bool ZipParts::has(const std::string& name) const {
    return zip_name_locate(archive_->zip, name.c_str(), 0) >= 0;
}

Result<std::string> ZipParts::read(const std::string& name) {
    const std::string quoted = in_quotes(plain_name(name));
    const zip_int64_t index = zip_name_locate(archive_->zip, name.c_str(), 0);
    if (index < 0) return refused_zip("no part " + quoted);
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive_->zip, static_cast<zip_uint64_t>(index), 0, &stat) != 0)
        return refused_zip("a part " + quoted + " that cannot be read");
    if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) && stat.encryption_method != ZIP_EM_NONE)
        return refused_zip("an encrypted part " + quoted + ": save it without a password");
    zip_file_t* file = zip_fopen_index(archive_->zip, static_cast<zip_uint64_t>(index), 0);
    if (!file) return refused_zip("a part " + quoted + " that cannot be unpacked");
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
    if (count < 0) return refused_zip("a damaged part " + quoted);
    if (text.size() > left_)
        return refused_zip("parts that unpack to more than " + std::to_string(limit_ / 1'000'000) +
                           " MB (at " + quoted + "), which are not read");
    left_ -= text.size();
    return text;
}

}  // namespace covaria
