# Options common to all targets, and one function per kind of target.

add_library(covaria_options INTERFACE)
target_include_directories(covaria_options INTERFACE ${PROJECT_SOURCE_DIR})
# No contraction and no fast-math: the same project and seed give the same bits everywhere this binary runs.
target_compile_options(covaria_options INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-march=x86-64-v3 -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual>)
# GCC 12 at -O2 sees uninitialised members in every moved std::variant of strings, and writes beyond vectors
# that it has just seen allocated: false alarms.
target_compile_options(covaria_options INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow>)
# Joined sources shadow each other's names and share "anonymous" bases; the dev preset reads each by itself.
if(CMAKE_UNITY_BUILD AND COVARIA_WERROR)
    target_compile_options(covaria_options INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
target_compile_definitions(covaria_options INTERFACE EIGEN_DONT_PARALLELIZE)
if(COVARIA_WERROR)
    target_compile_options(covaria_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(COVARIA_SANITIZE)
    target_compile_options(covaria_options INTERFACE -fsanitize=${COVARIA_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(covaria_options INTERFACE -fsanitize=${COVARIA_SANITIZE})
    if(COVARIA_SANITIZE MATCHES undefined)  # found by the address sanitizer or the processor too, and half of the time of compilation
        target_compile_options(covaria_options INTERFACE -fno-sanitize=null,alignment,vptr,object-size)
    endif()
endif()

# Precompiled headers, each compiled once and shared by all targets with the same compiler options.
# covaria_precompiled(name [HOT] [EXECUTABLES] LIBRARIES library ...): cmake/precompiled/<name>.h, as target
# pch_<name>[_hot]; EXECUTABLES: for the sources of executables, which are -fPIE instead of -fPIC.
function(covaria_precompiled name)
    cmake_parse_arguments(arg "HOT;EXECUTABLES" "" "LIBRARIES" ${ARGN})
    set(target pch_${name})
    if(arg_HOT)
        set(target pch_${name}_hot)
    endif()
    file(WRITE ${PROJECT_BINARY_DIR}/pch/${target}.cpp "")
    add_library(${target} OBJECT ${PROJECT_BINARY_DIR}/pch/${target}.cpp)
    target_link_libraries(${target} PRIVATE covaria_options ${arg_LIBRARIES})
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled/${name}.h)
    if(arg_HOT)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)
    endif()
    if(arg_EXECUTABLES)
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
        target_compile_options(${target} PRIVATE -fPIE)
    endif()
endfunction()

if(COVARIA_PRECOMPILE)
    covaria_precompiled(core LIBRARIES Eigen3::Eigen tl::expected)
    covaria_precompiled(core HOT LIBRARIES Eigen3::Eigen tl::expected)
    covaria_precompiled(qt LIBRARIES Eigen3::Eigen tl::expected Qt6::Widgets)
    if(COVARIA_TESTS)
        covaria_precompiled(test EXECUTABLES LIBRARIES Eigen3::Eigen tl::expected GTest::gtest)
        covaria_precompiled(qt_test EXECUTABLES LIBRARIES Eigen3::Eigen tl::expected GTest::gtest Qt6::Widgets)
    endif()
endif()

function(covaria_use_precompiled target name)
    if(COVARIA_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM pch_${name})
    endif()
endfunction()

# covaria_folder(name [IN folder] [QT] [HOT] [DEPENDS ...] [PRIVATE_DEPENDS ...])
# The library `covaria_<name>` of the current folder, or of one in it, made of all its sources. It links only what it may
# include.
# QT: run moc. HOT: inner loops of the propagation, worth the compiler's full effort in release builds.
function(covaria_folder name)
    cmake_parse_arguments(arg "QT;HOT" "IN" "DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${arg_IN}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${arg_IN}/*.h)
    if(sources)
        add_library(covaria_${name} STATIC ${sources} ${headers})
        if(NOT arg_QT)
            set_property(GLOBAL APPEND PROPERTY COVARIA_WORDS covaria_${name})
        endif()
        target_link_libraries(covaria_${name} PUBLIC covaria_options ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})
        if(arg_HOT)
            target_compile_options(covaria_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
            covaria_use_precompiled(covaria_${name} core_hot)
        elseif("Qt6::Widgets" IN_LIST arg_DEPENDS)
            covaria_use_precompiled(covaria_${name} qt)
        else()
            covaria_use_precompiled(covaria_${name} core)
        endif()
        if(arg_QT)
            set_target_properties(covaria_${name} PROPERTIES AUTOMOC ON)
        endif()
    else()
        add_library(covaria_${name} INTERFACE)
        target_link_libraries(covaria_${name} INTERFACE covaria_options ${arg_DEPENDS})
    endif()
endfunction()

# covaria_test(name [QT] [FOLDERS] [DEPENDS ...]): an executable of GoogleTest cases from all sources of the current folder.
# QT: a QApplication lives while the tests run. FOLDERS: and of the folders in it.
function(covaria_test name)
    cmake_parse_arguments(arg "QT;FOLDERS" "" "DEPENDS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    if(arg_FOLDERS)
        file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    endif()
    if(NOT sources)
        return()
    endif()
    add_executable(test_${name} ${sources})
    target_link_libraries(test_${name} PRIVATE ${arg_DEPENDS} GTest::gtest GTest::gtest_main tl::expected Eigen3::Eigen)
    if(arg_QT)
        target_sources(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/ui/qt_application.cpp)
        target_link_libraries(test_${name} PRIVATE Qt6::Widgets Qt6::Test)
        covaria_use_precompiled(test_${name} qt_test)
    else()
        covaria_use_precompiled(test_${name} test)
    endif()
    target_compile_definitions(test_${name} PRIVATE COVARIA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        COVARIA_BINARY_DIR="${PROJECT_BINARY_DIR}")
    if(name MATCHES "^([a-z]+)_")  # core_tests, viz_tests, ui_tests: all of a floor
        set(floor ${CMAKE_MATCH_1}_tests)
        if(NOT TARGET ${floor})
            add_custom_target(${floor})
        endif()
        add_dependencies(${floor} test_${name})
    endif()
    set(limit 300)
    if(COVARIA_SANITIZE)  # makes everything ten times slower
        set(limit 900)
    endif()
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
        PROPERTIES TIMEOUT ${limit} ENVIRONMENT "QT_QPA_PLATFORM=offscreen")
endfunction()
