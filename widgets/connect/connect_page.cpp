// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connect/connect_page.h"

#include "widgets/connect/check_list.h"
#include "widgets/connect/link_form.h"
#include "widgets/input/form_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace codewheel {
namespace {

constexpr int widestPage = 180 * grid::unit; // in a wide window fields stay near their labels

Role roleOf(CheckOutcome outcome)
{
    switch (outcome) {
    case CheckOutcome::passed:
        return Role::running;
    case CheckOutcome::failed:
        return Role::fault;
    case CheckOutcome::skipped:
        break;
    }
    return Role::inactive;
}

} // namespace

ConnectPage::ConnectPage(QWidget *parent)
    : Page(parent)
    , m_area(new QScrollArea(this))
    , m_content(new QWidget(this))
    , m_link(describe(new QComboBox(m_content), "link", tr("Link"), tr("How this bus is reached")))
    , m_sentence(wrappedLabel(m_content, "linkSentence"))
    , m_forms(new QStackedWidget(m_content))
    , m_problem(new InlineMessage(this))
    , m_steps(new CheckList(m_content))
    , m_test(new QPushButton(lineIcon(Icon::search), tr("&Test"), this))
    , m_keep(new QPushButton(lineIcon(Icon::save), tr("&Keep in project"), this))
    , m_connect(new QPushButton(lineIcon(Icon::start), tr("&Connect"), this))
{
    setAccessibleName(title());
    m_content->setMaximumWidth(widestPage);
    auto *column = layOut<QVBoxLayout>(m_content, grid::margin, grid::margin);
    auto *link = new QFormLayout;
    link->setHorizontalSpacing(grid::groupGap);
    link->addRow(tr("&Link"), m_link);
    column->addLayout(link);
    column->addWidget(m_sentence);
    column->addWidget(m_forms);
    column->addWidget(m_steps);
    column->addStretch(1);
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setFocusPolicy(Qt::NoFocus);
    m_area->setWidgetResizable(true);
    m_area->setWidget(m_content);
    // What they say and do is in sight, however far the form is scrolled.
    auto *foot = layOutColumn({m_problem, makeButtons()},
                              {.spacing = grid::margin, .margins = allAround(grid::margin)});
    layOutColumn(this, {{m_area, 1}, foot}, {.margins = QMargins()});
    setFocusProxy(m_link);
    connect(m_link, &QComboBox::currentIndexChanged, this, &ConnectPage::choose);
    connect(m_problem, &InlineMessage::actionTriggered, this, &ConnectPage::agree);
    connect(m_area->verticalScrollBar(), &QScrollBar::rangeChanged, this, &ConnectPage::scrollToSteps);
    showButtons();
}

QWidget *ConnectPage::makeButtons()
{
    auto *buttons = new QWidget(this);
    buttons->setMaximumWidth(widestPage);
    for (QPushButton *button : {m_test, m_keep, m_connect})
        button->setAutoDefault(true); // Return presses it, as Space does
    connect(m_test, &QPushButton::clicked, this, &ConnectPage::test);
    connect(m_keep, &QPushButton::clicked, this, &ConnectPage::keep);
    connect(m_connect, &QPushButton::clicked, this, &ConnectPage::connectNow);
    layOutRow(buttons, {Stretch{1}, m_test, m_keep, m_connect}, {.margins = QMargins()});
    return buttons;
}

QString ConnectPage::effect() const
{
    return tr("Testing and connecting only read. Nothing is written to a device.");
}

void ConnectPage::addForm(LinkForm *form)
{
    m_forms->addWidget(form);
    m_link->addItem(form->title());
    connect(form, &LinkForm::edited, this, &ConnectPage::forgetTest);
    connect(form, &LinkForm::portsWanted, this, &ConnectPage::portsWanted);
    connect(form, &LinkForm::fieldsMade, this, &ConnectPage::orderTabs);
    orderTabs();
    choose(m_link->currentIndex());
}

void ConnectPage::setVisible(bool visible)
{
    if (visible && !std::exchange(m_isOpened, true) && form() != nullptr)
        form()->makeFields(); // before its layout is worked out
    Page::setVisible(visible);
}

// The buttons come after the fields, which are younger.
void ConnectPage::orderTabs()
{
    QWidget *last = m_link;
    for (QWidget *field : m_forms->findChildren<QWidget *>())
        if (field->focusPolicy() != Qt::NoFocus && field->focusProxy() == nullptr &&
            field->window() == window()) // not the list of a combo box
            setTabOrder(std::exchange(last, field), field);
    for (QPushButton *next : {m_test, m_keep, m_connect})
        setTabOrder(std::exchange(last, next), next);
}

LinkForm *ConnectPage::form() const
{
    return static_cast<LinkForm *>(m_forms->currentWidget());
}

// A stack is as high as its highest page; here only the chosen one counts.
void ConnectPage::choose(int chosen)
{
    for (int i = 0; i < m_forms->count(); ++i)
        m_forms->widget(i)->setSizePolicy(QSizePolicy::Preferred,
                                          i == chosen ? QSizePolicy::Preferred : QSizePolicy::Ignored);
    if (m_isOpened)
        static_cast<LinkForm *>(m_forms->widget(chosen))->makeFields();
    m_forms->setCurrentIndex(chosen);
    m_sentence->setText(form()->sentence());
    forgetTest();
    showButtons();
}

// What was said is about other settings.
void ConnectPage::forgetTest()
{
    m_problem->withdraw();
    m_steps->clear();
}

void ConnectPage::setPorts(const std::vector<PortRow> &ports, const Trouble &trouble)
{
    for (int i = 0; i < m_forms->count(); ++i)
        static_cast<LinkForm *>(m_forms->widget(i))->setPorts(ports, trouble);
}

