// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace codewheel::test {

// An encoder of the tests' own kind as a peer. It is asked in lines: "get steps", "set steps=100 2000:1=-5"
// (up to three values), "go" (what it was given is in force), "keep" (what is in force is stored), "to 500"
// (that is its position now). What is not stored is gone when it was switched off.
class PlainNode
{
public:
    using Values = std::map<QByteArray, QByteArray>;

    explicit PlainNode(Values stored)
        : m_stored(std::move(stored))
        , m_inForce(m_stored)
    {}

    QByteArray answer(const QByteArray &line);
    void switchOffAndOn();
    void turn(std::int64_t steps) { m_position += steps; }

    std::int64_t position() const { return m_position; }
    bool isGiven() const { return !m_given.empty(); } // and not gone with
    int writes() const { return m_writes; }           // to its EEPROM
    QByteArray inForce(const QByteArray &key) const { return m_inForce.at(key); }
    const std::vector<QByteArray> &heard() const { return m_heard; }

private:
    QByteArray give(const QByteArray &values);

    Values m_stored;
    Values m_inForce;
    Values m_given;
    std::int64_t m_position = 0;
    int m_writes = 0;
    std::vector<QByteArray> m_heard;
};

} // namespace codewheel::test
