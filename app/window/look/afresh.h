// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

class EncoderBus;

// A simulated bus begins anew, with everything as at the start: what its command says, in the panel Training
// and in the menu.
class Afresh
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Afresh)

public:
    // Why it cannot now, in a sentence; empty: it can. Null: there is no bus.
    static QString whyNot(const EncoderBus *bus);
    // What it does, or why not.
    static QString tip(const QString &whyNot);
};

} // namespace codewheel
