// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/replace_page.h"

#include "bus/buses.h"
#include "bus/participant.h"
#include "catalog/catalog.h"
#include "vocabulary/refusal_text.h"
#include "widgets/job/step_list.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/replace_device_step.h"
#include "widgets/transfer/replace_position_step.h"
#include "widgets/transfer/replace_write_steps.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr int replaceStepsFrom = 680; // logical pixels, as in the wizard

} // namespace

ReplacePage::ReplacePage(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
                         LastPositions &positions, QWidget *parent)
    : Page(parent)
    , m_replacing{.buses = buses, .catalog = catalog, .project = project}
    , m_positions(positions)
    , m_wait(named(new InlineMessage(this), "replaceWait"))
    , m_stepName(named(new QLabel(this), "replaceStep"))
    , m_pages(new QStackedWidget(this))
    , m_back(new QPushButton(lineIcon(Icon::back), tr("Bac&k"), this))
    , m_next(named(new QPushButton(lineIcon(Icon::next), {}, this), "replaceNext"))
    , m_cancel(new QPushButton(lineIcon(Icon::cancel), tr("&Cancel"), this))
{
    setAccessibleName(tr("Replace encoder"));
    describe(m_back, "replaceBack", tr("To the previous step"));
    m_next->setDefault(true);
    describe(m_cancel, "replaceCancel", tr("Ends here; nothing is written"));
    makeSteps();
    layOutColumn(this,
                 {m_wait,
                  m_stepName,
                  {layOutRow({m_list, {m_pages, 1}}), 1},
                  layOutRow({m_cancel, Stretch{1}, m_back, m_next})},
                 {.spacing = grid::margin, .margins = allAround(grid::margin)});
    connect(m_next, &QPushButton::clicked, this, &ReplacePage::next);
    connect(m_back, &QPushButton::clicked, this, &ReplacePage::back);
    connect(m_cancel, &QPushButton::clicked, this, &ReplacePage::closeRequested);
    connect(&project, &ProjectDocument::replaced, this, &ReplacePage::leaveProject);
    connect(&project, &ProjectDocument::changed, this, &ReplacePage::followProject);
    connect(&buses, &Buses::changed, this, &ReplacePage::followBuses);
    showButtons();
    onEvent(this, {QEvent::Show}, [this] { m_isResultSeen = m_isResultSeen || current() == m_account; });
    onEvent(this, {QEvent::Resize}, [this] { showList(); });
}

void ReplacePage::makeSteps()
{
    m_write = new ReplaceWriteStep(m_replacing);
    m_account = new ReplaceAccountStep(m_replacing);
    m_position = new ReplacePositionStep(m_replacing, m_positions);
    m_device = new ReplaceDeviceStep(m_replacing);
    const bool isMeant = m_makeStepsOfKind && !m_replacing.place.isEmpty();
    const auto [begin, end] = isMeant ? m_makeStepsOfKind(m_replacing) : ReplaceStepsOfKind();
    m_steps.clear();
    for (ReplaceStep *step :
         {m_device, begin, static_cast<ReplaceStep *>(m_position), static_cast<ReplaceStep *>(m_write),
          static_cast<ReplaceStep *>(m_account), end})
        addStep(step);
    QStringList titles;
    for (const ReplaceStep *step : m_steps)
        titles << step->title();
    m_list = new StepList(titles, this);
    connect(m_write, &ReplaceWriteStep::ended, this, &ReplacePage::showAccount);
}

void ReplacePage::addStep(ReplaceStep *step)
{
    if (step == nullptr)
        return;
    auto *scroll = new QScrollArea(m_pages);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(step);
    m_pages->addWidget(scroll);
    m_steps.push_back(step);
    connect(step, &ReplaceStep::changed, this, &ReplacePage::showButtons);
    connect(step, &ReplaceStep::givesPlace, this, [this] { m_positions.takeReplaced(m_replacing.place); });
}

bool ReplacePage::isBusy() const
{
    return std::ranges::any_of(m_steps, &ReplaceStep::isBusy);
}

// After an account of what was not all done there is nothing more to do.
bool ReplacePage::isLast() const
{
    return current() == m_steps.back() || (current() == m_account && !isDone());
}

