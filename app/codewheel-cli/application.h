// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <memory>

namespace codewheel {

// What Qt needs of a program. For a PDF it is one with fonts, which neither looks for a screen nor needs one.
// argc and argv must outlive it.
std::unique_ptr<QCoreApplication> makeApplication(int &argc, char **argv);

} // namespace codewheel
