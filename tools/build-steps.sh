# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The steps that the tools share. Sourced by them, never run by itself; works from any folder.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

# ccache is used if present; with precompiled headers it has to be told what to ignore.
if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros,include_file_mtime,include_file_ctime}
fi

# clang++ compiles these sources in half the time of g++. A preset or folder that has its compiler keeps it.
if [[ -z ${CXX:-} ]] && command -v clang++ >/dev/null; then
    export CXX=clang++
fi

# install_packages PURPOSE...: see tools/packages.
install_packages() {
    "$root/tools/install-packages" "$@"
}

# configure PRESET [CMAKE ARGUMENT...]
configure() {
    (cd "$root" && cmake --preset "$@" --log-level=NOTICE)
}

# Whether the preset's build folder still matches the presets; ninja notices changes of CMakeLists.txt files by itself.
is_configured() {
    local build="$root/build/$1/build.ninja"
    [[ -f $build && ! $root/CMakePresets.json -nt $build ]]
}

# build PRESET [TARGET...]: all targets if none is named.
build() {
    local preset=$1
    shift
    local targets=()
    [[ $# -eq 0 ]] || targets=(--target "$@")
    cmake --build "$root/build/$preset" --parallel "$jobs" "${targets[@]}"
}

# source_files PATTERN...: what git tracks, or would if it were added, relative to the root.
source_files() {
    (cd "$root" && git ls-files -co --exclude-standard -- "$@" |
        while read -r file; do [[ ! -f $file ]] || echo "$file"; done)
}
