// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link_argument.h"
#include "can/can_refusals.h"

#include <span>

namespace codewheel {

// A setting of a link to a CAN bus, said once: project files, the command line and the forms of the window
// take it from here. All are whole numbers, in Bd.
struct CanSetting
{
    const char *key; // in files and on the command line
    int CanLinkArgument::*its;
    int least;
    int most;
    int usual;
    std::span<const int> ofAdapters; // those that serial adapters have; empty: any within the limits
    CanRefusalId wrong;              // what a serial adapter cannot take is refused with
    const char *labelOfForm;
    const char *sentenceOfForm;

    bool isWithin(int value) const { return value >= least && value <= most; }
    bool hasAdapter(int value) const; // whether serial adapters can be set to it
    QString label() const;            // with a mnemonic
    QString sentence() const;         // what it is for
};

std::span<const CanSetting> canSettings();
const CanSetting *canSetting(QStringView key); // null: there is none
inline constexpr char canRateKey[] = "rate";
inline constexpr char canBaudKey[] = "baud";

} // namespace codewheel
