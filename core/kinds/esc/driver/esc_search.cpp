// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_search.h"

#include <QStringList>

namespace codewheel {

bool EscSearch::isTheOne(const esc::ExchangeResult &result) const
{
    if (!result.answer)
        return false;
    return !m_serialNumber || (result.answer->kind == esc::Answer::Kind::value &&
                               std::int64_t{result.answer->value} == *m_serialNumber);
}

EscSearch::State EscSearch::answered(const esc::ExchangeResult &result)
{
    if (isTheOne(result))
        return State::found;
    if (--m_left <= 0)
        return State::nowhere;
    m_index = (m_index + 1) % m_places.size();
    return State::searching;
}

QString EscSearch::placesText() const
{
    QStringList texts;
    for (const Place &place : m_places)
        texts << (place.baudRate ? QStringLiteral("%1, %2 Bd").arg(place.address.shown()).arg(*place.baudRate)
                                 : place.address.shown());
    return texts.join(QStringLiteral("; "));
}

} // namespace codewheel
