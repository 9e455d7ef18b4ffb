// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/why/why_page.h"

#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/role_label.h"
#include "widgets/why/data_check_model.h"

#include <QHeaderView>
#include <QRegularExpression>
#include <QTableView>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

const DataCheck *firstRemark(const DataChecks &checks)
{
    const auto first = std::ranges::find(checks, DataCheck::Outcome::remark, &DataCheck::outcome);
    return first == checks.end() ? nullptr : &*first;
}

QString withoutNumbers(QString text)
{
    return text.remove(QRegularExpression(QStringLiteral("[0-9]")));
}

// What came may be counted in it.
bool isSameHelp(const DataCheck &one, const DataCheck &other)
{
    return one.id == other.id && one.action == other.action && one.why == other.why &&
           withoutNumbers(one.remedy) == withoutNumbers(other.remedy);
}

// "Data comes. Position: 12,345".
QString withPosition(const QString &said, const DataChecks &checks)
{
    const DataCheck *position = findCheck(checks, DataCheck::Id::position);
    return position == nullptr ? said
                               : sentence(WhyPage::tr("%1. Position: %2", "a sentence without its full stop"),
                                          {said, position->came});
}

} // namespace

WhyPage::WhyPage(Helpers helpers, QWidget *parent)
    : Page(parent)
    , m_helpers(std::move(helpers))
    , m_model(new DataCheckModel(this))
    , m_outcome(named(new RoleLabel(this), "whyOutcome"))
    , m_help(named(new InlineMessage(this), "whyHelp"))
    , m_table(describe(new QTableView(this), "whySteps", tr("Expected and came, step by step"),
                       tr("What is expected on the way of the data, and what came.")))
    , m_empty(
          new EmptyState(Icon::question, tr("Nothing is chosen"),
                         tr("Choose a device or a bus in the bus structure. If it is empty, connect a bus "
                            "first, or search with \"Who is there?\"."),
                         this))
{
    m_table->setModel(m_model);
    FittedColumns::useIn(*m_table, DataCheckModel::cameColumn); // nothing is cut off
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setIconSize({grid::smallIcon, grid::smallIcon});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setFocusProxy(m_table);
    layOutColumn(this, {{m_outcome, 0, Qt::AlignLeft}, m_help, {m_empty, 1}, {m_table, 1}},
                 {.spacing = grid::unit, .margins = allAround(grid::margin)});
    connect(m_help, &InlineMessage::actionTriggered, this, [this] { Q_EMIT actionWanted(m_helped.action); });
    showChecks({}, {});
}

QString WhyPage::effect() const
{
    return tr("Only looks at what is known. Nothing is sent here.");
}

void WhyPage::showChecks(const QString &about, const DataChecks &checks)
{
    if (about != this->about())
        showHelp(nullptr); // of another device: a message that was closed comes again
    setAbout(about);
    m_empty->setVisible(checks.empty());
    m_table->setVisible(!checks.empty());
    m_outcome->setVisible(!checks.empty());
    m_model->show(checks);
    showOutcome(checks);
}

void WhyPage::showOutcome(const DataChecks &checks)
{
    const DataCheck *first = firstDifference(checks);
    const DataCheck *remark = firstRemark(checks);
    const DataCheck *position = findCheck(checks, DataCheck::Id::position);
    const bool isDoubtful = position != nullptr && position->outcome == DataCheck::Outcome::remark;
    if (first != nullptr)
        m_outcome->setState(Role::fault, sentence(tr("What differs first: %1"), {first->what}));
    else
        m_outcome->setState(
            isDoubtful ? Role::attention : Role::running,
            withPosition(remark != nullptr ? tr("Data comes") : tr("Everything is as expected"), checks));
    showHelp(first != nullptr ? first : remark);
}

// Anew only when it has become another one: looking at the computer takes time, and screen readers are
// alerted.
void WhyPage::showHelp(const DataCheck *check)
{
    if (check == nullptr) {
        m_helped = {};
        m_help->withdraw();
        return;
    }
    const QString button = m_helpers.buttonFor(check->action);
    if (isSameHelp(*check, m_helped) && button == m_button) {
        if (!check->why && check->remedy != m_helped.remedy && !m_help->sentence().isEmpty()) // not closed
            m_help->rephrase(check->remedy);
        m_helped.remedy = check->remedy;
        return;
    }
    if (check->id != m_helped.id || m_helped.what.isEmpty())
        m_table->selectRow(m_model->rowOf(check->id));
    m_helped = *check;
    m_button = button;
    m_help->showTrouble(check->outcome == DataCheck::Outcome::differs ? Role::fault : Role::attention,
                        troubleOf(*check), button);
}

// Where the computer knows no more of it than the bus does, the bus says it better.
Trouble WhyPage::troubleOf(const DataCheck &check) const
{
    if (!check.why)
        return check.remedy;
    const Trouble trouble = m_helpers.troubleOf(*check.why);
    return trouble == Trouble(refusalText(*check.why)) ? Trouble(check.remedy) : trouble;
}

} // namespace codewheel
