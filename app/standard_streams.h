// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// First thing in main(). A closed standard stream is opened so that every use of it fails: otherwise its
// number would go to the next file or port opened, which would get the output. Writing to a pipe without a
// reader, or to a file at its size limit, also fails instead of ending the program.
void prepareStandardStreams();

} // namespace codewheel
