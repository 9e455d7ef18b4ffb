// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/octets.h"

#include <array>
#include <optional>

namespace codewheel::canopen {

// What LSS sets of a node: its number, empty where it has none, and its rate.
struct NodeSettings
{
    std::optional<int> node{};
    int rate = 125'000; // Bd

    friend bool operator==(const NodeSettings &, const NodeSettings &) = default;
};

// The side of a node in LSS (CiA 305).
class LssSlave
{
public:
    using Identity = std::array<std::uint32_t, 4>; // vendor, product, revision, serial
    using Frame = std::array<std::uint8_t, 8>;

    enum class Event : std::uint8_t {
        none,
        store,        // the settings
        activateRate, // after delay(), and nothing is sent for as long again
        leaves,       // the state of configuration
    };
    struct Outcome
    {
        std::optional<Frame> answer{};
        Event event = Event::none;
    };

    LssSlave(const Identity &identity, NodeSettings settings);

    Outcome take(Octets frame);
    // What it has been set to; in force after a reset, or activation.
    const NodeSettings &settings() const { return m_settings; }
    void setSettings(NodeSettings settings) { m_settings = settings; }
    // What the node is at present: one without a number answers a fast scan.
    void setNode(std::optional<int> node) { m_node = node; }
    int delay() const { return m_delay; } // ms
    void reset();

private:
    struct Row;
    static const std::array<Row, 16> rows;

    Outcome switchAll(const Frame &frame);
    Outcome select(const Frame &frame);
    Outcome setNumber(const Frame &frame);
    Outcome setRate(const Frame &frame);
    Outcome activate(const Frame &frame);
    Outcome store(const Frame &frame);
    Outcome inquireIdentity(const Frame &frame);
    Outcome inquireNode(const Frame &frame);
    Outcome identifyUnconfigured(const Frame &frame);
    Outcome fastScan(const Frame &frame);

    Identity m_identity;
    NodeSettings m_settings;
    std::optional<int> m_node;
    bool m_isConfiguring = false;
    std::size_t m_matched = 0; // words of a selection by identity, in their order
    std::size_t m_scanned = 0; // the word that a fast scan is at
    int m_delay = 0;
};

} // namespace codewheel::canopen
