# Options common to all targets, and one function per kind of target.

add_library(covaria_options INTERFACE)
target_include_directories(covaria_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
# No contraction and no fast-math: the same project and seed give the same bits everywhere this binary runs.
target_compile_options(covaria_options INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-march=x86-64-v3 -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual>)
# GCC 12 sees uninitialised members in every moved std::variant of strings at -O2: a false alarm.
target_compile_options(covaria_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
target_compile_definitions(covaria_options INTERFACE EIGEN_DONT_PARALLELIZE COVARIA_VERSION="${PROJECT_VERSION}")
if(COVARIA_WERROR)
    target_compile_options(covaria_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(COVARIA_SANITIZE)
    target_compile_options(covaria_options INTERFACE -fsanitize=${COVARIA_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(covaria_options INTERFACE -fsanitize=${COVARIA_SANITIZE})
endif()

# covaria_folder(name [QT] [HOT] [DEPENDS ...] [PRIVATE_DEPENDS ...] [PCH header ...])
# The library `covaria_<name>` of the current folder, made of all its sources. It links only what it may include.
# QT: run moc. HOT: inner loops of the propagation, worth the compiler's full effort in release builds.
function(covaria_folder name)
    cmake_parse_arguments(arg "QT;HOT" "" "DEPENDS;PRIVATE_DEPENDS;PCH" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
    if(sources)
        add_library(covaria_${name} STATIC ${sources} ${headers})
        target_link_libraries(covaria_${name} PUBLIC covaria_options ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})
        if(arg_PCH)
            target_precompile_headers(covaria_${name} PRIVATE ${arg_PCH})
        endif()
        if(arg_HOT)
            target_compile_options(covaria_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
        endif()
        if(arg_QT)
            set_target_properties(covaria_${name} PROPERTIES AUTOMOC ON)
        endif()
    else()
        add_library(covaria_${name} INTERFACE)
        target_link_libraries(covaria_${name} INTERFACE covaria_options ${arg_DEPENDS})
    endif()
endfunction()

# covaria_test(name [QT] [DEPENDS ...]): an executable of GoogleTest cases from all *_test.cpp of the current folder.
# QT: a QApplication lives while the tests run.
function(covaria_test name)
    cmake_parse_arguments(arg "QT" "" "DEPENDS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(test_${name} ${sources})
    target_link_libraries(test_${name} PRIVATE ${arg_DEPENDS} GTest::gtest GTest::gtest_main)
    if(arg_QT)
        target_sources(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/ui/qt_application.cpp)
        target_link_libraries(test_${name} PRIVATE Qt6::Widgets Qt6::Test)
    endif()
    target_compile_definitions(test_${name} PRIVATE COVARIA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        COVARIA_BINARY_DIR="${PROJECT_BINARY_DIR}")
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
        PROPERTIES TIMEOUT 600 ENVIRONMENT "QT_QPA_PLATFORM=offscreen")
endfunction()
