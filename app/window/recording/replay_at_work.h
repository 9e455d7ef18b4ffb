// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_at_work.h"
#include "replay/replay_bus.h"

namespace codewheel {

// One bus of a recording in the program; no project plans it, and it has no account. Made by Recordings.
class ReplayAtWork final : public BusAtWork
{
    Q_OBJECT

public:
    ReplayAtWork(Surroundings surroundings, std::unique_ptr<ReplayBus> bus, QObject *parent = nullptr)
        : BusAtWork(bus->id(), std::move(surroundings), parent)
        , m_bus(std::move(bus))
    {}

    static QString kindKey() { return QStringLiteral("recording"); }
    QString kind() const override { return kindKey(); }
    bool isTraining() const override { return false; }
    QString nameOfNew() const override { return m_bus->title(); }
    EncoderBus *bus() const override { return m_bus.get(); }
    ReplayBus &session() const { return *m_bus; }

Q_SIGNALS:
    void closeRequested();

private:
    const std::unique_ptr<ReplayBus> m_bus;
};

} // namespace codewheel
