// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace codewheel::test {

// An encoder on a bus of the tests' own, which answers each line with one.
class PlainPeer
{
public:
    using Values = std::map<QByteArray, QByteArray>;

    virtual ~PlainPeer() = default;
    virtual QByteArray answer(const QByteArray &line) = 0;
    virtual void switchOffAndOn() = 0;

    void turn(std::int64_t steps) { m_position += steps; }
    std::int64_t position() const { return m_position; }
    QByteArray inForce(const QByteArray &key) const { return m_inForce.at(key); }
    const std::vector<QByteArray> &heard() const { return m_heard; }

protected:
    explicit PlainPeer(Values inForce)
        : m_inForce(std::move(inForce))
    {}

    Values m_inForce;
    std::int64_t m_position = 0;
    std::vector<QByteArray> m_heard;
};

} // namespace codewheel::test
