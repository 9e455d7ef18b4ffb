// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"
#include "catalog/profile.h"

#include <utility>

namespace codewheel {

class AskedBus;

// How a kind of bus whose encoders are asked words its outline.
struct AskedOutlineWords
{
    QString (*title)(const QString &link); // empty: not given
    Profile profile;
    QString (*address)(NodeId node);
    QString (*toolTip)(NodeId node, const QString &called, const QString &state);

    BusNode node(NodeId its, const QString &name) const;
};

// Such a bus, connected, with its encoders in the order of their addresses.
class AskedOutline : public BusOutline
{
public:
    AskedOutline(const AskedOutlineWords &words, const AskedBus &bus) // must outlive it
        : m_words(words)
        , m_bus(bus)
    {}

    QString title() const override;
    std::optional<QString> behindName() const override;
    std::vector<BusNode> nodes() const override;
    using BusOutline::state;
    NodeState state(std::size_t node) const override;
    using BusOutline::toolTip;
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    virtual StateWord shown(Place place) const = 0;

    const AskedOutlineWords m_words;
    const AskedBus &m_bus;
};

// As planned.
class PlannedAskedOutline final : public BusOutline
{
public:
    struct Encoder
    {
        NodeId node;
        QString name;
    };
    // Its link; empty: not given.
    PlannedAskedOutline(const AskedOutlineWords &words, QString link, std::vector<Encoder> encoders)
        : m_words(words)
        , m_link(std::move(link))
        , m_encoders(std::move(encoders))
    {}

    QString title() const override { return m_words.title(m_link); }
    std::optional<QString> behindName() const override { return m_link; }
    QString toolTip() const override { return title(); }
    StateWord state() const override { return offline(); }
    std::vector<BusNode> nodes() const override;
    NodeState state(std::size_t) const override { return {planned(), {}, false}; }
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    const AskedOutlineWords m_words;
    const QString m_link;
    const std::vector<Encoder> m_encoders;
};

} // namespace codewheel
