// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/role.h"
#include "widgets/kinds/interbus/offer/offer_wish.h"
#include "widgets/look/page.h"
#include "widgets/look/trouble.h"

#include <optional>

class QPushButton;
class QStackedWidget;

namespace codewheel {

class InlineMessage;
class OfferForm;
class OfferedView;
struct OfferedPlace;

// A simulated ring is offered to others: first where and how, then who uses it. Knows no server; whoever owns
// it carries out what is wanted and shows what comes of it.
class OfferPage : public Page
{
    Q_OBJECT

public:
    explicit OfferPage(QWidget *parent = nullptr);

    QString title() const override { return tr("Offer to others"); }
    QString effect() const override;

    OfferForm &form() { return *m_form; }
    OfferedView &offered() { return *m_offered; }
    void setPlace(const std::optional<OfferedPlace> &place); // empty: it is not offered
    void setProblem(const Trouble &trouble);                 // empty: none
    void tell(Role role, const QString &sentence);           // what came of what was wanted
    // Why it cannot be offered; empty: it can.
    void setWhyNot(const QString &sentence);

Q_SIGNALS:
    void offerWanted(const codewheel::OfferWish &wish);
    void endWanted();
    void filesWanted(); // for those who use it

private:
    void offer();
    void showButtons();

    QString m_whyNot;
    OfferForm *m_form;
    OfferedView *m_offered;
    QStackedWidget *m_parts;
    InlineMessage *m_problem;
    QPushButton *m_offer;
    QPushButton *m_end;
    QPushButton *m_files;
    bool m_isOffered = false;
};

} // namespace codewheel
