// The list of writers: one line for each.
#include "core/writers/writers.h"

#include "core/writers/formats.h"

namespace covaria {

const std::vector<Writer>& writer_registry() {
    static const std::vector<Writer> writers{points_writer(), dcc_writer(), xlsx_writer(), urdf_writer(),
                                             robot_calibration_writer()};
    return writers;
}

const Writer* find_writer(const std::string& name) {
    for (const Writer& writer : writer_registry())
        if (writer.name == name) return &writer;
    return nullptr;
}

}  // namespace covaria
