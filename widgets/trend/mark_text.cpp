// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/refusal_text.h"
#include "widgets/trend/track_text.h"

namespace codewheel {

QString markText(const Mark &mark)
{
    if (const auto *note = std::get_if<QString>(&mark.what))
        return *note;
    const QString text = messageText(std::get<Message>(mark.what));
    const QString place = mark.place ? mark.place->shown() : QString();
    return place.isEmpty() ? text : QStringLiteral("%1: %2").arg(place, text);
}

QColor markColor(const Mark &mark, const QPalette &palette)
{
    const auto *message = std::get_if<Message>(&mark.what);
    if (message == nullptr)
        return roleColor(Role::setBit, palette);
    switch (message->severity) {
    case Severity::fault:
        return roleColor(Role::fault, palette);
    case Severity::attention:
        return roleColor(Role::attention, palette);
    case Severity::information:
        break;
    }
    return roleColor(Role::inactive, palette);
}

} // namespace codewheel
