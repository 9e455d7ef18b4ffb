// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/lss_selection.h"

namespace codewheel::canopen {

LssSelection::LssSelection(By by, const std::optional<NodeIdentity> &identity)
    : m_by(by)
    , m_wanted(identity)
{}

std::optional<LssRequest> LssSelection::next() const
{
    switch (m_step) {
    case Step::operateAll:
        return LssRequest{.kind = LssRequest::Kind::operateAll};
    case Step::select:
        return m_by == By::alone ? LssRequest{.kind = LssRequest::Kind::configureAll}
               : m_wanted        ? LssRequest{.kind = LssRequest::Kind::select, .identity = *m_wanted}
                                 : LssRequest{.kind = LssRequest::Kind::fastScan};
    case Step::identity:
        return LssRequest{.kind = LssRequest::Kind::inquireIdentity};
    case Step::node:
        return LssRequest{.kind = LssRequest::Kind::inquireNode};
    case Step::end:
        break;
    }
    return std::nullopt;
}

void LssSelection::take(const LssOutcome &outcome)
{
    switch (m_step) {
    case Step::operateAll: // whom somebody else has left in configuration would take what is for this one
        m_step = Step::select;
        break;
    case Step::select:
        takeSelected(outcome);
        break;
    case Step::identity:
    case Step::node:
        takeTold(outcome);
        break;
    case Step::end:
        break;
    }
}

void LssSelection::stop(Trouble trouble)
{
    m_trouble = trouble;
    m_step = Step::end;
}

void LssSelection::takeSelected(const LssOutcome &outcome)
{
    if (outcome.kind != LssOutcome::Kind::done) {
        stop(outcome.kind == LssOutcome::Kind::notSent ? Trouble::notSent
             : outcome.isIncomplete                    ? Trouble::lost
                                                       : Trouble::nobody);
        return;
    }
    if (m_by == By::fastScan && !m_wanted) // in a search each of them answers
        m_wanted = outcome.identity;
    else
        m_extraAnswers += outcome.extraAnswers;
    m_step = Step::identity;
}

void LssSelection::takeTold(const LssOutcome &outcome)
{
    m_extraAnswers += outcome.extraAnswers;
    if (outcome.kind != LssOutcome::Kind::done) {
        stop(m_by == By::alone ? Trouble::nobody : Trouble::notTold);
    } else if (m_step == Step::identity) {
        m_identity = outcome.identity;
        m_step = Step::node;
    } else {
        m_node = outcome.node;
        m_step = Step::end;
        compare();
    }
}

void LssSelection::compare()
{
    if (m_wanted.value_or(m_identity) != m_identity)
        m_trouble = Trouble::isOther;
    else if (m_extraAnswers > 0)
        m_trouble = Trouble::several;
}

} // namespace codewheel::canopen
