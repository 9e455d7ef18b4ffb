// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_faults.h"
#include "widgets/look/inline_message.h"

#include <functional>

class QToolButton;

namespace codewheel {

// The worst fault of all buses: a sentence that says what is wrong, where, and what to do, with the manual's
// code small after it; what can be done from here; and the other faults, one click away. If the user closes
// it, it comes back for another fault.
class FaultBanner : public InlineMessage
{
    Q_OBJECT

public:
    // An action, and whether it is available now.
    struct Offer
    {
        QString text;
        QString tip;
        QString whyNot{}; // empty: it is available
    };
    using OfferOf = std::function<Offer(BusId bus, const Fault &fault, FaultAction action)>;

    FaultBanner(OfferOf offerOf, QWidget *parent = nullptr);

    // Worst first; `nameOf`: the name of a bus, if it has to be given.
    void showFaults(const BusFaults &faults, const std::function<QString(BusId)> &nameOf);

Q_SIGNALS:
    void showRequested(codewheel::BusId bus, const codewheel::Fault &fault);
    void actionRequested(codewheel::BusId bus, const codewheel::Fault &fault, codewheel::FaultAction action);

private:
    using OnBus = BusFaults::OnBus;

    void showWorst();
    void showOffers();
    void listOthers();
    QToolButton *makeButton(const char *id, const QString &name, const QString &tip);
    QString textOf(const OnBus &fault) const;
    bool isDismissed(const OnBus &fault) const;

    const OfferOf m_offerOf;
    std::function<QString(BusId)> m_nameOf;
    std::vector<OnBus> m_faults;
    std::vector<OnBus> m_dismissed;
    std::optional<OnBus> m_told; // last announced to screen readers
    QToolButton *m_show;
    std::vector<std::pair<FaultAction, QToolButton *>> m_actions;
    QToolButton *m_others;
};

} // namespace codewheel
