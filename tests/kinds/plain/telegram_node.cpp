// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/telegram_node.h"

#include <QList>

namespace codewheel::test {

QByteArray TelegramNode::answer(const QByteArray &line)
{
    if (line == "at")
        return m_isGiven ? "at " + QByteArray::number(qlonglong(m_position)) : "none";
    m_heard.push_back(line);
    return take(line.mid(4));
}

QByteArray TelegramNode::take(const QByteArray &values)
{
    Values given;
    for (const QByteArray &one : values.split(' ')) {
        const QByteArray key = one.left(one.indexOf('='));
        given[key] = one.mid(key.size() + 1);
    }
    for (const auto &[key, usual] : m_factory)
        if (!given.contains(key) || m_refused.contains(key))
            return "no " + key;
    m_inForce = given;
    m_isGiven = true;
    return "ok";
}

void TelegramNode::switchOffAndOn()
{
    m_inForce = m_factory;
    m_isGiven = false;
}

} // namespace codewheel::test
