// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/found.h"

#include "finder/finder_texts.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {

QString certaintyKey(Certainty certainty)
{
    return certainty == Certainty::certain ? QStringLiteral("certain") : QStringLiteral("likely");
}

QString certaintyText(Certainty certainty)
{
    return certainty == Certainty::certain ? FinderTexts::tr("certain") : FinderTexts::tr("likely");
}

QString formatText(const SerialSettings &settings)
{
    return QStringLiteral("%1 Bd, %2").arg(settings.baudRate).arg(settings.format());
}

FinderNews refusedNews(const QString &place, const Refusal &why)
{
    return {.kind = FinderNews::Kind::refused, .place = place, .sentence = refusalText(why), .why = why};
}

} // namespace codewheel
