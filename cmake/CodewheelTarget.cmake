# SPDX-License-Identifier: GPL-3.0-or-later
# What all our own targets have in common: warnings, definitions, hardening, sanitizers.

option(CODEWHEEL_WERROR "Treat warnings in our own code as errors" OFF)
set(CODEWHEEL_SANITIZERS "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")

add_library(codewheel_options INTERFACE)
target_compile_definitions(codewheel_options INTERFACE
    QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_KEYWORDS QT_NO_FOREACH QT_DISABLE_DEPRECATED_BEFORE=0x060400)
target_compile_options(codewheel_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${CODEWHEEL_WERROR}>:-Werror>)

# Tested builds abort on an access out of range or to a missing value; a release does not check.
if(NOT CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_definitions(codewheel_options INTERFACE _GLIBCXX_ASSERTIONS)
endif()

# clang reports a name from another source of the same unit as shadowed; GCC finds the real cases.
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(codewheel_options INTERFACE -Wno-shadow)
endif()

if(CODEWHEEL_SANITIZERS)
    target_compile_options(codewheel_options INTERFACE
        -fsanitize=${CODEWHEEL_SANITIZERS} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(codewheel_options INTERFACE -fsanitize=${CODEWHEEL_SANITIZERS})
endif()
# A test program is linked in half the time with gold, which comes with the assembler, and with sanitizers, whose symbols gold
# does not know, in a fifth of it with lld.
if(NOT CMAKE_BUILD_TYPE STREQUAL "Release")
    set(codewheel_linker gold)
    if(CODEWHEEL_SANITIZERS)
        set(codewheel_linker lld)
    endif()
    include(CheckLinkerFlag)
    check_linker_flag(CXX -fuse-ld=${codewheel_linker} CODEWHEEL_HAS_FAST_LINKER)
    if(CODEWHEEL_HAS_FAST_LINKER)
        target_link_options(codewheel_options INTERFACE -fuse-ld=${codewheel_linker})
    endif()
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(codewheel_options INTERFACE -fstack-protector-strong -D_FORTIFY_SOURCE=2)
    # GCC 12 gives false warnings about bounds and uninitialized values after heavy inlining; the dev build has them.
    target_compile_options(codewheel_options INTERFACE -Wno-array-bounds
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-stringop-overread -Wno-stringop-overflow -Wno-restrict>)
    target_link_options(codewheel_options INTERFACE -Wl,-z,relro,-z,now)
    # What nobody calls is left out; relocations take a tenth of the room (glibc 2.36, binutils 2.38).
    target_compile_options(codewheel_options INTERFACE -ffunction-sections -fdata-sections)
    target_link_options(codewheel_options INTERFACE -Wl,--gc-sections -Wl,--as-needed)
    include(CheckLinkerFlag)
    check_linker_flag(CXX -Wl,-z,pack-relative-relocs CODEWHEEL_HAS_RELR)
    if(CODEWHEEL_HAS_RELR)
        target_link_options(codewheel_options INTERFACE -Wl,-z,pack-relative-relocs)
    endif()
    # The same sources give the same programs, in whatever folder they are built.
    target_compile_options(codewheel_options INTERFACE
        "-ffile-prefix-map=${PROJECT_BINARY_DIR}=build" "-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.")
endif()

# codewheel_resources(TARGET NAME ...): as qt_add_resources(). Without the times of the files, which are those of the checkout.
set(codewheel_rcc_options --format-version 1)
function(codewheel_resources)
    qt_add_resources(${ARGV} OPTIONS ${codewheel_rcc_options})
endfunction()

# Qt's moc as the libraries use it.
configure_file("${PROJECT_SOURCE_DIR}/cmake/moc.sh.in" "${PROJECT_BINARY_DIR}/moc.sh.in" @ONLY)
file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/moc.sh" INPUT "${PROJECT_BINARY_DIR}/moc.sh.in"
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# codewheel_library(NAME PUBLIC_LIBRARIES...): a static library; its folders add their own sources.
function(codewheel_library name)
    add_library(${name} STATIC)
    set_target_properties(${name} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE "${PROJECT_BINARY_DIR}/moc.sh")
    target_link_libraries(${name} PUBLIC codewheel_options ${ARGN})
    if("Qt6::Widgets" IN_LIST ARGN OR "codewheel_widgets" IN_LIST ARGN)
        target_precompile_headers(${name} REUSE_FROM codewheel_gui_pch)
    else()
        target_precompile_headers(${name} REUSE_FROM codewheel_pch)
    endif()
endfunction()

# codewheel_precompiled(NAME LIBRARY HEADERS...): headers that are compiled once, for all targets that reuse them.
function(codewheel_precompiled name library)
    file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp" CONTENT "")
    add_library(${name} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
    target_link_libraries(${name} PRIVATE codewheel_options ${library})
    target_precompile_headers(${name} PRIVATE ${ARGN})
    set_target_properties(${name} PROPERTIES AUTOMOC OFF UNITY_BUILD OFF)
endfunction()

set(codewheel_std_headers <algorithm> <array> <functional> <map> <memory> <optional> <span> <variant> <vector>
    <tl/expected.hpp>)
codewheel_precompiled(codewheel_pch "Qt6::Core;tl::expected" <QtCore> ${codewheel_std_headers})
codewheel_precompiled(codewheel_gui_pch "Qt6::Widgets;tl::expected" <QtWidgets> ${codewheel_std_headers})
