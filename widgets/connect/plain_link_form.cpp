// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connect/plain_link_form.h"

#include <utility>

namespace codewheel {

PlainLinkForm::PlainLinkForm(QString title, QString sentence, KindData plan, QWidget *parent, IsMeant isMeant)
    : LinkForm(parent)
    , m_title(std::move(title))
    , m_sentence(std::move(sentence))
    , m_plan(std::move(plan))
    , m_isMeant(std::move(isMeant))
{}

} // namespace codewheel
