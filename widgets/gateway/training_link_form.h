// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/connect/link_form.h"

namespace codewheel {

// The training bus as a kind of link: it has no settings. Its plan is a ProjectLink.
class TrainingLinkForm final : public LinkForm
{
    Q_OBJECT

public:
    using LinkForm::LinkForm;

    QString title() const override;
    QString sentence() const override;
    bool show(const KindData &plan) override;
    KindData plan() const override;
};

} // namespace codewheel
