# SPDX-License-Identifier: GPL-3.0-or-later
# codewheel_VERSION_ARCHITECTURE.deb, by cpack; see tools/package.

# codewheel_packages(VARIABLE PURPOSES...): those that tools/packages lists for these purposes, for a field of the package.
function(codewheel_packages variable)
    list(JOIN ARGN "|" purposes)
    file(STRINGS "${PROJECT_SOURCE_DIR}/tools/packages" lines REGEX "^(${purposes}) ")
    list(TRANSFORM lines REPLACE "^[a-z]+ +" "")
    list(JOIN lines ", " packages)
    set(${variable} "${packages}" PARENT_SCOPE)
endfunction()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME codewheel)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Codewheel developers <codewheel@example.org>")
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "set up, watch and diagnose absolute encoders")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Codewheel sets up, watches and diagnoses absolute encoders on INTERBUS,
through Modbus gateways, and on serial lines: for the engineer who commissions
a machine, for the technician who replaces an encoder at night, and for
everybody who wants to learn what the bits of an encoder do.

It comes with a training bus of simulated encoders, so that no hardware is
needed to try it. Beside the program with a window there is codewheel-cli, for
terminals and scripts.")
# Libraries are found in the programs; the others are plugins and fonts.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
codewheel_packages(CPACK_DEBIAN_PACKAGE_DEPENDS run)
codewheel_packages(CPACK_DEBIAN_PACKAGE_RECOMMENDS server doctor)
codewheel_packages(CPACK_DEBIAN_PACKAGE_SUGGESTS wayland)
include(CPack)
