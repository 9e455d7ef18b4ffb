// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/complaint.h"

#include <QStringList>

#include <map>
#include <span>

namespace codewheel {

// An option of a command. Without a name for its value it is a switch.
struct Option
{
    const char *name;  // "--dry-run"
    const char *value; // "SECONDS"; null: none
    const char *help;  // untranslated; null for another form of the previous option
};

// The words after the name of a command, sorted into options and the rest.
struct Arguments
{
    QStringList rest;
    std::map<QString, QString> options; // "--for" -> "10"; a switch has an empty value

    bool has(const char *option) const;
    std::optional<QString> value(const char *option) const;
    // A whole number within this range, or `otherwise` if the option is not given.
    Checked<int> number(const char *option, int otherwise, int minimum, int maximum) const;
};

// Accepts "--name value" and "--name=value" anywhere, each once; what follows "--" is not an option. `who`
// has these options, for the sentence: "write".
Checked<Arguments> parseArguments(const QStringList &words, std::span<const Option> options,
                                  const QString &who);

} // namespace codewheel
