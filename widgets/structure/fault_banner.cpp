// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/fault_banner.h"

#include "widgets/look/describe.h"
#include "widgets/look/label_text.h"

#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace codewheel {

FaultBanner::FaultBanner(OfferOf offerOf, QWidget *parent)
    : InlineMessage(parent)
    , m_offerOf(std::move(offerOf))
    , m_show(makeButton("showFault", tr("Show"),
                        tr("Chooses the place of the fault, and shows what is known of it")))
    , m_others(makeButton("otherFaults", tr("Other faults"),
                          tr("The other faults; choose one to see where it is")))
{
    setObjectName(QStringLiteral("faultBanner"));
    addButton(m_show);
    connect(m_show, &QToolButton::clicked, this, [this] {
        const OnBus worst = m_faults.front(); // a copy, since showing it may change the list
        Q_EMIT showRequested(worst.bus, worst.fault);
    });
    for (const auto &[action, id] :
         {std::pair(FaultAction::start, "startAgain"), std::pair(FaultAction::switchOff, "switchFaultOff"),
          std::pair(FaultAction::confirm, "confirmFault"),
          std::pair(FaultAction::acknowledge, "acknowledgeWatchdog"), std::pair(FaultAction::run, "sendRun"),
          std::pair(FaultAction::positionMode, "backToPositionMode"),
          std::pair(FaultAction::bringBack, "bringBack")}) {
        QToolButton *button = makeButton(id, tr("What can be done"), tr("What can be done about the fault"));
        addButton(button);
        button->hide(); // all of them together would widen the window
        m_actions.emplace_back(action, button);
        connect(button, &QToolButton::clicked, this, [this, what = action] {
            const OnBus worst = m_faults.front();
            Q_EMIT actionRequested(worst.bus, worst.fault, what);
        });
    }
    m_others->setPopupMode(QToolButton::InstantPopup);
    m_others->setMenu(new QMenu(m_others));
    addButton(m_others);
    connect(m_others->menu(), &QMenu::aboutToShow, this, &FaultBanner::listOthers);
    connect(this, &InlineMessage::closed, this, [this] {
        m_dismissed = m_faults;
        m_told.reset();
    });
}

QToolButton *FaultBanner::makeButton(const char *id, const QString &name, const QString &tip)
{
    auto *button = describe(new QToolButton(this), id, name, tip);
    button->setText(name);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    return button;
}

bool FaultBanner::isDismissed(const OnBus &fault) const
{
    return std::ranges::any_of(m_dismissed, [&](const OnBus &one) { return one.isSameAs(fault); });
}

void FaultBanner::showFaults(const BusFaults &faults, const std::function<QString(BusId)> &nameOf)
{
    m_nameOf = nameOf;
    const bool isSame = m_faults == faults.all();
    m_faults = faults.all();
    std::erase_if(m_dismissed, [this](const OnBus &dismissed) {
        return std::ranges::none_of(m_faults, [&](const OnBus &one) { return one.isSameAs(dismissed); });
    });
    if (std::ranges::all_of(m_faults, [this](const OnBus &one) { return isDismissed(one); })) {
        m_told.reset();
        withdraw();
        return;
    }
    const bool isNews = !isSame || !m_told;
    if (isNews)
        showWorst();
    showOffers();
    if (isNews)
        arrange();
}

QString FaultBanner::textOf(const OnBus &fault) const
{
    const QString bus = m_nameOf(fault.bus);
    return bus.isEmpty() ? fault.fault.text : tr("%1: %2", "bus: its fault").arg(bus, fault.fault.text);
}

void FaultBanner::showWorst()
{
    const OnBus &worst = m_faults.front();
    setDetail(worst.fault.code);
    if (m_told && m_told->isSameAs(worst))
        rephrase(textOf(worst));
    else
        showMessage(worst.fault.shown.role, textOf(worst));
    m_told = worst;
    const auto others = static_cast<int>(m_faults.size()) - 1;
    m_others->setText(tr("%n more", "faults", others));
    m_others->setVisible(others > 0);
}

void FaultBanner::showOffers()
{
    const OnBus &worst = m_faults.front();
    for (const auto &[action, button] : m_actions) {
        const bool isOffered = std::ranges::count(worst.fault.actions, action) > 0;
        button->setVisible(isOffered);
        if (!isOffered)
            continue;
        const Offer offer = m_offerOf(worst.bus, worst.fault, action);
        const QString tip = offer.whyNot.isEmpty() ? offer.tip : offer.whyNot;
        button->setText(offer.text);
        button->setAccessibleName(offer.text);
        button->setEnabled(offer.whyNot.isEmpty());
        if (button->toolTip() != tip)
            button->setToolTip(tip);
    }
}

void FaultBanner::listOthers()
{
    QMenu &menu = *m_others->menu();
    menu.clear();
    for (std::size_t i = 1; i < m_faults.size(); ++i) {
        const OnBus other = m_faults[i];
        QAction *action = menu.addAction(lineIcon(roleIcon(other.fault.shown.role), other.fault.shown.role),
                                         asLabel(textOf(other)));
        connect(action, &QAction::triggered, this,
                [this, other] { Q_EMIT showRequested(other.bus, other.fault); });
    }
}

} // namespace codewheel
