# SPDX-License-Identifier: GPL-3.0-or-later

# codewheel_test(NAME LIBRARIES...): a test program of its folder's sources. Add sources with target_sources(NAME ...).
function(codewheel_test name)
    add_executable(${name})
    target_link_libraries(${name} PRIVATE codewheel_test_support ${ARGN})
    target_precompile_headers(${name} REUSE_FROM codewheel_test_pch)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=0)
    set_tests_properties(${name} PROPERTIES
        ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8;TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/tsan.supp second_deadlock_stack=1"
        TIMEOUT 600)
endfunction()
