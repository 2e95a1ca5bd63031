#include "core/pdf/pdf_archive.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFLogger.hh>
#include <qpdf/QPDFWriter.hh>
#include <stdexcept>

#include "core/base/file_io.h"
#include "core/base/utf8.h"
#include "core/pdf/pdf_navigation.h"

namespace covaria {

namespace {

// A date is required of every attached file (ISO 19005-3 annex E); the clock has no place in a document that
// is made twice with equal bytes.
constexpr const char* no_clock = "D:20000101000000Z";

/// libqpdf throws; what it says is for programmers.
template <class Work>
auto with_pdf(const std::string& what, Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        return fail(ErrorCode::bad_input, what + ": " + e.what());
    }
}

/// Valid UTF-8 without marks of control, which neither XML nor a title has a place for.
std::string plain_text(const std::string& text) {
    std::string plain;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t valid = valid_utf8(rest);
        for (const char c : rest.substr(0, valid))
            plain += static_cast<unsigned char>(c) < 32 || c == 127 ? ' ' : c;
        rest.remove_prefix(valid);
        if (rest.empty()) break;
        plain += '?';
        rest.remove_prefix(1);
    }
    return plain;
}

std::string in_xml(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

/// A list of one in XMP; nothing without it.
std::string in_list(const std::string& element, const std::string& list, const std::string& text) {
    if (text.empty()) return {};
    return "   <" + element + "><" + list + "><rdf:li>" + in_xml(text) + "</rdf:li></" + list + "></" +
           element + ">\n";
}

std::string xmp_of(const PdfProperties& properties, const std::string& producer) {
    return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
           "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
           " <rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
           "  <rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\"\n"
           "    xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\" xmlns:pdf=\"http://ns.adobe.com/pdf/1.3/\"\n"
           "    xmlns:pdfaid=\"http://www.aiim.org/pdfa/ns/id/\">\n"
           "   <dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">" +
           in_xml(properties.title) + "</rdf:li></rdf:Alt></dc:title>\n" +
           in_list("dc:creator", "rdf:Seq", properties.author) +
           in_list("dc:language", "rdf:Bag", properties.language) + "   <xmp:CreatorTool>" +
           in_xml(properties.creator) +
           "</xmp:CreatorTool>\n"
           "   <pdf:Producer>" +
           in_xml(producer) +
           "</pdf:Producer>\n"
           "   <pdfaid:part>3</pdfaid:part>\n"
           "   <pdfaid:conformance>B</pdfaid:conformance>\n"
           "  </rdf:Description>\n"
           " </rdf:RDF>\n"
           "</x:xmpmeta>\n"
           "<?xpacket end=\"w\"?>\n";
}

/// Code of a language as RFC 3066 writes it: "zh-CN".
std::string language_tag(const std::string& code) {
    std::string tag = plain_text(code);
    std::replace(tag.begin(), tag.end(), '_', '-');
    return tag;
}

const char* relationship_of(AttachedAs as) {
    switch (as) {
        case AttachedAs::source:
            return "/Source";
        case AttachedAs::data:
            return "/Data";
        case AttachedAs::alternative:
            break;
    }
    return "/Alternative";
}

/// Properties and metadata say the same, and nothing of when.
void set_properties(QPDF& pdf, PdfProperties properties) {
    properties = {plain_text(properties.title), plain_text(properties.creator), plain_text(properties.author),
                  language_tag(properties.language)};
    QPDFObjectHandle before = pdf.getTrailer().getKey("/Info");
    std::string producer = "Qt";
    if (before.isDictionary() && before.getKey("/Producer").isString())
        producer = plain_text(before.getKey("/Producer").getUTF8Value());
    QPDFObjectHandle info = QPDFObjectHandle::newDictionary();
    info.replaceKey("/Title", QPDFObjectHandle::newUnicodeString(properties.title));
    if (!properties.author.empty())
        info.replaceKey("/Author", QPDFObjectHandle::newUnicodeString(properties.author));
    info.replaceKey("/Creator", QPDFObjectHandle::newUnicodeString(properties.creator));
    info.replaceKey("/Producer", QPDFObjectHandle::newUnicodeString(producer));
    pdf.getTrailer().removeKey("/ID");  // a random one; the new one is of the content
    pdf.getTrailer().replaceKey("/Info", pdf.makeIndirectObject(info));
    QPDFObjectHandle xmp = QPDFObjectHandle::newStream(&pdf, xmp_of(properties, producer));
    xmp.getDict().replaceKey("/Type", QPDFObjectHandle::newName("/Metadata"));
    xmp.getDict().replaceKey("/Subtype", QPDFObjectHandle::newName("/XML"));
    xmp.setFilterOnWrite(false);  // programs look for it in the bytes
    pdf.getRoot().replaceKey("/Metadata", xmp);
    if (!properties.language.empty())
        pdf.getRoot().replaceKey("/Lang", QPDFObjectHandle::newString(properties.language));
    QPDFObjectHandle view = QPDFObjectHandle::newDictionary();
    view.replaceKey("/DisplayDocTitle", QPDFObjectHandle::newBool(true));
    pdf.getRoot().replaceKey("/ViewerPreferences", view);
}

/// Part 1 asks for CIDSet; part 3 does without, and only a complete one would be right (6.2.11.4.2).
void remove_cid_sets(QPDF& pdf) {
    for (QPDFObjectHandle& object : pdf.getAllObjects())
        if (object.isDictionary() && object.hasKey("/CIDSet")) object.removeKey("/CIDSet");
}

void attach(QPDF& pdf, const std::vector<AttachedFile>& files) {
    QPDFEmbeddedFileDocumentHelper embedded(pdf);
    QPDFObjectHandle associated = QPDFObjectHandle::newArray();
    for (const AttachedFile& file : files) {
        auto stream = QPDFEFStreamObjectHelper::createEFStream(pdf, file.bytes);
        stream.setSubtype(file.mime).setModDate(no_clock);
        auto specification = QPDFFileSpecObjectHelper::createFileSpec(pdf, file.name, stream);
        specification.setDescription(plain_text(file.description));
        QPDFObjectHandle dictionary = specification.getObjectHandle();
        dictionary.replaceKey("/AFRelationship", QPDFObjectHandle::newName(relationship_of(file.as)));
        embedded.replaceEmbeddedFile(file.name, specification);
        associated.appendItem(dictionary);
    }
    if (!files.empty()) pdf.getRoot().replaceKey("/AF", associated);
}

/// Keeps what is written to it, up to what all files together may have.
class BoundedBytes : public Pipeline {
public:
    explicit BoundedBytes(std::size_t most) : Pipeline("attached file", nullptr), most_(most) {}
    void write(unsigned char const* data, size_t size) override {
        if (bytes.size() + size > most_)
            throw std::runtime_error("its attached files are larger than " +
                                     std::to_string(largest_file / 1'000'000) + " MB");
        bytes.append(reinterpret_cast<const char*>(data), size);
    }
    void finish() override {}
    std::string bytes;

private:
    std::size_t most_;
};

int hexadecimal(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

/// Whether a name occurs, plainly or with its letters as #58.
bool has_name(std::string_view bytes, std::string_view name) {
    for (std::size_t at = bytes.find('/'); at != std::string_view::npos; at = bytes.find('/', at + 1)) {
        std::size_t here = at + 1, matched = 0;
        for (; matched < name.size() && here < bytes.size(); ++matched) {
            char c = bytes[here++];
            if (c == '#' && here + 1 < bytes.size()) {
                c = static_cast<char>(16 * hexadecimal(bytes[here]) + hexadecimal(bytes[here + 1]));
                here += 2;
            }
            if (c != name[matched]) break;
        }
        const bool ends =
            here >= bytes.size() ||
            std::string_view("\0\t\n\f\r ()<>[]{}/%", 16).find(bytes[here]) != std::string_view::npos;
        if (matched == name.size() && ends) return true;
    }
    return false;
}

/// Opens a PDF; what is wrong with it is an Error, never a line that the library prints.
void open(QPDF& pdf, const std::string& bytes) {
    static std::once_flag silent;
    std::call_once(silent, [] {
        const auto logger = QPDFLogger::defaultLogger();
        logger->setError(logger->discard());
        logger->setWarn(logger->discard());
    });
    // The library would inflate a compressed table whole, whatever its size.
    if (has_name(bytes, "XRef"))
        throw std::runtime_error(
            "its table of objects is compressed: another program has written it anew "
            "(qpdf --object-streams=disable IN OUT undoes that)");
    pdf.setSuppressWarnings(true);
    pdf.setAttemptRecovery(false);
    pdf.processMemoryFile("PDF", bytes.data(), bytes.size());
}

}  // namespace

Result<std::string> archived_pdf(const std::string& bytes, const PdfProperties& properties,
                                 const std::vector<AttachedFile>& files, const PdfNavigation& navigation) {
    return with_pdf("the PDF could not be made an archive", [&]() -> Result<std::string> {
        QPDF pdf;
        open(pdf, bytes);
        set_properties(pdf, properties);
        remove_cid_sets(pdf);
        attach(pdf, files);
        add_navigation(pdf, navigation);
        QPDFWriter writer(pdf);
        writer.setOutputMemory();
        writer.setMinimumPDFVersion("1.7");
        writer.setDeterministicID(true);
        writer.setNewlineBeforeEndstream(true);
        writer.write();
        const std::shared_ptr<Buffer> written = writer.getBufferSharedPointer();
        return std::string(reinterpret_cast<const char*>(written->getBuffer()), written->getSize());
    });
}

Result<std::vector<AttachedFile>> files_in_pdf(const std::string& bytes) {
    return with_pdf("the PDF cannot be read", [&]() -> Result<std::vector<AttachedFile>> {
        QPDF pdf;
        open(pdf, bytes);
        std::vector<AttachedFile> files;
        std::size_t total = 0;
        for (const auto& [key, specification] : QPDFEmbeddedFileDocumentHelper(pdf).getEmbeddedFiles()) {
            QPDFObjectHandle stream = specification->getEmbeddedFileStream();
            if (!stream.isStream()) continue;
            BoundedBytes kept(static_cast<std::size_t>(largest_file) - total);
            if (!stream.pipeStreamData(&kept, 0, qpdf_dl_all, true))
                return fail(ErrorCode::bad_input, tell<"the attached file '%1' is broken">(plain_text(key)));
            total += kept.bytes.size();
            files.push_back({.name = specification->getFilename(),
                             .bytes = std::move(kept.bytes),
                             .mime = QPDFEFStreamObjectHelper(stream).getSubtype(),
                             .description = specification->getDescription()});
        }
        return files;
    });
}

}  // namespace covaria