void ConnectPage::showPlan(const KindData &plan)
{
    const KindData before = this->plan();
    for (int i = 0; i < m_forms->count(); ++i)
        if (static_cast<LinkForm *>(m_forms->widget(i))->showPlan(plan))
            m_link->setCurrentIndex(i);
    if (this->plan() != before)
        forgetTest();
}

int ConnectPage::chosenLink() const
{
    return m_link->currentIndex();
}

void ConnectPage::chooseLink(int link)
{
    m_link->setCurrentIndex(link);
}

KindData ConnectPage::plan() const
{
    return form()->plan();
}

void ConnectPage::setConnecting(bool on)
{
    m_isConnecting = on;
    showButtons();
}

void ConnectPage::setConnected(Connected connected)
{
    const Connected before = std::exchange(m_connected, connected);
    showButtons();
    if (before == connected || !isVisible())
        return;
    if (connected == Connected::no)
        m_problem->withdraw(); // what was said of the connection
    else if (before == Connected::no)
        tell(tr("Connected. Close this page (Esc) to see the encoders."));
}

void ConnectPage::setProblem(const Trouble &trouble)
{
    m_asksToReplace = false;
    m_problem->showTrouble(Role::fault, trouble);
}

void ConnectPage::tell(const QString &sentence)
{
    m_problem->showMessage(Role::running, sentence);
}

void ConnectPage::ask(const QString &sentence, const QString &answer)
{
    m_asksToReplace = false;
    m_problem->showMessage(Role::attention, sentence, answer);
}

void ConnectPage::askToReplace()
{
    ask(m_connected == Connected::simulated && form()->canBeTested()
            ? tr("This bus is connected to simulated encoders. It is disconnected first. What the project "
                 "plans "
                 "for them then counts for the real ones.")
            : tr("This bus is connected. It is disconnected first."),
        tr("Disconnect and connect"));
    m_problem->focusSafe();
    m_asksToReplace = true;
}

void ConnectPage::setTesting(bool on)
{
    m_isTesting = on;
    if (on)
        m_steps->clear();
    showButtons();
}

void ConnectPage::addStep(CheckOutcome outcome, const QString &what, const QString &sentence)
{
    m_steps->add(roleOf(outcome), what, sentence);
}

// The first step at the top, as soon as there is room below it.
void ConnectPage::scrollToSteps()
{
    if (m_steps->count() > 0)
        m_area->verticalScrollBar()->setValue(m_steps->y());
}

void ConnectPage::showButtons()
{
    const bool isConnected = m_connected != Connected::no;
    const bool canTest = form() != nullptr && form()->canBeTested();
    m_test->setVisible(canTest);
    m_test->setText(m_isTesting ? tr("Cancel &test") : tr("&Test"));
    m_test->setToolTip(
        m_isTesting   ? tr("Ends the test after its present step (Alt+T)")
        : isConnected ? tr("Disconnect first: a serial port has one user, and a gateway may have room for "
                           "one client only")
                      : tr("Tries these settings step by step, and says what answers and what does "
                           "not. Only reads (Alt+T)"));
    m_link->setEnabled(!m_isTesting);
    m_forms->setEnabled(!m_isTesting);
    m_test->setEnabled(!m_isConnecting && m_connected != Connected::real);
    m_connect->setEnabled(!m_isConnecting && !m_isTesting);
    m_connect->setText(m_isConnecting ? tr("Connecting…") : tr("&Connect"));
    m_connect->setToolTip(isConnected
                              ? tr("Disconnects, and connects anew with these settings (Alt+C)")
                              : tr("Keeps these settings in the project, and connects. Nothing is written "
                                   "(Alt+C)"));
    m_keep->setVisible(form() != nullptr && form()->canBeKept());
    m_keep->setEnabled(!m_isConnecting && !isConnected);
    m_keep->setToolTip(isConnected ? tr("The connection that is open is in the project")
                                   : tr("Plans this connection in the project. Nothing is opened (Alt+K)"));
}

// What is half typed is taken first, or nothing is done.
bool ConnectPage::takeTyped()
{
    form()->makeFields(); // what they would show is meant
    const QString halfTyped = takeFields(*form());
    const QString wrong = halfTyped.isEmpty() ? form()->wrong() : halfTyped;
    if (!wrong.isEmpty())
        m_problem->showMessage(Role::attention, wrong);
    return wrong.isEmpty();
}

bool ConnectPage::isComplete()
{
    if (!takeTyped())
        return false;
    const QString missing = form()->complaint();
    if (!missing.isEmpty())
        m_problem->showMessage(Role::attention, missing);
    return missing.isEmpty();
}

void ConnectPage::connectNow()
{
    if (!isComplete())
        return;
    if (m_connected != Connected::no) {
        askToReplace();
        return;
    }
    forgetTest();
    Q_EMIT connectWanted(plan());
}

void ConnectPage::connectBy(const KindData &plan)
{
    showPlan(plan);
    connectNow();
}

void ConnectPage::agree()
{
    const bool isReplacing = std::exchange(m_asksToReplace, false);
    if (!isComplete())
        return;
    if (isReplacing)
        Q_EMIT connectWanted(plan());
    else
        Q_EMIT agreed(plan());
}

void ConnectPage::keep()
{
    if (!takeTyped())
        return;
    Q_EMIT keepWanted(plan());
    tell(tr("This connection is in the project."));
}

void ConnectPage::test()
{
    if (m_isTesting)
        Q_EMIT testCancelled();
    else if (isComplete())
        Q_EMIT testWanted(plan());
}

} // namespace codewheel
