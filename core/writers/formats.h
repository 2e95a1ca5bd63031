// The writers, one file each. To add one: its file, a line here, one in writers.cpp, and its test.
#pragma once

#include "core/writers/writer.h"

namespace covaria {

Writer points_writer();
Writer dcc_writer();
Writer xlsx_writer();
Writer urdf_writer();
Writer robot_calibration_writer();

}  // namespace covaria
