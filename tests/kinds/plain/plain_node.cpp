// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/plain_node.h"

#include <QList>

#include <utility>

namespace codewheel::test {

QByteArray PlainNode::answer(const QByteArray &line)
{
    const QByteArray answer = carryOut(line);
    return line == m_lost ? QByteArray() : answer;
}

QByteArray PlainNode::carryOut(const QByteArray &line)
{
    m_heard.push_back(line);
    const QByteArray word = line.split(' ').front();
    const QByteArray rest = line.mid(word.size() + 1);
    if (word == "get")
        return m_inForce.contains(rest) ? rest + '=' + m_inForce.at(rest) : "no " + rest;
    if (word == "set")
        return give(rest);
    if (word == "to")
        m_position = rest.toLongLong();
    if (word == "go")
        for (const auto &[key, value] : std::exchange(m_given, {}))
            m_inForce[key] = value;
    if (word == "keep") {
        m_stored = m_inForce;
        ++m_writes;
    }
    return "ok";
}

QByteArray PlainNode::give(const QByteArray &values)
{
    for (const QByteArray &one : values.split(' ')) {
        const QByteArray key = one.left(one.indexOf('='));
        if (!m_inForce.contains(key))
            return "no " + key;
        m_given[key] = one.mid(key.size() + 1);
    }
    return "ok";
}

void PlainNode::switchOffAndOn()
{
    m_inForce = m_stored;
    m_given.clear();
}

} // namespace codewheel::test
