// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gateway/training_link_form.h"

#include "project/ring_plan.h"

namespace codewheel {

QString TrainingLinkForm::title() const
{
    return tr("Training bus");
}

QString TrainingLinkForm::sentence() const
{
    return tr("A simulated ring in this program. Nothing leaves this computer.");
}

bool TrainingLinkForm::show(const KindData &plan)
{
    const auto *link = plan.as<ProjectLink>();
    return link != nullptr && link->kind == ProjectLink().kind;
}

KindData TrainingLinkForm::plan() const
{
    return KindData(ProjectLink());
}

} // namespace codewheel
