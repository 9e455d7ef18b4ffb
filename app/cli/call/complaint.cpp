// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/complaint.h"

#include "doctor/hindrance_of_refusal.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

namespace codewheel {

tl::unexpected<Complaint> badInput(const char *key, const QString &pattern,
                                   std::vector<RefusalArgument> arguments)
{
    const QString text = sentence(pattern, argumentTexts(arguments));
    return tl::unexpected(
        Complaint{ExitCode::badInput, QString::fromLatin1(key), text, std::move(arguments)});
}

Complaint notDone(const char *key, const QString &text, std::vector<RefusalArgument> arguments,
                  const QString &command)
{
    return {ExitCode::refused, QString::fromLatin1(key), text, std::move(arguments), command};
}

Complaint complaintAbout(const Refusal &refusal)
{
    const ExitCode exit = refusal.kind == RefusalKind::badInput ? ExitCode::badInput : ExitCode::refused;
    const auto hindrance = hindranceOf(refusal);
    return {exit, refusalKey(refusal.id), hindrance ? hindrance->sentence : refusalText(refusal),
            refusal.arguments, hindrance ? hindrance->command : QString()};
}

QString commandToCopy(const QString &command)
{
    return command.isEmpty() ? QString() : QStringLiteral("    %1\n").arg(command);
}

} // namespace codewheel
