// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// How the program ends; scripts rely on the numbers. `refused`: not done, not known whether it was done, or
// done but not reported, since standard output could not be written.
enum class ExitCode { done = 0, refused = 1, badInput = 2 };

// Why a call was not carried out: a sentence for people, a key and arguments for programs.
struct Complaint
{
    ExitCode exit = ExitCode::badInput;
    QString key;
    QString text; // what was wrong and what would be right
    std::vector<RefusalArgument> arguments{};
    QString command{}; // that helps, for a terminal; empty: none
};

template <typename T>
using Checked = tl::expected<T, Complaint>;

// Bad input of the call itself. `pattern` is a translated sentence with %1.. for the arguments.
tl::unexpected<Complaint> badInput(const char *key, const QString &pattern,
                                   std::vector<RefusalArgument> arguments = {});

// What was refused, or is not known to be done.
Complaint notDone(const char *key, const QString &text, std::vector<RefusalArgument> arguments = {},
                  const QString &command = {});

// What core refused: exit 2 if the input is to blame, 1 if encoder or bus are. Where this computer knows more
// of the cause, such as the program that has the port, the sentence is that of the doctor.
Complaint complaintAbout(const Refusal &refusal);

// To be copied, in a line of its own; empty if there is none.
QString commandToCopy(const QString &command);

} // namespace codewheel
