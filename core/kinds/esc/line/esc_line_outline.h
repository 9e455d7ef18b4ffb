// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"

namespace codewheel {

class EscLineSession;

// A serial line, and its encoders in the order of their addresses.
class EscLineOutline final : public BusOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineOutline)

public:
    explicit EscLineOutline(const EscLineSession &line) // must outlive it
        : m_line(line)
    {}

    QString title() const override;
    std::optional<QString> behindName() const override;
    QString toolTip() const override;
    QString alarmStop() const override;
    StateWord state() const override;
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t node) const override;
    std::vector<Fault> faults() const override;
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    StateWord shown(Place place) const;

    const EscLineSession &m_line;
};

// A line that is not connected.
class PlannedLineOutline final : public BusOutline
{
public:
    struct Encoder
    {
        NodeId node;
        QString name;
    };
    // Its port; empty: not given.
    PlannedLineOutline(QString port, std::vector<Encoder> encoders)
        : m_port(std::move(port))
        , m_encoders(std::move(encoders))
    {}

    QString title() const override;
    std::optional<QString> behindName() const override { return m_port; }
    QString toolTip() const override { return title(); }
    StateWord state() const override { return offline(); }
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t) const override { return {planned(), {}, false}; }
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    const QString m_port;
    const std::vector<Encoder> m_encoders;
};

} // namespace codewheel
