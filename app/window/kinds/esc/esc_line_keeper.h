// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_keeper.h"
#include "kinds/esc/plan/esc_line_plan.h"

namespace codewheel {

class EscLineAtWork;

// What is kept of a serial line. Used by EscLineViews.
class EscLineKeeper : public AskedBusKeeper
{
    Q_OBJECT

public:
    explicit EscLineKeeper(const EscLineAtWork &line, QObject *parent = nullptr); // which must outlive it

    EscLinePlan line() const { return *plan().as<EscLinePlan>(); }

    void keepFractionBits(int bits);
    void keepBaudRate(int baudRate);
    // Whether this encoder sends the bytes of its warnings in the other order.
    void keepByteOrder(Place number, bool isSwapped);
    // Everything planned and known of the encoder moves along; the new address is no longer wanted.
    void moveEncoder(Place from, Place to);

private:
    void takeUp(ProjectDevice &encoder, const EncoderSession &connected) const override;

    const EscLineAtWork &m_line;
};

} // namespace codewheel
