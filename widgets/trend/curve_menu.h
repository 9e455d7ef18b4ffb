// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "history/histories.h"
#include "history/track.h"

#include <QMenu>

#include <functional>

namespace codewheel {

// All curves there can be, by encoder.
class CurveMenu : public QMenu
{
    Q_OBJECT

public:
    // All outlive it.
    CurveMenu(const Buses &buses, const Histories &histories, std::function<QString(Place)> station,
              QWidget *parent = nullptr);

Q_SIGNALS:
    void chosen(const codewheel::Track &track);

private:
    void fill();
    void addEncoder(Place place);
    void addBits(QMenu &menu, Place place, Channel channel);
    void add(QMenu &menu, const QString &text, const Track &track);

    const Buses &m_buses;
    const Histories &m_histories;
    std::function<QString(Place)> m_station;
};

} // namespace codewheel
