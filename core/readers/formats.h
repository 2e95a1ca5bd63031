// The readers, one file each. To add one: its file, a line here, one in readers.cpp, and its test.
#pragma once

#include "core/readers/reader.h"

namespace covaria {

Reader spatial_analyzer_reader();
Reader point_table_reader();
Reader coordinate_list_reader();
Reader dcc_reader();
Reader gsi_reader();
Reader gama_reader();
Reader comp3d_reader();
Reader comp3d_observations_reader();
Reader comp3d_project_reader();
Reader excel_budget_reader();
Reader gum_workbench_reader();
Reader suncal_reader();
Reader motive_reader();
Reader robot_calibration_reader();
Reader urdf_reader();

}  // namespace covaria