QString ReplacePage::doneSoFar() const
{
    QStringList done;
    for (const ReplaceStep *step : m_steps)
        done << step->doneSoFar();
    done.removeAll(QString());
    return done.join(u' ');
}

ReplaceStep *ReplacePage::current() const
{
    return m_steps[static_cast<std::size_t>(m_pages->currentIndex())];
}

// The steps are rebuilt, so that nothing typed for another encoder remains in them.
void ReplacePage::replace(Place number)
{
    const bool isResultNew = m_hasBegun && !m_isResultSeen && m_replacing.place == number;
    if (isBusy() || isResultNew)
        return;
    m_replacing.place = number;
    m_positions.beginReplacement(number);
    takePlanned();
    const bool isAgain = m_unfinished && m_unfinished->place == number;
    m_replacing.now = isAgain ? m_unfinished->label : Replacement{};
    m_replacing.key = isAgain ? m_unfinished->key : QString();
    m_replacing.position.reset();
    m_hasBegun = false;
    m_isResultSeen = false;
    m_waits = !isConnected();
    while (QWidget *page = m_pages->widget(0)) {
        m_pages->removeWidget(page);
        delete page;
    }
    delete m_list;
    makeSteps();
    auto *middle = static_cast<QHBoxLayout *>(layout()->itemAt(2)->layout());
    middle->insertWidget(0, m_list);
    showWait();
    showList();
    showStep(m_device);
}

void ReplacePage::takePlanned()
{
    m_replacing.before = m_replacing.project.device(m_replacing.place);
    m_replacing.before.standAt(m_replacing.place);
}

void ReplacePage::followProject()
{
    if (!isVisible() || m_hasBegun)
        return;
    takePlanned();
    if (current() != m_write || m_position->stillHolds()) {
        current()->refresh();
        return;
    }
    showStep(m_position);
    m_position->askAnew();
}

bool ReplacePage::isConnected() const
{
    return m_replacing.buses.open(m_replacing.place.bus) != nullptr;
}

void ReplacePage::followBuses()
{
    if (m_hasBegun || m_replacing.place.isEmpty())
        return;
    const bool waited = std::exchange(m_waits, !isConnected());
    if (waited && !m_waits)
        beginAnew();
    else
        showWait();
}

// Nothing that was shown of the bus before is offered.
void ReplacePage::showWait()
{
    if (m_waits)
        m_wait->showMessage(
            Role::attention,
            m_replacing.buses.isOpening(m_replacing.place.bus)
                ? tr("The bus of %1 is starting. Once it runs, this begins anew, with what was "
                     "given of the new encoder.")
                      .arg(m_replacing.place.shown())
                : refusalText(notConnected(m_replacing.place)));
    else
        m_wait->withdraw();
    m_pages->setVisible(!m_waits);
    showButtons();
}

// Without taking the focus from other parts of the window.
void ReplacePage::beginAnew()
{
    m_unfinished = {m_replacing.place, m_replacing.now, m_replacing.key};
    const QPointer<QWidget> focused = window()->focusWidget();
    const bool isElsewhere = focused != nullptr && !isAncestorOf(focused);
    replace(m_replacing.place);
    if (isElsewhere && focused)
        focused->setFocus();
}

// The old project's plan means nothing to another project. An account of what was written stays to be saved.
void ReplacePage::leaveProject()
{
    m_unfinished.reset();
    if (!isVisible() || m_hasBegun)
        return;
    replace(m_replacing.place);
    Q_EMIT closeRequested();
}

void ReplacePage::showList()
{
    m_list->setVisible(width() >= replaceStepsFrom);
    m_stepName->setVisible(width() < replaceStepsFrom);
}

void ReplacePage::showNext(int by)
{
    showStep(m_steps[static_cast<std::size_t>(m_pages->currentIndex() + by)]);
}

void ReplacePage::showStep(const ReplaceStep *step)
{
    const auto index = static_cast<int>(std::ranges::find(m_steps, step) - m_steps.begin());
    m_pages->setCurrentIndex(index);
    m_press.begin();
    m_list->setCurrent(index);
    current()->enter();
    showButtons();
    m_stepName->setText(current()->title());
    Q_EMIT headChanged();
    current()->setFocus();
}

