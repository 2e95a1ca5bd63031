// PNG files by way of VTK.
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <system_error>

#include "core/base/file_io.h"
#include "viz/vtk/image.h"
#include "viz/vtk/rendering_log.h"

namespace covaria {
namespace {

namespace fs = std::filesystem;

/// The file as bytes in memory, so that a full disk shows as an error of the stream.
vtkSmartPointer<vtkUnsignedCharArray> encoded(const Image& image) {
    vtkNew<vtkImageData> data;
    data->SetDimensions(image.width, image.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y)
        std::memcpy(data->GetScalarPointer(0, image.height - 1 - y, 0),
                    image.rgba.data() + row * static_cast<std::size_t>(y), row);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(data);
    writer->WriteToMemoryOn();
    writer->Write();
    return writer->GetResult();
}

}  // namespace

std::array<std::uint8_t, 4> Image::at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height) return {};
    const std::size_t i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]};
}

Result<void> write_png(const Image& image, const fs::path& file) {
    detail::redirect_vtk_messages();
    if (image.empty()) return fail(ErrorCode::bad_input, "there is no picture to write to " + file.string());
    const auto bytes = encoded(image);
    if (!bytes) return fail(ErrorCode::numeric, "the picture " + file.string() + " cannot be encoded");
    const auto* begin = reinterpret_cast<const char*>(bytes->GetPointer(0));
    return write_file_atomically(file,
                                 std::string(begin, static_cast<std::size_t>(bytes->GetNumberOfValues())));
}

Result<Image> read_png(const fs::path& file) {
    detail::redirect_vtk_messages();
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return fail(ErrorCode::not_found, "no picture " + file.string());
    vtkNew<vtkPNGReader> reader;
    if (!reader->CanReadFile(file.c_str()))
        return fail(ErrorCode::io, file.string() + " is not a PNG picture");
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkImageData* data = reader->GetOutput();
    const int channels = data->GetNumberOfScalarComponents();
    if (reader->GetErrorCode() != vtkErrorCode::NoError || data->GetScalarType() != VTK_UNSIGNED_CHAR ||
        channels < 3)
        return fail(ErrorCode::io,
                    "cannot read the picture " + file.string() + ": it is damaged or has no colours");
    Image image{data->GetDimensions()[0], data->GetDimensions()[1], {}};
    image.rgba.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x) {
            const auto* pixel = static_cast<const std::uint8_t*>(data->GetScalarPointer(x, y, 0));
            image.rgba.insert(image.rgba.end(),
                              {pixel[0], pixel[1], pixel[2], channels == 4 ? pixel[3] : std::uint8_t{255}});
        }
    return image;
}

}  // namespace covaria
