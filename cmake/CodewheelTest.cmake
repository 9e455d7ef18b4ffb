# SPDX-License-Identifier: GPL-3.0-or-later

# Tests need no screen, disturb no desktop, run in one language, and stop at the first finding of a sanitizer.
set(codewheel_test_environment
    "QT_QPA_PLATFORM=offscreen"
    "DBUS_SESSION_BUS_ADDRESS="
    "LC_ALL=C.UTF-8"
    "FONTCONFIG_FILE=${PROJECT_SOURCE_DIR}/tests/support/fonts.conf"
    "ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1"
    "LSAN_OPTIONS=print_suppressions=0:suppressions='${PROJECT_SOURCE_DIR}/tests/support/lsan.supp'"
    "UBSAN_OPTIONS=print_stacktrace=1"
    # A test that starts a program forks; ThreadSanitizer need not care about the program, and the test goes on.
    "TSAN_OPTIONS=die_after_fork=0:second_deadlock_stack=1:suppressions='${PROJECT_SOURCE_DIR}/tests/support/tsan.supp'")

# codewheel_test(NAME LIBRARIES...): a test program of its folder's sources. Add sources with target_sources(NAME ...).
function(codewheel_test name)
    codewheel_test_program(${name} codewheel_test_support codewheel_test_pch ${ARGN})
endfunction()

# codewheel_gui_test(NAME LIBRARIES...): the same with QApplication, codewheel_widgets and Qt Test.
function(codewheel_gui_test name)
    codewheel_test_program(${name} codewheel_gui_test_support codewheel_gui_test_pch ${ARGN})
endfunction()

# codewheel_starts_no_thread(NAME): says so of a test program, which ThreadSanitizer then has nothing to tell about. Elsewhere a
# thread ends it.
function(codewheel_starts_no_thread name)
    if(CODEWHEEL_SANITIZERS STREQUAL "thread")
        set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
        set_tests_properties(${name} PROPERTIES DISABLED ON)
    elseif(NOT CODEWHEEL_SANITIZERS)
        target_sources(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests/support/no_thread.cpp")
    endif()
endfunction()

# With CODEWHEEL_TEST_PARTS set, its tests run in that many parts, side by side; those that match CODEWHEEL_UNSANITIZED_TESTS, which take
# long and only measure layouts or kill programs, not under a sanitizer. Programs with a large CODEWHEEL_TEST_COST (s) begin first.
# One that computes takes two of ctest's slots; one that waits, for ports and programs, takes one: CODEWHEEL_TEST_SLOTS.
function(codewheel_test_program name support precompiled)
    add_executable(${name})
    target_link_libraries(${name} PRIVATE ${support} codewheel_test_options ${ARGN})
    target_precompile_headers(${name} REUSE_FROM ${precompiled})
    if(CODEWHEEL_SANITIZERS STREQUAL "thread")
        target_sources(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests/support/clone_under_tsan.cpp")
    endif()
    if(NOT CODEWHEEL_TEST_PARTS)
        set(CODEWHEEL_TEST_PARTS 1)
    endif()
    if(CODEWHEEL_SANITIZERS AND CODEWHEEL_UNSANITIZED_TESTS)
        set(filter "--gtest_filter=-${CODEWHEEL_UNSANITIZED_TESTS}")
    endif()
    if(NOT CODEWHEEL_TEST_COST)
        set(CODEWHEEL_TEST_COST 1)
    endif()
    if(NOT CODEWHEEL_TEST_SLOTS)
        set(CODEWHEEL_TEST_SLOTS 2)
    endif()
    foreach(part RANGE 1 ${CODEWHEEL_TEST_PARTS})
        set(test ${name})
        if(CODEWHEEL_TEST_PARTS GREATER 1)
            set(test ${name}_${part})
        endif()
        math(EXPR index "${part} - 1")
        add_test(NAME ${test} COMMAND ${name} --gtest_brief=0 ${filter})
        set_tests_properties(${test} PROPERTIES TIMEOUT 600 COST ${CODEWHEEL_TEST_COST} PROCESSORS ${CODEWHEEL_TEST_SLOTS} ENVIRONMENT
            "${codewheel_test_environment};GTEST_TOTAL_SHARDS=${CODEWHEEL_TEST_PARTS};GTEST_SHARD_INDEX=${index}")
    endforeach()
endfunction()
