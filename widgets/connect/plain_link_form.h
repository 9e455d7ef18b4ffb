// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/connect/link_form.h"

#include <functional>

namespace codewheel {

// A link without settings, such as a simulated bus.
class PlainLinkForm : public LinkForm
{
    Q_OBJECT

public:
    // `plan` empty: a link that is not planned in a project. `isMeant`: the plans that mean this link; by
    // default that one alone.
    using IsMeant = std::function<bool(const KindData &)>;
    PlainLinkForm(QString title, QString sentence, KindData plan, QWidget *parent = nullptr,
                  IsMeant isMeant = {});

    QString title() const override { return m_title; }
    QString sentence() const override { return m_sentence; }
    bool canBeKept() const override { return m_plan != KindData(); }
    bool showPlan(const KindData &plan) override { return m_isMeant ? m_isMeant(plan) : plan == m_plan; }
    KindData plan() const override { return m_plan; }

private:
    QString m_title;
    QString m_sentence;
    KindData m_plan;
    IsMeant m_isMeant;
};

} // namespace codewheel
