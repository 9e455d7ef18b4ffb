// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/complaint.h"

#include "encoder/refusal_text.h"
#include "encoder/sentence.h"

namespace codewheel {

tl::unexpected<Complaint> badInput(const QString &key, const QString &pattern,
                                   std::vector<RefusalArgument> arguments)
{
    const QString text = sentence(pattern, argumentTexts(arguments));
    return tl::unexpected(Complaint{ExitCode::badInput, key, text, std::move(arguments)});
}

Complaint complaintAbout(const Refusal &refusal)
{
    const ExitCode exit = refusal.kind == RefusalKind::badInput ? ExitCode::badInput : ExitCode::refused;
    return {exit, refusalKey(refusal.id), refusalText(refusal), refusal.arguments};
}

} // namespace codewheel
