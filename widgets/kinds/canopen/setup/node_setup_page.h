// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/page.h"

#include <optional>

namespace codewheel {

class CanopenSession;
class NodeSetupView;

// A device on a CAN bus gets its number and rate: a page of the main window.
class NodeSetupPage : public Page
{
    Q_OBJECT

public:
    explicit NodeSetupPage(QWidget *parent = nullptr);

    void setBus(codewheel::CanopenSession *bus); // null: none
    void setAbout(const QString &bus);           // its name
    // Of this node; empty: of one without a number. What runs stays, and what is to be proven of this one.
    void showNode(std::optional<int> node);
    NodeSetupView &view() const { return *m_view; }

    QString title() const override { return tr("Number and rate"); }
    QString about() const override;
    QString effect() const override;
    QString lostByClosing() const override;
    void leave() override;

private:
    NodeSetupView *m_view;
    QString m_bus;
};

} // namespace codewheel
