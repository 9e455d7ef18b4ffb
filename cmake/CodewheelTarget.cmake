# SPDX-License-Identifier: GPL-3.0-or-later
# What all our own targets have in common: warnings, definitions, hardening, sanitizers.

option(CODEWHEEL_WERROR "Treat warnings in our own code as errors" OFF)
set(CODEWHEEL_SANITIZERS "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")

add_library(codewheel_options INTERFACE)
target_compile_definitions(codewheel_options INTERFACE
    QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_KEYWORDS QT_NO_FOREACH QT_DISABLE_DEPRECATED_BEFORE=0x060400)
target_compile_options(codewheel_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<BOOL:${CODEWHEEL_WERROR}>:-Werror>)

if(CODEWHEEL_SANITIZERS)
    target_compile_options(codewheel_options INTERFACE
        -fsanitize=${CODEWHEEL_SANITIZERS} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(codewheel_options INTERFACE -fsanitize=${CODEWHEEL_SANITIZERS})
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(codewheel_options INTERFACE -fstack-protector-strong -D_FORTIFY_SOURCE=2)
    target_link_options(codewheel_options INTERFACE -Wl,-z,relro,-z,now)
endif()

# codewheel_library(NAME PUBLIC_LIBRARIES...): a static library; its folders add their own sources.
function(codewheel_library name)
    add_library(${name} STATIC)
    target_link_libraries(${name} PUBLIC codewheel_options ${ARGN})
    if(CODEWHEEL_SANITIZERS)
        codewheel_precompile(${name} ${ARGN})
    endif()
endfunction()

# Sanitizers double what a file takes to compile; precompiled headers give that back. The other builds go without, so that
# they show which file lacks an include of its own.
function(codewheel_precompile name)
    set(qt <QtCore>)
    if("Qt6::Widgets" IN_LIST ARGN OR "codewheel_widgets" IN_LIST ARGN)
        set(qt <QtWidgets>)
    endif()
    target_precompile_headers(${name} PRIVATE
        ${qt} <algorithm> <array> <functional> <map> <memory> <optional> <span> <variant> <vector> <tl/expected.hpp>)
endfunction()