QString ReplacePage::title() const
{
    return tr("Replace encoder %1/%2", "step of steps").arg(m_pages->currentIndex() + 1).arg(m_steps.size());
}

QString ReplacePage::about() const
{
    QStringList parts{m_replacing.place.shown(), m_replacing.before.station,
                      participantName(deviceBefore(m_replacing))};
    parts.removeAll(QString());
    return parts.join(QStringLiteral("  "));
}

QString ReplacePage::effect() const
{
    if (const QString its = current()->effect(); !its.isEmpty())
        return its;
    return current() == m_account ? tr("What was written. Nothing more is sent.")
           : isBusy()             ? tr("Writes to the encoder.")
                                  : tr("Nothing is sent or planned before Write.");
}

QString ReplacePage::lostByClosing() const
{
    if (isBusy())
        return goesOn();
    const Replacement &now = m_replacing.now;
    const QString kept = m_unfinished && m_unfinished->place == m_replacing.place
                             ? m_unfinished->label.serialNumber
                             : QString();
    const bool isGiven = current() != m_device || now.turns > 0 || now.serialNumber != kept;
    const QString done = doneSoFar();
    if (m_hasBegun || !done.isEmpty())
        return m_hasBegun ? done : done + u' ' + tr("Its values have not been written.");
    return isGiven ? tr("Nothing has been written to %1, and what was given here is forgotten.")
                         .arg(m_replacing.place.shown())
                   : QString();
}

void ReplacePage::leave()
{
    if (!m_hasBegun)
        replace(m_replacing.place);
}

void ReplacePage::next()
{
    if (current() == m_write && m_press.isSecond())
        return;
    if (isLast()) {
        Q_EMIT closeRequested();
    } else if (!current()->leave()) {
        current()->setFocus();
    } else if (current() == m_write) {
        m_hasBegun = true;
        m_write->takeNew(); // before the project names its label
        putIntoProject();
        m_write->begin();
        Q_EMIT headChanged();
    } else {
        showNext(1);
    }
}

// From the account of one that has failed everything begins anew.
void ReplacePage::back()
{
    if (current() == m_account)
        replace(m_replacing.place);
    else
        showNext(-1);
}

bool ReplacePage::canBeRepeated() const
{
    return current() == m_account && m_unfinished && m_unfinished->place == m_replacing.place;
}

// The new encoder is in place, whatever becomes of the writing.
void ReplacePage::putIntoProject()
{
    m_replacing.project.editDevice(m_replacing.place, tr("Replace encoder %1").arg(m_replacing.place.shown()),
                                   [this](ProjectDevice &planned) {
                                       planned = replaced(planned, m_replacing.now, m_replacing.position);
                                   });
    Q_EMIT messaged(encoderReplacedMessage(m_replacing.before, m_replacing.now));
}

void ReplacePage::showAccount()
{
    const TransferAccount what = m_write->account();
    m_unfinished.reset();
    if (!what.isDone())
        m_unfinished = {m_replacing.place, m_replacing.now, m_replacing.key};
    Q_EMIT messaged(messageOf(what));
    m_account->show(what);
    showStep(m_account);
    m_isResultSeen = isVisible();
}

void ReplacePage::showButtons()
{
    const bool isFirst = current() == m_device;
    m_next->setText(isLast()                 ? m_account->nextText()
                    : current() == m_account ? m_device->nextText()
                                             : current()->nextText());
    m_next->setEnabled(!m_waits && current()->mayGoOn());
    m_next->setToolTip(current() == m_write ? tr("Sends what is shown above to the new encoder")
                       : isLast()           ? tr("Back to the monitors")
                                            : tr("To the next step"));
    const bool repeats = canBeRepeated();
    m_back->setEnabled(repeats || (!m_waits && !isFirst && current()->mayGoBack()));
    m_back->setText(repeats ? tr("&Repeat") : tr("Bac&k"));
    m_back->setToolTip(repeats ? tr("Begins anew, with what was given of the new encoder")
                               : tr("To the previous step"));
    m_cancel->setVisible(!m_hasBegun && !isBusy()); // the strip has one of its own
    m_cancel->setToolTip(doneSoFar().isEmpty() ? tr("Ends here; nothing is written")
                                               : tr("Ends here; its values are not written"));
}

} // namespace codewheel
