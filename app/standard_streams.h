// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// First of all in main(). A standard stream that is closed is opened, so that every use of it fails: else its
// number would go to the next file or port that is opened, which would get what is said there. Writing to a
// pipe without a reader and to a file that may not grow fails too, in place of ending the program.
void prepareStandardStreams();

} // namespace codewheel
