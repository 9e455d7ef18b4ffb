// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/check_outcome.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>

#include <atomic>
#include <optional>
#include <vector>

namespace codewheel {

// What a step of a LinkCheck found.
template <class Step, class Address>
struct LinkFinding
{
    Step step{};
    Address address{}; // of an encoder; 0: whichever there is
    CheckOutcome outcome = CheckOutcome::skipped;
    QString sentence{};
    std::optional<Refusal> why{}; // of a link that cannot be opened

    friend bool operator==(const LinkFinding &, const LinkFinding &) = default;
};

// What each of them says of a step that was not made.
class LinkCheckTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::LinkCheckTexts)

public:
    static QString stopped() { return tr("Not tested: the test was ended."); }
    static QString notTested() { return tr("Not tested, because of what failed before."); }
};

// The course of a test of the link to a bus whose encoders are asked, step by step. Each next() does one
// step, so its caller can show what was found so far; interrupt() ends a step that waits. A kind says what
// its steps do.
template <class Link, class Step, class Address>
class LinkCheck
{
public:
    using Finding = LinkFinding<Step, Address>;

    virtual ~LinkCheck() { m_link.close(); }
    Q_DISABLE_COPY_MOVE(LinkCheck)

    bool isDone() const { return m_next == m_steps.size(); }
    Finding next()
    {
        Finding finding = m_isStopped ? stopped()
                          : m_isOver  ? told(CheckOutcome::skipped, LinkCheckTexts::notTested())
                                      : found(m_steps[m_next].step, m_steps[m_next].address);
        ++m_next;
        if (isDone())
            m_link.close();
        return finding;
    }
    void interrupt() // skips what is left. Any thread
    {
        m_isStopped = true;
        m_link.interrupt();
    }

protected:
    // `link` must outlive this and is used by nobody else meanwhile.
    LinkCheck(Link &link, std::vector<Finding> steps)
        : m_link(link)
        , m_steps(std::move(steps))
    {}

    Link &link() const { return m_link; }
    const std::atomic<bool> &isStopped() const { return m_isStopped; }
    void endHere() { m_isOver = true; } // nothing further can be found out
    void addStep(Step step, Address address = {}) { m_steps.push_back({step, address}); }

    Finding told(CheckOutcome outcome, const QString &sentence) const
    {
        Finding finding = m_steps[m_next];
        finding.outcome = outcome;
        finding.sentence = sentence;
        return finding;
    }
    Finding stopped() const { return told(CheckOutcome::skipped, LinkCheckTexts::stopped()); }
    Finding refused(const Refusal &why)
    {
        m_isOver = true;
        Finding finding = told(CheckOutcome::failed, refusalText(why));
        finding.why = why;
        return finding;
    }

private:
    virtual Finding found(Step step, Address address) = 0;

    Link &m_link;
    std::vector<Finding> m_steps; // not made yet
    std::size_t m_next = 0;
    bool m_isOver = false;
    std::atomic<bool> m_isStopped = false;
};

} // namespace codewheel
