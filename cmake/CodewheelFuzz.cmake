# SPDX-License-Identifier: GPL-3.0-or-later

option(CODEWHEEL_FUZZ "Build the fuzz targets for libFuzzer (clang only)" OFF)

# codewheel_fuzz(NAME LIBRARIES...): fuzz_NAME from fuzz_NAME.cpp, which defines LLVMFuzzerTestOneInput(). With
# libFuzzer it is run by tools/fuzz; without, it runs over the files of corpus/NAME as a test.
function(codewheel_fuzz name)
    add_executable(fuzz_${name} fuzz_${name}.cpp)
    target_link_libraries(fuzz_${name} PRIVATE codewheel_options ${ARGN})
    target_include_directories(fuzz_${name} PRIVATE "${PROJECT_SOURCE_DIR}")
    if(CODEWHEEL_FUZZ)
        target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
        set_property(GLOBAL APPEND PROPERTY codewheel_fuzz_targets fuzz_${name})
    else()
        target_sources(fuzz_${name} PRIVATE run_corpus.cpp)
        add_test(NAME fuzz_${name} COMMAND fuzz_${name} "${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}")
        set_tests_properties(fuzz_${name} PROPERTIES ENVIRONMENT "${codewheel_test_environment}" TIMEOUT 600)
    endif()
endfunction()
